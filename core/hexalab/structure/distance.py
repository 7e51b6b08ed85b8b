"""How far each cell is from the nearest irregular edge (SPEC T5)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids
from .frame import Frame


def irregular_distance(frame: Frame, edges: NDArray[np.bool_] | None = None) -> Ids:
    """(N,) int32: faces on the way from each cell to the nearest one at an irregular edge; -1 where there is no way.

    Parameters
    ----------
    frame : Frame
    edges : (E,) bool, optional
        The edges to be near to; the interior irregular ones by default.
    """
    near = frame.irregular & ~frame.edge_on_boundary if edges is None else edges
    out = np.full(frame.count, -1, np.int32)
    at = np.zeros(frame.count, dtype=bool)
    for places in frame.cell_edges:
        at |= near[places]
    front = np.flatnonzero(at)
    level = 0
    while len(front):
        out[front] = level
        level += 1
        found = []
        for side in range(6):
            rows = frame.cell_faces[side, front]
            inner = rows < frame.paired
            rows, cells = rows[inner], front[inner]
            behind = frame.face_cells[0, rows] ^ frame.face_cells[1, rows] ^ cells
            behind = behind[out[behind] < 0]
            out[behind] = level
            found.append(behind)
        front = np.unique(np.concatenate(found))
    return out
