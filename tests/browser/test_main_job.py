"""The main job, end to end: open, slice, measure; what is drawn is what the core says, natively."""

from __future__ import annotations

import io
import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

import hexalab
from hexalab.filters.stack import FilterStack

from .conftest import grid, planes
from .ui import one_viewer

DROP = """async ([url, name]) => {
    const bytes = await (await fetch(url)).arrayBuffer();
    const transfer = new DataTransfer();
    transfer.items.add(new File([bytes], name));
    for (const type of ["dragenter", "dragover", "drop"]) {
        document.body.dispatchEvent(
            new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }
}"""

PIXELS = """async (size) => {
    const blob = await window.hexalab.screenshot(size);
    const bytes = new Uint8Array(await blob.arrayBuffer());
    let text = "";
    for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(text);
}"""


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str) -> Iterator[Page]:
    with one_viewer(chromium, site) as page:
        yield page


@pytest.fixture
def viewer(opened: Page) -> Page:
    """The viewer with Python ready, under the settings that any mesh begins with."""
    opened.evaluate("() => window.hexalab.reset()")
    return opened


def drop(page: Page, site: str, shelf: Path, name: str, content: bytes) -> None:
    """Drop a file with that content onto the page."""
    (shelf / name).write_bytes(content)
    page.evaluate(DROP, [f"{site}/bench/{name}", name])


def picture(page: Page, width: int = 320, height: int = 240) -> np.ndarray[Any, np.dtype[np.uint8]]:
    """A screenshot as (height, width, 4) uint8."""
    import base64

    data = base64.b64decode(page.evaluate(PIXELS, {"width": width, "height": height}))
    return np.asarray(Image.open(io.BytesIO(data)).convert("RGBA"))


def shown_natively(mesh: hexalab.Mesh, status: dict[str, Any]) -> tuple[int, int]:
    """Cells shown and faces between shown and hidden or outside, by brute force over the core's filters."""
    filters = {"planes": {"enabled": True, "rule": "barycentre", "items": []}} | status["filters"]
    shown = FilterStack(mesh, lambda quantity: hexalab.quality(mesh, quantity)).apply(filters)
    seen: dict[tuple[int, ...], int] = {}
    for cell in mesh.cells[shown]:
        for face in ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
            key = tuple(sorted(cell[list(face)]))
            seen[key] = seen.get(key, 0) + 1
    return int(shown.sum()), sum(1 for count in seen.values() if count == 1)


def test_R1_a_dropped_file_opens_and_its_summary_is_the_cores(
    viewer: Page, site: str, shelf: Path, tmp_path: Path
) -> None:
    mesh = grid(5, 4, 3, noise=0.2)
    hexalab.write(mesh, tmp_path / "box.mesh")
    drop(viewer, site, shelf, "box.mesh", (tmp_path / "box.mesh").read_bytes())
    viewer.wait_for_function("() => window.hexalab.summary()?.name === 'box.mesh'")
    summary = viewer.evaluate("() => window.hexalab.summary()")
    assert (summary["vertices"], summary["cells"], summary["boundary_faces"]) == (120, 60, 94)
    quality = viewer.evaluate("() => window.hexalab.quality('scaled_jacobian')")
    values = hexalab.quality(mesh, "scaled_jacobian")
    assert math.isclose(quality["min"], values.min(), rel_tol=1e-12)
    assert math.isclose(quality["mean"], values.mean(), rel_tol=1e-12)


@pytest.mark.parametrize("offset", [0.0, 0.2, 0.5, 0.9, 1.0])
def test_F1_faces_drawn_after_a_slice_are_those_of_the_core(
    viewer: Page, site: str, shelf: Path, tmp_path: Path, offset: float
) -> None:
    mesh = grid(6, 5, 4, noise=0.1)
    hexalab.write(mesh, shelf / "slice.vtk")
    viewer.evaluate("url => window.hexalab.open(url)", f"{site}/bench/slice.vtk")
    status = planes(offset, (1.0, 0.5, 0.25))
    viewer.evaluate("status => window.hexalab.setStatus(status)", status)
    drawn = viewer.evaluate("() => window.hexalab.drawn().faces")
    shown = viewer.evaluate("() => window.hexalab.summary().shown")
    assert (shown["cells"], drawn) == shown_natively(mesh, status)
    assert shown["faces"] == drawn


def test_V2_outside_is_white_and_the_cut_is_yellow(viewer: Page, site: str, shelf: Path) -> None:
    hexalab.write(grid(4, 4, 4), shelf / "cube.mesh")
    viewer.evaluate("url => window.hexalab.open(url)", f"{site}/bench/cube.mesh")
    flat = {"lighting": {"mode": "none"}, "background": "#336699", "silhouette": 0, "irregular": {"mode": 0}}
    viewer.evaluate("status => window.hexalab.setStatus(status)", flat | planes(0))
    whole = picture(viewer)
    # the camera looks along -z: cutting with the normal (0, 0, -1) turns the cut towards it
    viewer.evaluate("status => window.hexalab.setStatus(status)", flat | planes(0.5, (0, 0, -1)))
    cut = picture(viewer)
    middle = (slice(110, 130), slice(150, 170))
    assert tuple(whole[0, 0][:3]) == (0x33, 0x66, 0x99)
    assert np.median(whole[middle][..., :3], axis=(0, 1)).min() > 200
    red, green, blue = np.median(cut[middle][..., :3], axis=(0, 1))
    assert min(red, green) > 200
    assert blue < 80


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("empty.mesh", b"", "empty"),
        ("picture.mesh", b"\x89PNG\r\n\x1a\n" + bytes(64), "PNG"),
        ("cut.mesh", b"MeshVersionFormatted 2\nDimension 3\nVertices\n8\n0 0 0 0\n1 0", "line"),
        (
            "surface.vtk",
            b"# vtk DataFile Version 3.0\nquads\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n",
            "POLYDATA",
        ),
    ],
)
def test_R10_a_bad_file_is_told_in_words_and_the_old_mesh_stays(
    viewer: Page, site: str, shelf: Path, name: str, content: bytes, words: str
) -> None:
    hexalab.write(grid(2, 2, 2), shelf / "good.mesh")
    viewer.evaluate("url => window.hexalab.open(url)", f"{site}/bench/good.mesh")
    drop(viewer, site, shelf, name, content)
    told = "([name, words]) => new RegExp(`${name}.*${words}`, 'i').test(document.body.innerText)"
    viewer.wait_for_function(told, arg=[name, words])
    assert viewer.evaluate("() => window.hexalab.summary().name") == "good.mesh"
    assert viewer.evaluate("() => window.hexalab.drawn().faces") == 24


def test_V6_nothing_is_drawn_while_nothing_changes(viewer: Page, site: str, shelf: Path) -> None:
    hexalab.write(grid(3, 3, 3), shelf / "rest.mesh")
    viewer.evaluate("url => window.hexalab.open(url)", f"{site}/bench/rest.mesh")
    viewer.evaluate("() => window.hexalab.settled()")
    viewer.wait_for_timeout(500)
    before = viewer.evaluate("() => window.hexalab.drawn().frames")
    viewer.wait_for_timeout(1000)
    assert viewer.evaluate("() => window.hexalab.drawn().frames") == before


def test_A3_status_round_trip_changes_nothing(viewer: Page, site: str, shelf: Path) -> None:
    hexalab.write(grid(3, 3, 3), shelf / "status.mesh")
    viewer.evaluate("url => window.hexalab.open(url)", f"{site}/bench/status.mesh")
    status = viewer.evaluate("() => window.hexalab.getStatus()")
    viewer.evaluate("status => window.hexalab.setStatus(status)", status)
    after = viewer.evaluate("() => window.hexalab.getStatus()")
    assert {**after, "mesh": 0} == {**status, "mesh": 0}  # the file's hash may come meanwhile
    assert json.loads(json.dumps(status)) == status


def test_O3_the_page_asks_nothing_of_other_origins(page: Page, site: str, shelf: Path) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto(f"{site}/viewer/")
    page.evaluate("() => window.hexalab.ready")
    hexalab.write(grid(2, 2, 2), shelf / "own.mesh")
    page.evaluate("url => window.hexalab.open(url)", f"{site}/bench/own.mesh")
    assert {url.split(":")[0] for url in asked} <= {"http", "blob", "data"}
    assert all(url.startswith(site) for url in asked if url.startswith("http"))
