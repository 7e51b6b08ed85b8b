"""The command line (SPEC A2): what it prints, its exit codes, one line on stderr for a user's mistake."""

from __future__ import annotations

import csv
import gzip
import io
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from hexalab import cli, read, write
from hexalab.diagnosis import TURNED
from hexalab.quality import METRICS
from hexalab.words import number
from tests.tools import needs

ROOT = Path(__file__).parents[3]

KEYS = [
    "file", "format", "vertices", "cells", "kinds", "faces", "boundary_faces", "nonmanifold_faces",
    "edges", "interior_edge_valence", "boundary_edge_valence", "cells_per_depth", "components",
    "unreferenced_vertices", "cells_repeating_a_vertex", "findings", "quality", "groups", "features",
]  # fmt: skip
STATISTICS = ["min", "max", "mean", "median", "variance", "not_finite", "outside_acceptable"]


Run = Callable[..., tuple[int, str, str]]

PACKAGES = {
    "render": "playwright", "build": "jinja2", "validate": "jinja2", "new-source": "jinja2",
}  # fmt: skip
"""What a verb needs besides numpy."""


def test_A2_info_json_has_the_keys_and_the_facts(run: Run, mesh_file: Path) -> None:
    code, out, err = run("info", "--json", mesh_file)
    facts = json.loads(out)
    assert (code, err) == (0, "")
    assert list(facts) == KEYS
    assert facts["file"] == str(mesh_file)
    assert (facts["vertices"], facts["cells"], facts["kinds"]) == (60, 24, {"hexahedron": 24})
    assert (facts["faces"], facts["boundary_faces"], facts["edges"]) == (98, 52, 133)
    assert facts["interior_edge_valence"] == {"4": 29}
    assert facts["boundary_edge_valence"] == {"1": 36, "2": 68}
    assert facts["cells_per_depth"] == [24]
    assert (facts["components"], facts["nonmanifold_faces"], facts["unreferenced_vertices"]) == (1, 0, 0)
    assert facts["findings"] == []
    assert list(facts["quality"]) == list(METRICS)
    sj = facts["quality"]["scaled_jacobian"]
    assert list(sj) == STATISTICS
    assert (sj["min"], sj["max"], sj["variance"]) == (1, 1, 0)


def test_A2_info_prints_one_object_per_file_and_goes_on_after_a_bad_one(
    run: Run, mesh_file: Path, tmp_path: Path
) -> None:
    bad, zipped = tmp_path / "bad.mesh", tmp_path / "grid.mesh.gz"
    bad.write_bytes(mesh_file.read_bytes()[:200])
    zipped.write_bytes(gzip.compress(mesh_file.read_bytes()))
    code, out, err = run("info", "--json", tmp_path / "none.mesh", mesh_file, bad, zipped)
    facts = [json.loads(line) for line in out.splitlines()]
    assert code == 2
    assert [found["file"] for found in facts] == [str(mesh_file), str(zipped)]
    assert facts[0]["quality"] == facts[1]["quality"]
    complaints = err.splitlines()
    assert len(complaints) == 2
    assert complaints[0].startswith("hexalab: ") and "none.mesh" in complaints[0]
    assert "bad.mesh" in complaints[1]


def test_A2_info_without_json_reads_well(run: Run, mesh_file: Path, twisted: bytes, tmp_path: Path) -> None:
    other = tmp_path / "twisted.mesh"
    other.write_bytes(twisted)
    code, out, _ = run("info", mesh_file, other)
    assert code == 0
    first, second = out.split(str(other))
    assert "24 hexahedra" in first
    assert "98, 52 on the boundary" in first
    assert re.search(r"^  Scaled Jacobian +1\.000 +1\.000", first, re.MULTILINE)
    assert "finding: " in second and "finding: " not in first
    assert max(map(len, out.splitlines())) <= 110


def test_A2_info_strict_tells_an_invalid_cell_by_its_exit_code(
    run: Run, mesh_file: Path, twisted: bytes, tmp_path: Path
) -> None:
    other = tmp_path / "twisted.mesh"
    other.write_bytes(twisted)
    assert run("info", "--strict", mesh_file)[0] == 0
    assert run("info", other)[0] == 0
    assert run("info", "--strict", other, mesh_file)[0] == 1
    assert run("info", "--strict", other, tmp_path / "none")[0] == 2


def test_R9_a_mesh_of_inverted_cells_is_turned_round_and_that_is_told(
    run: Run, grid: Callable[..., bytes], tmp_path: Path
) -> None:
    path = tmp_path / "inverted.mesh"
    path.write_bytes(grid(2, 2, 2, inverted=True))
    code, out, _ = run("info", "--strict", path)
    assert code == 1
    assert "turned" in out
    facts = json.loads(run("info", "--json", path)[1])
    assert facts["quality"]["volume"]["min"] == 1


def test_A2_quality_json(run: Run, mesh_file: Path) -> None:
    code, out, err = run("quality", mesh_file, "--json")
    assert (code, err) == (0, "")
    found = json.loads(out)
    assert list(found) == list(METRICS)
    assert list(found["shape"]) == STATISTICS


def test_A2_quality_json_with_cells_gives_the_values_in_file_order(
    run: Run, twisted: bytes, tmp_path: Path
) -> None:
    path = tmp_path / "twisted.mesh"
    path.write_bytes(twisted)
    words = ("quality", path, "--metric", "volume", "--metric", "oddy", "--json", "--cells")
    found = json.loads(run(*words)[1])
    assert list(found) == ["volume", "oddy"]
    assert found["volume"]["values"][0] == 1
    assert found["volume"]["values"][1] < 1
    assert found["oddy"]["values"][1] is None
    assert found["oddy"]["not_finite"] == 1


def test_A2_quality_csv(run: Run, mesh_file: Path) -> None:
    words = ("quality", mesh_file, "--metric", "volume", "--csv")
    rows = list(csv.reader(io.StringIO(run(*words)[1])))
    assert rows[0] == ["metric", *STATISTICS]
    assert rows[1][:3] == ["volume", "1.0", "1.0"]
    cells = list(csv.reader(io.StringIO(run(*words, "--cells")[1])))
    assert cells[0] == ["cell", "volume"]
    assert cells[1:] == [[str(cell), "1.0"] for cell in range(1, 25)]  # Medit counts from 1


def test_A2_quality_table(run: Run, mesh_file: Path) -> None:
    code, out, _ = run("quality", mesh_file, "--metric", "skew")
    assert code == 0
    assert out.splitlines()[1].split() == [
        "min", "mean", "median", "max", "variance", "outside", "not", "finite",
    ]  # fmt: skip
    assert out.splitlines()[2].split() == ["Skew", *["0.000"] * 5, "0", "0"]


@pytest.mark.parametrize("verb", ["info", "quality"])
def test_A2_a_unit_is_told_in_the_table_and_nothing_is_converted(
    run: Run, mesh_file: Path, verb: str
) -> None:
    _, plain, _ = run(verb, mesh_file)
    code, out, err = run(verb, mesh_file, "--unit", "um")
    assert (code, err) == (0, "")
    named = {"Jacobian (µm³)", "Volume (µm³)", "Dimension (µm)", "Characteristic Length (µm)"}
    assert set(re.findall(r"^  (.+? \(\S+\))  ", out, re.MULTILINE)) == named
    assert re.sub(r" \(µm³?\)", "", out).split() == plain.split()
    code, _, err = run(verb, mesh_file, "--unit", "yard")
    assert code == 2 and "yard" in err


@pytest.mark.parametrize("ending", ["mesh", "vtk", "vtu", "meshb", "msh", "inp", "msh.gz"])
def test_A2_convert(run: Run, mesh_file: Path, tmp_path: Path, ending: str) -> None:
    target = tmp_path / f"out.{ending}"
    code, out, err = run("convert", mesh_file, target)
    assert (code, err) == (0, "")
    assert out == f"{target}: 24 cells, 60 vertices\n"
    mesh, old = read(target), read(mesh_file)
    assert (mesh.points == old.points).all()
    assert (mesh.cells == old.cells).all()


def test_R9_what_reading_assumed_is_told_when_converting(
    run: Run, grid: Callable[..., bytes], tmp_path: Path
) -> None:
    path = tmp_path / "inverted.mesh"
    path.write_bytes(grid(1, 1, 1, inverted=True))
    code, out, err = run("convert", path, tmp_path / "out.vtk")
    assert code == 0
    assert out.endswith(": 1 cell, 8 vertices\n")
    assert "--orient turns the mesh round" in err
    assert read(tmp_path / "out.vtk").notes == [TURNED]
    code, _, err = run("convert", "--orient", path, tmp_path / "out.vtk")
    assert code == 0
    assert "has been turned round" in err
    assert read(tmp_path / "out.vtk").notes == []


def test_R8_numbers_are_kept_or_told(run: Run, mesh_file: Path, tmp_path: Path) -> None:
    mesh = read(mesh_file)
    numbered = replace(mesh, cell_numbers=np.arange(mesh.cell_count) * 7 + 100)
    assert write(numbered, tmp_path / "in.inp") == []
    code, _, err = run("convert", "--format", "msh2", tmp_path / "in.inp", tmp_path / "out.txt")
    assert (code, err) == (0, "")
    assert (tmp_path / "out.txt").read_text().startswith("$MeshFormat\n2.2 ")
    assert (read(tmp_path / "out.txt").cell_numbers == numbered.cell_numbers).all()
    code, _, err = run("convert", tmp_path / "out.txt", tmp_path / "out.vtk")
    assert (code, err) == (0, "")
    assert (read(tmp_path / "out.vtk").cell_numbers == numbered.cell_numbers).all()
    code, _, err = run("convert", tmp_path / "out.txt", tmp_path / "out.mesh")
    assert "no place for the numbers of elements" in err and "nodes" not in err


@pytest.mark.parametrize(("ending", "lost"), [("mesh", True), ("vtu", False)])
def test_R8_attributes_that_a_format_cannot_hold_are_told(
    run: Run, mesh_file: Path, tmp_path: Path, ending: str, lost: bool
) -> None:
    mesh = read(mesh_file)
    mesh.cell_data = {"reference": np.arange(mesh.cell_count), "stress": np.ones(mesh.cell_count)}
    write(mesh, tmp_path / "in.vtk")
    code, _, err = run("convert", tmp_path / "in.vtk", tmp_path / f"out.{ending}")
    assert code == 0
    assert ("stress" in err) == lost
    assert "reference" not in err
    assert ("stress" in read(tmp_path / f"out.{ending}").cell_data) != lost


def test_A2_many_layers_are_cut_short(run: Run, grid: Callable[..., bytes], tmp_path: Path) -> None:
    path = tmp_path / "thick.mesh"
    path.write_bytes(grid(27, 27, 27))
    layers = re.search(r"cells by depth +(.*)", run("info", path)[1])
    assert layers and layers[1].startswith(f"{27**3 - 25**3:,} {25**3 - 23**3:,} ")
    assert layers[1].endswith("and 2 layers more")


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (None, "-"),
        (0.0, "0.000"),
        (0.12345, "0.123"),
        (0.0004, "4.00e-04"),
        (-1234.5, "-1,234.500"),
        (1e6, "1.00e+06"),
    ],
)
def test_A2_numbers_never_read_zero_unless_they_are(value: float | None, text: str) -> None:
    assert number(value) == text


def test_A2_too_little_memory_is_told(run: Run, mesh_file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def exhaust(argv: list[str]) -> int:
        raise MemoryError

    monkeypatch.setattr(cli, "run", exhaust)
    assert run("info", mesh_file) == (2, "", "hexalab: not enough memory for this mesh\n")


MISTAKES = [
    ([], "which verb? One of info"),
    (["inform"], "inform"),
    (["info"], "FILE"),
    (["info", "--jsn", "x"], "--jsn"),
    (["info", "none.mesh"], "none.mesh"),
    (["info", "."], "."),
    (["quality", "GRID", "--metric", "scaled jacobian"], "did you mean scaled_jacobian?"),
    (["quality", "GRID", "--metric", "xyz"], "no metric 'xyz'"),
    (["quality", "GRID", "--json", "--csv"], "--json"),
    (["quality", "POLYGONS"], "polygons.vtk"),
    (["quality", "EMPTY"], "empty"),
    (["quality", "PNG"], "PNG"),
    (["convert", "GRID", "out.xyz"], "out.xyz"),
    (["serve", "--port", "70000"], "from 0 to 65535"),
    (["convert", "GRID", "no/such/folder/out.vtk"], "out.vtk"),
]


@pytest.mark.parametrize(("words", "told"), MISTAKES)
def test_A2_a_users_mistake_is_one_line_and_exit_code_2(
    run: Run, mesh_file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str], told: str
) -> None:
    monkeypatch.chdir(tmp_path)
    files = {
        "POLYGONS": b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n",
        "EMPTY": b"",
        "PNG": b"\x89PNG\r\n\x1a\n" + bytes(50),
    }
    names = {"GRID": "grid.mesh", "POLYGONS": "polygons.vtk", "EMPTY": "empty.mesh", "PNG": "picture.mesh"}
    for name, data in files.items():
        Path(names[name]).write_bytes(data)
    code, out, err = run(*(names.get(word, word) for word in words))
    assert code == 2
    assert out == ""
    assert re.fullmatch(r"hexalab[^\n]*: [^\n]+\n", err)
    assert told in err
    assert "Traceback" not in err


@pytest.mark.parametrize(
    "verb", [verb for verb, row in cli.VERBS.items() if row.module.startswith("hexalab.")]
)
def test_A2_help_for_every_verb(run: Run, verb: str) -> None:
    if verb in PACKAGES:
        needs(PACKAGES[verb])
    code, out, err = run(verb, "--help")
    assert (code, err) == (0, "")
    assert out.startswith(f"usage: hexalab {verb}")
    assert cli.VERBS[verb].help in run("--help")[1]


def test_A2_version(run: Run) -> None:
    from hexalab import __version__

    assert run("--version") == (0, f"hexalab {__version__}\n", "")


def test_A2_an_interrupt_is_no_traceback(run: Run, mesh_file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(argv: list[str]) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr(cli, "run", interrupt)
    assert run("info", mesh_file) == (130, "", "")


@pytest.mark.skipif(sys.platform == "emscripten", reason="starts processes")
@pytest.mark.skipif(
    sys.platform == "win32", reason="Windows has no broken pipes: it tells of an invalid argument"
)
def test_A2_as_a_process_whose_reader_leaves(mesh_file: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "core")}
    command = [sys.executable, "-m", "hexalab", "info", "--json", *[str(mesh_file)] * 40]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment)
    assert process.stdout and process.stderr
    assert json.loads(process.stdout.readline())["cells"] == 24
    process.stdout.close()
    assert process.stderr.read() == b""
    assert process.wait() == 141
