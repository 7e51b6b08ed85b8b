"""Faces as structure is traced through them: two cells at most, whose corners follow each other in one order.

At a face of more than two cells, and where the two cells have its four vertices in another order round, there
is no way on: each cell has such a face for itself, as on the boundary.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Ids
from ..cells import FACES
from ..topology import Topology

_CORNERS = np.array(FACES, np.intp)

SAME_WAY = 4
"""Added to a turn where both cells have the corners in the same sense: one of them is mirrored."""

NO_WAY = 8
"""Instead of a turn where the corners come in another order."""

MEETING = np.array(
    [
        [[(t + 3 - k) % 4 for k in range(4)] for t in range(4)]
        + [[(k + sign * t) % 4 for k in range(4)] for t in range(4)]
        for sign in (1, -1)
    ]
)
"""(2, 8, 4): of the first or second cell of a face, for each turn, its edges as the other cell has them."""


@dataclass(frozen=True)
class Joints:
    """Faces, those between two cells first.

    Attributes
    ----------
    cells : (2, F) int32
        Cells of each, -1 outside.
    locals : (2, F) uint8
        Which of `FACES` it is of each of the two.
    rows : (6, N) int32
        Face at each place of each cell.
    paired : int
        Number of faces between two cells; those from there on are the boundary.
    turns : (paired,) uint8
        Which corner of the second cell's side is the first of the first cell's; `SAME_WAY` more, if the cells
        are not of one orientation.
    crowded, disordered : int
        Number of faces that were parted because more than two cells have them, because their corners come in
        another order.
    """

    cells: Ids
    locals: NDArray[np.uint8]
    rows: Ids
    paired: int
    turns: NDArray[np.uint8]
    crowded: int
    disordered: int


def find_joints(topology: Topology) -> Joints:
    """Find the faces of cells with eight vertices each."""
    faces = topology.faces
    turns = _turns(topology)
    parted = turns == NO_WAY
    disordered = int(np.count_nonzero(parted))
    parted = np.concatenate([parted, np.zeros(faces.cells.shape[1] - faces.paired, dtype=bool)])
    parted[faces.nonmanifold_rows] = True
    if not parted.any():
        return Joints(faces.cells, faces.locals, faces.rows, faces.paired, turns, 0, 0)
    kept = np.flatnonzero(~parted)
    number = np.full(len(parted), -1, np.int32)
    number[kept] = np.arange(len(kept), dtype=np.int32)
    rows = number[faces.rows]
    local, cell = np.nonzero(rows < 0)
    rows[local, cell] = np.arange(len(kept), len(kept) + len(cell), dtype=np.int32)
    outside = np.full(len(cell), -1, np.int32)
    paired = int(np.count_nonzero(kept < faces.paired))
    return Joints(
        cells=np.concatenate([faces.cells[:, kept], np.stack([cell.astype(np.int32), outside])], axis=1),
        locals=np.concatenate([faces.locals[:, kept], np.stack([local, 0 * local]).astype(np.uint8)], axis=1),
        rows=rows,
        paired=paired,
        turns=turns[kept[:paired]],
        crowded=faces.nonmanifold_count,
        disordered=disordered
        - int(
            np.count_nonzero(turns[faces.nonmanifold_rows[faces.nonmanifold_rows < faces.paired]] == NO_WAY)
        ),
    )


def _turns(topology: Topology) -> NDArray[np.uint8]:
    """Turn of each face between two cells, `NO_WAY` among them."""
    faces, corners, count = topology.faces, topology.corners.reshape(-1), topology.cell_count
    turns = np.empty(faces.paired, np.uint8)
    for start in range(0, faces.paired, CHUNK):
        part = slice(start, min(start + CHUNK, faces.paired))
        (one, other), (local, far) = faces.cells[:, part], faces.locals[:, part]
        ring = [corners[_CORNERS[far, k] * count + other] for k in range(4)]
        first, second, third = (corners[_CORNERS[local, k] * count + one] for k in range(3))
        turn = np.full(len(one), NO_WAY, np.uint8)
        for k in range(4):
            straight = (ring[k] == first) & (ring[(k + 2) % 4] == third)
            turn[straight & (ring[(k + 3) % 4] == second)] = k
            turn[straight & (ring[(k + 1) % 4] == second)] = k + SAME_WAY
        turns[part] = turn
    return turns
