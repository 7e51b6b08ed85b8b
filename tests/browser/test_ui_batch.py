"""A zip of meshes in, a zip of pictures, histograms and measurements out (SPEC B1)."""

from __future__ import annotations

import csv
import io
import json
import zipfile
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page

import hexalab

from . import ui
from .conftest import grid


@pytest.fixture
def archive(tmp_path: Path) -> Path:
    """Two meshes, one with a status of its own, one file that is no mesh, and one to be left alone."""
    file = tmp_path / "meshes.zip"
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as pack:
        for name, sides in (("box.mesh", (3, 3, 3)), ("deep/bar.vtk", (4, 1, 1))):
            hexalab.write(grid(*sides, noise=0.1), tmp_path / Path(name).name)
            pack.write(tmp_path / Path(name).name, name)
        pack.writestr("deep/bar.json", json.dumps({"background": "#102030", "lighting": {"mode": "none"}}))
        pack.writestr("broken.vtk", "nonsense")
        pack.writestr("__MACOSX/box.mesh", "nonsense")
    return file


def test_B1_a_dropped_zip_gives_pictures_histograms_and_measurements(viewer: Page, archive: Path) -> None:
    ui.set_status(viewer, {"background": "#ff0000", "lighting": {"mode": "none"}, "silhouette": 0})
    viewer.locator("#file").set_input_files(archive)
    ui.until(lambda: viewer.locator("#batch").is_visible())
    assert "3 meshes in meshes.zip" in viewer.locator("#batch").inner_text()
    for side, pixels in (("Width", "120"), ("Height", "80")):
        viewer.locator("#batch").get_by_label(side).fill(pixels)
        viewer.locator("#batch").get_by_label(side).press("Enter")
    with viewer.expect_download(timeout=120_000) as waiting:
        viewer.locator("#batch").get_by_role("button", name="Start").click()
    assert waiting.value.suggested_filename == "meshes-hexalab.zip"
    made = zipfile.ZipFile(Path(waiting.value.path()))
    charts = {f"{stem}-scaled_jacobian.{form}" for stem in ("box", "deep/bar") for form in ("png", "svg")}
    tables = {"measurements.csv", "measurements.json"}
    assert set(made.namelist()) == {"box.png", "deep/bar.png"} | charts | tables
    assert made.read("deep/bar-scaled_jacobian.svg").startswith(b"<svg")
    for name, colour in (("box.png", (255, 0, 0)), ("deep/bar.png", (16, 32, 48))):
        picture = Image.open(io.BytesIO(made.read(name)))
        assert picture.size == (120, 80)
        assert picture.convert("RGB").getpixel((0, 0)) == colour
        assert b"iTXthexalab" in made.read(name)
    rows = {row["name"]: row for row in csv.DictReader(io.StringIO(made.read("measurements.csv").decode()))}
    assert set(rows) == {"box.mesh", "deep/bar.vtk", "broken.vtk"}
    assert "vtk DataFile" in rows["broken.vtk"]["problem"]
    values = hexalab.quality(grid(3, 3, 3, noise=0.1), "scaled_jacobian")
    assert float(rows["box.mesh"]["scaled_jacobian_min"]) == pytest.approx(values.min(), rel=1e-9)
    assert float(rows["box.mesh"]["scaled_jacobian_mean"]) == pytest.approx(np.mean(values), rel=1e-9)
    assert rows["box.mesh"]["cells"] == "27"
    told = {one["name"]: one for one in json.loads(made.read("measurements.json"))["meshes"]}
    assert told["box.mesh"]["quality"]["scaled_jacobian"]["min"] == float(
        rows["box.mesh"]["scaled_jacobian_min"]
    )
    assert told["broken.vtk"] == {"name": "broken.vtk", "problem": rows["broken.vtk"]["problem"]}


def test_R5_decks_in_an_archive_are_meshes_with_what_they_include(viewer: Page, tmp_path: Path) -> None:
    file = tmp_path / "decks.zip"
    deck = "*HEADING\n*INCLUDE, INPUT=all.msh\n"
    with zipfile.ZipFile(file, "w") as pack:
        for folder, side in (("a", 1), ("b", 2)):
            hexalab.write(grid(side, 1, 1), tmp_path / "part.inp")
            pack.write(tmp_path / "part.inp", f"{folder}/all.msh")
            pack.writestr(f"{folder}/job.inp", deck)
    ui.set_status(viewer, {"lighting": {"mode": "none"}})
    viewer.locator("#file").set_input_files(file)
    ui.until(lambda: viewer.locator("#batch").is_visible())
    assert "2 meshes in decks.zip" in viewer.locator("#batch").inner_text()
    with viewer.expect_download(timeout=120_000) as waiting:
        viewer.locator("#batch").get_by_role("button", name="Start").click()
    table = zipfile.ZipFile(Path(waiting.value.path())).read("measurements.csv").decode()
    rows = list(csv.DictReader(io.StringIO(table)))
    found = [(row["name"], row["cells"], row["problem"]) for row in rows]
    assert found == [("a/job.inp", "1", ""), ("b/job.inp", "2", "")]


def test_R6_a_zip_of_one_mesh_opens(viewer: Page, tmp_path: Path) -> None:
    hexalab.write(grid(2, 2, 2), tmp_path / "single.mesh")
    with zipfile.ZipFile(tmp_path / "single.zip", "w", zipfile.ZIP_DEFLATED) as pack:
        pack.write(tmp_path / "single.mesh", "folder/single.mesh")
    viewer.locator("#file").set_input_files(tmp_path / "single.zip")
    ui.until(lambda: ui.summary(viewer).get("name") == "single.mesh" and ui.shown(viewer) == 8)


def test_B1_meshes_of_one_stem_have_pictures_of_their_own_and_settings_do_not_go_on(
    viewer: Page, tmp_path: Path
) -> None:
    """The first has a status beside it; of that nothing stays for the second, nor on the page."""
    file = tmp_path / "twice.zip"
    with zipfile.ZipFile(file, "w") as pack:
        for name in ("part.mesh", "part.vtk"):
            hexalab.write(grid(2, 1, 1), tmp_path / name)
            pack.write(tmp_path / name, f"a/{name}" if name == "part.mesh" else f"A/{name}")
        pack.writestr("a/part.json", json.dumps({"background": "#102030", "colour": {"by": "kind"}}))
    status = {"background": "#ff0000", "lighting": {"mode": "none"}, "silhouette": 0}
    data = list(file.read_bytes())
    before = ui.status(viewer)
    made = viewer.evaluate(
        """async ([data, status]) => {
            const zip = await window.hexalab.batch(new Blob([new Uint8Array(data)]), status, { width: 60, height: 40 });
            return [...new Uint8Array(await zip.arrayBuffer())];
        }""",
        [data, status],
    )
    pack = zipfile.ZipFile(io.BytesIO(bytes(made)))
    rows = {row["name"]: row for row in csv.DictReader(io.StringIO(pack.read("measurements.csv").decode()))}
    assert {name: row["picture"] for name, row in rows.items()} == {
        "a/part.mesh": "a/part.png",
        "A/part.vtk": "A/part-2.png",
    }
    for row, colour in (("a/part.mesh", (16, 32, 48)), ("A/part.vtk", (255, 0, 0))):
        picture = Image.open(io.BytesIO(pack.read(rows[row]["picture"]))).convert("RGB")
        assert picture.getpixel((0, 0)) == colour
    assert {**ui.status(viewer), "mesh": 0} == {**before, "mesh": 0}
