"""A page of one file (SPEC A7); truth: the viewer's own picture."""

from __future__ import annotations

import io
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

import hexalab

from .. import grouped
from ..test_ui_page import AXE, violations
from ..ui import until
from .asking import HALF, OPEN, PLAIN, put, take

pytestmark = pytest.mark.browser


def opened(chromium: Browser, path: Path, **context: Any) -> Page:
    """A page from the disk, without a network; what it reports on the console is kept in `told`."""
    page = chromium.new_context(viewport={"width": 1000, "height": 700}, offline=True, **context).new_page()
    told: list[str] = []
    page.on("console", lambda message: told.append(message.text))
    page.on("pageerror", lambda error: told.append(str(error)))
    page.told = told  # type: ignore[attr-defined]
    page.goto(path.as_uri())
    return page


def ready(page: Page) -> None:
    until(lambda: page.evaluate("() => 'ready' in document.documentElement.dataset"))


def pixels(page: Page) -> np.ndarray:
    picture = Image.open(io.BytesIO(page.locator("#canvas").screenshot())).convert("RGB")
    return np.asarray(picture).astype(int)


LOOKS = {
    "lines": {"silhouette": 0.5, "irregular": {"mode": 3, "boundary": True}},
    "rounded": {"separation": {"mode": "rounded"}, "colour": {"by": "quality", "metric": "volume"}},
    "seen through": {
        "separation": {"mode": "fissure"},
        "see_through": {"cells": "all"},
        "lighting": {"mode": "direct"},
    },
}


@pytest.mark.parametrize("look", LOOKS)
def test_A7_the_page_shows_what_the_viewer_shows(
    viewer: Page, chromium: Browser, tmp_path: Path, look: str
) -> None:
    put(viewer, OPEN, LOOKS[look])
    compare(viewer, chromium, tmp_path)


def test_A7_the_page_has_the_arrows_of_each_slice(viewer: Page, chromium: Browser, tmp_path: Path) -> None:
    viewer.evaluate("() => window.hexalab.openOffered('1')")
    try:
        put(viewer, OPEN)
        bare = compare(viewer, chromium, tmp_path)
        put(viewer, {"arrows": {"attribute": "cell:flow", "length": 0.2, "colour": "#c00000"}})
        assert (np.abs(compare(viewer, chromium, tmp_path) - bare).max(axis=2) > 60).sum() > 1000
    finally:
        viewer.evaluate("() => window.hexalab.openOffered('0')")


def test_R12_the_page_has_marks_and_groups_and_tells_the_files_numbers(
    viewer: Page, chromium: Browser, tmp_path: Path
) -> None:
    viewer.evaluate("() => window.hexalab.openOffered('2')")
    try:
        put(viewer, OPEN)
        bare = compare(viewer, chromium, tmp_path)
        marks = {"nodes": ["nset:FIXED"], "sharp_angle": 60, "interfaces": "material"}
        put(viewer, {"marks": marks, "colour": {"by": "group"}})
        marked = compare(viewer, chromium, tmp_path)
        assert (np.abs(marked - bare).max(axis=2) > 60).sum() > 3000
        page = opened(chromium, tmp_path / "page.html")
        ready(page)
        box = page.locator("#canvas").bounding_box()
        assert box
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        told = until(lambda: re.search(r"cell (\d+)", page.locator("#facts").inner_text()))
        assert int(told[1]) in grouped.solid().cell_numbers, "the deck's number, not the row"
        page.context.close()
    finally:
        viewer.evaluate("() => window.hexalab.openOffered('0')")


def compare(viewer: Page, chromium: Browser, tmp_path: Path) -> np.ndarray:
    """Hold the page of one file against the viewer's own picture; returns its pixels."""
    path = tmp_path / "page.html"
    path.write_bytes(take(viewer, "page"))
    page = opened(chromium, path)
    ready(page)
    box = page.locator("#canvas").bounding_box()
    assert box
    size = {name: int(box[name]) for name in ("width", "height")}
    expected = Image.open(io.BytesIO(take(viewer, "screenshot", size))).convert("RGB")
    shown = pixels(page)
    error = np.abs(shown - np.asarray(expected).astype(int)).max(axis=2)
    error[-80:, -80:] = 0  # the axes in the corner
    # What is smoothed differs by the way it is smoothed: four samples to a pixel there, sixteen here.
    assert (error > 60).mean() < 0.01, f"{(error > 60).mean():.4f} of the pixels differ"
    assert error.mean() < 2
    assert page.told == []  # type: ignore[attr-defined]
    page.context.close()
    return shown


def test_A7_colours_and_slices_can_be_chosen_and_a_cell_is_told(
    viewer: Page, chromium: Browser, tmp_path: Path
) -> None:
    put(viewer, HALF, PLAIN, {"unit": "mm"})
    path = tmp_path / "page.html"
    wanted = {
        "metrics": ["volume", "diagonal"],
        "slices": [0, 0.5],
        "reference": "A <b>& B (2026): “Boxes”.",
        "link": "https://example.org/viewer/?mesh=a/b",
    }
    path.write_bytes(take(viewer, "page", wanted))
    page = opened(chromium, path)
    ready(page)
    assert page.title() == "brick.vtk"
    assert "A <b>& B (2026): “Boxes”." in page.locator(".about").inner_text()
    assert page.get_by_role("link", name="Open in HexaLab").get_attribute("href") == wanted["link"]
    assert "24 of 24 cells shown" in page.locator("#facts").inner_text()
    assert page.locator("#quantity option").all_inner_texts() == ["Boundary and inside", "Volume", "Diagonal"]
    plain = pixels(page)
    page.select_option("#quantity", label="Volume")
    until(lambda: (pixels(page) != plain).any())
    assert page.get_by_role("img", name="Legend: Volume").is_visible()
    whole = pixels(page)
    page.locator("#slice").fill("1")
    until(lambda: (pixels(page) != whole).any())
    assert "12 of 24 cells shown" in page.locator("#facts").inner_text()
    box = page.locator("#canvas").bounding_box()
    assert box
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    told = until(lambda: re.search(r"cell (\d+), Volume 1\.000\smm³", page.locator("#facts").inner_text()))
    assert int(told[1]) in range(24) and int(told[1]) // 6 >= 2, "its number in the whole mesh"
    turned = pixels(page)
    page.locator("#canvas").focus()
    page.keyboard.press("ArrowLeft")
    until(lambda: (np.abs(pixels(page) - turned) > 60).mean() > 0.01)
    page.get_by_role("button", name="Reset the view").click()
    until(lambda: (np.abs(pixels(page) - turned) > 60).mean() < 0.001)
    assert page.told == []  # type: ignore[attr-defined]
    page.context.close()


def test_A7_the_page_asks_nobody_and_lets_nothing_in(viewer: Page, chromium: Browser, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_bytes(take(viewer, "page"))
    html = path.read_text("utf-8")
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', html)
    assert policy and "default-src 'none'" in policy[1] and "unsafe" not in policy[1]
    assert "http:" not in re.sub(r"http://www\.w3\.org/\S+", "", html)
    page = opened(chromium, path)
    ready(page)
    assert page.told == []  # type: ignore[attr-defined]
    tried = page.evaluate(
        """async () => {
          const script = document.createElement("script");
          script.textContent = "window.broken = true";
          document.head.append(script);
          const fetched = await fetch("https://example.org/").then(() => true, () => false);
          return { ran: "broken" in window, fetched };
        }"""
    )
    assert tried == {"ran": False, "fetched": False}
    page.context.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [(1280, 800), (360, 740)])
def test_A7_axe_finds_nothing_in_the_page(
    viewer: Page, chromium: Browser, tmp_path: Path, scheme: Any, size: tuple[int, int]
) -> None:
    put(viewer, PLAIN)
    path = tmp_path / "page.html"
    path.write_bytes(
        take(viewer, "page", {"metrics": ["volume"], "slices": [0, 0.5], "reference": "A (2026)."})
    )
    viewport = {"width": size[0], "height": size[1]}
    context = chromium.new_context(viewport=viewport, offline=True, color_scheme=scheme)  # type: ignore[arg-type]
    page = context.new_page()
    page.add_init_script(AXE.read_text())
    page.goto(path.as_uri())
    ready(page)
    assert violations(page) == []
    assert page.evaluate("() => document.documentElement.scrollWidth") <= size[0]
    box = page.locator("#canvas").bounding_box()
    assert box and box["height"] > 250, "the picture has most of the window"
    context.close()


def test_A7_without_webgl_or_scripts_the_picture_stands(
    viewer: Page, chromium: Browser, tmp_path: Path
) -> None:
    path = tmp_path / "page.html"
    path.write_bytes(take(viewer, "page"))
    quiet = opened(chromium, path, java_script_enabled=False)
    assert quiet.locator("#poster").is_visible()
    assert quiet.locator("noscript").inner_text() == "With JavaScript the mesh can be turned."
    quiet.context.close()
    context = chromium.new_context(offline=True)
    page = context.new_page()
    page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
    page.goto(path.as_uri())
    until(lambda: page.locator("#note").is_visible())
    assert "this is its picture" in page.locator("#note").inner_text()
    assert page.locator("#poster").is_visible()
    context.close()


def test_A7_the_site_saves_a_page_with_the_reference(page: Page, site: str, tmp_path: Path) -> None:
    page.goto(f"{site}/viewer/?mesh=shapes/cube")
    page.evaluate("() => window.hexalab.ready")
    until(lambda: page.evaluate("() => window.hexalab.summary()?.findings !== undefined"), 60)
    html = take(page, "page", {"metrics": ["scaled_jacobian"]}).decode()
    assert "<title>Cube</title>" in html
    assert "The HexaLab contributors (2026): HexaLab shapes" in html
    (tmp_path / "cube.vtu").write_bytes(take(page, "cells", "vtu", {"metrics": ["volume"]}))
    assert hexalab.read(tmp_path / "cube.vtu").cell_count == 256, "half of it is shown"
