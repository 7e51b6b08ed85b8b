"""The facts of a report, against what is recomputed otherwise."""

from __future__ import annotations

import hashlib
import json
import platform
from dataclasses import replace

import numpy as np
import pytest

import hexalab
from hexalab.diagnosis import TURNED
from hexalab.formats import read_bytes
from hexalab.mesh import Mesh
from hexalab.report import VERSION, About, Found, MetricCriterion, collect, written
from tests.core.conftest import grid_points, medit

from .decks import BAD, ELEMENTS, EMPTY, SETS, UNUSED, deck, two_kinds


@pytest.fixture(scope="module")
def mesh() -> Mesh:
    return read_bytes(deck(), "part.inp")


def test_the_file_is_told_with_what_made_the_report(mesh: Mesh) -> None:
    facts = collect(mesh, About("part.inp", 1234, "ab" * 32, "mm", ("Something is left out.",)))
    assert facts["version"] == VERSION
    assert facts["file"] == {
        "name": "part.inp", "format": "inp", "format_name": "Abaqus", "bytes": 1234, "sha256": "ab" * 32,
        "included": [], "unit": "mm",
    }  # fmt: skip
    assert facts["made_by"] == {
        "hexalab": hexalab.__version__, "python": platform.python_version(), "numpy": np.__version__,
    }  # fmt: skip
    assert facts["notes"] == ["Something is left out."]
    assert collect(mesh)["file"]["name"] == "part.inp"


def test_files_that_the_deck_includes_are_told_with_their_digests() -> None:
    whole = deck()
    cut = whole.index(b"*ELEMENT")
    start = whole[:cut] + b"*INCLUDE, INPUT=cells.inp\n"
    facts = collect(read_bytes(start, "part.inp", {"cells.inp": whole[cut:]}))
    digest = hashlib.sha256(whole[cut:]).hexdigest()
    assert facts["file"]["included"] == [{"name": "cells.inp", "sha256": digest}]
    for form in ("html", "md", "xml"):
        assert digest in written(facts, form), form


def test_counts_are_those_of_the_summary(mesh: Mesh) -> None:
    told = hexalab.summarise(mesh)
    facts = collect(mesh)
    assert facts["counts"] == {name: told[name] for name in facts["counts"]}
    assert (facts["counts"]["cells"], facts["counts"]["vertices"]) == (4, 19)
    assert facts["extent"] == [[0, 0, 0], [2, 2, 1]], "the unused node is not of the mesh"
    assert facts["features"] == told["features"]


def test_findings_name_elements_and_nodes_of_the_file(mesh: Mesh) -> None:
    found = {one["id"]: one for one in collect(mesh)["findings"]}
    assert found["invalid_corner_cells"]["numbers"] == [BAD]
    assert (found["invalid_corner_cells"]["severity"], found["invalid_corner_cells"]["on"]) == (
        "error",
        "cells",
    )
    assert (found["unreferenced_vertices"]["on"], found["unreferenced_vertices"]["numbers"]) == (
        "vertices",
        [UNUSED],
    )


def test_only_the_first_numbers_of_a_finding_are_told_and_all_are_counted() -> None:
    points, cells = grid_points((30, 1, 1))
    points = np.concatenate([points, np.full((25, 3), 9.0)])
    unused = collect(read_bytes(medit(points, cells), "grid.mesh"))["findings"][0]
    assert unused["id"] == "unreferenced_vertices"
    assert (unused["concerned"], len(unused["numbers"])) == (25, 20)
    assert unused["numbers"][0] == 31 * 4 + 1, "Medit counts from 1"


def test_validity_is_that_of_certify(mesh: Mesh) -> None:
    validity = collect(mesh)["validity"]
    assert validity == {
        "invalid": 1, "valid": 3, "undecided": 0, "invalid_cells": [BAD], "undecided_cells": [],
    }  # fmt: skip


def test_groups_are_measured(mesh: Mesh) -> None:
    groups = {one["id"]: one for one in collect(mesh)["groups"]}
    quality = dict(zip(ELEMENTS, hexalab.quality(mesh, "scaled_jacobian"), strict=True))
    volume = dict(zip(ELEMENTS, hexalab.quality(mesh, "volume"), strict=True))
    for name, members in SETS.items():
        told = groups[f"elset:{name}"]
        assert told["count"] == 2 and told["kind"] == "cells"
        assert told["scaled_jacobian_min"] == pytest.approx(min(quality[one] for one in members))
        assert told["scaled_jacobian_mean"] == pytest.approx(np.mean([quality[one] for one in members]))
        assert told["volume"] == pytest.approx(sum(volume[one] for one in members))
        assert told["invalid"] == (BAD in members)


def test_every_metric_is_recomputed(mesh: Mesh) -> None:
    rows = collect(mesh)["metrics"]
    assert [row["id"] for row in rows] == list(hexalab.METRICS)
    for row in rows:
        values = hexalab.quality(mesh, row["id"])
        finite = values[np.isfinite(values)]
        assert row["min"] == finite.min() and row["max"] == finite.max(), row["id"]
        assert row["mean"] == pytest.approx(finite.mean())
        assert row["not_finite"] == np.count_nonzero(~np.isfinite(values))
        if row["acceptable_range"]:
            low, high = row["acceptable_range"]
            low, high = -np.inf if low is None else low, np.inf if high is None else high
            outside = (finite < low - 1e-9) | (finite > high + 1e-9)
            assert row["outside_acceptable"] == np.count_nonzero(outside), row["id"]
        order = np.argsort(finite if row["better"] == "high" else -finite, kind="stable")
        told = np.array(ELEMENTS)[np.isfinite(values)][order]
        assert [one["number"] for one in row["worst"]] == told.tolist(), row["id"]
        assert [one["value"] for one in row["worst"]] == finite[order].tolist()
        assert [*row["not_finite_cells"]] == np.array(ELEMENTS)[~np.isfinite(values)].tolist()
        histogram = row["histogram"]
        assert sum(histogram["counts"]) == len(finite) == row["count"]
        assert histogram["low"] <= finite.min() and finite.max() <= histogram["high"]


def test_what_a_session_knows_changes_nothing(mesh: Mesh) -> None:
    values = {name: hexalab.quality(mesh, name) for name in ("scaled_jacobian", "oddy")}
    found = replace(Found.of(mesh), known=values.get)
    assert collect(mesh, found=found) == collect(mesh)
    moved = replace(found, known={"oddy": np.full(4, 0.25)}.get)
    assert {row["id"]: row["mean"] for row in collect(mesh, found=moved)["metrics"]}["oddy"] == 0.25, (
        "it is used"
    )


def test_without_criteria_validity_and_errors_give_the_verdict(mesh: Mesh) -> None:
    verdict = collect(mesh)["verdict"]
    assert (verdict["passed"], verdict["by"]) == (False, ["diagnosis"])
    assert [(check["kind"], check["state"], check["numbers"]) for check in verdict["checks"]] == [
        ("invalid", "missed", [BAD]),
        ("finding", "missed", [BAD]),
    ]
    sound = collect(read_bytes(deck(bad=False), "part.inp"))["verdict"]
    assert sound["passed"], "notes and warnings are no errors"


def test_a_mesh_that_was_inverted_as_a_whole_fails() -> None:
    points, cells = grid_points((2, 2, 2))
    mesh = hexalab.diagnosis.turn_round(
        read_bytes(medit(points, cells[:, [4, 5, 6, 7, 0, 1, 2, 3]]), "a.mesh")
    )
    assert mesh.notes == [TURNED]
    verdict = collect(mesh)["verdict"]
    assert not verdict["passed"]
    assert [check["of"] for check in verdict["checks"]] == ["invalid", "turned_round"]


def test_strict_adds_the_diagnosis_to_criteria(mesh: Mesh) -> None:
    loose = [MetricCriterion("volume", minimum=-1)]
    assert collect(mesh, criteria=loose)["verdict"]["passed"]
    strict = collect(mesh, criteria=loose, strict=True)["verdict"]
    assert not strict["passed"] and strict["by"] == ["criteria", "diagnosis"] and len(strict["checks"]) == 3


def test_other_kinds_and_empty_meshes_are_told() -> None:
    facts = collect(two_kinds())
    rows = {row["id"]: row for row in facts["metrics"]}
    assert facts["counts"]["kinds"] == {"hexahedron": 2, "tetrahedron": 1}
    assert (rows["skew"]["count"], rows["volume"]["count"]) == (2, 3)
    assert [one["number"] for one in rows["skew"]["worst"]] == [0, 1]
    empty = collect(EMPTY)
    assert empty["verdict"]["passed"] and empty["verdict"]["checks"][0]["state"] == "not measured"
    assert all(row["histogram"] is None for row in empty["metrics"])


def test_the_same_input_gives_the_same_and_it_is_json(mesh: Mesh) -> None:
    one, other = (json.dumps(collect(read_bytes(deck(), "part.inp")), allow_nan=False) for _ in range(2))
    assert one == other


def test_numbers_that_are_not_finite_are_none() -> None:
    points, cells = grid_points((2, 1, 1))
    points[11] = np.nan
    facts = collect(Mesh.from_cells(points, cells, cell_numbers=np.array([5, 8])))
    json.dumps(facts, allow_nan=False)
    volume = next(row for row in facts["metrics"] if row["id"] == "volume")
    assert (volume["not_finite"], volume["not_finite_cells"]) == (1, [8])
