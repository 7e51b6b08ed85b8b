"""Walks over faces: hop distance from the boundary, connected components."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..arrays import CHUNK, Ids
from .classes import classes
from .faces import Faces
from .slots import last_writers

UNREACHED = -1
"""Depth of a cell from which no way over faces leads to the boundary."""


def depth(faces: Faces) -> Ids:
    """(C,) int32: over how many faces one must go from each cell to a cell with a face on the boundary.

    Breadth first, all cells of one depth at a time; over a non-manifold face one comes to each of its cells.
    """
    cell_count = faces.rows.shape[1]
    # One more place, at which -1 points: "outside" counts as reached.
    out = np.full(cell_count + 1, UNREACHED, np.int32)
    out[-1] = 0
    slot = np.empty(cell_count, np.int32)
    found = faces.cells[0, faces.boundary]
    level = 0
    while len(found):
        out[found] = level
        frontier = _once(found, slot)
        level += 1
        steps = []
        for rows in _across(faces, frontier):
            steps.append(rows[out[rows] < 0])
        if len(faces.crowd_cells):
            steps.append(_across_crowds(faces, out, level))
        found = np.concatenate(steps)
    return out[:-1]


def _once(cells: Ids, slot: Ids) -> Ids:
    """Each cell once; `slot` is scratch space."""
    order = np.arange(len(cells), dtype=np.int32)
    once: Ids = cells[last_writers(slot, cells, order) == order]
    return once


def _across(faces: Faces, cells: Ids) -> list[Ids]:
    """For each of the six sides, the cells on the other side, -1 outside."""
    whole = 2 * faces.paired + faces.cells.shape[1] - faces.paired == faces.rows.size
    found = []
    for side in faces.rows:
        rows = side[cells]
        if whole:
            own = cells
        else:
            there = np.flatnonzero(rows >= 0)
            rows, own = rows[there], cells[there]
        across: Ids = faces.cells[0][rows]
        across ^= faces.cells[1][rows]
        across ^= own
        found.append(across)
    return found


def _across_crowds(faces: Faces, reached: Ids, level: int) -> Ids:
    """Cells not reached yet whose non-manifold face has a cell of the level before."""
    at = reached[faces.crowd_cells]
    hit = np.zeros(int(faces.crowd_faces.max()) + 1, dtype=bool)
    hit[faces.crowd_faces[at == level - 1]] = True
    return faces.crowd_cells[hit[faces.crowd_faces] & (at < 0)].astype(np.int32)


def components(faces: Faces) -> tuple[Ids, int]:
    """(C,) int32 label of the face-connected component of each cell, in order of first cells; how many."""
    return classes(faces.rows.shape[1], lambda: _joined(faces))


def _joined(faces: Faces) -> Iterator[tuple[Ids, Ids]]:
    """Cells that share a face."""
    for start in range(0, faces.paired, CHUNK):
        part = slice(start, min(start + CHUNK, faces.paired))
        yield faces.cells[0, part], faces.cells[1, part]
    if len(faces.crowd_cells):
        same = faces.crowd_faces[1:] == faces.crowd_faces[:-1]
        yield faces.crowd_cells[:-1][same], faces.crowd_cells[1:][same]
