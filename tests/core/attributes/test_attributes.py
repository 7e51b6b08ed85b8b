"""Attributes of the file (SPEC R8): ids, ranges, values per cell."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.attributes import attributes, cell_values, described, finite_range, own_vectors, vectors
from hexalab.cells import COLLAPSE, CORNERS_OF_KIND, KINDS
from hexalab.errors import HexaLabError
from hexalab.mesh import Mesh


def every_kind() -> Mesh:
    """One cell of each kind, each on vertices of its own."""
    corners, kinds, start = [], [], 0
    for kind in range(len(KINDS)):
        corners.append([start + place for place in COLLAPSE[kind]])
        kinds.append(kind)
        start += len(CORNERS_OF_KIND[kind])
    rng = np.random.default_rng(7)
    mesh = Mesh(rng.random((3, start)), np.array(corners, np.int32).T, np.array(kinds, np.uint8))
    mesh.point_data = {"t": rng.random(start).astype(np.float32), "v": rng.random((start, 3))}
    mesh.cell_data = {
        "id": np.array([4, 3, 2, 1], np.int16),
        "inside": np.array([True, False, True, False]),
        "stress": rng.random((4, 9)),
        "label": np.array(["a", "b", "c", "d"]),
        "flat": np.array([[-1.0], [2.0], [np.nan], [np.inf]]),
        "many": np.zeros((4, 12)),
    }
    return mesh


def test_R8_attributes_have_ids_by_place_name_and_component() -> None:
    found = attributes(every_kind())
    assert list(found)[:5] == ["cell:id", "cell:inside", "cell:stress", "cell:flat", "cell:many"]
    assert {"cell:stress:0", "cell:stress:8", "point:t", "point:v", "point:v:2"} <= set(found)
    assert not {"cell:label", "cell:many:0", "cell:flat:0", "point:v:3"} & set(found)
    assert found["point:v:1"].name == "v, y"
    assert found["cell:stress:8"].name == "stress, 8"
    assert found["point:v"].name == "v, magnitude"


def test_R8_a_name_that_looks_like_a_component_stands_for_itself() -> None:
    mesh = every_kind()
    mesh.cell_data = {"a": np.ones((4, 2)), "a:1": np.arange(4.0)}
    assert np.array_equal(cell_values(mesh, "cell:a:1"), [0, 1, 2, 3])


def test_R8_a_points_attribute_is_averaged_over_the_cells_own_corners() -> None:
    mesh = every_kind()
    start = 0
    for cell, kind in enumerate(mesh.kinds):
        own = slice(start, start + len(CORNERS_OF_KIND[kind]))
        start = own.stop
        assert cell_values(mesh, "point:t")[cell] == pytest.approx(mesh.point_data["t"][own].mean())
        assert cell_values(mesh, "point:v:2")[cell] == pytest.approx(mesh.point_data["v"][own, 2].mean())
        lengths = np.linalg.norm(mesh.point_data["v"][own], axis=1)
        assert cell_values(mesh, "point:v")[cell] == pytest.approx(lengths.mean())


def test_R8_averaging_agrees_across_chunks() -> None:
    count = 70_001
    corners = np.random.default_rng(1).integers(0, 500, (8, count)).astype(np.int32)
    values = np.random.default_rng(2).random(500)
    mesh = Mesh(np.zeros((3, 500)), corners, np.zeros(count, np.uint8), point_data={"a": values})
    assert np.allclose(cell_values(mesh, "point:a"), values[corners].mean(axis=0), rtol=1e-15)


def test_R8_a_cells_attribute_is_itself() -> None:
    mesh = every_kind()
    assert np.array_equal(cell_values(mesh, "cell:id"), [4, 3, 2, 1])
    assert np.array_equal(cell_values(mesh, "cell:inside"), [1, 0, 1, 0])
    assert np.allclose(cell_values(mesh, "cell:stress"), np.linalg.norm(mesh.cell_data["stress"], axis=1))


def test_R8_ranges_are_of_the_finite_values() -> None:
    rows = {row["id"]: row for row in described(every_kind())}
    flat = {"id": "cell:flat", "name": "flat", "on": "cell", "components": 1, "min": -1.0, "max": 2.0}
    assert rows["cell:flat"] == flat
    assert rows["cell:id"]["min"] == 1
    assert finite_range(np.array([np.nan, np.inf])) is None
    assert finite_range(np.array([])) is None


def test_R8_vectors_are_told_from_numbers_and_from_other_rows() -> None:
    mesh = every_kind()
    mesh.cell_data["in plane"] = np.zeros((4, 2))
    told = {row["id"]: row["components"] for row in described(mesh)}
    assert {id for id, count in told.items() if count == 3} == {"point:v"} == set(vectors(mesh))
    assert (told["point:v:1"], told["cell:flat"], told["cell:in plane"], told["cell:many"]) == (1, 1, 2, 12)
    assert own_vectors(mesh, vectors(mesh)["point:v"]) is mesh.point_data["v"]


def test_R8_an_unknown_attribute_is_told_with_those_that_are_there() -> None:
    with pytest.raises(HexaLabError, match="no attribute 'cell:x'; it has cell:id, "):
        cell_values(every_kind(), "cell:x")
