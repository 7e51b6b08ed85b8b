"""The command line on numbers, groups and features (SPEC R11, R12, R13)."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from hexalab import Group, Mesh, write

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def deck(tmp_path: Path) -> Path:
    """Eight cubes in a row, each twice as long as the one before; sets of elements, numbered 100, 107, ..."""
    places = np.array([[2.0**i - 1, j, k] for k in range(2) for j in range(2) for i in range(9)])
    corners = [[i + n for i in (0, 1, 10, 9, 18, 19, 28, 27)] for n in range(8)]
    mesh = Mesh.from_cells(
        places,
        corners,
        cell_numbers=np.arange(8) * 7 + 100,
        groups=(Group("SHORT", "elset", [0, 1, 2]), Group("LONG", "elset", [6, 7])),
    )
    write(mesh, tmp_path / "row.inp")
    return tmp_path / "row.inp"


def test_R11_the_worst_cells_by_the_numbers_of_the_file(run: Run, deck: Path) -> None:
    words = ("quality", deck, "--worst", 3, "--metric", "max_edge_ratio")
    found = json.loads(run(*words, "--json")[1])["max_edge_ratio"]
    assert [row["cell"] for row in found] == [149, 142, 135] and [row["row"] for row in found] == [7, 6, 5]
    assert [row["value"] for row in found] == [128, 64, 32]
    assert found[0]["barycentre"] == [191, 0.5, 0.5]
    assert run(*words)[1].splitlines()[3].split() == ["149", "128.000", "191.000", "0.500", "0.500"]
    rows = list(csv.reader(io.StringIO(run(*words, "--csv")[1])))
    assert rows[0] == ["metric", "cell", "value", "x", "y", "z"] and rows[1][1] == "149"
    assert run(*words, "--as", "elset")[1] == "*ELSET, ELSET=WORST\n149, 142, 135\n"
    assert run(*words, "--as", "list")[1] == "149\n142\n135\n"
    assert run(*words, "--as", "paraview")[1] == "isin(id, [7, 6, 5])\n"
    assert run("quality", deck, "--as", "list")[0] == 2
    assert run("quality", deck, "--worst", 0)[0] == 2


def test_R12_the_quality_of_a_group(run: Run, deck: Path) -> None:
    words = ("quality", deck, "--metric", "volume", "--json")
    assert json.loads(run(*words, "--group", "short")[1])["volume"]["max"] == 4
    assert json.loads(run(*words, "--group", "elset:LONG")[1])["volume"]["min"] == 64
    both = json.loads(run(*words, "--group", "LONG", "--group", "SHORT", "--cells")[1])
    assert both["volume"]["values"] == [1, 2, 4, 64, 128] and both["numbers"] == [100, 107, 114, 142, 149]
    code, out, err = run(*words, "--group", "WIDE")
    assert (code, out) == (2, "") and "it has elset:SHORT, elset:LONG" in err


def test_R12_info_lists_groups_and_features(run: Run, deck: Path) -> None:
    facts = json.loads(run("info", "--json", deck)[1])
    assert [(row["name"], row["kind"], row["origin"], row["count"]) for row in facts["groups"]] == [
        ("SHORT", "cells", "elset", 3),
        ("LONG", "cells", "elset", 2),
    ]
    assert facts["features"]["edges"] == {"count": 0, "lost": 0, "groups": []}
    assert "group: SHORT (elset), 3 cells" in run("info", deck)[1]


def test_R13_info_counts_features_and_those_that_the_mesh_does_not_hold(run: Run, tmp_path: Path) -> None:
    text = """MeshVersionFormatted 2 Dimension 3 Vertices 8
0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 0 1 0 1 0 1 0 1 1 1 0 0 1 1 0
Edges 3
1 2 5 2 3 5 1 3 6
Ridges 1
1
Quadrilaterals 2
1 2 3 4 4 1 2 7 8 8
Hexahedra 1
1 2 3 4 5 6 7 8 3 End"""
    (tmp_path / "x.mesh").write_text(text)
    facts = json.loads(run("info", "--json", tmp_path / "x.mesh")[1])
    assert (facts["features"]["edges"]["count"], facts["features"]["edges"]["lost"]) == (3, 1)
    assert (facts["features"]["faces"]["count"], facts["features"]["faces"]["lost"]) == (2, 1)
    assert {row["id"]: row["count"] for row in facts["features"]["edges"]["groups"]} == {
        "mark:ridges": 1,
        "reference:5": 2,
        "reference:6": 1,
    }
    assert [(row["id"], row["message"]) for row in facts["findings"]] == [
        ("lost_edges", "1 feature edge is no edge of the mesh."),
        ("lost_faces", "1 feature face is no face of the mesh."),
    ]
    out = run("info", tmp_path / "x.mesh")[1]
    assert "features: 3 edges; ridges (mark): 1, reference 5: 2, reference 6: 1" in out
