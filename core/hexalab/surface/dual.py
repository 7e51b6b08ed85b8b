"""Surfaces within the mesh: sheets as what they are dual to, and the walls between blocks (SPEC T4).

Both are seen from two sides, so that each quad is there twice, once for each side.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..cells import EDGES, FACES
from ..structure.base_complex import BaseComplex
from ..structure.frame import DIRECTIONS, OPPOSITE, Frame
from ..structure.sheets import Sheets
from .drawn_mesh import DrawnMesh
from .edges import faces_beside, one_of_each, quad_sides
from .flat import Edges, flat_surface, interleave
from .records import Surface


def _edge_at(corner: int, direction: int) -> int:
    """The edge of a cell that leads from a corner in a direction."""
    return next(edge for edge in DIRECTIONS[direction] if corner in EDGES[edge])


CROSSING = np.array(
    [
        [[_edge_at(corner, direction) for corner in FACES[side]] for side in OPPOSITE[direction]]
        for direction in range(3)
    ],
    np.intp,
)
"""(3, 2, 4): the edges of each direction in a ring, seen from its beginning and from its end; as `FACES` turn."""


def dual_surface(
    drawn_mesh: DrawnMesh, frame: Frame, sheets: Sheets, chosen: NDArray[np.bool_], shown: NDArray[np.bool_]
) -> Surface:
    """Surfaces through the middles of sheets: in each cell that one crosses a quad, between four middles of edges.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    frame : Frame
    sheets : Sheets
    chosen : (S,) bool
        Which sheets.
    shown : (C,) bool
        Which cells of the mesh: of the others there is nothing.
    """
    rows = np.arange(frame.count, dtype=np.int32) if frame.cells is None else frame.cells
    cells, local, rings = [], [], []
    for direction in range(3):
        crossed = np.flatnonzero(chosen[sheets.of_cells[direction]] & shown[rows])
        for end, side in enumerate(OPPOSITE[direction]):
            cells.append(rows[crossed])
            local.append(np.full(len(crossed), side, np.uint8))
            rings.append(frame.cell_edges[CROSSING[direction, end][:, None], crossed])
    edges = np.concatenate(rings, axis=1)
    ends = frame.edge_vertices
    points = drawn_mesh.points(ends[0][edges])
    points += drawn_mesh.points(ends[1][edges])
    points *= np.float32(0.5)
    return _two_sided(drawn_mesh, edges, points, np.concatenate(cells), np.concatenate(local))


def walls(
    drawn_mesh: DrawnMesh,
    frame: Frame,
    base: BaseComplex,
    chosen: NDArray[np.bool_],
    shown: NDArray[np.bool_],
) -> Surface:
    """Faces between blocks, those at chosen blocks, (B,) bool, and shown cells, (C,) bool of the mesh."""
    rows = np.arange(frame.count, dtype=np.int32) if frame.cells is None else frame.cells
    faces = np.flatnonzero(base.complex_faces[: frame.paired])
    of_block = chosen[base.of_cells[frame.face_cells[:, faces]]].any(axis=0)
    faces = faces[of_block & shown[rows[frame.face_cells[:, faces]]].any(axis=0)]
    own = frame.face_cells[:, faces].reshape(-1)
    local = frame.face_locals[:, faces].reshape(-1)
    corners = frame.topology.corners_of(own, local)
    return _two_sided(drawn_mesh, corners, drawn_mesh.points(corners), rows[own], local)


def _two_sided(drawn_mesh: DrawnMesh, ring: Ids, points: Array, cells: Ids, local: Array) -> Surface:
    """Surface of quads with two sides, (4, Q) numbers of whatever its (3, 4, Q) corners stand for."""
    start, end, side = quad_sides(ring)
    winner = one_of_each(start, end)
    drawn = np.flatnonzero(winner == np.arange(len(start)))
    place, quad = np.divmod(side, max(ring.shape[1], 1))
    lines = points[:, np.stack([place[drawn], (place[drawn] + 1) % 4]), quad[drawn]]
    edges = Edges(edges=interleave(lines), edge_faces=faces_beside(winner, drawn, quad))
    inside = np.ones(ring.shape[1], dtype=bool)
    return replace(flat_surface(drawn_mesh, "lines", points, cells, local, inside, edges), two_sided=True)
