"""The portrait of a published mesh stands in for it while its file is fetched (SPEC C8)."""

from __future__ import annotations

import io
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

from site_builder.pictures.shot import packed
from tests.browser import ui
from tests.browser.faraway import Faraway, faraway_below
from tests.browser.visits import CONTROLLED, visitor

FEW = 4
"""Pixels that the body may move by when the mesh takes the portrait's place."""


@pytest.fixture(scope="module")
def far(tmp_path_factory: pytest.TempPathFactory, chromium: Browser) -> Iterator[Faraway]:
    with faraway_below(tmp_path_factory.mktemp("far"), chromium) as faraway:
        yield faraway


@pytest.fixture
def away(far: Faraway) -> Faraway:
    """Its host waits before it sends the rest."""
    far.host.go.clear()
    return far


def shown(page: Page) -> bool:
    return page.locator(".portrait-on").count() == 1


def under_way(page: Page) -> bool:
    """Whether the portrait stands, and some bytes have come."""
    return shown(page) and " of " in page.locator(".progress-text").inner_text()


def gone(page: Page) -> bool:
    hidden: bool = page.locator(".portrait").evaluate(
        "(one) => getComputedStyle(one).visibility === 'hidden'"
    )
    return hidden


def body(page: Page) -> np.ndarray:
    """Left, top, right and bottom of what is drawn on the canvas or lies over it, where no control does."""
    whole = page.locator("#canvas").bounding_box()
    assert whole
    with Image.open(io.BytesIO(page.screenshot(clip=whole))) as picture:
        pixels = np.asarray(picture.convert("RGB")).astype(int)
    drawn = np.abs(pixels - 255).max(axis=2) > 6
    drawn[:44, :] = False  # progress
    drawn[-140:, -120:] = False  # axes, and the button that fits
    rows, columns = np.flatnonzero(drawn.any(axis=1)), np.flatnonzero(drawn.any(axis=0))
    return np.array([columns[0], rows[0], columns[-1], rows[-1]])


def drag(page: Page) -> None:
    x, y = ui.middle(page)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y + 20, steps=4)
    page.mouse.up()


def choose(page: Page, mesh: str) -> None:
    """In the panel, out of the source "far"."""
    page.locator("#catalogue-source").select_option("far")
    page.locator("#catalogue-mesh").select_option(mesh)


@pytest.mark.parametrize("size", [(1280, 800), (360, 740)])
@pytest.mark.parametrize("motion", ["no-preference", "reduce"])
def test_C8_the_portrait_goes_over_into_the_mesh(
    chromium: Browser, away: Faraway, size: tuple[int, int], motion: Any
) -> None:
    window = {"width": size[0], "height": size[1]}
    with visitor(chromium, viewport=window, reduced_motion=motion, service_workers="block") as (_, page):
        page.goto(away.viewer("bar"))
        ui.until(lambda: under_way(page))
        assert page.get_by_role("img", name="Bar, a picture. A. One").is_visible()
        assert page.locator("#mesh-name").inner_text() == "Bar"
        assert page.evaluate("() => window.hexalab.summary()") is None
        drag(page)
        page.get_by_text("View and light").click()
        before = body(page)

        away.host.go.set()
        ui.until(lambda: gone(page))
        page.evaluate("() => window.hexalab.settled()")
        assert np.abs(body(page) - before).max() <= FEW
        status = ui.status(page)
        for name, part in away.view.items():
            for key in part.keys() - {"planes"}:
                assert status[name][key] == part[key]
        assert status["filters"]["planes"]["items"] == away.view["filters"]["planes"]["items"]
        still = page.locator(".portrait").evaluate("(one) => getComputedStyle(one).transitionDuration")
        assert (set(still.split(", ")) == {"0s"}) == (motion == "reduce")
        drag(page)
        ui.until(lambda: ui.status(page)["camera"]["direction"] != away.view["camera"]["direction"])


def test_C8_a_mesh_that_can_not_be_fetched_leaves_its_portrait(chromium: Browser, away: Faraway) -> None:
    with visitor(chromium, service_workers="block") as (_, page):
        page.goto(away.viewer("gone"))
        ui.until(lambda: "could not be fetched" in page.locator(".messages").inner_text())
        assert "404" in ui.messages(page)
        ui.until(lambda: shown(page))
        assert not page.get_by_text("Drop a hexahedral mesh anywhere").is_visible()
        page.evaluate("() => window.hexalab.open('shapes/cube')")
        ui.until(lambda: gone(page))
        assert ui.messages(page) == ""


def test_C8_an_open_mesh_stays_in_its_place_until_the_other_is_there(
    chromium: Browser, away: Faraway
) -> None:
    with visitor(chromium, service_workers="block") as (_, page):
        page.goto(f"{away.site}viewer/?mesh=shapes/cube")
        page.evaluate("() => window.hexalab.ready")
        ui.until(lambda: ui.summary(page).get("cells") == 512 and ui.shown(page) > 0)
        choose(page, "gone")
        ui.until(lambda: "404" in ui.messages(page) and gone(page))
        assert page.locator(".bar-mesh").inner_text() == "Cube"
        choose(page, "bar")
        ui.until(lambda: under_way(page))
        aside, canvas = (page.locator(one).bounding_box() for one in (".portrait", "#canvas"))
        assert aside and canvas
        assert aside["width"] < canvas["width"] / 4
        assert page.locator(".bar-mesh").inner_text() == "Cube"
        direction = ui.status(page)["camera"]["direction"]
        drag(page)
        ui.until(lambda: ui.status(page)["camera"]["direction"] != direction)
        away.host.go.set()
        ui.until(lambda: page.locator(".bar-mesh").inner_text() == "Bar" and gone(page))


def test_C8_under_settings_of_the_address_no_other_view_is_promised(chromium: Browser, away: Faraway) -> None:
    with visitor(chromium, service_workers="block") as (_, page):
        page.goto(f"{away.viewer('bar')}#status={packed({'silhouette': 0.5})}")
        ui.until(lambda: " of " in page.locator(".progress-text").inner_text())
        assert not shown(page)
        away.host.go.set()
        ui.until(lambda: ui.summary(page).get("cells") == 84)
        ui.until(lambda: ui.status(page)["silhouette"] == 0.5)


def test_C8_without_a_network_a_portrait_that_was_seen_is_there(chromium: Browser, away: Faraway) -> None:
    with visitor(chromium) as (context, page):
        page.goto(f"{away.site}viewer/")
        page.evaluate(CONTROLLED)
        page.goto(away.viewer("bar"))
        ui.until(lambda: under_way(page))
        context.set_offline(True)
        page.goto(away.viewer("bar"))
        ui.until(lambda: shown(page))
        ui.until(lambda: "there is no network" in page.locator(".messages").inner_text())
        assert shown(page)
