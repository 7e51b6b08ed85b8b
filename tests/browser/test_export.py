"""Files that leave the page (SPEC A7, A8); truth: VTK, glTF's validator, the picture itself, closed formulas."""

from __future__ import annotations

import base64
import io
import json
import re
import subprocess
import zipfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

import hexalab
from hexalab import cli
from hexalab.hosts.loopback import Loopback
from hexalab.hosts.offers import file_offers

from .conftest import grid
from .test_ui_page import AXE, violations
from .ui import until

pytestmark = pytest.mark.browser
ROOT = Path(__file__).parents[2]

SIZE = {"width": 900, "height": 700}
HALF = {"filters": {"planes": {"items": [{"enabled": True, "normal": [1, 0, 0], "offset": 0.5}]}}}
OPEN = {"filters": {"planes": {"items": [{"enabled": True, "normal": [-1, 0, 0], "offset": 0.5}]}}}
"""The other half: what the slice exposes looks at the eye."""
PLAIN = {"lighting": {"mode": "none"}}

TAKE = """async ([method, args]) => {
  const made = await window.hexalab[method](...args);
  const blob = made.file ?? made;
  const bytes = new Uint8Array(await blob.arrayBuffer());
  let text = "";
  for (let at = 0; at < bytes.length; at += 32768) text += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return { data: btoa(text), notes: made.notes ?? [], type: blob.type };
}"""


@pytest.fixture(scope="module")
def brick(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A box of 4 x 3 x 2 unit cubes far from the origin, in a file."""
    mesh = grid(4, 3, 2)
    path = tmp_path_factory.mktemp("export") / "brick.vtk"
    moved = hexalab.Mesh(mesh.coordinates + np.array([[100.0], [20], [-3]]), mesh.corners, mesh.kinds)
    hexalab.write(moved, path)
    return path


@pytest.fixture(scope="module")
def viewer(chromium: Browser, brick: Path) -> Iterator[Page]:
    """The viewer before the native core, with the box open."""
    with Loopback(file_offers([brick]), opens=False) as server:
        server.start()
        context = chromium.new_context(viewport=SIZE, accept_downloads=True)
        page = context.new_page()
        errors: list[str] = []
        page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto(server.address)
        page.evaluate("() => window.hexalab.ready")
        page.evaluate("() => window.hexalab.openOffered('0')")
        yield page
        context.close()
        server.shutdown()
        assert not errors, f"the console reported {errors}"


@pytest.fixture(autouse=True)
def fresh(viewer: Page) -> None:
    """Each test begins with the mesh's own settings."""
    viewer.keyboard.press("Escape")
    viewer.evaluate("() => window.hexalab.reset()")


def take(page: Page, method: str, *args: Any) -> bytes:
    """What a method of the page makes, as bytes."""
    return base64.b64decode(page.evaluate(TAKE, [method, list(args)])["data"])


def put(page: Page, *statuses: dict[str, Any]) -> None:
    for status in statuses:
        assert page.evaluate("(status) => window.hexalab.setStatus(status)", status) == []


def run(words: list[str]) -> int:
    """The command line in a thread of its own: Playwright runs once in each, and here the tests' browser does."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(cli.main, words).result()


def polygons(path: Path) -> Any:
    """What VTK reads of a file of polygons."""
    vtk = pytest.importorskip("vtkmodules.vtkIOPLY" if path.suffix == ".ply" else "vtkmodules.vtkIOGeometry")
    reader = getattr(
        vtk, {".ply": "vtkPLYReader", ".obj": "vtkOBJReader", ".stl": "vtkSTLReader"}[path.suffix]
    )()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def measured(found: Any) -> tuple[float, float]:
    """Area of polygons and the volume that they enclose, by VTK."""
    from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

    triangles = vtkTriangleFilter()
    triangles.SetInputData(found)
    mass = vtkMassProperties()
    mass.SetInputConnection(triangles.GetOutputPort())
    mass.Update()
    return mass.GetSurfaceArea(), mass.GetVolume()


@pytest.mark.parametrize("form", ["ply", "obj", "stl"])
def test_A8_the_shown_surface_is_read_by_vtk_where_it_stands(viewer: Page, tmp_path: Path, form: str) -> None:
    put(viewer, HALF)
    path = tmp_path / f"half.{form}"
    path.write_bytes(take(viewer, "surface", form))
    found = polygons(path)
    assert np.allclose(found.GetBounds(), [102, 104, 20, 23, -3, -1], atol=1e-4)
    area, volume = measured(found)
    assert area == pytest.approx(2 * (2 * 3 + 3 * 2 + 2 * 2), rel=1e-4)
    assert volume == pytest.approx(2 * 3 * 2, rel=1e-4), "closed, its faces outward"
    faces = 2 * (2 * 3 + 3 * 2 + 2 * 2)
    assert found.GetNumberOfCells() == (2 * faces if form == "stl" else faces)


def test_A8_colours_are_those_of_the_picture(viewer: Page, tmp_path: Path) -> None:
    vtk_to_numpy = pytest.importorskip("vtkmodules.util.numpy_support").vtk_to_numpy
    colour = {"colour": {"by": "sides", "outside": "#204060", "inside": "#c08040"}}
    put(viewer, OPEN, PLAIN, colour)
    path = tmp_path / "half.ply"
    path.write_bytes(take(viewer, "surface", "ply"))
    found = polygons(path)
    colours = vtk_to_numpy(found.GetPointData().GetScalars())[:, :3]
    points = vtk_to_numpy(found.GetPoints().GetData())
    inside = (colours == (0xC0, 0x80, 0x40)).all(axis=1)
    outside = (colours == (0x20, 0x40, 0x60)).all(axis=1)
    assert (inside | outside).all() and inside.any() and outside.any()
    assert np.allclose(points[inside, 0], 102), "what the slice exposes"
    picture = Image.open(io.BytesIO(take(viewer, "screenshot", {"width": 300, "height": 300}))).convert("RGB")
    seen = {tuple(row) for row in np.asarray(picture).reshape(-1, 3).tolist()}
    assert {(0xC0, 0x80, 0x40), (0x20, 0x40, 0x60)} <= seen


def test_A8_light_darkens_what_is_closed_in(viewer: Page, tmp_path: Path) -> None:
    vtk_to_numpy = pytest.importorskip("vtkmodules.util.numpy_support").vtk_to_numpy
    # A shaft in the box: of 24 cells the middle ones are dug out from above.
    hidden = {"filters": {"picking": {"enabled": True, "hidden": [9, 15]}}}
    put(viewer, hidden, {"colour": {"by": "sides", "outside": "#ffffff", "inside": "#ffffff"}})
    values = {}
    for light in (True, False):
        path = tmp_path / f"{light}.ply"
        path.write_bytes(take(viewer, "surface", "ply", {"light": light}))
        values[light] = vtk_to_numpy(polygons(path).GetPointData().GetScalars())[:, 0]
    assert (values[False] == 255).all()
    assert values[True].min() < 170 and values[True].max() > 250


def validated(path: Path) -> dict[str, Any]:
    """What glTF's validator (Khronos) says of a file."""
    script = (
        "const fs = require('fs'); require('gltf-validator')"
        ".validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])))"
        ".then((report) => console.log(JSON.stringify(report)));"
    )
    done = subprocess.run(["node", "-e", script, str(path)], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    report: dict[str, Any] = json.loads(done.stdout)
    return report


@pytest.mark.parametrize("mode", ["lines", "fissure", "rounded"])
def test_A8_glb_is_valid_and_stands_upright_in_the_files_unit(
    viewer: Page, tmp_path: Path, mode: str
) -> None:
    put(viewer, HALF, {"separation": {"mode": mode}})
    path = tmp_path / "half.glb"
    path.write_bytes(take(viewer, "surface", "glb"))
    report = validated(path)
    assert report["issues"]["numErrors"] + report["issues"]["numWarnings"] == 0, report["issues"]
    assert report["info"]["drawCallCount"] == (2 if mode == "lines" else 1)
    vtk = pytest.importorskip("vtkmodules.vtkIOGeometry")
    reader = vtk.vtkGLTFReader()
    reader.SetFileName(str(path))
    reader.ApplyDeformationsToGeometryOn()
    reader.Update()
    box = [0.0] * 6
    reader.GetOutput().GetBounds(box)
    bounds = np.array(box).reshape(3, 2)
    # z of the file is up: it becomes y, and y becomes -z
    expected = np.array([[102, 104], [-3, -1], [-23, -20]], float)
    assert np.allclose(bounds, expected, atol=0.2 if mode != "lines" else 1e-3), bounds


def test_A8_what_can_not_be_saved_is_told(viewer: Page) -> None:
    for method, args, words in (
        ("surface", ["step"], "found the format ‘step’, expected one of glb, ply, obj, stl"),
        ("cells", ["glb"], "found the format ‘glb’, expected one of mesh, vtk, vtu"),
        ("page", [{"metrics": ["none"]}], "found the metric ‘none’"),
        ("page", [{"slices": [2]}], "found the slice 2, expected numbers from 0 to 1"),
        ("turntable", [{"frames": 1}], "frames: found 1, expected a whole number from 2 to 720"),
        ("turntable", [{"format": "gif"}], "found the format ‘gif’, expected zip, webm or mp4"),
        ("turntable", [{"format": "webm", "width": 321, "height": 240}], "expected even numbers"),
    ):
        ask = "([method, args]) => window.hexalab[method](...args).then(() => '', (error) => error.message)"
        assert words in viewer.evaluate(ask, [method, args])
    put(viewer, {"filters": {"peel": {"depth": 9}}})
    for method, args in (("surface", ["ply"]), ("cells", ["vtu"]), ("page", []), ("turntable", [])):
        assert "no cell is shown" in viewer.evaluate(ask, [method, args])


def test_A8_stl_far_from_the_origin_says_what_it_rounds(viewer: Page) -> None:
    notes = viewer.evaluate(TAKE, ["surface", ["stl"]])["notes"]
    assert len(notes) == 1 and "STL has single precision" in notes[0]
    assert viewer.evaluate(TAKE, ["surface", ["ply"]])["notes"] == []


# -- the turntable


def test_A8_a_turntable_goes_round_once_and_comes_back(viewer: Page) -> None:
    before = viewer.evaluate("() => window.hexalab.getStatus()")
    turn = {"frames": 4, "width": 200, "height": 150}
    archive = zipfile.ZipFile(io.BytesIO(take(viewer, "turntable", turn)))
    assert archive.namelist() == [f"brick-{number:03}.png" for number in range(4)]
    frames = [
        np.asarray(Image.open(io.BytesIO(archive.read(name))).convert("RGB")).astype(int)
        for name in archive.namelist()
    ]
    assert {frame.shape for frame in frames} == {(150, 200, 3)}
    for frame in frames:
        drawn = (frame != 255).any(axis=2)
        assert drawn.any() and not (
            drawn[0].any() or drawn[-1].any() or drawn[:, 0].any() or drawn[:, -1].any()
        )
    # A box is its own mirror image half a turn on, but for its light; a quarter on, it is another.
    quarter, half = (np.abs(frames[0] - frames[place]).mean() for place in (1, 2))
    assert quarter > 5 * max(half, 0.1)
    assert viewer.evaluate("() => window.hexalab.getStatus()") == before


@pytest.mark.parametrize("form", ["webm", "mp4"])
def test_A8_a_turntable_as_a_video_plays(viewer: Page, chromium: Browser, form: str) -> None:
    turn = {"frames": 8, "seconds": 2, "width": 160, "height": 120, "format": form}
    data = base64.b64encode(take(viewer, "turntable", turn)).decode()
    page = chromium.new_page()
    told = page.evaluate(
        """async ([data, type]) => {
          const video = document.createElement("video");
          video.src = `data:${type};base64,${data}`;
          await new Promise((resolve, reject) => {
            video.onloadeddata = resolve;
            video.onerror = () => reject(new Error(video.error.message));
          });
          return { seconds: video.duration, width: video.videoWidth, height: video.videoHeight };
        }""",
        [data, f"video/{form}"],
    )
    page.close()
    assert (told["width"], told["height"]) == (160, 120)
    assert told["seconds"] == pytest.approx(2, abs=0.3)


# -- a page of one file


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
    path = tmp_path / "page.html"
    path.write_bytes(take(viewer, "page"))
    page = opened(chromium, path)
    ready(page)
    box = page.locator("#canvas").bounding_box()
    assert box
    size = {name: int(box[name]) for name in ("width", "height")}
    expected = Image.open(io.BytesIO(take(viewer, "screenshot", size))).convert("RGB")
    error = np.abs(pixels(page) - np.asarray(expected).astype(int)).max(axis=2)
    error[-80:, -80:] = 0  # the axes in the corner
    # What is smoothed differs by the way it is smoothed: four samples to a pixel there, sixteen here.
    assert (error > 60).mean() < 0.01, f"{(error > 60).mean():.4f} of the pixels differ"
    assert error.mean() < 2
    assert page.told == []  # type: ignore[attr-defined]
    page.context.close()


def test_A7_colours_and_slices_can_be_chosen_and_a_cell_is_told(
    viewer: Page, chromium: Browser, tmp_path: Path
) -> None:
    put(viewer, HALF, PLAIN)
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
    told = until(lambda: re.search(r"cell (\d+), Volume 1\b", page.locator("#facts").inner_text()))
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


# -- the dialog


@pytest.mark.parametrize(
    ("what", "form", "name", "begins"),
    [
        ("cells", "vtu", "brick.vtu", b"<?xml"),
        ("surface", "glb", "brick.glb", b"glTF"),
        ("page", "", "brick.html", b"<!doctype html>"),
        ("turntable", "zip", "brick.zip", b"PK"),
    ],
)
def test_A8_the_dialog_saves(
    viewer: Page, tmp_path: Path, what: str, form: str, name: str, begins: bytes
) -> None:
    viewer.locator("#bar").get_by_role("button", name="Save", exact=True).click()
    dialog = viewer.locator("#save")
    dialog.get_by_label("What").select_option(what)
    assert dialog.get_by_label("Format").is_visible() == bool(form)
    if form:
        assert dialog.get_by_label("Format").input_value() == form
    if what == "turntable":
        for label, value in (("Pictures", "2"), ("Width", "100"), ("Height", "80")):
            dialog.get_by_label(label).fill(value)
            dialog.get_by_label(label).press("Enter")
    with viewer.expect_download() as download:
        dialog.get_by_role("button", name="Save", exact=True).click()
    assert download.value.suggested_filename == name
    path = tmp_path / name
    download.value.save_as(path)
    assert path.read_bytes().startswith(begins)
    until(lambda: f"Saved: {name}" in dialog.locator(".save-result").inner_text())
    if what == "cells":
        found = hexalab.read(path)
        assert found.cell_count == 24 and set(found.cell_data) == {"scaled_jacobian"}


def test_A8_the_dialog_says_what_is_left_out(viewer: Page) -> None:
    viewer.locator("#bar").get_by_role("button", name="Save", exact=True).click()
    dialog = viewer.locator("#save")
    dialog.get_by_label("What").select_option("cells")
    dialog.get_by_label("Format").select_option("mesh")
    with viewer.expect_download():
        dialog.get_by_role("button", name="Save", exact=True).click()
    until(lambda: "no place for the attributes scaled_jacobian" in dialog.locator(".save-notes").inner_text())


# -- the command line


def test_A8_export_writes_what_the_ending_says(
    brick: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "half.json").write_text(json.dumps({**HALF, "silhouette": 7}))
    status = ["--status", str(tmp_path / "half.json")]
    page = tmp_path / "page.html"
    words = ["export", str(brick), "-o", str(page), *status, "--metrics", "volume", "--slices", "2"]
    assert run([*words, "--reference", "B. Rick (2026)"]) == 0
    out, err = capsys.readouterr()
    assert out == f"{page}: 24 cells, {page.stat().st_size:,} bytes\n"
    assert err.count("\n") == 1 and "silhouette: found 7" in err
    assert "B. Rick (2026)" in page.read_text("utf-8")
    surface = tmp_path / "half.stl"
    assert run(["export", str(brick), "-o", str(surface), *status]) == 0
    assert measured(polygons(surface))[1] == pytest.approx(12, rel=1e-4)
    assert "single precision" in capsys.readouterr().err
