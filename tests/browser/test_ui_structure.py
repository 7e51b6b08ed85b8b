"""The panel of the structure: figures, table, matrix, controls; a cell's sheets; filter, undo, links (SPEC T4, T5)."""

from __future__ import annotations

import base64
import io
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Locator, Page

import hexalab
from hexalab.hosts.page_scripts import PICTURE
from hexalab.structure.matrix import sheet_pairs

from . import ui
from .test_ui_page import AXE, violations

ROOT = Path(__file__).resolve().parents[2]
MESH = ROOT / "repository" / "structures" / "padded-cube.mesh"


@pytest.fixture(scope="module")
def structure() -> hexalab.Structure:
    return hexalab.structure(hexalab.read(MESH))


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    (shelf / MESH.name).write_bytes(MESH.read_bytes())
    with ui.one_viewer(chromium, site, script=AXE.read_text()) as page:
        page.evaluate("url => window.hexalab.open(url)", f"{site}/bench/{MESH.name}")
        ui.until(lambda: ui.summary(page).get("findings") is not None)
        ui.unfold(page)
        page.locator(".structure-figures").scroll_into_view_if_needed()
        ui.until(lambda: figure(page, "sheets").is_enabled())
        yield page


@pytest.fixture
def mesh(opened: Page) -> Page:
    opened.set_viewport_size({"width": 1280, "height": 800})
    ui.reset(opened)
    return opened


def figure(page: Page, kind: str) -> Locator:
    return page.locator(".figure-button", has_text=kind)


def status(page: Page, section: str) -> Any:
    return page.evaluate("section => window.hexalab.getStatus()[section]", section)


def look(page: Page, kind: str, **more: Any) -> None:
    ui.set_status(page, {"structure": {"kind": kind, **more}})


def picture(page: Page) -> np.ndarray:
    """What the viewer's own picture has, (h, w, 3)."""
    page.evaluate("() => window.hexalab.setStatus({})")
    png = base64.b64decode(
        page.evaluate(PICTURE, {"format": "", "size": {"width": 480, "height": 360}})["data"]
    )
    return np.array(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)


def near(pixels: np.ndarray, colour: tuple[int, int, int]) -> int:
    """Pixels whose hue is about a colour's, in light or shade."""
    chroma = pixels - pixels.mean(axis=2, keepdims=True)
    wanted = np.array(colour) - np.mean(colour)
    length = np.linalg.norm(chroma, axis=2)
    cosine = (chroma @ wanted) / np.maximum(length * np.linalg.norm(wanted), 1e-9)
    return int(((cosine > 0.97) & (length > 30)).sum())


TEAL, AMBER = (0x17, 0xA3, 0x98), (0xF2, 0xA9, 0x3B)


def test_T4_figures_tell_how_many_there_are_and_lead_there(mesh: Page, structure: hexalab.Structure) -> None:
    counts = {
        "arcs": structure.graph.count,
        "sheets": structure.sheets.count,
        "chords": structure.chords.count,
        "blocks": structure.base_complex.count,
    }
    for kind, number in counts.items():
        assert figure(mesh, kind).locator("strong").inner_text() == f"{number:,}"
        figure(mesh, kind).click()
        assert status(mesh, "structure")["kind"] == kind
        assert figure(mesh, kind).get_attribute("aria-pressed") == "true"
        rows = mesh.locator(".structure-table .data-table")
        if number:
            ui.until(lambda rows=rows, number=number: rows.get_attribute("aria-rowcount") == str(number + 1))
        else:
            ui.until(lambda rows=rows: not rows.is_visible())
    assert status(mesh, "colour")["by"] == "block"
    figure(mesh, "blocks").click()
    assert status(mesh, "structure")["kind"] == "none"
    assert status(mesh, "colour")["by"] == "sides"


def test_T4_rows_are_chosen_by_keys_and_seen_in_two_colours(mesh: Page, structure: hexalab.Structure) -> None:
    figure(mesh, "sheets").click()
    table = mesh.locator(".structure-table .data-table")
    ui.until(lambda: table.get_attribute("aria-rowcount") == str(structure.sheets.count + 1))
    assert near(picture(mesh), TEAL) == 0
    table.focus()
    mesh.keyboard.press("ArrowDown")
    mesh.keyboard.press("Shift+ArrowDown")
    chosen = status(mesh, "structure")["chosen"]
    assert chosen == [0, 1]
    pixels = picture(mesh)
    assert near(pixels, TEAL) > 300
    assert near(pixels, AMBER) > 300
    assert mesh.get_by_text("Chosen: sheets 0 and 1").is_visible()
    mesh.locator("#structure-form").select_option("surfaces")
    assert near(picture(mesh), AMBER) > 300
    distance = status(mesh, "camera")["distance"]
    mesh.keyboard.press("Escape")
    table.focus()
    mesh.keyboard.press("Enter")  # goes to the row of the cursor
    ui.until(lambda: status(mesh, "camera")["distance"] != distance)
    table.focus()
    mesh.keyboard.press("Escape")
    assert status(mesh, "structure")["chosen"] == []


def test_T4_two_sheets_of_the_matrix(mesh: Page, structure: hexalab.Structure) -> None:
    figure(mesh, "sheets").click()
    canvas = mesh.locator("#sheet-matrix canvas")
    canvas.scroll_into_view_if_needed()
    ui.until(canvas.is_visible)
    pairs = sheet_pairs(structure.frame, structure.sheets)
    place = int(np.flatnonzero((pairs.crossings > 0) & (pairs.one != pairs.other))[0])
    one, other, count = int(pairs.one[place]), int(pairs.other[place]), structure.sheets.count
    area = canvas.bounding_box()
    assert area is not None
    x, y = ((number + 0.5) / count for number in (other, one))
    canvas.click(position={"x": x * area["width"], "y": y * area["height"]})
    assert sorted(status(mesh, "structure")["chosen"]) == sorted((one, other))
    line = mesh.locator(".pair-matrix-line").inner_text()
    assert f"cross {pairs.crossings[place]}" in line


def test_T5_only_the_chosen_and_without_them(mesh: Page, structure: hexalab.Structure) -> None:
    cells = structure.sheets.cells
    look(mesh, "sheets", chosen=[2])
    mesh.get_by_role("button", name="Only these").click()
    ui.until(lambda: ui.summary(mesh)["shown"]["cells"] == cells[2])
    assert mesh.get_by_text("only sheet 2").is_visible()
    mesh.get_by_role("button", name="Hide", exact=True).first.click()
    ui.until(lambda: ui.summary(mesh)["shown"]["cells"] == len(structure.block_of_cells) - cells[2])
    assert mesh.get_by_text("without sheet 2").is_visible()
    mesh.locator("#structure-filter").uncheck()
    ui.until(lambda: ui.summary(mesh)["shown"]["cells"] == len(structure.block_of_cells))
    mesh.keyboard.press("Control+z")
    ui.until(lambda: ui.summary(mesh)["shown"]["cells"] == len(structure.block_of_cells) - cells[2])
    mesh.get_by_role("button", name="Show what is hidden by structure").click()
    ui.until(lambda: not mesh.locator(".structure-filter").is_visible())


def test_T4_blocks_apart_stay_within_the_picture(mesh: Page) -> None:
    look(mesh, "blocks")
    together = picture(mesh)
    mesh.locator("#structure-explode").press("End")
    assert status(mesh, "structure")["explode"] == 1
    apart = picture(mesh)
    edge = np.concatenate([apart[0], apart[-1], apart[:, 0], apart[:, -1]])
    assert (edge == 255).all()  # nothing of it is cut off
    assert (together < 250).any(axis=2).sum() != (apart < 250).any(axis=2).sum()
    mesh.locator("#structure-form").select_option("surfaces")
    assert "walls stay" in mesh.locator(".row", has=mesh.locator("#structure-explode")).inner_text()


def test_T4_a_cell_tells_its_sheets_chords_and_block(mesh: Page, structure: hexalab.Structure) -> None:
    mesh.locator("#canvas").click(position={"x": 480, "y": 250})
    ui.until(lambda: mesh.locator(".inspector").is_visible())
    number = int(mesh.locator("#inspector-title").inner_text().split()[-1]) - 1  # Medit counts from 1
    words = mesh.locator(".inspector .cell-list", has_text="Sheets").inner_text()
    for sheet in structure.sheet_of_cells[:, number]:
        assert str(sheet) in words.split()
    block = str(structure.block_of_cells[number])
    mesh.locator(".inspector .cell-list button", has_text=block).last.click()
    assert status(mesh, "structure")["kind"] == "blocks"
    assert status(mesh, "structure")["chosen"] == [int(block)]
    mesh.keyboard.press("Escape")


def test_T4_tables_and_facts_leave_the_page(mesh: Page, structure: hexalab.Structure) -> None:
    look(mesh, "blocks")
    with mesh.expect_download() as csv:
        mesh.get_by_role("button", name="Table as CSV").click()
    lines = Path(csv.value.path()).read_text().splitlines()
    assert lines[0] == "number,cells,kind,i,j,k"
    assert len(lines) == 1 + structure.base_complex.count
    with mesh.expect_download() as facts:
        mesh.get_by_role("button", name="Facts as JSON").click()
    assert json.loads(Path(facts.value.path()).read_text()) == hexalab_facts(structure)


def hexalab_facts(structure: hexalab.Structure) -> dict[str, Any]:
    from hexalab.structure import facts_of

    found: dict[str, Any] = json.loads(json.dumps(facts_of(structure)))
    return found


def test_T5_saved_cells_carry_the_structure(mesh: Page, structure: hexalab.Structure, tmp_path: Path) -> None:
    ui.set_status(mesh, {"filters": {"structure": {"blocks": [3]}}})
    data = mesh.evaluate(
        """async () => {
            const { file } = await window.hexalab.cells("vtu", { structure: true });
            const bytes = new Uint8Array(await file.arrayBuffer());
            return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
        }"""
    )
    (tmp_path / "part.vtu").write_bytes(base64.b64decode(data))
    part = hexalab.read(tmp_path / "part.vtu")
    assert set(part.cell_data["block"]) == {3}
    rows = part.cell_data["original_cell"]
    assert np.array_equal(part.cell_data["sheet_1"], structure.sheet_of_cells[0, rows])


def test_T4_a_link_brings_the_same_look(mesh: Page) -> None:
    wanted = {"kind": "sheets", "chosen": [4, 7], "form": "surfaces", "curves": True}
    look(mesh, **wanted)
    told = mesh.evaluate("() => window.hexalab.getStatus()")
    mesh.evaluate("() => window.hexalab.reset()")
    assert status(mesh, "structure")["kind"] == "none"
    assert mesh.evaluate("status => window.hexalab.setStatus(status)", told) == []
    assert {name: status(mesh, "structure")[name] for name in wanted} == wanted


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_T4_the_panel_can_be_read_by_everybody(mesh: Page, scheme: str) -> None:
    mesh.emulate_media(color_scheme=scheme)  # type: ignore[arg-type]
    figure(mesh, "sheets").click()
    ui.until(lambda: mesh.locator(".pair-matrix canvas").is_visible())
    assert violations(mesh) == []
    mesh.emulate_media(color_scheme="light")


def test_T4_on_a_phone_nothing_sticks_out(mesh: Page) -> None:
    mesh.set_viewport_size({"width": 360, "height": 760})
    figure(mesh, "sheets").click()
    assert mesh.evaluate("() => document.documentElement.scrollWidth") <= 360
