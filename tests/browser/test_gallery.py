"""Pictures that the build takes: they show the inside, are taken once, and their links bring the same view back."""

from __future__ import annotations

import base64
import io
import json
import os
import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page

from benchmarks.page import SITE
from hexalab.png_text import read_settings
from site_builder import BuildReport, build

pytestmark = pytest.mark.browser

DEMO = Path(__file__).resolve().parents[1] / "site_builder" / "demo"

SCREENSHOT = """async () => {
  await window.hexalab.settled();
  const blob = await window.hexalab.screenshot({ width: 720, height: 480 });
  const reader = new FileReader();
  await new Promise((done) => { reader.onload = done; reader.readAsDataURL(blob); });
  return reader.result.split(",")[1];
}"""


def pixels(source: Path | bytes) -> np.ndarray:
    """Colours of a picture, (height, width, 3), 0 to 255."""
    file = io.BytesIO(source) if isinstance(source, bytes) else source
    return np.asarray(Image.open(file).convert("RGB")).astype(int)


def yellow(picture: np.ndarray) -> float:
    """Share of pixels whose colour is that of inside faces, lit or shaded."""
    red, green, blue = np.moveaxis(picture, -1, 0)
    return float(((red > 120) & (abs(red - green) < 12) & (blue < 0.35 * red)).mean())


@pytest.fixture(scope="module")
def meshes() -> list[dict]:
    """The site's own meshes, as its index for the viewer lists them."""
    index = json.loads((SITE / "catalogue.json").read_text())
    rows = [
        {
            **mesh,
            "source": source["slug"],
            "picture": SITE / "pictures" / source["slug"] / f"{mesh['slug']}.png",
        }
        for source in index["sources"]
        for mesh in source["meshes"]
        if not mesh["remote"]
    ]
    assert len(rows) > 40
    return rows


def test_C2_every_mesh_of_our_own_has_a_thumbnail_on_white(meshes):
    for mesh in meshes:
        picture = pixels(mesh["picture"])
        assert picture.shape == (480, 720, 3), mesh["slug"]
        assert (picture[[0, 0, -1, -1], [0, -1, 0, -1]] == 255).all(), mesh["slug"]
        assert 0.03 < (picture.sum(axis=2) < 700).mean() < 0.9, mesh["slug"]


def test_C2_thumbnails_show_the_inside(meshes):
    cut = [mesh for mesh in meshes if mesh["source"] in ("shapes", "structures") and mesh["slug"] != "mixed"]
    shares = {mesh["slug"]: yellow(pixels(mesh["picture"])) for mesh in cut}
    assert len(shares) > 30
    assert all(share > 0.004 for share in shares.values()), shares
    assert np.median(list(shares.values())) > 0.05


def test_S3_thumbnails_carry_status_and_mesh(meshes):
    for mesh in meshes:
        settings = read_settings(mesh["picture"].read_bytes())
        assert settings["mesh"]["sha256"] == mesh["sha256"], mesh["slug"]
        assert settings["mesh"]["cells"] == mesh["cells"], mesh["slug"]


def test_V5_the_gallery_shows_that_each_light_differs():
    def shades(light: str) -> np.ndarray:
        return pixels(SITE / "gallery" / f"lines-{light}.png")

    none, direct, best = shades("none"), shades("direct"), shades("object-space-ao")
    drawn = yellow(none)
    flat = (none == [255, 255, 0]).all(axis=2).mean()
    assert flat > 0.8 * drawn  # without light the inside is one colour but for the lines
    assert (direct == [255, 255, 0]).all(axis=2).mean() < 0.2 * flat
    dark = [((picture.max(axis=2) < 90).mean()) for picture in (direct, best)]
    assert dark[1] > 2 * dark[0]  # deep places are dark under ambient occlusion alone


def test_S2_a_link_of_the_gallery_brings_the_same_picture_back(page: Page, site: str):
    page.goto(f"{site}/gallery/")
    page.locator('a:has(img[src$="darkness-coded-edges-direct.png"])').click()
    page.wait_for_function("() => window.hexalab !== undefined")
    page.evaluate("() => window.hexalab.ready")
    page.wait_for_function("() => window.hexalab.getStatus().lighting.mode === 'direct'")
    page.evaluate("() => window.hexalab.settled()")
    again = pixels(base64.b64decode(page.evaluate(SCREENSHOT)))
    kept = pixels(SITE / "gallery" / "darkness-coded-edges-direct.png")
    assert np.abs(again - kept).mean() < 0.5


def test_T4_a_picture_of_structure_opens_what_it_shows(page: Page, site: str):
    page.goto(f"{site}/guide/structure/")
    page.locator('a:has(img[src$="guide/structure/crossing.png"])').click()
    page.wait_for_function("() => window.hexalab !== undefined")
    page.evaluate("() => window.hexalab.ready")
    page.wait_for_function("() => window.hexalab.getStatus().structure.chosen.length === 2")
    page.evaluate("() => window.hexalab.settled()")
    again = pixels(base64.b64decode(page.evaluate(SCREENSHOT)))
    kept = pixels(SITE / "guide" / "structure" / "crossing.png")
    differing = np.abs(again - kept)  # the build's light comes from 256 directions, the viewer's from 1024
    assert differing.mean() < 0.5
    assert (differing.max(axis=2) > 4).mean() < 0.01
    red, green, blue = np.moveaxis(kept, -1, 0)
    teal, amber = (green > red + 60) & (blue > red + 40), (red > blue + 90) & (green > blue + 40)
    assert 0.01 < teal.mean() < 0.3
    assert 0.01 < amber.mean() < 0.3


def test_V8_gallery_and_guide_have_all_their_pictures(page: Page, site: str):
    for address, count in (("gallery/", 62), ("guide/", 18), ("guide/structure/", 35)):
        page.goto(f"{site}/{address}")
        page.evaluate("() => document.querySelectorAll('img').forEach((image) => (image.loading = 'eager'))")
        page.wait_for_function("() => [...document.images].every((image) => image.complete)")
        widths = page.evaluate(
            "() => [...document.images].map((image) => [image.naturalWidth, image.width, image.alt])"
        )
        assert len(widths) == count
        assert all(natural > 0 and width > 0 and alt for natural, width, alt in widths)
        page.set_viewport_size({"width": 360, "height": 800})
        assert page.evaluate("() => document.documentElement.scrollWidth") == 360


def built(repository: Path, site: Path) -> BuildReport:
    """Builds in a thread of its own: Playwright runs once in a thread, and in this one the tests' browser does."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(build, repository, site).result()


def test_C7_a_picture_is_taken_once(tmp_path: Path):
    repository, site = tmp_path / "repository", tmp_path / "site"
    shutil.copytree(DEMO, repository, ignore=shutil.ignore_patterns("__pycache__"))
    for made in SITE.parent.glob("cache/*-*"):  # the viewer and its Python, which are the same
        shutil.copytree(made, tmp_path / "cache" / made.name, copy_function=os.link)
    first = built(repository, site)
    assert (first.taken, first.notes) == (3, [])
    files = sorted((site / "pictures").rglob("*.png"))
    assert len(files) == 3
    assert all(yellow(pixels(file)) > 0 or (pixels(file).sum(axis=2) < 700).mean() > 0.03 for file in files)
    page = (site / "sources/small/pair/index.html").read_text()
    assert 'src="../../../pictures/small/pair.png"' in page
    assert "pictures/small/pair.png" in page.partition('property="og:image"')[2][:120]
    before = {file: file.read_bytes() for file in files}
    again = built(repository, site)
    assert again.taken == 0
    assert all(file.read_bytes() == before[file] for file in files)
    shutil.rmtree(tmp_path / "cache" / "pictures")
    assert built(repository, site).taken == 3
    assert all(file.read_bytes() == before[file] for file in files)  # the same bytes from another browser
    mesh = repository / "small" / "pair.mesh"
    mesh.write_text(mesh.read_text().replace("2 1 1 0", "2.5 1 1 0"))
    changed = built(repository, site)
    assert changed.taken == 1
    assert [file.name for file in files if file.read_bytes() != before[file]] == ["pair.png"]
