"""Figures for print: what stands around a picture, several in a row, as PNG, SVG and PDF (SPEC S5)."""

from __future__ import annotations

import base64
import io
import json
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Error, Page

from hexalab.png_text import read_settings

from . import ui
from .conftest import grid

SVG = "{http://www.w3.org/2000/svg}"
MESH = grid(6, 4, 3, noise=0.2)
PLAIN: dict[str, Any] = {"lighting": {"mode": "none"}, "irregular": {"mode": 0}, "silhouette": 0}


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    with ui.one_viewer(chromium, site, accept_downloads=True) as page:
        ui.open_mesh(page, site, shelf, MESH, "figure.mesh")
        yield page


@pytest.fixture
def viewer(opened: Page) -> Page:
    opened.evaluate("() => window.hexalab.reset()")
    ui.set_status(opened, PLAIN)
    return opened


def figure(page: Page, file: str, **settings: Any) -> bytes:
    ui.set_status(page, {"figure": settings})
    text = page.evaluate(
        """async (file) => {
            const bytes = new Uint8Array(await (await window.hexalab.figure(file)).arrayBuffer());
            let text = "";
            for (let at = 0; at < bytes.length; at += 32768)
              text += String.fromCharCode(...bytes.subarray(at, at + 32768));
            return btoa(text);
        }""",
        file,
    )
    return base64.b64decode(text)


def words(svg: bytes) -> list[str]:
    return [text.text or "" for text in ElementTree.fromstring(svg).iter(f"{SVG}text")]


def test_S5_a_figure_without_anything_is_the_picture_and_carries_the_settings(viewer: Page) -> None:
    png = figure(viewer, "png", unit="px", width=300, height=200)
    assert Image.open(io.BytesIO(png)).size == (300, 200)
    assert read_settings(png)["figure"]["width"] == 300


def test_S5_sizes_in_millimetres_are_pixels_by_the_resolution(viewer: Page) -> None:
    png = figure(viewer, "png", unit="mm", width=50.8, height=25.4, resolution=100)
    assert Image.open(io.BytesIO(png)).size == (200, 100)


def test_S5_everything_around_a_picture_is_text_in_the_svg(viewer: Page) -> None:
    ui.set_status(viewer, {"colour": {"by": "quality"}})
    svg = figure(
        viewer, "svg", unit="mm", width=120, height=80, resolution=100, legend="histogram",
        legend_title="Quality", scale_bar=True, axes=True, caption=True, caption_text="A noisy grid.",
    )  # fmt: skip
    said = words(svg)
    for word in ("Quality", "cells", "x", "y", "z", "A noisy grid.", "0", "1"):
        assert word in said, said
    counts = [int(word.replace(",", "")) for word in said if word.replace(",", "").isdigit()]
    assert max(counts) <= MESH.cell_count
    (image,) = ElementTree.fromstring(svg).iter(f"{SVG}image")
    picture = Image.open(io.BytesIO(base64.b64decode(image.attrib["href"].split(",")[1])))
    assert picture.size == (int(image.attrib["width"]), int(image.attrib["height"]))


def test_S5_the_scale_bar_has_the_length_that_it_says(viewer: Page) -> None:
    """Seen from the front, orthographic: the grid is 6 wide, so that 1 of the file is a sixth of its width."""
    ui.set_status(
        viewer,
        {"camera": {"fit": True, "projection": "orthographic", "direction": [0, 0, -1], "up": [0, 1, 0]}},
    )
    settings = {"unit": "px", "width": 400, "height": 300, "scale_bar": True}
    svg = ElementTree.fromstring(figure(viewer, "svg", **settings))
    bar = max(svg.iter(f"{SVG}line"), key=lambda line: float(line.attrib["x2"]) - float(line.attrib["x1"]))
    length = float(bar.attrib["x2"]) - float(bar.attrib["x1"])
    (said,) = [float(word) for word in words(ElementTree.tostring(svg)) if re.fullmatch(r"[\d.]+", word)]
    low, high = MESH.extent
    picture = figure(viewer, "png", **settings | {"scale_bar": False, "transparent": True})
    drawn = np.flatnonzero((np.array(Image.open(io.BytesIO(picture)))[..., 3] > 128).any(axis=0))
    pixels = (drawn[-1] - drawn[0] + 1) / (high[0] - low[0])
    assert length / said == pytest.approx(pixels, rel=0.02)


def test_S5_crop_leaves_nothing_empty_and_keeps_the_width(viewer: Page) -> None:
    png = figure(viewer, "png", unit="px", width=400, height=400, crop=True, transparent=True)
    alpha = np.array(Image.open(io.BytesIO(png)))[..., 3] > 0
    assert alpha.shape[1] in range(396, 402) or alpha.shape[0] in range(396, 402)
    for edge in (alpha[:2], alpha[-2:], alpha[:, :2], alpha[:, -2:]):
        assert edge.any()


def test_S5_panels_stand_in_a_row_with_letters_and_the_settings_stay(viewer: Page) -> None:
    before = ui.status(viewer)
    panels = {"setting": "peel", "values": [0, 1]}
    settings = {"unit": "px", "width": 600, "height": 300, "panels": panels}
    svg = ElementTree.fromstring(figure(viewer, "svg", **settings))
    images = list(svg.iter(f"{SVG}image"))
    assert len(images) == 2 and words(ElementTree.tostring(svg)) == ["a)", "b)"]
    pixels = [
        np.array(Image.open(io.BytesIO(base64.b64decode(one.attrib["href"].split(",")[1]))).convert("RGB"))
        for one in images
    ]
    assert pixels[0].shape == pixels[1].shape
    yellow = [(np.abs(picture.astype(int) - [255, 255, 0]).sum(axis=2) < 30).sum() for picture in pixels]
    assert yellow[0] == 0 and yellow[1] > 100
    after = ui.status(viewer)
    assert {**after, "figure": 0} == {**before, "figure": 0}


def test_S5_what_changes_for_a_figure_alone_is_not_told_as_a_change(viewer: Page) -> None:
    ui.set_status(viewer, {"lighting": {"mode": "direct"}})
    viewer.evaluate(
        """() => {
            window.told = [];
            const line = document.querySelector(".status-line") ?? document.querySelector("footer");
            new MutationObserver(() => window.told.push(line.innerText))
                .observe(line, { subtree: true, childList: true, characterData: true });
        }"""
    )
    figure(
        viewer, "png", crop=True, width=300, height=200, panels={"setting": "silhouette", "values": [0, 1]}
    )
    assert not [text for text in viewer.evaluate("() => window.told") if "Light" in text or "Silhou" in text]
    assert ui.status(viewer)["lighting"]["mode"] == "direct"


def test_S5_a_pdf_has_its_size_and_its_words_as_text(viewer: Page) -> None:
    pdf = figure(
        viewer, "pdf", unit="mm", width=100, height=60, resolution=72, caption=True, caption_text="Words"
    )
    assert pdf.startswith(b"%PDF-")
    (box,) = re.findall(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", pdf)
    assert [float(side) / 72 * 25.4 for side in box] == pytest.approx([100, 60], abs=0.5)
    assert b"/Helvetica" in pdf and b"/Image" in pdf


def test_S5_a_pdf_says_which_letters_it_lacks(viewer: Page) -> None:
    settings = {"unit": "mm", "width": 100, "height": 60, "resolution": 72, "caption": True}
    assert figure(viewer, "pdf", **settings, caption_text="−1 größer, “so”…").startswith(b"%PDF-")
    with pytest.raises(Error, match="no ‘网’: save SVG or PNG"):
        figure(viewer, "pdf", **settings, caption_text="网格")
    assert "网格" in words(figure(viewer, "svg", **settings, caption_text="网格"))


def test_S5_the_dialog_shows_what_will_be_saved(viewer: Page) -> None:
    ui.set_status(
        viewer, {"figure": {"unit": "px", "width": 320, "height": 240, "legend": "none", "crop": False}}
    )
    viewer.get_by_role("button", name="Image", exact=True).click()
    preview = viewer.locator(".figure-preview")
    ui.until(lambda: "320 × 240 pixels" in viewer.locator(".figure-size").inner_text())
    assert preview.evaluate("image => [image.naturalWidth, image.naturalHeight]") == [320, 240]
    viewer.locator("#figure-legend").select_option("bar")
    viewer.locator("#image").get_by_label("Letters, value").fill("10")
    viewer.locator("#image").get_by_label("Letters, value").press("Enter")
    viewer.get_by_role("button", name="Column").click()
    ui.until(lambda: "mm" in viewer.locator(".figure-size").inner_text(), 40)
    assert ui.status(viewer)["figure"]["width"] == 85
    with viewer.expect_download() as waiting:
        viewer.get_by_role("button", name="Save PNG").click()
    assert waiting.value.suggested_filename == "figure.png"
    assert (
        json.loads(json.dumps(read_settings(Path(waiting.value.path()).read_bytes())))["figure"]["legend"]
        == "bar"
    )


def test_Q4_the_histogram_for_print_labels_its_ends_and_names_its_counts(viewer: Page) -> None:
    ui.unfold(viewer)
    ui.set_status(viewer, {"histogram": {"title": "My title", "width": 100, "height": 50, "font": "serif"}})
    ui.until(lambda: viewer.locator(".histogram .bar").count() > 1)
    for orientation in ("horizontal", "vertical"):
        ui.set_status(viewer, {"histogram": {"orientation": orientation}})
        with viewer.expect_download() as waiting:
            viewer.get_by_role("button", name="Save the histogram as SVG").click()
        svg = Path(waiting.value.path()).read_bytes()
        said = words(svg)
        assert {"My title", "cells", "0", "1"} <= set(said)
        assert b'width="100mm"' in svg and b"Times" in svg
    with viewer.expect_download() as waiting:
        viewer.get_by_role("button", name="Save the histogram as PDF").click()
    assert Path(waiting.value.path()).read_bytes().startswith(b"%PDF-")
