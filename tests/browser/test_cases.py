"""The same small files, opened in the page from disk: it tells what the command line tells."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page

from tests.browser import ui
from tests.core.cli.test_cases import assert_told
from tests.core.formats.case_rows import CASES, ROWS, Row

REFUSED = {name: words for name, row in ROWS.items() if (words := row.refused or row.refused_in_page)}
READ = {name: row for name, row in ROWS.items() if name not in REFUSED}


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str) -> Iterator[Page]:
    """One viewer for all files."""
    with ui.one_viewer(chromium, site) as page:
        yield page


def choose(page: Page, name: str) -> None:
    """Open a file as a user does, by the dialogue."""
    page.locator("#file").set_input_files(CASES / name)


@pytest.mark.parametrize("name", READ)
def test_the_page_tells_what_the_row_says(opened: Page, name: str) -> None:
    row: Row = READ[name]
    choose(opened, name)
    ui.until(
        lambda: ui.summary(opened).get("name") == name and ui.summary(opened).get("findings") is not None
    )
    summary = ui.summary(opened)
    assert {kind: count for kind, count in summary["kinds"].items() if count} == row.kinds
    volume, scaled_jacobian = (
        opened.evaluate("id => window.hexalab.quality(id)", metric)
        for metric in ("volume", "scaled_jacobian")
    )
    assert volume["mean"] * summary["cells"] == pytest.approx(row.volume)
    assert_told(row, scaled_jacobian, summary["findings"])
    words = [finding["message"] for finding in summary["findings"]]
    ui.until(lambda: opened.locator(".finding-text:visible").all_inner_texts() == words)
    for array, least, greatest in row.attributes:
        told = opened.evaluate("id => window.hexalab.quality(id)", f"cell:{array}")
        assert (told["min"], told["max"]) == (least, greatest)


@pytest.mark.parametrize("name", REFUSED)
def test_the_page_refuses_in_words_and_keeps_the_mesh(opened: Page, name: str) -> None:
    choose(opened, "polyhedron-lattice-cube.vtu")
    ui.until(lambda: ui.summary(opened).get("name") == "polyhedron-lattice-cube.vtu")
    choose(opened, name)
    ui.until(lambda: name in ui.messages(opened))
    assert REFUSED[name] in ui.messages(opened)
    assert ui.summary(opened)["name"] == "polyhedron-lattice-cube.vtu"
