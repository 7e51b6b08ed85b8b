"""Cells that repeat another: they have the very same vertices and faces."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Ids
from ..cells import FACES
from .faces import Faces


def repeated_cells(corners: Ids, faces: Faces) -> Ids:
    """Ids of the cells whose vertices and faces are those of a cell before them, ascending.

    Such a cell is at a face of more than two cells, or the two have each other on both sides of all their faces: no
    others are compared. (Of folded cells, which have a face several times, some may lie outside of both.)

    >>> from hexalab.topology.faces import find_faces
    >>> cube = np.arange(8, dtype=np.int32)
    >>> turned, twisted = cube[[1, 2, 3, 0, 5, 6, 7, 4]], cube[[0, 2, 1, 3, 4, 5, 6, 7]]
    >>> corners = np.stack([cube, cube + 8, turned, twisted], axis=1)
    >>> repeated_cells(corners, find_faces(corners, 16)).tolist()
    [2]
    """
    cells = _candidates(faces) if corners.shape[1] else np.empty(0, np.intp)
    vertices = _as_sets(corners[:, cells])
    some = _order(vertices, cells)
    alike = _as_before(vertices, some)
    cells = np.sort(cells[np.union1d(some[1:][alike], some[:-1][alike])])
    if not len(cells):
        return np.empty(0, np.int32)
    forms = np.concatenate([_as_sets(corners[:, cells]), _as_sets(_face_ids(corners[:, cells]))])
    order = _order(forms, cells)
    return np.sort(cells[order[1:][_as_before(forms, order)]]).astype(np.int32)


def _candidates(faces: Faces) -> Array:
    """Cells at crowded faces, and cells that have one and the same neighbour wherever a face leads to another cell."""
    first = _across(faces, 0)
    alike = np.flatnonzero(first >= 0)
    for local in range(1, 6):
        other = _across(faces, local, alike)
        alike = alike[(other == first[alike]) | (other == NOWHERE)]
        if not len(alike):
            break
    nowhere = np.flatnonzero(first == NOWHERE)  # rare, so that all of these are looked at
    candidates: Array = np.unique(np.concatenate([faces.crowd_cells.astype(np.intp), alike, nowhere]))
    return candidates


NOWHERE = -2


def _across(faces: Faces, local: int, cells: Array | None = None) -> Array:
    """The cell on the other side of a local face of cells; -1 at the boundary.

    `NOWHERE` is a face that has vanished, and one that a folded cell has twice.
    """
    rows = faces.rows[local] if cells is None else faces.rows[local, cells]
    own = np.arange(len(rows)) if cells is None else cells
    if not faces.cells.shape[1]:
        return np.full(len(rows), NOWHERE)
    left, right = faces.cells[0, rows], faces.cells[1, rows]
    other = np.where(left == own, right, left)
    return np.where((rows < 0) | (other == own), NOWHERE, other)


def _as_sets(ids: Array) -> Array:
    """The columns as sets: ascending, -1 for each id that stands there already.

    >>> _as_sets(np.array([[3], [1], [3], [2]])).T.tolist()
    [[-1, 1, 2, 3]]
    """
    ids = np.sort(ids, axis=0)
    ids[1:][ids[1:] == ids[:-1]] = -1
    return np.sort(ids, axis=0)


def _face_ids(corners: Ids) -> Array:
    """(6, n) a number for each set of three or four vertices that is a face, -1 for a face that has vanished."""
    faces = _as_sets(corners[np.array(FACES).T].reshape(4, -1))
    order = _order(faces)
    ids = np.zeros(faces.shape[1], np.intp)
    ids[order[1:]] = np.cumsum(~_as_before(faces, order))
    return np.where(faces[1] < 0, -1, ids).reshape(6, -1)


def _order(columns: Array, *last: Array) -> Array:
    """Order of columns in which equal ones stand together."""
    order: Array = np.lexsort((*last, *columns))
    return order


def _as_before(columns: Array, order: Array) -> Array:
    """Whether each column but the first, in that order, equals the one before it."""
    return np.asarray((columns[:, order[1:]] == columns[:, order[:-1]]).all(axis=0))
