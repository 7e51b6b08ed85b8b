"""The page as a whole: sizes, schemes, keyboard, screen readers, catalogue, embedding, a browser without WebGL 2."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser, Page

import hexalab

from . import ui
from .conftest import grid

ROOT = Path(__file__).parents[2]
AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
MESH = grid(4, 4, 4, noise=0.1)


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    with ui.one_viewer(chromium, site, script=AXE.read_text()) as page:
        ui.open_mesh(page, site, shelf, MESH, "page.mesh")
        yield page


@pytest.fixture
def mesh(opened: Page) -> Page:
    opened.set_viewport_size({"width": 1280, "height": 800})
    ui.reset(opened)
    return opened


def violations(page: Page) -> list[str]:
    """What axe-core finds wrong."""
    found = page.evaluate("() => axe.run(document, { resultTypes: ['violations'] })")["violations"]
    return [f"{one['id']}: {[node['html'] for node in one['nodes']]}" for one in found]


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [(1280, 800), (360, 740)])
def test_V8_axe_finds_nothing(mesh: Page, scheme: Any, size: tuple[int, int]) -> None:
    mesh.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    mesh.set_viewport_size({"width": size[0], "height": size[1]})
    ui.unfold(mesh)
    band = {"quantity": "scaled_jacobian", "keep": "inside", "minimum": 0.1, "maximum": 0.99}
    ui.set_status(mesh, {"filters": {"quality": {"items": [band]}}, "colour": {"by": "quality"}})
    mesh.mouse.click(*ui.middle(mesh))
    ui.drop(mesh, ("broken.vtk", "nonsense"))
    ui.until(lambda: "broken.vtk" in ui.messages(mesh))
    assert violations(mesh) == []
    for name in ("Share", "Image", "Save", "Help"):
        button = mesh.locator("#bar").get_by_role("button", name=name, exact=True)
        box = button.bounding_box()
        assert box and box["x"] + box["width"] <= size[0], f"{name} stands in the window"
        button.click()
        assert violations(mesh) == [], name
        mesh.keyboard.press("Escape")
    mesh.get_by_role("button", name="Dismiss this message").click()


def test_V8_slice_separation_and_metric_stand_without_scrolling_at_800_px(mesh: Page) -> None:
    mesh.evaluate("() => { localStorage.clear(); }")
    mesh.evaluate("() => { document.getElementById('panel').scrollTop = 0; }")
    mesh.evaluate(
        """() => {
            for (const fold of document.querySelectorAll('.row-fold[aria-expanded="true"]')) fold.click();
        }"""
    )
    for control in ("#slice", "#separation", "#metric"):
        box = mesh.locator(control).bounding_box()
        assert box
        assert box["y"] + box["height"] <= 800, control


@pytest.mark.parametrize("width", [360, 720, 1280, 3840])
def test_V8_nothing_is_wider_than_the_window(mesh: Page, width: int) -> None:
    mesh.set_viewport_size({"width": width, "height": 740})
    mesh.wait_for_timeout(200)
    wide = mesh.evaluate(
        """() => [...document.querySelectorAll("body *")].filter((one) => {
            const box = one.getBoundingClientRect();
            return box.width > 0 && box.right > innerWidth + 1 && !one.closest("svg");
        }).map((one) => one.outerHTML.slice(0, 80))"""
    )
    assert wide == []
    canvas = mesh.locator("#canvas").bounding_box()
    assert canvas
    assert canvas["height"] > 250
    assert mesh.evaluate("() => document.scrollingElement.scrollHeight") <= 740
    if width < 720:
        rows = mesh.locator(".row:visible").evaluate_all("rows => rows.map((row) => row.offsetHeight)")
        assert min(rows) >= 44, "rows are as high as a thumb"


def test_V8_the_whole_panel_is_reached_by_tab_and_every_control_has_a_name(mesh: Page) -> None:
    mesh.locator(".wordmark").focus()
    names: list[str] = []
    for _ in range(80):
        mesh.keyboard.press("Tab")
        names.append(
            mesh.evaluate(
                "() => { const e = document.activeElement; return e.id || e.ariaLabel || e.innerText; }"
            )
        )
    for wanted in ("canvas", "slice", "peel", "separation", "colour-by", "metric"):
        assert wanted in names, wanted
    ui.unfold(mesh)
    assert not mesh.evaluate(
        """() => [...document.querySelectorAll("input, select, button")].filter((one) =>
            !(one.ariaLabel || one.labels?.length || one.innerText || one.title)).map((one) => one.outerHTML)"""
    )


def test_V8_keys_act_and_the_sheet_lists_them(mesh: Page) -> None:
    mesh.locator("#canvas").focus()
    for key, path, value in (
        ("e", ("separation", "mode"), "darkness_coded_edges"),
        ("c", ("colour", "by"), "quality"),
        ("5", ("camera", "projection"), "orthographic"),
        ("7", ("camera", "direction"), [0, -1, 0]),
        ("i", ("irregular", "mode"), 2),
        ("q", ("lighting", "mode"), "object_space_ao"),
    ):
        mesh.keyboard.press(key)
        section, name = path
        assert ui.status(mesh)[section][name] == value, key
    mesh.keyboard.press("Enter")
    assert ui.status(mesh)["camera"]["projection"] == "perspective"
    mesh.keyboard.press("?")
    assert mesh.locator("#help").is_visible()
    mesh.keyboard.press("e")
    assert ui.status(mesh)["separation"]["mode"] == "darkness_coded_edges", "a dialog keeps its keys"
    mesh.keyboard.press("Escape")
    box = mesh.get_by_label("Slice, value")
    box.focus()
    mesh.keyboard.type("5e-1")
    mesh.keyboard.press("Enter")
    assert ui.status(mesh)["camera"]["projection"] == "perspective", "a text field keeps its keys"
    assert ui.status(mesh)["filters"]["planes"]["items"][0]["offset"] == 0.5


def test_V8_the_picture_has_a_text_equivalent(mesh: Page) -> None:
    ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}})
    words = mesh.locator("#picture-in-words").text_content() or ""
    assert "page.mesh: 64 hexahedra." in words
    assert "8 of 64 cells shown, 24 faces." in words
    values = hexalab.quality(MESH, "scaled_jacobian")
    assert f"from {values.min():.3f} to {values.max():.3f}, mean {values.mean():.3f}" in words


def test_V6_a_drag_on_the_picture_turns_it_and_is_one_step_of_undo(mesh: Page) -> None:
    before = ui.status(mesh)["camera"]
    x, y = ui.middle(mesh)
    mesh.mouse.move(x, y)
    mesh.mouse.down()
    mesh.mouse.move(x + 90, y + 30, steps=6)
    mesh.mouse.up()
    ui.until(lambda: ui.status(mesh)["camera"]["direction"] != before["direction"])
    mesh.keyboard.press("Control+z")
    assert ui.status(mesh)["camera"] == before


def test_R9_a_finding_shows_its_cells(mesh: Page, site: str, shelf: Path) -> None:
    broken = grid(4, 4, 4)
    points = broken.points.copy()
    inner = int(np.flatnonzero((points == [2, 2, 2]).all(axis=1))[0])
    points[inner] = [0.2, 0.2, 0.2]
    bad = hexalab.Mesh.from_cells(points, broken.cells)
    ui.open_mesh(mesh, site, shelf, bad, "broken.mesh")
    finding = next(one for one in hexalab.diagnose(bad) if len(one.cells))
    mesh.get_by_role("button", name=f"Show: {finding.message}").click()
    ui.until(lambda: ui.shown(mesh) == len(finding.cells))
    assert ui.status(mesh)["filters"]["picking"]["shown"] == sorted(finding.cells.tolist())
    mesh.keyboard.press("Control+z")
    ui.until(lambda: ui.shown(mesh) == 64)
    ui.open_mesh(mesh, site, shelf, MESH, "page.mesh")


def test_a_fold_is_remembered(mesh: Page) -> None:
    before = mesh.evaluate("() => document.getElementById('section-structure').open")
    mesh.locator("#section-structure > summary").click()
    remembered = "() => JSON.parse(localStorage['hexalab.sections'] ?? '{}').structure"
    ui.until(lambda: mesh.evaluate(remembered) is not before)


def test_C4_the_catalogues_panel_opens_a_mesh_with_its_reference(page: Page, site: str) -> None:
    index = json.loads((ROOT / "build" / "site" / "catalogue.json").read_text())
    source = next(one for one in index["sources"] if any(not row["remote"] for row in one["meshes"]))
    row = min((row for row in source["meshes"] if not row["remote"]), key=lambda row: row["cells"])
    page.goto(f"{site}/viewer/")
    page.locator("#catalogue-source").select_option(source["slug"])
    if len(source["meshes"]) > 1:
        page.locator("#catalogue-mesh").select_option(row["slug"])
    ui.until(lambda: ui.summary(page).get("findings") is not None, 60)
    assert ui.summary(page)["cells"] == row["cells"]
    assert page.locator(".bar-mesh").inner_text() == row["name"]
    assert f"?mesh={source['slug']}/{row['slug']}" in page.url
    page.get_by_role("button", name="cite").click()
    assert source["title"] in page.locator("#citation").inner_text()


def test_O2_a_catalogue_mesh_stands_before_python_is_ready(page: Page, site: str) -> None:
    index = json.loads((ROOT / "build" / "site" / "catalogue.json").read_text())
    found = [(one, row) for one in index["sources"] for row in one["meshes"] if row.get("preview")]
    if not found:
        pytest.skip("the site was built without previews")
    source, row = found[0]
    page.goto(f"{site}/viewer/?mesh={source['slug']}/{row['slug']}")
    ui.until(lambda: page.evaluate("() => window.hexalab?.drawn().faces") or 0, 30)
    assert page.evaluate("() => window.hexalab.timings().boot") is None
    page.evaluate("() => window.hexalab.ready")
    ui.until(lambda: ui.summary(page).get("findings") is not None)
    assert ui.summary(page)["cells"] == row["cells"]


def test_V9_without_webgl_the_tables_stand(chromium: Browser, site: str, shelf: Path) -> None:
    script = "HTMLCanvasElement.prototype.getContext = () => null;"
    hexalab.write(MESH, shelf / "blind.mesh")
    context = chromium.new_context()
    page = context.new_page()
    page.add_init_script(script)
    page.goto(f"{site}/viewer/?mesh={site}/bench/blind.mesh")
    ui.until(lambda: ui.summary(page).get("findings") is not None, 60)
    ui.until(lambda: page.locator(".digest-line dd").count() == 3)
    assert "WebGL 2" in ui.messages(page)
    assert "64 of 64 cells shown" in page.locator("#status-line").inner_text()
    context.close()
