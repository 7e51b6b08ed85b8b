"""The irregular structure: edges with another number of cells around them than a grid has."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..cells import EDGES, FACES
from .drawn_mesh import DrawnMesh
from .edges import Indices
from .flat import NO_LINES, interleave
from .records import Bytes, Irregular

REGULAR_INTERIOR, REGULAR_BOUNDARY = 4, 2
"""Cells around an edge of a grid, within it and on its boundary."""

REACH = np.float32(0.45)
"""Barbs and flaps reach so far along the neighbouring edges."""

_PLACES = np.array(FACES, np.intp)


def extract_irregular(drawn_mesh: DrawnMesh, barbs: bool = True, paper: bool = True) -> Irregular:
    """Irregular edges with what depicts them, whatever the filters hide.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    barbs, paper : bool
        Whether to make these too; of an unstructured mesh they are many.
    """
    topology = drawn_mesh.whole.topology
    boundary = topology.edge_on_boundary
    usual = np.where(boundary, REGULAR_BOUNDARY, REGULAR_INTERIOR)
    odd = topology.edge_cells != usual
    within, outer = np.flatnonzero(odd & ~boundary), np.flatnonzero(odd & boundary)
    edges = np.concatenate([within, outer])
    valence: Bytes = np.minimum(topology.edge_cells[edges], 255).astype(np.uint8)
    outside: Bytes = boundary[edges].view(np.uint8)
    vertices = topology.edge_vertices[:, edges]
    reached = _on_boundary(drawn_mesh)[vertices]
    barb_lines, flaps = NO_LINES, NO_LINES
    barb_of: Indices = np.empty(0, np.intp)
    flap_of: Indices = np.empty(0, np.intp)
    if (barbs or paper) and len(edges):
        around = _faces_around(drawn_mesh, edges)
        corners = drawn_mesh.points(around.corners)
        root, tip = corners[:, [0, 1]], corners[:, [3, 2]]
        far = root + REACH * (tip - root)
        if barbs:
            lines = np.stack([root[:, 0], far[:, 0], root[:, 1], far[:, 1]], axis=1)
            barb_lines, barb_of = interleave(lines), np.repeat(around.edges, 2)
        if paper:
            quads = np.stack([root[:, 0], root[:, 1], far[:, 1], far[:, 0]], axis=1)
            flaps, flap_of = interleave(quads), around.edges
    return Irregular(
        edges=interleave(drawn_mesh.points(vertices)),
        valence=valence,
        boundary=outside,
        ends_on_boundary=reached[0] + np.uint8(2) * reached[1],
        barbs=barb_lines,
        barb_valence=valence[barb_of],
        barb_boundary=outside[barb_of],
        paper=flaps,
        paper_valence=valence[flap_of],
        paper_boundary=outside[flap_of],
        counts={
            "interior": _counts(topology.edge_cells[within]),
            "boundary": _counts(topology.edge_cells[outer]),
        },
    )


def _on_boundary(drawn_mesh: DrawnMesh) -> Bytes:
    """(V,) 1 where a vertex lies on the mesh's boundary."""
    topology = drawn_mesh.whole.topology
    on: Bytes = np.zeros(drawn_mesh.whole.vertex_count, np.uint8)
    on[topology.edge_vertices[:, topology.edge_on_boundary]] = 1
    return on


class _FacesAround(NamedTuple):
    """Faces around some edges, in order of the edges.

    Attributes
    ----------
    edges : (P,) intp
        Place of the edge among those asked for.
    corners : (4, P) int32
        The edge's two vertices, then the face's others; a triangle's third twice.
    """

    edges: Indices
    corners: Ids


def _faces_around(drawn_mesh: DrawnMesh, edges: Array) -> _FacesAround:
    """Each face around each of some edges once."""
    topology = drawn_mesh.whole.topology
    number = np.full(topology.edge_count + 1, -1, np.int32)
    number[edges] = np.arange(len(edges), dtype=np.int32)
    found: list[Array] = []
    crowded: list[Array] = []
    corners: list[Ids] = []
    shared = np.zeros(topology.face_cells.shape[1], dtype=bool)
    shared[topology.nonmanifold_face_rows] = True
    for place, ends in enumerate(EDGES):
        edge = number[topology.cell_edges[place]]
        cells = np.flatnonzero(edge >= 0)
        for face, ring in enumerate(FACES):
            if not set(ends) <= set(ring):
                continue
            rows = topology.cell_faces[face, cells]
            there = np.flatnonzero(rows >= 0)
            rows = rows[there]
            first = topology.face_cells[0][rows] == cells[there]
            first &= topology.face_locals[0][rows] == face
            mine, rows = cells[there[first]], rows[first]
            start = next(i for i in range(4) if {ring[i], ring[(i + 1) % 4]} == set(ends))
            a, b, c, d = (topology.corners[ring[(start + i) % 4]][mine] for i in range(4))
            corners.append(np.stack([a, b, np.where(c == b, d, c), np.where(d == a, c, d)]))
            found.append(edge[mine])
            crowded.append(shared[rows])
    number_of, quads = np.concatenate(found), np.concatenate(corners, axis=1)
    order = _once(number_of, quads, np.concatenate(crowded))
    return _FacesAround(number_of[order].astype(np.intp), quads[:, order])


def _once(number: Ids, quads: Ids, crowded: NDArray[np.bool_]) -> Indices:
    """Order by edge, without the further rows of faces that more than two cells share."""
    kept = np.flatnonzero(~crowded)
    if len(kept) < len(crowded):
        some = np.flatnonzero(crowded)
        sets = np.sort(quads[:, some], axis=0)
        kept = np.concatenate(
            [kept, some[np.unique(np.vstack([number[some], sets]), axis=1, return_index=True)[1]]]
        )
    return np.asarray(kept[np.argsort(number[kept], kind="stable")])


def _counts(valence: Ids) -> dict[str, int]:
    values, numbers = np.unique(valence, return_counts=True)
    return {str(value): int(number) for value, number in zip(values, numbers, strict=True)}
