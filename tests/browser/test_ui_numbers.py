"""The file's own numbers, and its elements of lower dimension: gone to, told, copied, drawn (SPEC R11, R13)."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page

import hexalab

from . import grouped, ui
from .test_ui_groups import changed, picture


@pytest.fixture(scope="module")
def deck(shelf: Path) -> hexalab.Mesh:
    return grouped.deck(shelf / "numbers.inp")


@pytest.fixture(scope="module")
def featured(shelf: Path) -> hexalab.Mesh:
    return grouped.featured(shelf / "features.vtu")


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str) -> Iterator[Page]:
    with ui.one_viewer(chromium, site, accept_downloads=True) as page:
        yield page


def shown(page: Page, site: str, name: str) -> Page:
    """The viewer with a mesh of the shelf, all its settings the mesh's own."""
    if ui.summary(page).get("name") != name:
        page.evaluate("url => window.hexalab.open(url)", f"{site}/bench/{name}")
        ui.until(lambda: ui.summary(page).get("findings") is not None)
        ui.unfold(page)
    ui.reset(page)
    return page


@pytest.fixture
def numbered(opened: Page, site: str, deck: hexalab.Mesh) -> Page:
    return shown(opened, site, "numbers.inp")


@pytest.fixture
def lined(opened: Page, site: str, featured: hexalab.Mesh) -> Page:
    page = shown(opened, site, "features.vtu")
    ui.set_status(page, {"camera": {"fit": True, "direction": [0.5, 0.6, -0.62], "up": [0, 0, 1]}})
    return page


def heading(page: Page) -> str:
    found: str = page.locator(".inspector h2").inner_text()
    return found


def row_of(mesh: hexalab.Mesh, number: int) -> int:
    (row,) = np.flatnonzero(mesh.cell_numbers == number)
    return int(row)


def around(mesh: hexalab.Mesh, row: int) -> set[int]:
    """Rows of the cells that share a vertex with one."""
    return set(np.flatnonzero(np.isin(mesh.cells, mesh.cells[row]).any(axis=1)).tolist())


def test_R11_a_number_is_typed_and_its_element_isolated_and_one_undo_leads_back(
    numbered: Page, deck: hexalab.Mesh
) -> None:
    before = ui.status(numbered)
    numbered.evaluate("() => { document.querySelector('#section-mesh').open = false; }")
    numbered.locator("#canvas").focus()
    numbered.keyboard.press("n")
    assert numbered.locator(":focus").get_attribute("id") == "go-to", "the folded section opens"
    numbered.keyboard.type("1301")
    numbered.keyboard.press("Enter")
    ui.until(lambda: heading(numbered) == "Cell 1301")
    ui.until(lambda: ui.status(numbered)["camera"] != before["camera"])
    picking = ui.status(numbered)["filters"]["picking"]
    row = row_of(deck, 1301)
    assert picking["isolated"]
    assert row in picking["shown"]
    assert {row} < set(picking["shown"]) <= around(deck, row)
    assert ui.drawn(numbered)[0] == len(picking["shown"])
    numbered.keyboard.press("Control+z")
    assert ui.status(numbered)["filters"] == before["filters"]
    assert ui.status(numbered)["camera"] == before["camera"], "the view went back with it"
    assert ui.drawn(numbered)[0] == deck.cell_count
    assert numbered.locator("#go-to").input_value() == "1301"


def test_R11_a_node_is_gone_to_by_a_word_or_by_the_choice(numbered: Page, deck: hexalab.Mesh) -> None:
    vertex = int(np.flatnonzero(deck.vertex_numbers == 12)[0])
    wanted = np.flatnonzero((deck.cells == vertex).any(axis=1)).tolist()
    numbered.locator("#go-to").fill("node 12")
    numbered.get_by_role("button", name="Go", exact=True).click()
    ui.until(lambda: ui.status(numbered)["filters"]["picking"]["shown"] == wanted)
    ui.until(lambda: "\n12\t" in numbered.locator(".inspector").inner_text(), 20)
    ui.reset(numbered)
    numbered.get_by_label("What the number is of").select_option("node")
    numbered.locator("#go-to").fill("12")
    numbered.locator("#go-to").press("Enter")
    ui.until(lambda: ui.status(numbered)["filters"]["picking"]["shown"] == wanted)
    numbered.get_by_label("What the number is of").select_option("element")


def test_R11_what_can_not_be_gone_to_is_told(numbered: Page, deck: hexalab.Mesh) -> None:
    before = ui.status(numbered)["filters"]
    field = numbered.locator("#go-to")
    field.fill("1302")
    field.press("Enter")
    low, high = (int(end(deck.cell_numbers)) for end in (np.min, np.max))
    wanted = f"the mesh has no element 1302: its numbers are from {low:,} to {high:,}"
    ui.until(lambda: wanted in ui.messages(numbered))
    field.fill("a cell")
    field.press("Enter")
    assert "“a cell” is no number" in field.evaluate("field => field.validationMessage")
    assert ui.status(numbered)["filters"] == before
    field.fill("1001")
    field.press("Enter")
    ui.until(lambda: heading(numbered) == "Cell 1001")
    assert wanted not in ui.messages(numbered)


def test_R11_worst_cells_have_the_files_numbers_and_are_walked_by_keyboard(
    numbered: Page, deck: hexalab.Mesh
) -> None:
    assert deck.cell_numbers is not None
    values = hexalab.quality(deck, "scaled_jacobian")
    order = np.argsort(values, kind="stable")
    links = numbered.locator(".worst tbody th button")
    ui.until(lambda: links.count() == 50)
    told = [int(one) for one in links.all_inner_texts()]
    assert told[:5] == deck.cell_numbers[order[:5]].tolist()
    links.first.click()
    ui.until(lambda: heading(numbered) == f"Cell {told[0]}")
    numbered.keyboard.press("ArrowDown")
    ui.until(lambda: heading(numbered) == f"Cell {told[1]}")
    ui.until(lambda: numbered.locator(":focus").inner_text() == str(told[1]))
    with numbered.expect_download() as download:
        numbered.get_by_role("button", name="List as CSV").click()
    rows = list(csv.reader(io.StringIO(download.value.path().read_text())))[1:]
    assert [int(row[0]) for row in rows] == deck.cell_numbers[order].tolist()
    with numbered.expect_download() as download:
        numbered.get_by_role("button", name="All values as CSV").click()
    rows = list(csv.reader(io.StringIO(download.value.path().read_text())))[1:]
    assert [int(row[0]) for row in rows] == deck.cell_numbers.tolist()
    assert [float(row[1]) for row in rows] == pytest.approx(values.tolist(), abs=1e-5)


def test_R11_worst_cells_are_copied_for_other_programs(numbered: Page, deck: hexalab.Mesh) -> None:
    links = numbered.locator(".worst tbody th button")
    ui.until(lambda: links.count() == 50)
    told = [int(one) for one in links.all_inner_texts()]
    form = numbered.get_by_label("Copy as")
    copy = numbered.get_by_role("button", name="Copy", exact=True)
    text = numbered.get_by_label("Copied cells")
    form.select_option("elset")
    copy.click()
    ui.until(text.is_visible)
    (head, *lines) = text.input_value().splitlines()
    assert head == "*ELSET, ELSET=WORST"
    assert [int(one) for one in ",".join(lines).split(",")] == told
    form.select_option("paraview")
    copy.click()
    ui.until(lambda: "isin" in text.input_value())
    rows = [int(one) for one in re.findall(r"\d+", text.input_value().split("[")[1])]
    assert rows == [row_of(deck, number) for number in told]


def test_R11_picked_cells_are_typed_by_the_files_numbers(numbered: Page, deck: hexalab.Mesh) -> None:
    field = numbered.locator("#pick-hidden")
    field.fill("1001-1010, 1301")
    field.press("Enter")
    rows = sorted(row_of(deck, number) for number in (1001, 1004, 1007, 1010, 1301))
    ui.until(lambda: ui.status(numbered)["filters"]["picking"]["hidden"] == rows)
    assert ui.drawn(numbered)[0] == deck.cell_count - 5
    field.fill("5")
    field.press("Enter")
    assert ui.status(numbered)["filters"]["picking"]["hidden"] == rows, "no cell has this number"
    numbered.locator("#canvas").focus()
    ui.set_status(numbered, {"filters": {"picking": {"hidden": rows[:2]}}})
    assert deck.cell_numbers is not None
    ui.until(lambda: field.input_value() == ", ".join(map(str, sorted(deck.cell_numbers[rows[:2]]))))


def test_R11_the_cell_under_the_pointer_is_told_by_its_number(numbered: Page, deck: hexalab.Mesh) -> None:
    assert deck.cell_numbers is not None
    x, y = ui.middle(numbered)
    numbered.mouse.move(x - 3, y)
    numbered.mouse.move(x, y)
    words = ui.until(lambda: re.match(r"cell (\d+)", numbered.locator(".hover-cell").inner_text()))
    assert int(words[1]) in deck.cell_numbers
    numbered.mouse.click(x, y)
    ui.until(lambda: heading(numbered) == f"Cell {words[1]}")
    told = numbered.locator(".inspector .cell-list").first.inner_text()
    row = row_of(deck, int(words[1]))
    names = [name for name, rows in grouped.sets(deck).items() if row in rows]
    assert all(name in told for name in names), told


def test_R13_features_are_drawn_dimension_by_dimension_and_group_by_group(lined: Page) -> None:
    heads = lined.locator("#section-features .group-list h3")
    assert heads.all_inner_texts() == ["2 corners", "17 edges", "32 faces"]
    assert (
        lined.locator("#section-features > summary .digest").text_content() == "2 corners, 17 edges, 32 faces"
    )
    assert "1 not in the mesh: drawn in red" in lined.locator("#section-features").inner_text()
    box = lambda name: lined.get_by_role("checkbox", name=name, exact=True)  # noqa: E731
    for name in ("corners", "edges", "faces"):
        if box(f"Feature {name} drawn").is_checked():
            box(f"Feature {name} drawn").click()
    bare = picture(lined)
    box("Feature edges drawn").focus()
    lined.keyboard.press("Space")
    edges = changed(bare, picture(lined))
    assert edges > 300
    box("reference 1 of the feature edges drawn").click()
    fewer = changed(bare, picture(lined))
    assert 0 < fewer < edges
    assert ui.status(lined)["marks"]["hidden"] == ["edges:reference:1"]
    box("Feature edges drawn").click()
    assert changed(bare, picture(lined)) == 0
    box("reference 1 of the feature edges drawn").click()
    assert ui.status(lined)["marks"]["edges"], "a group that is ticked is seen"
    box("Feature edges drawn").click()
    for name, least in (("faces", 10_000), ("corners", 20)):
        box(f"Feature {name} drawn").click()
        assert changed(bare, picture(lined)) > least, name
        box(f"Feature {name} drawn").click()


def test_R13_sharp_edges_follow_the_slider(lined: Page) -> None:
    ui.set_status(lined, {"marks": {"corners": False, "edges": False, "faces": False}})
    bare = picture(lined)
    digest = lined.locator("#section-features > summary .digest")
    slider = lined.locator("#sharp-angle")
    slider.focus()
    slider.press("Home")
    ui.until(lambda: digest.text_content() == "64 sharp edges")
    assert ui.status(lined)["marks"]["sharp_angle"] == 0
    assert changed(bare, picture(lined)) > 1000
    field = lined.get_by_label("Sharp edges, value")
    field.fill("89")
    field.press("Enter")
    ui.until(lambda: ui.status(lined)["marks"]["sharp_angle"] == 89)
    assert changed(bare, picture(lined)) > 1000, "a box has right angles"
    field.fill("91")
    field.press("Enter")
    ui.until(lambda: digest.text_content() == "0 sharp edges")
    assert changed(bare, picture(lined)) == 0
    slider.press("End")
    ui.until(lambda: digest.text_content() == "2 corners, 17 edges, 32 faces")
