"""Walls: where the base complex parts the cells (SPEC T3; Gao et al. 2015, 2017).

A wall starts at an irregular edge, all faces around it, and runs on straight across each regular interior edge,
to the face opposite at that edge, the one of the four that shares no cell with it. It ends at irregular edges
and at the boundary.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..topology.classes import classes
from ..topology.slots import last_writers
from .frame import ACROSS, ROUND, SIDES, Frame


def separating_faces(frame: Frame, start_at: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """(F,) bool: the faces that walls pass which start at some irregular edges, (E,) bool.

    All faces reached in one step are found at once; the number of rounds is the longest way in steps.
    """
    passed = _faces_at(frame, start_at)
    goes_on = ~(frame.irregular | frame.edge_on_boundary)
    slot = np.empty(frame.face_count, np.int32)
    front = np.flatnonzero(passed).astype(np.int32)
    while len(front):
        found = np.concatenate([_opposite(frame, front, k, goes_on) for k in range(4)])
        found = found[~passed[found]]
        order = np.arange(len(found), dtype=np.int32)
        front = found[last_writers(slot, found, order) == order]
        passed[front] = True
    return passed


def _faces_at(frame: Frame, edges: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """(F,) bool: all faces at some edges, (E,) bool."""
    at = np.zeros(frame.face_count, dtype=bool)
    for place, sides in enumerate(SIDES):
        cells = np.flatnonzero(edges[frame.cell_edges[place]])
        for side in sides:
            at[frame.cell_faces[side][cells]] = True
    return at


def _opposite(frame: Frame, faces: Ids, k: int, goes_on: NDArray[np.bool_]) -> Ids:
    """The faces opposite to some at their k-th edge, of those that go on there.

    From the face to the next one in its first cell at that edge, through that into the cell behind, and to that
    cell's other face at the edge.
    """
    cells, locals_ = frame.face_cells[0, faces], frame.face_locals[0, faces]
    edges = frame.cell_edges[ROUND[locals_, k], cells]
    there = np.flatnonzero(goes_on[edges])
    cells, locals_ = cells[there], locals_[there]
    side = ACROSS[locals_, k]
    behind, side_behind, through = frame.behind(cells, side)
    turned = frame.meeting(through, _PLACE[locals_, k], cells)
    across: Ids = frame.cell_faces[ACROSS[side_behind, turned], behind]
    return across


_PLACE = np.array(
    [
        [int(np.flatnonzero(ROUND[ACROSS[face, k]] == ROUND[face, k])[0]) for k in range(4)]
        for face in range(6)
    ],
    np.uint8,
)
"""(6, 4): which edge, of the face across it, each edge of a face is."""


def complex_edges(frame: Frame, complex_faces: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """(E,) bool: the edges all of whose faces are complex."""
    out = np.ones(frame.edge_count, dtype=bool)
    inside = ~complex_faces
    for place, (one, other) in enumerate(SIDES):
        cells = np.flatnonzero(inside[frame.cell_faces[one]] | inside[frame.cell_faces[other]])
        out[frame.cell_edges[place][cells]] = False
    return out


def patches(frame: Frame, complex_faces: Array, edges: NDArray[np.bool_]) -> tuple[Ids, int]:
    """Classes of complex faces, (n,) rows, that meet at edges which are not complex: base faces, and how many."""
    rows = np.flatnonzero(complex_faces).astype(np.int32)
    number = np.arange(len(rows), dtype=np.int32)
    own = frame.edges_of(rows)
    last = np.empty(frame.edge_count, np.int32)
    links = []
    for ring in own:
        last[ring] = number
    for ring in own:
        joined = np.flatnonzero(~edges[ring])
        links.append((number[joined], last[ring[joined]]))
    return classes(len(rows), lambda: links)
