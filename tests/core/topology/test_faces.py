"""Faces against dictionaries, on random small meshes and on shapes with known answers."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.typing import NDArray

from tests.core.topology.checks import check_faces, topology, vertices_of_rows
from tests.core.topology.grids import grid_cells
from tests.core.topology.strategies import meshes


@given(meshes)
@settings(max_examples=150, deadline=None)
def test_R7_faces_equal_dictionaries(cells: NDArray[np.int32]) -> None:
    check_faces(cells, topology(cells))


@given(meshes)
@settings(max_examples=40, deadline=None)
def test_R7_faces_with_ids_wider_than_21_bits(cells: NDArray[np.int32]) -> None:
    wide = np.where(cells % 2, cells + (1 << 22), cells).astype(np.int32)
    check_faces(wide, topology(wide, (1 << 22) + 200))


@given(meshes)
@settings(max_examples=60, deadline=None)
def test_R7_faces_left_to_the_sort_are_the_same(cells: NDArray[np.int32]) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("hexalab.topology.matching.ROUNDS", 0)
        check_faces(cells, topology(cells))


def test_R7_a_vertex_of_very_many_faces_does_not_take_many_rounds() -> None:
    """A fan of 30,000 wedges around one edge: vertex 0 is the smallest of nearly every face."""
    n = 30_000
    low, high = 2 + np.arange(n), 2 + n + np.arange(n)
    after = np.roll(np.arange(n), -1)
    zero, one = np.zeros(n, int), np.ones(n, int)
    cells = np.stack([zero, low, low[after], low[after], one, high, high[after], high[after]], axis=1)
    t = topology(cells)
    assert (t.face_count, t.boundary_face_count) == (4 * n, 3 * n)


def test_R7_doublets_two_quads_that_share_three_vertices_stay_apart() -> None:
    cells = [[0, 1, 2, 3, 5, 6, 7, 8], [0, 1, 2, 4, 9, 10, 11, 12]]
    t = topology(cells)
    assert (t.face_count, t.boundary_face_count) == (12, 12)


def test_R7_a_triangle_does_not_match_the_quad_it_is_part_of() -> None:
    cells = [[0, 1, 2, 3, 4, 5, 6, 7], [0, 1, 2, 2, 8, 9, 10, 10]]
    t = topology(cells)
    assert (t.face_count, t.boundary_face_count) == (11, 11)


def test_R7_a_triangle_is_known_whichever_vertex_the_cell_repeats() -> None:
    for ring in ([0, 0, 1, 2], [0, 1, 1, 2], [0, 1, 2, 2], [0, 1, 2, 0], [0, 1, 0, 2]):
        cells = [[2, 1, 0, 0, 3, 4, 5, 6], [*ring, 7, 8, 9, 10]]
        t = topology(cells)
        row = t.cell_faces[0, 1]
        assert sorted(t.face_cells[:, row].tolist()) == [0, 1]
        for corners in t.corners_of(np.array([0, 1]), np.array([0, 0])).T.tolist():
            assert corners[2] == corners[3] and set(corners) == {0, 1, 2}


def test_R7_grid_counts_in_closed_form() -> None:
    nx, ny, nz = 7, 5, 3
    t = topology(grid_cells(nx, ny, nz))
    boundary = 2 * (nx * ny + ny * nz + nz * nx)
    assert t.boundary_face_count == len(t.face_cells[0, t.faces.boundary]) == boundary
    assert t.face_count == (6 * nx * ny * nz + boundary) // 2
    assert len(vertices_of_rows(t, t.faces.boundary)) == (nx + 1) * (ny + 1) * (nz + 1) - (nx - 1) * (
        ny - 1
    ) * (nz - 1)


def test_R7_faces_of_no_cells() -> None:
    t = topology(np.empty((0, 8), np.int32), 3)
    assert (t.face_count, t.boundary_face_count, t.face_cells[0, t.faces.boundary].size) == (0, 0, 0)
    assert t.corners_of(t.face_cells[0], t.face_locals[0]).shape == (4, 0)


@given(meshes)
@settings(max_examples=60, deadline=None)
def test_R7_neighbours_across_each_face(cells: NDArray[np.int32]) -> None:
    t = topology(cells)
    across = t.neighbours_of(np.arange(len(cells)))
    for cell in range(len(cells)):
        for local in range(6):
            row = t.cell_faces[local, cell]
            others = set(t.face_cells[:, row].tolist()) - {cell} if row >= 0 else {-1}
            assert others == {int(across[local, cell])}
