"""The first look at a mesh, and what the next one keeps: views, parts, history, the file opened last."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

import hexalab
from hexalab import Mesh
from hexalab.status.views import three_quarters

from . import ui
from .conftest import grid

LONG = grid(9, 3, 2)


def parts(*meshes: Mesh) -> Mesh:
    """Meshes as parts of one."""
    first = np.cumsum([0, *(mesh.vertex_count for mesh in meshes[:-1])])
    cells = [mesh.cells + at for mesh, at in zip(meshes, first, strict=True)]
    return Mesh.from_cells(np.concatenate([mesh.points for mesh in meshes]), np.concatenate(cells))


def moved(mesh: Mesh, *by: float) -> Mesh:
    return Mesh.from_cells(mesh.points + np.array(by), mesh.cells)


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str) -> Iterator[Page]:
    with ui.one_viewer(chromium, site, accept_downloads=True) as page:
        yield page


@pytest.fixture
def viewer(opened: Page) -> Page:
    opened.set_viewport_size({"width": 1280, "height": 800})
    opened.evaluate("() => window.hexalab.reset()")
    for button in opened.get_by_role("button", name="Dismiss this message").all():
        button.click()
    return opened


def canvas(page: Page) -> np.ndarray:
    """Picture and what lies over it as (height, width, 3) numbers from 0 to 255, once nothing moves."""
    page.evaluate("() => window.hexalab.settled()")
    with Image.open(io.BytesIO(page.locator("#canvas").screenshot())) as picture:
        return np.asarray(picture.convert("RGB")).astype(int)


def margins(page: Page, **size: int) -> list[int]:
    """Blank pixels at left, top, right and bottom of a picture."""
    alpha = page.evaluate(
        """async (size) => {
            const bitmap = await createImageBitmap(await window.hexalab.screenshot({ ...size, transparent: true }));
            const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
            const pen = canvas.getContext("2d");
            pen.drawImage(bitmap, 0, 0);
            const { data } = pen.getImageData(0, 0, bitmap.width, bitmap.height);
            return [...data].filter((_, k) => k % 4 === 3);
        }""",
        size,
    )
    drawn = np.array(alpha).reshape(size["height"], size["width"]) > 0
    rows, columns = np.flatnonzero(drawn.any(axis=1)), np.flatnonzero(drawn.any(axis=0))
    return [columns[0], rows[0], size["width"] - 1 - columns[-1], size["height"] - 1 - rows[-1]]


@pytest.mark.parametrize("size", [(400, 300), (200, 500), (600, 150)])
def test_V6_a_mesh_opens_whole_and_fills_any_shape(viewer: Page, site: str, shelf: Path, size: Any) -> None:
    ui.open_mesh(viewer, site, shelf, LONG, "long.mesh")
    ui.unfold(viewer)
    camera = ui.status(viewer)["camera"]
    assert camera["fit"] is True
    assert tuple(camera["direction"]) == three_quarters([9, 3, 2]).direction
    for view in (None, "View from front", "View from top", "View from right"):
        if view:
            viewer.get_by_role("button", name=view).click()
        left, top, right, bottom = margins(viewer, width=size[0], height=size[1])
        tight = min((left + right) / size[0], (top + bottom) / size[1])
        assert 0.03 < tight < 0.09, f"{view}: {(left, top, right, bottom)}"
        assert abs(left - right) < 0.02 * size[0] + 2 and abs(top - bottom) < 0.02 * size[1] + 2


def test_F1_the_first_slice_faces_the_eye(viewer: Page, site: str, shelf: Path) -> None:
    ui.open_mesh(viewer, site, shelf, LONG, "long.mesh")
    status = ui.status(viewer)
    (plane,) = status["filters"]["planes"]["items"]
    assert plane["offset"] == 0
    assert np.dot(plane["normal"], status["camera"]["direction"]) > 0.4
    viewer.get_by_label("Slice, value").fill("0.5")
    viewer.get_by_label("Slice, value").press("Enter")
    ui.until(lambda: 0 < ui.shown(viewer) < 54)


def test_C4_a_mesh_of_the_catalogue_opens_as_its_portrait_shows_it(viewer: Page) -> None:
    catalogue = viewer.evaluate("() => fetch('../catalogue.json').then((answer) => answer.json())")
    address, mesh = next(
        (f"{source['slug']}/{mesh['slug']}", mesh)
        for source in catalogue["sources"]
        for mesh in source["meshes"]
        if "view" in mesh and not mesh.get("remote") and mesh["cells"] > 10
    )
    viewer.evaluate("id => window.hexalab.open(id)", address)
    status = ui.status(viewer)
    for name, part in mesh["view"].items():
        assert {key: status[name][key] for key in part if key != "planes"} == {
            key: value for key, value in part.items() if key != "planes"
        }
    assert status["filters"]["planes"]["items"] == mesh["view"]["filters"]["planes"]["items"]


def test_S1_the_view_is_kept_once_it_was_changed_and_that_is_said(
    viewer: Page, site: str, shelf: Path
) -> None:
    ui.open_mesh(viewer, site, shelf, LONG, "long.mesh")
    ui.open_mesh(viewer, site, shelf, grid(3, 9, 2), "other.mesh")
    assert ui.messages(viewer) == ""
    assert tuple(ui.status(viewer)["camera"]["direction"]) == three_quarters([3, 9, 2]).direction
    viewer.locator("#canvas").focus()
    viewer.keyboard.press("ArrowRight")
    ui.until(lambda: ui.status(viewer)["camera"]["fit"] is False)
    direction = ui.status(viewer)["camera"]["direction"]
    ui.open_mesh(viewer, site, shelf, LONG, "long.mesh")
    assert ui.status(viewer)["camera"]["direction"] == direction
    assert "was kept" in ui.messages(viewer)
    viewer.get_by_role("button", name="reset", exact=True).click()
    ui.until(lambda: ui.status(viewer)["camera"]["fit"])
    assert ui.messages(viewer) == ""


def test_S1_a_switch_keeps_the_view_never(viewer: Page, site: str, shelf: Path) -> None:
    ui.open_mesh(viewer, site, shelf, LONG, "long.mesh")
    ui.unfold(viewer)
    viewer.locator("#keeping").select_option("never")
    ui.set_status(viewer, {"filters": {"peel": {"depth": 1}}})
    ui.open_mesh(viewer, site, shelf, LONG, "again.mesh")
    assert ui.status(viewer)["filters"]["peel"]["depth"] == 0
    viewer.locator("#keeping").select_option("changed")


def test_V6_a_stray_cell_does_not_hide_the_mesh(viewer: Page, site: str, shelf: Path) -> None:
    body = moved(LONG, 500_000, 4_500_000, 100)
    ui.open_mesh(viewer, site, shelf, parts(body, grid(1, 1, 1)), "map.mesh")
    assert "opens on the largest part, 54 cells" in ui.messages(viewer)
    assert min(margins(viewer, width=300, height=200)) < 20
    viewer.get_by_role("button", name="fit everything").click()
    ui.until(lambda: not ui.status(viewer)["camera"]["fit"])
    assert ui.status(viewer)["camera"]["distance"] > 1000


def test_V6_what_is_shown_is_fitted_by_key_button_and_double_click(
    viewer: Page, site: str, shelf: Path
) -> None:
    ui.open_mesh(viewer, site, shelf, LONG, "long.mesh")
    ui.set_status(viewer, {"filters": {"picking": {"isolated": True, "shown": [0]}}})
    far = ui.status(viewer)["camera"]

    def near() -> bool:
        camera = ui.status(viewer)["camera"]
        return not camera["fit"] and camera["distance"] < 0.6

    viewer.locator("#canvas").focus()
    for act in (
        lambda: viewer.keyboard.press("."),
        lambda: viewer.locator(".fit-button").click(),
        lambda: viewer.mouse.dblclick(340, 760),
    ):
        ui.set_status(viewer, {"camera": {"fit": True, "direction": far["direction"]}})
        act()
        ui.until(near)
    viewer.keyboard.press("Control+z")


def test_R9_parts_are_listed_coloured_hidden_and_shown_alone(viewer: Page, site: str, shelf: Path) -> None:
    mesh = parts(grid(1, 1, 1), moved(grid(2, 2, 2), 5, 0, 0), moved(grid(3, 1, 1), 0, 4, 0))
    ui.open_mesh(viewer, site, shelf, mesh, "parts.mesh")
    facts = viewer.locator(".first-facts").inner_text()
    assert "Parts\n3" in facts and "Inverted cells\nnone" in facts and "Extent" in facts
    ui.unfold(viewer)
    rows = viewer.locator(".parts .category-count")
    assert rows.all_inner_texts() == ["8 cells", "3 cells", "1 cell"]
    viewer.get_by_label("Part 1 shown").uncheck()
    ui.until(lambda: ui.shown(viewer) == 4)
    viewer.get_by_role("button", name="Show Part 1 only").click()
    ui.until(lambda: ui.shown(viewer) == 8)
    viewer.get_by_role("button", name="Colour by part").click()
    ui.until(lambda: ui.status(viewer)["colour"]["by"] == "part")
    viewer.get_by_role("button", name="Show all").click()
    ui.until(lambda: ui.shown(viewer) == 12)


def test_V9_back_opens_the_mesh_before_with_its_settings(viewer: Page, site: str, shelf: Path) -> None:
    ui.open_mesh(viewer, site, shelf, LONG, "long.mesh")
    ui.set_status(viewer, {"filters": {"peel": {"depth": 1}}})
    ui.open_mesh(viewer, site, shelf, grid(2, 2, 2), "two.mesh")
    ui.set_status(viewer, {"filters": {"peel": {"depth": 0}}})
    viewer.go_back()
    ui.until(lambda: ui.summary(viewer).get("name") == "long.mesh")
    ui.until(lambda: ui.status(viewer)["filters"]["peel"]["depth"] == 1)
    viewer.go_forward()
    ui.until(lambda: ui.summary(viewer).get("name") == "two.mesh")
    ui.until(lambda: ui.status(viewer)["filters"]["peel"]["depth"] == 0)


def test_V9_after_a_reload_the_last_file_is_offered_with_its_settings(
    chromium: Browser, site: str, tmp_path: Path
) -> None:
    hexalab.write(LONG, tmp_path / "mine.mesh")
    with ui.one_viewer(chromium, site) as page:
        page.set_input_files("#file", tmp_path / "mine.mesh")
        ui.until(lambda: ui.summary(page).get("name") == "mine.mesh")
        ui.set_status(page, {"silhouette": 0.25})
        page.wait_for_timeout(900)
        page.reload()
        again = page.get_by_role("button", name="Open mine.mesh again")
        again.click()
        ui.until(lambda: ui.summary(page).get("name") == "mine.mesh", 60)
        ui.until(lambda: ui.status(page)["silhouette"] == 0.25)
        ui.unfold(page)
        page.locator("#remember").uncheck()
        page.wait_for_timeout(300)
        page.reload()
        page.evaluate("() => window.hexalab.ready")
        assert not again.is_visible()


def test_Q3_the_worst_cells_are_walked_by_arrow_keys_and_outlined(
    viewer: Page, site: str, shelf: Path
) -> None:
    mesh = grid(5, 4, 3, noise=0.25)
    ui.open_mesh(viewer, site, shelf, mesh, "worst.mesh")
    ui.unfold(viewer)
    order = np.argsort(hexalab.quality(mesh, "scaled_jacobian"), kind="stable") + 1  # Medit counts from 1
    buttons = viewer.locator(".worst button")
    ui.until(lambda: buttons.count() > 10)
    assert buttons.all_inner_texts()[:10] == [str(cell) for cell in order[:10]]
    buttons.first.click()
    ui.until(lambda: viewer.locator("#inspector-title").inner_text() == f"Cell {order[0]}")
    ui.until(lambda: viewer.locator(".cell-label").is_visible())
    assert viewer.locator(".cell-label").inner_text().startswith(f"{order[0]} · SJ")
    viewer.keyboard.press("ArrowDown")
    ui.until(lambda: viewer.locator("#inspector-title").inner_text() == f"Cell {order[1]}")
    label = viewer.locator(".cell-label").bounding_box()
    inspector = viewer.locator(".inspector").bounding_box()
    assert label and inspector and label["x"] + label["width"] < inspector["x"]
    viewer.get_by_role("button", name="Cut to it").click()
    ui.until(lambda: ui.shown(viewer) < 60)
    with viewer.expect_download() as waiting:
        viewer.get_by_role("button", name="List as CSV").click()
    lines = Path(waiting.value.path()).read_text().splitlines()
    assert lines[0] == "cell,scaled_jacobian,x,y,z"
    assert [int(line.split(",")[0]) for line in lines[1:6]] == order[:5].tolist()
    with viewer.expect_download() as waiting:
        viewer.get_by_role("button", name="All values as CSV").click()
    rows = Path(waiting.value.path()).read_text().splitlines()
    assert rows[0] == "cell,scaled_jacobian"
    values = [float(row.split(",")[1]) for row in rows[1:]]
    assert values == pytest.approx(hexalab.quality(mesh, "scaled_jacobian").tolist(), abs=1e-12)
    viewer.keyboard.press("Escape")
    ui.until(lambda: not viewer.locator(".cell-label").is_visible())


def test_Q3_the_outline_has_a_light_rim_on_dark_cells(viewer: Page, site: str, shelf: Path) -> None:
    ui.open_mesh(viewer, site, shelf, grid(3, 3, 3), "dark.mesh")
    dark = {"colour": {"by": "quality", "map": "parula"}, "lighting": {"mode": "direct"}}
    ui.set_status(viewer, {**dark, "background": "#000000"})
    viewer.mouse.click(*ui.middle(viewer))
    label = viewer.locator(".cell-label")
    ui.until(label.is_visible)
    picture = canvas(viewer)
    box, whole = label.bounding_box(), viewer.locator("#canvas").bounding_box()
    assert box and whole
    left, top = int(box["x"] - whole["x"]), int(box["y"] - whole["y"])
    picture[top - 1 : top + int(box["height"]) + 2, left - 1 : left + int(box["width"]) + 2] = 0
    ink = np.abs(picture - [0x0B, 0x6E, 0x74]).max(axis=2) < 12
    light = picture.min(axis=2) > 200
    beside = np.zeros_like(light)
    for across in range(-4, 5):
        for down in range(-4, 5):
            beside |= np.roll(light, (down, across), (0, 1))
    assert ink.sum() > 300
    assert (ink & beside).sum() > 0.9 * ink.sum()


def test_V8_on_a_small_screen_name_and_inspector_leave_the_picture_free(
    viewer: Page, site: str, shelf: Path
) -> None:
    viewer.set_viewport_size({"width": 360, "height": 740})
    ui.open_mesh(viewer, site, shelf, grid(3, 3, 3), "a name in sight.mesh")
    name = viewer.locator("#mesh-name")
    assert name.inner_text() == "a name in sight.mesh"
    viewer.mouse.click(*ui.middle(viewer))
    inspector = viewer.locator(".inspector")
    ui.until(inspector.is_visible)
    boxes = [element.bounding_box() for element in (name, viewer.locator("#canvas"), inspector)]
    tops, heights = zip(*((box["y"], box["height"]) for box in boxes if box), strict=True)
    assert tops[0] + heights[0] <= tops[1]
    assert tops[1] + heights[1] <= tops[2]
    assert tops[2] + heights[2] == 740
    for width, in_a_line in ((320, True), (480, True), (600, False)):
        viewer.set_viewport_size({"width": width, "height": 740})
        assert name.is_visible() is in_a_line
        assert viewer.evaluate("() => document.documentElement.scrollWidth") == width


def test_R10_a_file_that_is_neither_mesh_nor_settings_hears_what_is_read(viewer: Page) -> None:
    for name, text, words in (
        ("notes.csv", "a,b", "Read are meshes, settings"),
        ("notes.txt", "hello", "Read are meshes, settings"),
        ("package.json", json.dumps({"name": "x"}), "holds no settings of HexaLab: found name"),
    ):
        ui.drop(viewer, (name, text))
        ui.until(lambda words=words, name=name: name in ui.messages(viewer) and words in ui.messages(viewer))
