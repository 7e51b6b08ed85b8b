"""Cells that repeat another: they have the very same vertices."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Ids
from .faces import Faces


def repeated_cells(corners: Ids, faces: Faces) -> Ids:
    """Ids of the cells whose vertices are those of a cell before them, ascending.

    Such a cell shares all of its faces with the other. So it is at a face of more than two cells, or the two have each
    other on both sides of all their faces: no others are looked at vertex by vertex.

    >>> from hexalab.topology.faces import find_faces
    >>> cube = np.arange(8, dtype=np.int32)
    >>> corners = np.stack([cube, cube + 8, cube[[1, 2, 3, 0, 5, 6, 7, 4]]], axis=1)
    >>> repeated_cells(corners, find_faces(corners, 16)).tolist()
    [2]
    """
    if not corners.shape[1]:
        return np.empty(0, np.int32)
    crowded = np.unique(faces.crowd_cells).astype(np.int64)
    first = _across(faces, 0)
    alike = np.flatnonzero(first >= 0)
    for local in range(1, 6):
        other = _across(faces, local, alike)
        alike = alike[(other == first[alike]) | (other == VANISHED)]
        if not len(alike):
            break
    whole = np.flatnonzero(
        first == VANISHED
    )  # its face 0 has vanished: rare, so that all of these are looked at
    candidates = np.unique(np.concatenate([crowded, alike, whole]))
    if len(candidates) < 2:
        return np.empty(0, np.int32)
    vertices = np.sort(corners[:, candidates], axis=0)
    vertices[1:][vertices[1:] == vertices[:-1]] = -1
    vertices = np.sort(vertices, axis=0)
    order = np.lexsort((candidates, *vertices))
    same = (np.diff(vertices[:, order], axis=1) == 0).all(axis=0)
    return np.sort(candidates[order][1:][same]).astype(np.int32)


VANISHED = -2


def _across(faces: Faces, local: int, cells: Array | None = None) -> Array:
    """The cell on the other side of a local face of cells, -1 at the boundary, `VANISHED` where there is no face."""
    rows = faces.rows[local] if cells is None else faces.rows[local, cells]
    own = np.arange(len(rows)) if cells is None else cells
    left, right = faces.cells[0, rows], faces.cells[1, rows]
    return np.where(rows < 0, VANISHED, np.where(left == own, right, left))
