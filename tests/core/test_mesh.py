"""SPEC A1: a mesh checks what it is made of, and what is computed of it can't go stale."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from hexalab.formats import write
from hexalab.mesh import Mesh

POINTS = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)
FIELDS = {"coordinates": POINTS.T, "corners": np.arange(8).reshape(8, 1), "kinds": [0]}


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"coordinates": POINTS}, "coordinates must be (3, V) numbers, not (8, 3) float64"),
        ({"coordinates": POINTS.T.astype(str)}, "coordinates must be (3, V) numbers"),
        ({"corners": np.arange(8).reshape(1, 8)}, "corners must be (8, C), not (1, 8)"),
        ({"corners": np.arange(1, 9).reshape(8, 1)}, "corners refer to vertices 1 to 8, expected 0 to 7"),
        ({"corners": np.arange(-1, 7).reshape(8, 1)}, "corners refer to vertices -1 to 6, expected 0 to 7"),
        ({"corners": np.arange(8, dtype=np.int64).reshape(8, 1) + 2**32}, "4294967296 to 4294967303, expected 0 to 7"),
        ({"corners": np.arange(8.0).reshape(8, 1)}, "corners refer to vertices float64, expected integers"),
        ({"kinds": [0, 0]}, "kinds must be (1,), not (2,)"),
        ({"kinds": [4]}, "kinds are 4 to 4, expected 0 to 3"),
        ({"kinds": [256]}, "kinds are 256 to 256, expected 0 to 3"),
        ({"point_data": {"t": np.zeros(7)}}, "point_data['t'] must be a number or a row of numbers for each of 8"),
        ({"cell_data": {"t": np.zeros(2)}}, "cell_data['t'] must be a number or a row of numbers for each of 1"),
        ({"cell_data": {"t": 3}}, "cell_data['t']"),
        ({"cell_data": {"t": ["rock"]}}, "cell_data['t']"),
        ({"vertex_numbers": [1, 2]}, "vertex_numbers must be (8,) integers, not (2,)"),
        ({"cell_numbers": [1.5]}, "cell_numbers must be (1,) integers, not (1,) float64"),
    ],
)  # fmt: skip
def test_A1_what_is_wrong_with_the_arrays_of_a_mesh_is_told(fields: dict, words: str) -> None:
    with pytest.raises(ValueError, match=re.escape(words)):
        Mesh(**(FIELDS | fields))


def test_A1_lists_of_numbers_will_do() -> None:
    mesh = Mesh(**FIELDS, cell_data={"t": [7]}, vertex_numbers=list(range(8)))
    assert mesh.cell_data["t"].tolist() == [7] and mesh.vertex_numbers.dtype == np.int64
    assert Mesh.from_cells(POINTS.tolist(), [list(range(8))]).cell_count == 1
    assert Mesh(np.zeros((3, 0)), np.zeros((8, 0)), np.zeros(0)).cell_count == 0


@pytest.mark.parametrize("ending", [".mesh", ".vtk", ".vtu"])
def test_A1_no_file_is_written_of_arrays_that_do_not_fit(tmp_path: Path, ending: str) -> None:
    mesh = Mesh(**FIELDS)
    mesh.cell_data["t"] = np.zeros(5)
    with pytest.raises(ValueError, match=r"cell_data\['t'\]"):
        write(mesh, tmp_path / f"x{ending}")
    assert not list(tmp_path.iterdir())


def test_A1_meshes_are_compared_as_objects() -> None:
    mesh = Mesh(**FIELDS)
    assert mesh == mesh and mesh != Mesh(**FIELDS)
    assert len({mesh, mesh}) == 1


@pytest.mark.parametrize("name", ["coordinates", "corners", "kinds"])
def test_A1_what_is_computed_does_not_go_stale(name: str) -> None:
    mesh = Mesh(**FIELDS)
    assert mesh.diagonal == np.sqrt(3)
    with pytest.raises(AttributeError, match=f"replace\\(mesh, {name}="):
        setattr(mesh, name, getattr(mesh, name) * 2)
    with pytest.raises(ValueError, match="read-only"):
        getattr(mesh, name)[:] = 0
    with pytest.raises(ValueError, match="read-only"):
        mesh.points[0] = 5
    assert replace(mesh, coordinates=mesh.coordinates * 2).diagonal == 2 * np.sqrt(3)
    assert mesh.diagonal == np.sqrt(3)


def test_A1_arrays_of_the_right_type_are_neither_copied_nor_locked() -> None:
    coordinates = np.ascontiguousarray(POINTS.T)
    mesh = Mesh(**(FIELDS | {"coordinates": coordinates}))
    assert np.shares_memory(mesh.coordinates, coordinates)
    assert coordinates.flags.writeable and not mesh.coordinates.flags.writeable
