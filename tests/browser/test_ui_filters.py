"""Each filter's controls, driven by pointer and keyboard; what is drawn is what the core says, natively."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

import hexalab
from hexalab.filters import FilterStack
from hexalab.status import DEFAULTS, merge

from . import ui
from .conftest import grid

MESH = grid(5, 5, 5, noise=0.15)
CELLS = MESH.cell_count


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    with ui.one_viewer(chromium, site) as page:
        ui.open_mesh(page, site, shelf, MESH, "filters.mesh")
        yield page


@pytest.fixture
def mesh(opened: Page) -> Page:
    ui.reset(opened)
    return opened


def natively(page: Page) -> int:
    """How many cells the core shows under the page's status."""
    filters: dict[str, Any] = merge(DEFAULTS, ui.status(page))["filters"]
    stack = FilterStack(MESH, lambda quantity: hexalab.quality(MESH, quantity))
    return int(np.count_nonzero(stack.apply(filters)))


def test_F6_a_slow_gpu_draws_drafts_while_the_slice_is_held_and_the_whole_picture_after(
    mesh: Page, site: str, shelf: Path
) -> None:
    large = grid(36, 36, 36)
    hexalab.write(large, shelf / "large.mesh")
    mesh.evaluate("url => window.hexalab.open(url)", f"{site}/bench/large.mesh")
    ui.set_status(mesh, {"lighting": {"mode": "object_space_ao"}})
    mesh.evaluate("() => window.hexalab.settled()")
    box = mesh.locator("#slice").bounding_box()
    assert box
    y = box["y"] + box["height"] / 2
    mesh.mouse.move(box["x"] + 8, y)
    mesh.mouse.down()
    for step in range(8):
        mesh.mouse.move(box["x"] + box["width"] * (0.1 + 0.05 * step), y)
        mesh.wait_for_timeout(60)
    draft = mesh.evaluate("() => window.hexalab.drawn()")
    seen = Image.open(io.BytesIO(mesh.locator("#canvas").screenshot())).convert("L")
    mesh.mouse.up()
    grey = np.asarray(seen).astype(float)
    height, width = grey.shape
    middle = grey[2 * height // 5 : 3 * height // 5, width // 2 : 3 * width // 5]
    assert np.abs(np.diff(middle, axis=1)).mean() > 1  # edges are seen, though the core sent none
    assert draft["edges"] == 0
    assert 5000 < draft["faces"] < 6 * 36**2
    ui.until(lambda: mesh.evaluate("() => window.hexalab.drawn().edges") > 0)
    mesh.evaluate("() => window.hexalab.settled()")
    picture = "async () => (await window.hexalab.screenshot({ width: 300, height: 200 })).size"
    size = mesh.evaluate(picture)
    again = ui.status(mesh)
    ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}})
    ui.set_status(mesh, again)
    mesh.evaluate("() => window.hexalab.settled()")
    assert mesh.evaluate(picture) == size  # nothing is left of the draft
    ui.open_mesh(mesh, site, shelf, MESH, "filters.mesh")


def test_F6_the_slice_follows_the_pointer_while_it_is_dragged(mesh: Page) -> None:
    box = mesh.locator("#slice").bounding_box()
    assert box
    y = box["y"] + box["height"] / 2
    mesh.mouse.move(box["x"] + 8, y)
    mesh.mouse.down()
    counts = []
    for share in (0.25, 0.5, 0.75):
        mesh.mouse.move(box["x"] + box["width"] * share, y)
        mesh.wait_for_timeout(150)
        assert ui.status(mesh)["filters"]["planes"]["items"][0]["offset"] == pytest.approx(share, abs=0.06)
        counts.append(ui.drawn(mesh)[0])
        assert counts[-1] == natively(mesh)
    mesh.mouse.up()
    assert counts[0] > counts[1] > counts[2] > 0


def test_F1_typed_offset_axis_buttons_and_invert(mesh: Page) -> None:
    box = mesh.get_by_label("Slice, value")
    box.fill("0.4")
    box.press("Enter")
    mesh.get_by_role("button", name="Normal along Y").click()
    plane = ui.status(mesh)["filters"]["planes"]["items"][0]
    assert (plane["normal"], plane["offset"]) == ([0, 1, 0], 0.4)
    before = ui.drawn(mesh)[0]
    assert before == natively(mesh)
    mesh.get_by_role("button", name="Invert the plane").click()
    assert ui.drawn(mesh)[0] == CELLS - before


def test_F1_set_plane_from_view_snaps_with_shift_and_inverts_from_behind(mesh: Page) -> None:
    ui.set_status(mesh, {"camera": {"direction": [0.6, 0, -0.8]}})
    button = mesh.get_by_role("button", name="Set plane from view")
    button.click()
    assert ui.status(mesh)["filters"]["planes"]["items"][0]["normal"] == pytest.approx([0.6, 0, -0.8])
    button.click(modifiers=["Shift"])
    assert ui.status(mesh)["filters"]["planes"]["items"][0]["normal"] == [0, 0, -1]
    ui.set_status(mesh, {"camera": {"direction": [0.1, 0, 1]}})
    button.click()
    assert ui.status(mesh)["filters"]["planes"]["items"][0]["normal"] == [0, 0, 1]


def test_F1_typed_normal_several_planes_and_the_rule(mesh: Page) -> None:
    ui.unfold(mesh)
    mesh.get_by_label("Slice, value").fill("0.3")
    mesh.get_by_label("Slice, value").press("Enter")
    for axis, part in zip("xyz", "110", strict=True):
        mesh.get_by_label(f"Normal, {axis}").fill(part)
        mesh.get_by_label(f"Normal, {axis}").press("Enter")
    mesh.get_by_role("button", name="Add a plane").click()
    mesh.get_by_label("Slice, value").fill("0.5")
    mesh.get_by_label("Slice, value").press("Enter")
    planes = ui.status(mesh)["filters"]["planes"]
    assert [plane["offset"] for plane in planes["items"]] == [0.3, 0.5]
    assert planes["items"][0]["normal"] == [1, 1, 0]
    by_barycentre = ui.drawn(mesh)[0]
    assert by_barycentre == natively(mesh)
    mesh.locator("#plane-rule").select_option("any_corner")
    assert ui.drawn(mesh)[0] == natively(mesh) < by_barycentre
    mesh.get_by_role("button", name="Remove this plane").click()
    assert len(ui.status(mesh)["filters"]["planes"]["items"]) == 1


def test_F2_peel_hides_nothing_at_the_left_and_everything_at_the_right(mesh: Page) -> None:
    peel = mesh.locator("#peel")
    peel.focus()
    for key, expected in (("Home", 125), ("ArrowRight", 27), ("End", 0), ("ArrowLeft", 1)):
        peel.press(key)
        assert ui.drawn(mesh)[0] == natively(mesh) == expected
    assert "of 125" in mesh.locator("#status-line").inner_text()


def test_F3_quality_by_typed_native_value_band_and_hiding_the_bad(mesh: Page) -> None:
    values = hexalab.quality(MESH, "scaled_jacobian")
    bound = round(float(np.median(values)), 3)
    box = mesh.get_by_label("Quality, value")
    box.fill(str(bound))
    box.press("Enter")
    assert ui.drawn(mesh)[0] == np.count_nonzero(values <= bound)
    mesh.locator("#quality-keep").select_option("best")
    assert ui.drawn(mesh)[0] == np.count_nonzero(values >= bound)
    mesh.locator("#quality-keep").select_option("band")
    for name, value in (("minimum", bound - 0.05), ("maximum", bound + 0.05)):
        mesh.get_by_label(f"Quality, {name}").fill(str(value))
        mesh.get_by_label(f"Quality, {name}").press("Enter")
    inside = np.count_nonzero((values >= bound - 0.05) & (values <= bound + 0.05))
    assert ui.drawn(mesh)[0] == inside
    mesh.locator("#quality-keep").select_option("outside")
    assert ui.drawn(mesh)[0] == natively(mesh)


def test_F5_regularise_says_why_it_has_no_effect(mesh: Page) -> None:
    assert mesh.locator("#regularise-why").inner_text() or mesh.locator("#regularise-why").text_content()
    ui.set_status(mesh, {"filters": {"planes": {"items": [{"normal": [1, 0.4, 0.2], "offset": 0.5}]}}})
    assert not mesh.locator("#regularise-why").text_content()
    mesh.locator("#regularise").focus()
    mesh.locator("#regularise").press("ArrowRight")
    assert ui.status(mesh)["filters"]["regularisation"]["strength"] == 1
    assert ui.drawn(mesh)[0] == natively(mesh)


def test_F4_dig_undig_isolate_by_click_and_by_held_keys(mesh: Page) -> None:
    x, y = ui.middle(mesh)
    mesh.get_by_role("button", name="Dig", exact=True).click()
    mesh.mouse.click(x, y)
    ui.until(lambda: ui.shown(mesh) == CELLS - 1)
    first = ui.status(mesh)["filters"]["picking"]["hidden"]
    mesh.keyboard.press("Escape")
    mesh.keyboard.down("Control")
    mesh.mouse.click(x, y)
    mesh.keyboard.up("Control")
    ui.until(lambda: ui.shown(mesh) == CELLS - 2)
    second = [cell for cell in ui.status(mesh)["filters"]["picking"]["hidden"] if cell not in first]
    assert second[0] == first[0] - 1, "the second cell lies behind the first"
    mesh.keyboard.down("Shift")
    mesh.mouse.click(x, y)
    mesh.keyboard.up("Shift")
    ui.until(lambda: ui.shown(mesh) == CELLS - 1)
    assert ui.status(mesh)["filters"]["picking"]["hidden"] == first
    mesh.get_by_role("button", name="Isolate", exact=True).click()
    mesh.mouse.click(x, y)
    ui.until(lambda: ui.shown(mesh) == 1)
    mesh.keyboard.press("Control+z")
    ui.until(lambda: ui.shown(mesh) == CELLS - 1)
    mesh.keyboard.press("Control+Shift+Z")
    ui.until(lambda: ui.shown(mesh) == 1)


def test_F4_cells_by_number_and_what_is_no_cell(mesh: Page) -> None:
    ui.unfold(mesh)
    field = mesh.locator("#pick-hidden")
    field.fill("3, 10-12")
    field.press("Enter")
    assert ui.drawn(mesh)[0] == CELLS - 4
    field.fill("3, 500")
    field.press("Enter")
    assert "1 to 125" in field.evaluate("field => field.validationMessage")
    assert ui.status(mesh)["filters"]["picking"]["hidden"] == [2, 9, 10, 11], "Medit counts from 1"
    mesh.get_by_role("button", name="Clear what was picked").click()
    assert ui.drawn(mesh)[0] == CELLS


def test_F_each_filter_has_a_switch(mesh: Page) -> None:
    ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}})
    peeled = ui.shown(mesh)
    switch = mesh.get_by_role("checkbox", name="Peel on")
    switch.uncheck()
    assert ui.drawn(mesh)[0] == CELLS > peeled
    switch.check()
    assert ui.drawn(mesh)[0] == peeled


def test_F_the_switch_of_an_idle_row_can_be_clicked(mesh: Page) -> None:
    switch = mesh.get_by_label("Regularise on")
    switch.click(timeout=3000)
    ui.until(lambda: not ui.status(mesh)["filters"]["regularisation"]["enabled"])
    switch.click(timeout=3000)
    ui.until(lambda: ui.status(mesh)["filters"]["regularisation"]["enabled"])
