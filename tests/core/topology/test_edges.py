"""Edges, depth and components against dictionaries, and the published meshes' facts."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.typing import NDArray

from hexalab.cells import FACES
from tests.core.topology.checks import check_edges, check_walks, topology
from tests.core.topology.grids import grid_cells
from tests.core.topology.strategies import meshes


@given(meshes)
@settings(max_examples=150, deadline=None)
def test_R7_edges_and_valence_equal_dictionaries(cells: NDArray[np.int32]) -> None:
    check_edges(cells, topology(cells))


@given(meshes)
@settings(max_examples=40, deadline=None)
def test_R7_edges_left_to_the_sort_are_the_same(cells: NDArray[np.int32]) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("hexalab.topology.edges.LAYERS", 0)
        check_edges(cells, topology(cells))


def test_R7_a_vertex_of_very_many_edges_does_not_take_many_layers() -> None:
    """Forty thousand cells that share nothing but vertex 0: 120,000 edges have it as smaller end."""
    n = 40_000
    cells = np.arange(1, 7 * n + 1).reshape(n, 7)
    t = topology(np.concatenate([np.zeros((n, 1), int), cells], axis=1))
    assert t.edge_count == 12 * n


@given(meshes)
@settings(max_examples=60, deadline=None)
def test_R7_edges_of_faces(cells: NDArray[np.int32]) -> None:
    t = topology(cells)
    ends = np.concatenate([t.edge_vertices, [[-1], [-1]]], axis=1)
    for local in range(6):
        of_face = t.edges_of(np.arange(len(cells)), np.full(len(cells), local))
        for cell, ids in enumerate(cells.tolist()):
            ring = [ids[place] for place in FACES[local]]
            want = {frozenset((ring[k], ring[k - 1])) for k in range(4) if ring[k] != ring[k - 1]}
            assert {frozenset(ends[:, row].tolist()) for row in of_face[:, cell] if row >= 0} == want


@given(meshes)
@settings(max_examples=60, deadline=None)
def test_R7_cells_that_repeat_a_vertex(cells: NDArray[np.int32]) -> None:
    assert topology(cells).repeating_cells.tolist() == [len(set(ids)) < 8 for ids in cells.tolist()]


def test_V4_grid_valence_in_closed_form() -> None:
    nx, ny, nz = 6, 4, 5
    t = topology(grid_cells(nx, ny, nz))
    assert t.interior_edge_valence == {
        4: nx * (ny - 1) * (nz - 1) + ny * (nx - 1) * (nz - 1) + nz * (nx - 1) * (ny - 1)
    }
    assert t.boundary_edge_valence[1] == 4 * (nx + ny + nz)
    assert set(t.boundary_edge_valence) == {1, 2}


@given(meshes)
@settings(max_examples=150, deadline=None)
def test_F2_R9_depth_and_components_equal_walks(cells: NDArray[np.int32]) -> None:
    check_walks(cells, topology(cells))


def test_F2_a_mesh_without_boundary_has_no_depth() -> None:
    """A torus of three dimensions: every face has two cells."""
    n = 3
    k, j, i = (axis.ravel() for axis in np.meshgrid(range(n), range(n), range(n), indexing="ij"))
    places = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    cells = np.stack([(((k + c) % n) * n + (j + b) % n) * n + (i + a) % n for a, b, c in places], axis=1)
    t = topology(cells)
    assert t.boundary_face_count == 0 and t.face_count == 3 * n**3
    assert set(t.depth.tolist()) == {-1} and t.cells_per_depth == [] and t.max_depth == 0
    assert t.component_count == 1
