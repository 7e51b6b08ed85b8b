"""What hands do to a page: drags that end elsewhere, runs of steps, numbers of the whole world, another screen."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from tests.browser import ui
from tests.browser.conftest import grid

MESH = grid(3, 3, 3)


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    """One viewer for all tests that leave it whole."""
    with ui.one_viewer(chromium, site) as page:
        ui.open_mesh(page, site, shelf, MESH, "hands.mesh")
        yield page


@pytest.fixture
def mesh(opened: Page) -> Page:
    ui.reset(opened)
    return opened


def test_V6_a_drag_ends_with_the_first_move_without_buttons(mesh: Page, site: str, shelf: Path) -> None:
    ui.open_mesh(mesh, site, shelf, MESH, "drag.mesh")
    x, y = ui.middle(mesh)
    fire = """([type, x, y, buttons]) => document.getElementById("canvas").dispatchEvent(
        new PointerEvent(type, { clientX: x, clientY: y, buttons, button: 0, pointerId: 1, pointerType: "mouse",
            bubbles: true }))"""
    mesh.evaluate("() => { document.getElementById('canvas').setPointerCapture = () => {} }")
    mesh.evaluate(fire, ["pointerdown", x, y, 1])
    mesh.evaluate(fire, ["pointermove", x + 40, y, 1])
    turned = ui.status(mesh)["camera"]
    mesh.evaluate(fire, ["pointermove", x + 80, y, 0])
    mesh.evaluate(fire, ["pointermove", x + 120, y, 0])
    assert ui.status(mesh)["camera"] == turned


def test_S2_turns_of_the_wheel_in_a_row_are_one_step_of_undo(mesh: Page) -> None:
    x, y = ui.middle(mesh)
    mesh.mouse.move(x, y)
    start = ui.status(mesh)["camera"]["distance"]
    for _ in range(3):
        mesh.mouse.wheel(0, -100)
    ui.until(lambda: ui.status(mesh)["camera"]["distance"] < start)
    mesh.wait_for_timeout(1000)
    middle = ui.status(mesh)["camera"]["distance"]
    mesh.mouse.wheel(0, -100)
    ui.until(lambda: ui.status(mesh)["camera"]["distance"] < middle)
    mesh.keyboard.press("Control+z")
    assert ui.status(mesh)["camera"]["distance"] == start
    mesh.keyboard.press("Control+Shift+z")
    assert ui.status(mesh)["camera"]["distance"] < middle


def test_V8_a_number_box_refuses_visibly_and_escape_restores(mesh: Page) -> None:
    ui.unfold(mesh)
    box = mesh.locator("#section-filters input.number").first
    box.scroll_into_view_if_needed()
    before = box.input_value()
    box.fill("much")
    box.press("Enter")
    assert box.get_attribute("aria-invalid") == "true" and box.input_value() == "much"
    box.press("Escape")
    assert box.get_attribute("aria-invalid") == "false" and box.input_value() == before
    box.fill("٠٫٥")
    box.press("Enter")
    assert box.input_value() == "0.500"
    whole = mesh.get_by_label("Peel, value")
    for typed, taken in (("0.37", "0"), ("1,4", "1")):
        whole.fill(typed)
        whole.press("Enter")
        assert whole.input_value() == taken
        assert ui.status(mesh)["filters"]["peel"]["depth"] == int(taken)


def test_V6_a_change_of_the_pixel_ratio_alone_draws_anew(chromium: Browser, site: str) -> None:
    """Chromium's emulation of another screen tells no page; so the page's question is answered here."""
    script = """
        const media = window.matchMedia.bind(window);
        window.asked = [];
        window.matchMedia = (query) => query.startsWith("(resolution") ? { addEventListener: (_, heard) => {
            window.asked.push({ query, heard });
        } } : media(query);
    """
    with ui.one_viewer(chromium, site, script) as page:
        ratio = (
            "() => document.getElementById('canvas').width / document.getElementById('canvas').clientWidth"
        )
        assert page.evaluate(ratio) == pytest.approx(1, abs=0.01)
        page.evaluate(
            """() => {
                Object.defineProperty(window, "devicePixelRatio", { value: 2 });
                window.asked.at(-1).heard();
            }"""
        )
        assert page.evaluate(ratio) == pytest.approx(2, abs=0.01)
        assert page.evaluate("() => window.asked.at(-1).query") == "(resolution: 2dppx)"


def test_V6_a_picture_without_height_has_no_numbers_that_are_none(mesh: Page) -> None:
    mesh.set_viewport_size({"width": 1280, "height": 1})
    canvas = mesh.locator("#canvas")
    canvas.evaluate("canvas => { canvas.style.height = '0px'; canvas.focus(); }")
    for key in ("Shift+ArrowUp", "ArrowLeft", "+"):
        mesh.keyboard.press(key)
    camera = ui.status(mesh)["camera"]
    canvas.evaluate("canvas => { canvas.style.height = '' }")
    mesh.set_viewport_size({"width": 1280, "height": 800})
    numbers = [camera["distance"], *camera["target"], *camera["direction"], *camera["up"]]
    assert all(isinstance(number, (int, float)) for number in numbers), numbers
