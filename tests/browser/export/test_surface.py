"""The shown surface (SPEC A8); truth: VTK, glTF's validator, the picture itself, closed formulas."""

from __future__ import annotations

import io
import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page

from .asking import HALF, OPEN, PLAIN, TAKE, measured, polygons, put, take

pytestmark = pytest.mark.browser

ROOT = Path(__file__).parents[3]


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


def test_A8_stl_far_from_the_origin_says_what_it_rounds(viewer: Page) -> None:
    notes = viewer.evaluate(TAKE, ["surface", ["stl"]])["notes"]
    assert len(notes) == 1 and "STL has single precision" in notes[0]
    assert viewer.evaluate(TAKE, ["surface", ["ply"]])["notes"] == []
