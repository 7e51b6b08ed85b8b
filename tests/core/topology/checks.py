"""A mesh's topology compared with dictionaries, row by row; needs nothing but numpy."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hexalab.cells import EDGES, FACES
from hexalab.topology import Topology
from tests.core.topology.brute_force import BruteForce


def topology(cells: NDArray[np.int32], vertex_count: int | None = None) -> Topology:
    cells = np.asarray(cells, dtype=np.int32).reshape(-1, 8)
    count = int(cells.max(initial=-1)) + 1 if vertex_count is None else vertex_count
    return Topology(np.ascontiguousarray(cells.T), count)


def vertices_of_rows(t: Topology, rows: slice) -> set[int]:
    """Vertices of the faces in some rows."""
    return set(t.corners_of(t.face_cells[0, rows], t.face_locals[0, rows]).reshape(-1).tolist())


def check_faces(cells: NDArray[np.int32], t: Topology) -> None:
    truth = BruteForce(cells.tolist())
    assert t.face_count == len(truth.face_cells)
    assert t.boundary_face_count == len(truth.boundary)
    assert t.nonmanifold_face_count == sum(len(around) > 2 for around in truth.face_cells.values())
    seen: dict[frozenset[int], list[tuple[int, int]]] = {}
    corners = t.corners_of(t.face_cells[0], t.face_locals[0])
    for row in range(t.face_cells.shape[1]):
        face = frozenset(corners[:, row].tolist())
        for side in range(2):
            cell, local = int(t.face_cells[side, row]), int(t.face_locals[side, row])
            if cell >= 0:
                assert face == frozenset(cells[cell, list(FACES[local])].tolist())
                assert t.cell_faces[local, cell] == row
                seen.setdefault(face, []).append((cell, local))
        if t.face_cells[1, row] >= 0:
            assert t.face_cells[0, row] != t.face_cells[1, row]
    assert {face: sorted(sides) for face, sides in seen.items()} == truth.face_sides
    assert (t.cell_faces >= 0).sum() == sum(len(sides) for sides in truth.face_sides.values())
    for face, sides in truth.face_sides.items():
        rows = {int(t.cell_faces[local, cell]) for cell, local in sides}
        pairs = sum(t.face_cells[1, row] >= 0 for row in rows)
        most = max(sum(c == cell for c, _ in sides) for cell, _ in sides)
        assert pairs == min(len(sides) // 2, len(sides) - most), face
    on_boundary = {frozenset(ids) for ids in corners[:, t.faces.boundary].T.tolist()}
    assert on_boundary == truth.boundary
    assert vertices_of_rows(t, t.faces.boundary) == truth.boundary_vertices
    many = {frozenset(corners[:, row].tolist()) for row in t.nonmanifold_face_rows}
    assert many == {face for face, around in truth.face_cells.items() if len(around) > 2}


def check_edges(cells: NDArray[np.int32], t: Topology) -> None:
    truth = BruteForce(cells.tolist())
    found = [frozenset(ends) for ends in t.edge_vertices.T.tolist()]
    assert len(found) == len(set(found)) == t.edge_count
    assert set(found) == set(truth.edge_cells)
    for cell, ids in enumerate(cells.tolist()):
        for place, (a, b) in enumerate(EDGES):
            row = int(t.cell_edges[place, cell])
            assert (row < 0) == (ids[a] == ids[b])
            assert row < 0 or found[row] == frozenset((ids[a], ids[b]))
    around = {edge: len(of) for edge, of in truth.edge_cells.items()}
    assert dict(zip(found, t.edge_cells.tolist(), strict=True)) == around
    assert {found[row] for row in np.flatnonzero(t.edge_on_boundary)} == truth.boundary_edges
    assert t.interior_edge_valence == truth.valence(on_boundary=False)
    assert t.boundary_edge_valence == truth.valence(on_boundary=True)


def check_walks(cells: NDArray[np.int32], t: Topology) -> None:
    truth = BruteForce(cells.tolist())
    depth = truth.depth
    assert t.depth.tolist() == depth
    assert t.cells_per_depth == [depth.count(level) for level in range(max(depth, default=-1) + 1)]
    assert t.components.tolist() == truth.components
    assert t.component_count == len(set(truth.components))
