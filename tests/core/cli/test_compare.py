"""`hexalab compare` (SPEC S7): what it prints, what it decides, what it writes."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hexalab import METRICS, Mesh, quality, read, summarise, write
from tests.core.conftest import grid_points

Run = Callable[..., tuple[int, str, str]]

EXAMPLE = Path(__file__).resolve().parents[3] / "docs" / "examples" / "compare.yaml"

SQUARE = "OFF\n4 1 0\n0 0 2\n3 0 2\n3 2 2\n0 2 2\n4 0 1 2 3\n"


@pytest.fixture
def pair(tmp_path: Path) -> tuple[Path, Path]:
    """A grid of 3 x 2 x 1 unit cubes, and the same with one corner pushed in."""
    before = Mesh.from_cells(*grid_points((3, 2, 1)))
    coordinates = before.coordinates.copy()
    coordinates[:, 0] += (0.3, 0.2, 0.1)
    paths = tmp_path / "before.mesh", tmp_path / "after.mesh"
    for mesh, path in zip((before, replace(before, coordinates=coordinates)), paths, strict=True):
        write(mesh, path)
    return paths


def test_S7_json_has_what_the_specification_names(run: Run, pair: tuple[Path, Path]) -> None:
    code, out, err = run("compare", *pair, "--json")
    assert (code, err) == (0, "")
    facts = json.loads(out)
    for side, path in zip("ab", pair, strict=True):
        assert facts[side] == {**json.loads(json.dumps(summarise(read(path)))), "file": str(path)}
    for metric in METRICS:
        first, second = (quality(read(path), metric) for path in pair)
        for name, of in (("min", np.min), ("mean", np.mean), ("max", np.max)):
            assert facts["difference"][metric][name] == pytest.approx(of(second) - of(first), abs=1e-12)
    assert facts["same_connectivity"] is True
    way = 0.14**0.5
    there = facts["distance"]["b_to_a"]
    assert there["max"] == pytest.approx(0.1), "pushed into the box, its nearest face is below"
    assert facts["distance"]["a_to_b"]["max"] <= way
    assert facts["distance"]["hausdorff"] == max(
        facts["distance"][name]["max"] for name in ("a_to_b", "b_to_a")
    )
    assert facts["distance"]["hausdorff_percent"] == pytest.approx(
        100 * facts["distance"]["hausdorff"] / 14**0.5
    )
    assert facts["volume_ratio"] < 1
    assert facts["changes"]["scaled_jacobian"]["worse"] == 1
    assert facts["displacement"]["max"] == pytest.approx(way)


def test_S7_text_tells_the_same(run: Run, pair: tuple[Path, Path]) -> None:
    code, out, err = run(
        "compare", *pair, "--metric", "scaled_jacobian", "--metric", "volume", "--unit", "mm"
    )
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert lines[0] == f"A  {pair[0]}: 6 hexahedra, 24 vertices"
    assert "The cells are the same; 1 vertex moved, by 0.374 at most (10.000 % of the diagonal)" in lines[2]
    volume = next(line for line in lines if line.lstrip().startswith("Volume (mm³)"))
    assert volume.split()[2:5] == ["1.000", "0.850", "-0.150"], (
        "a quarter of what the corner went, along each axis"
    )
    (row,) = (
        line for line in lines if line.startswith("  Scaled Jacobian  ") and line.rstrip().endswith(" 1")
    )
    assert row.split()[2:5] == ["1", "0", "5"]
    assert "largest (mm)" in out
    assert "Hausdorff distance, of vertices" in out


def test_S7_meshes_of_other_cells_say_so(run: Run, pair: tuple[Path, Path], mesh_file: Path) -> None:
    code, out, _ = run("compare", pair[0], mesh_file, "--json")
    facts = json.loads(out)
    assert (code, facts["same_connectivity"], facts["changes"]) == (0, False, None)
    _, text, _ = run("compare", pair[0], mesh_file)
    assert "The cells are not the same: 24 vertices and 60." in text
    assert "Cell by cell" not in text


@pytest.mark.parametrize("name", ["square.off", "faces.mesh"])
def test_S7_a_surface_is_measured_against(
    run: Run, pair: tuple[Path, Path], tmp_path: Path, name: str
) -> None:
    surface = tmp_path / name
    rows = ["MeshVersionFormatted 2", "Dimension 3", "Vertices 4", "0 0 2 0", "3 0 2 0", "3 2 2 0", "0 2 2 0"]
    faces = "\n".join([*rows, "Quadrilaterals 1", "1 2 3 4 0", "End"])
    surface.write_text(SQUARE if name.endswith("off") else faces)
    code, out, err = run("compare", pair[0], surface, "--json")
    assert (code, err) == (0, "")
    facts = json.loads(out)
    assert (facts["b"]["triangles"], facts["b"]["closed"], facts["b"]["area"]) == (2, False, 6)
    assert (facts["distance"]["a_to_b"]["max"], facts["distance"]["b_to_a"]["max"]) == (2, 1)
    assert (facts["volume_ratio"], facts["difference"]) == (None, {})
    _, text, _ = run("compare", pair[0], surface)
    assert "a surface of 2 triangles, open" in text


CRITERIA: list[tuple[dict[str, Any], int, str]] = [
    ({"difference": "scaled_jacobian", "minimum": 0}, 1, "missed: Scaled Jacobian, min, B - A: at least 0"),
    ({"difference": "scaled_jacobian", "minimum": -0.9, "maximum": 0}, 0, ""),
    ({"difference": "volume", "of": "max", "minimum": 0, "maximum": 0}, 0, ""),
    ({"worse": "scaled_jacobian"}, 1, "1 of 6 cells got worse"),
    ({"worse": "scaled_jacobian", "share": 0.2}, 0, ""),
    ({"distance": "hausdorff", "maximum": 0.05}, 1, "missed: Distance, hausdorff: at most 0.05"),
    ({"distance": "mean", "maximum": 1, "percent": True}, 0, ""),
    ({"volume": 0.01}, 1, "missed: Volume gained or lost: at most 1 %"),
    ({"volume": 0.05}, 0, ""),
    ({"same_cells": True}, 0, ""),
    ({"same_cells": False}, 1, "missed: Not the same cells: They are the same."),
]


@pytest.mark.parametrize(("criterion", "expected", "words"), CRITERIA)
def test_S7_criteria_decide_on_the_exit_code(
    run: Run, pair: tuple[Path, Path], tmp_path: Path, criterion: dict[str, Any], expected: int, words: str
) -> None:
    file = tmp_path / "criteria.json"
    file.write_text(json.dumps({"criteria": [criterion]}))
    code, out, err = run("compare", *pair, "--json", "--criteria", file)
    assert (code, words in err, bool(err)) == (expected, True, expected == 1)
    verdict = json.loads(out)["verdict"]
    assert verdict["passed"] is (expected == 0)
    assert len(verdict["checks"]) == 1


def test_S7_the_example_of_criteria_can_be_asked(run: Run, pair: tuple[Path, Path]) -> None:
    pytest.importorskip("yaml")
    code, out, err = run("compare", *pair, "--json", "--criteria", EXAMPLE)
    states = [check["state"] for check in json.loads(out)["verdict"]["checks"]]
    assert (code, states) == (1, ["missed", "missed", "missed", "missed", "passed"])
    assert err.count("\n") == 4


def test_S7_what_can_not_be_measured_is_not_passed(
    run: Run, pair: tuple[Path, Path], mesh_file: Path, tmp_path: Path
) -> None:
    file = tmp_path / "criteria.json"
    file.write_text(json.dumps([{"worse": "volume"}]))
    code, _, err = run("compare", pair[0], mesh_file, "--criteria", file)
    assert code == 1
    assert "not measured: Volume got worse: at most 0 % of the cells: The cells are not the same" in err


@pytest.mark.parametrize(
    ("criterion", "words"),
    [
        ({"difference": "scaled_jacobian"}, "a difference without bounds"),
        ({"distance": "furthest", "maximum": 1}, "expected one of hausdorff, max, mean, rms"),
        ({"metric": "volume", "minimum": 1}, "one of difference, worse, distance, volume, same_cells"),
        ({"worse": "beauty"}, "expected the id of a metric"),
        ({"same_cells": "yes"}, "expected true or false"),
    ],
)
def test_S7_wrong_criteria_are_misuse(
    run: Run, pair: tuple[Path, Path], tmp_path: Path, criterion: dict[str, Any], words: str
) -> None:
    file = tmp_path / "criteria.json"
    file.write_text(json.dumps([criterion]))
    code, out, err = run("compare", *pair, "--criteria", file)
    assert (code, out, words in err, err.count("\n")) == (2, "", True, 1)


def test_S7_metrics_that_criteria_need_are_not_left_out(
    run: Run, pair: tuple[Path, Path], tmp_path: Path
) -> None:
    file = tmp_path / "criteria.json"
    file.write_text(json.dumps([{"worse": "shape"}]))
    code, _, err = run("compare", *pair, "--criteria", file, "--metric", "volume")
    assert (code, "asks for shape, which --metric leaves out" in err) == (2, True)


def test_S7_the_first_mesh_is_written_with_what_was_measured(
    run: Run, pair: tuple[Path, Path], tmp_path: Path
) -> None:
    out = tmp_path / "compared.vtu"
    code, _, err = run("compare", *pair, "--metric", "volume", "-o", out)
    assert (code, err) == (0, "")
    written = read(out)
    assert set(written.point_data) == {"distance", "displacement"}
    assert written.point_data["displacement"][0] == pytest.approx([0.3, 0.2, 0.1])
    first, second = (quality(read(path), "volume") for path in pair)
    assert written.cell_data["change_volume"] == pytest.approx(second - first, abs=1e-12)


def test_S7_a_file_that_is_not_there_or_broken_is_told_in_one_line(
    run: Run, pair: tuple[Path, Path], tmp_path: Path
) -> None:
    broken = tmp_path / "broken.stl"
    broken.write_bytes(b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n")
    for given in ((pair[0], tmp_path / "none.mesh"), (pair[0], broken), (broken, pair[0])):
        code, out, err = run("compare", *given)
        assert (code, out, err.count("\n")) == (2, "", 1)
    assert run("compare", *pair, "-o", tmp_path / "out.xyz")[0] == 2
