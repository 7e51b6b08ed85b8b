"""`hexalab batch` (SPEC B2, B3): here, side by side, on a cluster; and the page's own batch."""

from __future__ import annotations

import csv
import io
import json
import os
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

import hexalab
from hexalab.comparison import compare
from hexalab.hosts.batching.records import KEPT
from hexalab.hosts.batching.sources import Source
from hexalab.reference import read_reference

from .cluster import ENVIRONMENT, cluster
from .conftest import grid
from .ui import status, until
from .viewing import ROOT, viewing, visited

pytestmark = pytest.mark.browser
LOOK = {"lighting": {"mode": "none"}, "background": "#336699", "silhouette": 0.5}


@pytest.fixture
def meshes(tmp_path: Path) -> Path:
    """Four meshes, one with a status beside it, one of them broken; a deck of two files."""
    folder = tmp_path / "meshes"
    (folder / "deep").mkdir(parents=True)
    hexalab.write(grid(3, 3, 3, noise=0.2), folder / "box.mesh")
    hexalab.write(grid(4, 1, 1, noise=0.1), folder / "deep" / "bar.vtk")
    (folder / "deep" / "bar.json").write_text(json.dumps({"background": "#102030"}))
    (folder / "broken.vtk").write_text("nonsense")
    hexalab.write(grid(2, 1, 1), folder / "deep" / "part.inp")
    (folder / "deep" / "part.inp").rename(folder / "deep" / "all.inp")
    (folder / "deep" / "job.inp").write_text("*HEADING\n*INCLUDE, INPUT=all.inp\n")
    (folder / ".hidden.mesh").write_text("nonsense")
    (tmp_path / "look.json").write_text(json.dumps(LOOK))
    return folder


@pytest.fixture(scope="module")
def alone() -> dict[str, bytes]:
    """What one process made of the meshes, once that was asked for."""
    return {}


def made_alone(alone: dict[str, bytes], words: list[str], out: Path) -> dict[str, bytes]:
    """What one process makes of the meshes, which is made once."""
    if not alone:
        hexalab_says(*words, "-o", out)
        alone |= contents(out)
    return alone


@pytest.fixture
def words(meshes: Path, tmp_path: Path) -> list[str]:
    """The arguments that all runs have in common."""
    return ["batch", str(meshes), "--status", str(tmp_path / "look.json"), "--width", "120", "--height", "80"]


def hexalab_says(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "hexalab", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT, timeout=300)


def contents(place: Path) -> dict[str, bytes]:
    """What a batch has left, the records of what is done left out."""
    source = Source(place)
    return {name: source.read(name) for name in source.names() if not name.startswith(KEPT)}


def zipped(folder: Path, target: Path) -> Path:
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as pack:
        for name in Source(folder).names():
            pack.write(folder / name, name)
    return target


CHARTS = {
    f"{stem}-scaled_jacobian.{form}" for stem in ("box", "deep/bar", "deep/job") for form in ("png", "svg")
}
FILES = {"box.png", "deep/bar.png", "deep/job.png", "measurements.csv", "measurements.json"} | CHARTS


def test_B2_a_folder_gives_what_the_page_gives_of_the_same_archive(
    viewer: Page, meshes: Path, words: list[str], tmp_path: Path, alone: dict[str, bytes]
) -> None:
    done = hexalab_says(*words, "-o", tmp_path / "out")
    assert (done.returncode, done.stdout) == (1, f"{tmp_path / 'out'}: 3 of 4 meshes\n")
    assert done.stderr.startswith("hexalab: broken.vtk, line 1: ") and done.stderr.count("\n") == 1
    ours = contents(tmp_path / "out")
    alone |= ours
    assert set(ours) == FILES
    rows = {row["name"]: row for row in csv.DictReader(io.StringIO(ours["measurements.csv"].decode()))}
    assert list(rows) == ["box.mesh", "broken.vtk", "deep/bar.vtk", "deep/job.inp"]
    assert [rows[name]["cells"] for name in rows] == ["27", "", "4", "2"]
    assert "vtk DataFile" in rows["broken.vtk"]["problem"]
    for name, colour in (("box.png", (0x33, 0x66, 0x99)), ("deep/bar.png", (0x10, 0x20, 0x30))):
        picture = Image.open(io.BytesIO(ours[name])).convert("RGB")
        assert (picture.size, picture.getpixel((0, 0))) == ((120, 80), colour)

    archive = zipped(meshes, tmp_path / "meshes.zip").read_bytes()
    with viewing(meshes / "box.mesh") as program, visited(viewer.context.browser, program.address) as page:
        assert batch_of_page(page, archive, tmp_path) == ours, "one core: to the last digit, and to the pixel"
    theirs = batch_of_page(viewer, archive, tmp_path)
    assert set(theirs) == FILES
    tables = [csv.reader(io.StringIO(one["measurements.csv"].decode())) for one in (ours, theirs)]
    for mine, other in zip(*tables, strict=True):
        assert len(mine) == len(other)
        for here, there in zip(mine, other, strict=True):
            # Two C libraries round the last bit of roots and angles otherwise.
            assert here == there or float(here) == pytest.approx(float(there), rel=2e-15)
    for name in FILES - CHARTS:
        if name.endswith(".png"):
            pixels = [Image.open(io.BytesIO(one[name])).convert("RGB").tobytes() for one in (ours, theirs)]
            assert pixels[0] == pixels[1], name


def batch_of_page(page: Page, archive: bytes, folder: Path) -> dict[str, bytes]:
    """What the page's own batch makes of an archive."""
    made = page.evaluate(
        """async ([data, status]) => {
            const archive = new Blob([new Uint8Array(data)]);
            const zip = await window.hexalab.batch(archive, status, { width: 120, height: 80 });
            return [...new Uint8Array(await zip.arrayBuffer())];
        }""",
        [list(archive), LOOK],
    )
    (folder / "page.zip").write_bytes(bytes(made))
    return contents(folder / "page.zip")


def test_B3_processes_side_by_side_and_an_archive_give_the_same(
    words: list[str], tmp_path: Path, meshes: Path, alone: dict[str, bytes]
) -> None:
    before = made_alone(alone, words, tmp_path / "one")
    archive = zipped(meshes, tmp_path / "meshes.zip")
    words[1] = str(archive)
    done = hexalab_says(*words, "-o", tmp_path / "two.zip", "--jobs", "2")
    assert done.returncode == 1
    assert contents(tmp_path / "two.zip") == before
    assert not list(tmp_path.glob("*.partial")) and not list(tmp_path.glob("*.half"))


def test_B3_a_batch_goes_on_where_it_was_left(words: list[str], tmp_path: Path, meshes: Path) -> None:
    out = tmp_path / "out"
    hexalab_says(*words, "-o", out)
    before = contents(out)
    times = {name: (out / name).stat().st_mtime_ns for name in ("box.png", "deep/bar.png")}
    hexalab.write(grid(2, 2, 2), meshes / "broken.vtk")  # mended
    hexalab.write(grid(5, 1, 1), meshes / "deep" / "bar.vtk")  # another mesh
    done = hexalab_says(*words, "-o", out, "--resume")
    assert (done.returncode, done.stdout) == (0, f"{out}: 4 of 4 meshes, 2 of them before\n")
    assert (out / "box.png").stat().st_mtime_ns == times["box.png"]
    assert (out / "deep/bar.png").stat().st_mtime_ns > times["deep/bar.png"]
    after = contents(out)
    rows = {row["name"]: row for row in csv.DictReader(io.StringIO(after["measurements.csv"].decode()))}
    assert [row["cells"] for row in rows.values()] == ["27", "8", "5", "2"]
    line = next(
        row for row in csv.reader(io.StringIO(before["measurements.csv"].decode())) if row[0] == "box.mesh"
    )
    assert line == list(rows["box.mesh"].values())


@pytest.fixture
def pairs(tmp_path: Path) -> tuple[Path, Path]:
    """Two folders: a mesh whose vertices have moved, one that is a surface in the second, and one that is not there."""
    before, after = tmp_path / "before", tmp_path / "after"
    for folder in (before, after):
        (folder / "deep").mkdir(parents=True)
    hexalab.write(grid(3, 3, 3, noise=0.1), before / "box.mesh")
    hexalab.write(grid(3, 3, 3, noise=0.3), after / "box.mesh")
    hexalab.write(grid(4, 1, 1), before / "deep" / "bar.vtk")
    (after / "deep" / "bar.off").write_text("OFF\n3 1 0\n0 0 2\n4 0 2\n0 1 2\n3 0 1 2\n")
    hexalab.write(grid(1, 1, 1), before / "lonely.mesh")
    (tmp_path / "look.json").write_text(json.dumps(LOOK))
    return before, after


def rows_in(made: dict[str, bytes]) -> dict[str, dict[str, str]]:
    """The table's rows, by the name of the mesh."""
    return {row["name"]: row for row in csv.DictReader(io.StringIO(made["measurements.csv"].decode()))}


def check_against(row: dict[str, str], facts: dict[str, Any]) -> None:
    """Every column of a comparison has the number that the core gives."""
    expected: dict[str, Any] = {
        "same_cells": facts["same_connectivity"],
        "volume_ratio": facts["volume_ratio"],
        **{name: facts["distance"][name] for name in ("hausdorff", "hausdorff_percent")},
    }
    for way in ("a_to_b", "b_to_a"):
        for name in ("max", "mean", "rms"):
            for unit in ("", "_percent"):
                expected[f"distance_{way}_{name}{unit}"] = facts["distance"][way][f"{name}{unit}"]
    for metric, numbers in facts["difference"].items():
        expected |= {f"{metric}_difference_{name}": value for name, value in numbers.items()}
    for metric, counts in (facts["changes"] or {}).items():
        expected |= {f"{metric}_{name}": counts[name] for name in ("worse", "better")}
    for column, value in expected.items():
        if value is None or isinstance(value, bool):
            assert row[column] == ("" if value is None else str(value).lower()), column
        else:
            assert float(row[column]) == value, column
    columns = list(row)
    compared = {column for column in columns[columns.index("with") :] if row[column] != ""}
    assert compared - {"with"} == {column for column, value in expected.items() if value is not None}


def test_B2_each_mesh_is_compared_with_its_counterpart(pairs: tuple[Path, Path], tmp_path: Path) -> None:
    before, after = pairs
    look = ["--status", tmp_path / "look.json", "--width", "240", "--height", "100"]
    words = ["batch", before, "--with", after, *look]
    done = hexalab_says(*words, "-o", tmp_path / "out")
    assert (done.returncode, done.stdout) == (1, f"{tmp_path / 'out'}: 2 of 3 meshes\n")
    assert done.stderr == f"hexalab: lonely.mesh: {after} holds nothing of this name to compare with\n"
    made = contents(tmp_path / "out")
    rows = rows_in(made)
    assert [rows[name]["with"] for name in rows] == ["box.mesh", "deep/bar.off", ""]
    a, b = (hexalab.read(folder / "box.mesh") for folder in pairs)
    check_against(rows["box.mesh"], compare(a, b))
    bar = hexalab.read(before / "deep" / "bar.vtk")
    check_against(rows["deep/bar.vtk"], compare(bar, read_reference(after / "deep" / "bar.off")))
    told = {one["name"]: one for one in json.loads(made["measurements.json"])["meshes"]}
    assert told["box.mesh"]["comparison"]["changes"] == compare(a, b)["changes"]
    assert told["deep/bar.vtk"]["comparison"]["with"] == "deep/bar.off"
    picture = Image.open(io.BytesIO(made["box.png"])).convert("RGB")
    ground = (0x33, 0x66, 0x99)
    assert picture.size == (240, 100)
    for left in (0, 120):
        half = picture.crop((left, 0, left + 120, 84))  # labels are below
        assert sum(pixel != ground for pixel in half.get_flattened_data()) > 500, "both are in it"

    hexalab.write(grid(3, 3, 3), after / "box.mesh")
    again = hexalab_says(*words, "-o", tmp_path / "out", "--resume", "--jobs", "2")
    assert (again.returncode, again.stdout) == (1, f"{tmp_path / 'out'}: 2 of 3 meshes, 1 of them before\n")
    check_against(rows_in(contents(tmp_path / "out"))["box.mesh"], compare(a, grid(3, 3, 3)))


def test_B1_the_page_compares_each_of_an_archive_with_what_it_shows(
    pairs: tuple[Path, Path], tmp_path: Path, chromium: Browser
) -> None:
    before, after = pairs
    (before / "lonely.mesh").unlink()
    archive = zipped(before, tmp_path / "before.zip")
    other = after / "box.mesh"
    with (
        viewing(before / "deep" / "bar.vtk", other, "--compare") as program,
        visited(chromium, program.address) as page,
    ):
        until(lambda: page.evaluate("() => window.hexalab.comparison()?.second?.cells") == 27)
        look = {**LOOK, "compare": {"layout": "curtain"}, "colour": {"by": "quality"}}
        page.evaluate("(look) => window.hexalab.setStatus(look)", look)
        here = status(page)
        page.set_input_files("#file", archive)
        dialog = page.locator("#batch")
        until(dialog.is_visible)
        assert "Each is compared with box.mesh: its picture shows both" in dialog.inner_text()
        dialog.get_by_label("Width").fill("240")
        dialog.get_by_label("Width").press("Enter")
        with page.expect_download(timeout=120_000) as waiting:
            dialog.get_by_role("button", name="Start").click()
        made = contents(Path(waiting.value.path()))
        assert status(page) == here
        assert page.evaluate("() => window.hexalab.comparison().second.cells") == 27
        assert page.evaluate("() => window.hexalab.summary().cells") == 4

        page.evaluate(
            "(file) => window.hexalab.compare(new File([file], 'bar.off'))",
            (after / "deep" / "bar.off").read_text(),
        )
        page.evaluate("() => window.hexalab.setStatus({ compare: { reference: { shown: false } } })")
        here = status(page)
        film = batch_of_page(page, archive.read_bytes(), tmp_path)
        assert status(page) == here and not here["compare"]["reference"]["shown"]
        assert page.evaluate("() => window.hexalab.comparison().name") == "bar.off"
    rows = rows_in(made)
    assert [(row["with"], row["problem"]) for row in rows.values()] == [("box.mesh", "")] * 2
    for name, row in rows.items():
        check_against(row, compare(hexalab.read(before / name), hexalab.read(other)))
    assert Image.open(io.BytesIO(made["box.png"])).size == (240, 960)
    surface = read_reference(after / "deep" / "bar.off")
    for name, row in rows_in(film).items():
        check_against(row, compare(hexalab.read(before / name), surface))
    assert Image.open(io.BytesIO(film["box.png"])).size == (120, 80)


def test_B3_an_interrupted_batch_leaves_what_is_done(words: list[str], tmp_path: Path) -> None:
    out = tmp_path / "out.zip"
    command = [sys.executable, "-m", "hexalab", *words, "-o", str(out)]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=ENVIRONMENT
    )
    partial = tmp_path / "out.zip.partial"
    until(lambda: (partial / KEPT / "box.json").is_file(), 60)
    process.send_signal(signal.SIGINT)
    _, complaint = process.communicate(timeout=60)
    assert process.returncode == 130, complaint
    assert "--resume goes on" in complaint and "Traceback" not in complaint
    assert (partial / "box.png").is_file() and b"box.mesh" in (partial / "measurements.csv").read_bytes()
    done = hexalab_says(*words, "-o", out, "--resume")
    assert "of them before" in done.stdout and done.returncode == 1
    assert set(contents(out)) == FILES and not partial.exists()


def test_B3_a_process_that_dies_costs_its_own_mesh_alone(
    words: list[str], tmp_path: Path, meshes: Path
) -> None:
    code = (
        "import os, hexalab.hosts.batching.work as work, hexalab.hosts.labour.worker as worker\n"
        "run = work.run\n"
        "work.run = lambda job: os._exit(9) if job['name'] == 'box.mesh' else run(job)\n"
        "worker.main()\n"
    )
    (tmp_path / "dying.py").write_text(code)
    script = (
        "import sys\nfrom hexalab.hosts.labour import crew\nfrom hexalab import cli\n"
        "crew.WORKER = ['dying']\nsys.exit(cli.main(sys.argv[1:]))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, *words, "-o", str(tmp_path / "out")],
        capture_output=True, text=True, timeout=300,
        env={**ENVIRONMENT, "PYTHONPATH": os.pathsep.join([str(ROOT / "core"), str(tmp_path)])},
    )  # fmt: skip
    assert done.returncode == 1, done.stderr
    assert "box.mesh: the process ended with code 9" in done.stderr
    assert "2 of 4 meshes" in done.stdout


def test_B3_a_cluster_gives_the_same(words: list[str], tmp_path: Path, alone: dict[str, bytes]) -> None:
    pytest.importorskip("distributed")
    before = made_alone(alone, words, tmp_path / "one")
    with cluster(tmp_path, 2) as (file, _):
        done = hexalab_says(*words, "-o", tmp_path / "two", "--scheduler", file)
    assert done.returncode == 1, done.stderr
    assert done.stderr.startswith("hexalab: broken.vtk, line 1: "), done.stderr
    assert contents(tmp_path / "two") == before


def test_B3_a_scheduler_that_is_not_there_is_told(words: list[str], tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    began = time.monotonic()
    done = hexalab_says(*words, "-o", tmp_path / "out", "--scheduler", "tcp://127.0.0.1:9")
    assert (done.returncode, done.stdout) == (2, "")
    assert "no scheduler answers at tcp://127.0.0.1:9" in done.stderr and done.stderr.count("\n") == 1
    assert time.monotonic() - began < 120


def test_B2_what_can_not_be_is_said_in_a_line(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    for words, said in (
        (["missing", "-o", "out"], "missing: no such file"),
        (["empty", "-o", "out"], "there is no mesh in it"),
        (["empty", "-o", "out", "--jobs", "0"], "expected a number from 1"),
        (["empty", "-o", "out", "--width", "10"], "give both"),
    ):
        places = {word: tmp_path / word for word in ("missing", "empty", "out")}
        done = hexalab_says("batch", *(places.get(word, word) for word in words))
        assert done.returncode == 2 and said in done.stderr and done.stderr.count("\n") == 1, done.stderr
