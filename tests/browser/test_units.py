"""The unit of length that a user names: where it is told, and whose it is (SPEC Q1, S1)."""

from __future__ import annotations

import csv
import io
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

import hexalab

from . import ui
from .conftest import grid

MESH = grid(5, 4, 3, noise=0.2)
OTHER = grid(2, 2, 2)
VOLUME: dict[str, Any] = {"colour": {"by": "quality", "metric": "volume"}}
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    with ui.one_viewer(chromium, site, accept_downloads=True) as page:
        hexalab.write(OTHER, shelf / "other.mesh")
        ui.open_mesh(page, site, shelf, MESH, "units.mesh")
        ui.unfold(page)
        yield page


@pytest.fixture
def mesh(opened: Page, site: str) -> Page:
    opened.evaluate("url => window.hexalab.open(url)", f"{site}/bench/units.mesh")
    ui.reset(opened)
    ui.set_status(opened, VOLUME)
    ui.until(lambda: ui.status(opened)["unit"] == "none")
    return opened


def text(page: Page, place: str) -> str:
    """What is written somewhere, with plain blanks."""
    return page.locator(place).inner_text().replace("\u00a0", " ").strip()


def figure_words(page: Page) -> list[str]:
    svg = page.evaluate("async () => (await window.hexalab.figure('svg')).text()")
    return [(one.text or "").replace("\u00a0", " ") for one in ElementTree.fromstring(svg).iter(f"{SVG}text")]


def point_at_a_cell(page: Page) -> str:
    """Move the pointer over the mesh; what the status line tells of the cell under it."""
    x, y = ui.middle(page)
    page.mouse.move(x - 3, y)
    page.mouse.move(x, y)
    return ui.until(lambda: "VOL" in text(page, ".hover-cell") and text(page, ".hover-cell"))


def test_Q1_a_unit_is_told_wherever_a_length_or_a_volume_is(mesh: Page) -> None:
    mesh.locator("#length-unit").select_option("um")
    assert mesh.locator("#length-unit option:checked").inner_text() == "µm"
    assert text(mesh, ".first-facts").splitlines()[1] == "5.000 × 4.000 × 3.000 µm"
    assert text(mesh, ".digest-line").count("µm³") == 3
    statistics = text(mesh, "table:has(caption:has-text('Statistics of Volume'))")
    assert statistics.count("µm³") == 8 and statistics.count("µm⁶") == 1
    assert mesh.locator(".histogram .unit").text_content() == "µm³"
    assert mesh.locator(".histogram").get_attribute("aria-label") == "Histogram of Volume (µm³)"
    assert text(mesh, ".row-unit") == "µm³"
    assert text(mesh, ".worst thead").split("\t") == ["Cell", "Value (µm³)", "Place (µm)"]
    assert "µm³" in point_at_a_cell(mesh)
    mesh.mouse.click(*ui.middle(mesh))
    ui.until(lambda: mesh.locator(".inspector").is_visible())
    rows = dict(
        row.split("\t") for row in text(mesh, ".inspector table >> nth=0").splitlines() if "\t" in row
    )
    units = {name: value.split(" ")[1] for name, value in rows.items() if " " in value}
    assert units == {
        "Jacobian": "µm³", "Volume": "µm³", "Dimension": "µm", "Characteristic Length": "µm"
    }  # fmt: skip
    assert text(mesh, ".inspector table >> nth=-1").startswith("Corners (µm)")
    assert text(mesh, ".cell-label").endswith("µm³")
    assert "µm³" in text(mesh, "#picture-in-words")


def test_Q1_the_unit_is_told_in_figures_and_files(mesh: Page) -> None:
    figure = {"unit": "px", "width": 600, "height": 400, "legend": "bar", "scale_bar": True}
    ui.set_status(mesh, {"unit": "in", "figure": figure})
    words = figure_words(mesh)
    assert "Volume (in³)" in words
    assert [word for word in words if re.fullmatch(r"[\d.]+ in", word)] == ["2 in"]
    with mesh.expect_download() as download:
        mesh.get_by_role("button", name="List as CSV").click()
    (head, first, *_) = csv.reader(io.StringIO(download.value.path().read_text()))
    assert head == ["cell", "volume (in^3)", "x (in)", "y (in)", "z (in)"]
    values = hexalab.quality(MESH, "volume")
    assert float(first[1]) == pytest.approx(values.min())
    ui.set_status(mesh, {"figure": {"legend_title": "Size"}})
    assert "Size" in figure_words(mesh)


def test_Q1_without_a_unit_nothing_is_said_and_numbers_are_the_same_with_one(mesh: Page) -> None:
    said = {place: text(mesh, place) for place in (".first-facts", ".digest-line", ".histogram-frame")}
    numbers = mesh.locator(".digest-line dd").all_inner_texts()
    assert not mesh.locator(".histogram .unit").count()
    ui.set_status(mesh, {"unit": "km"})
    named = [one.split("\u00a0") for one in mesh.locator(".digest-line dd").all_inner_texts()]
    assert named == [[one, "km³"] for one in numbers]
    ui.set_status(mesh, {"colour": {"metric": "scaled_jacobian"}})
    ui.until(lambda: "km" not in text(mesh, ".digest-line"))
    ui.set_status(mesh, {"unit": "none", **VOLUME})
    ui.until(lambda: {place: text(mesh, place) for place in said} == said)


def test_S1_a_unit_is_one_files_and_can_be_undone(mesh: Page, site: str) -> None:
    mesh.locator("#length-unit").select_option("ft")
    mesh.keyboard.press("Control+z")
    assert ui.status(mesh)["unit"] == "none"
    mesh.locator("#length-unit").select_option("ft")
    mesh.evaluate("url => window.hexalab.open(url)", f"{site}/bench/units.mesh")
    assert ui.status(mesh)["unit"] == "ft", "the same file, opened again"
    mesh.evaluate("url => window.hexalab.open(url)", f"{site}/bench/other.mesh")
    assert ui.status(mesh)["unit"] == "none", "of another file nothing is known"
    assert mesh.locator("#length-unit").input_value() == "none"
    assert ui.set_status(mesh, {"unit": "m"}) == []
    assert text(mesh, ".first-facts").splitlines()[1] == "2.000 × 2.000 × 2.000 m"
    (rejection,) = ui.set_status(mesh, {"unit": "yard"})
    assert rejection["path"] == "unit" and ui.status(mesh)["unit"] == "m"
