"""Faces and edges by their vertices: which cell has them, if any.

Only cells' sides all of whose vertices are looked for can be among them: few, where features lie on the boundary.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array, Ids
from ..cells import EDGES, FACES


def sides_of(corners: Ids, vertex_count: int, faces: Array) -> tuple[Ids, NDArray[np.uint8]]:
    """Find faces by their vertices, in whatever order.

    Parameters
    ----------
    corners : (8, C) int32
    vertex_count : int
    faces : (4, n) int
        Vertex ids; a triangle repeats one.

    Returns
    -------
    cells : (n,) int32
        The first cell that has such a face; -1 where none has.
    local : (n,) uint8
        Which of its six faces it is (`hexalab.cells.FACES`).

    >>> cube = np.arange(8, dtype=np.int32).reshape(8, 1)
    >>> [found.tolist() for found in sides_of(cube, 8, np.array([[5, 4, 6, 7], [0, 1, 2, 4]]).T)]
    [[0, -1], [1, 0]]
    """
    asked = face_keys_of(np.asarray(faces))
    wanted = np.zeros(vertex_count, dtype=bool)
    wanted[faces] = True
    some_cells, some_locals, keys = [], [], []
    for start in range(0, corners.shape[1], CHUNK):
        chunk = corners[:, start : start + CHUNK]
        there = wanted[chunk]
        for local, face in enumerate(FACES):
            rows = np.flatnonzero(there[list(face)].all(axis=0))
            if len(rows):
                some_cells.append((rows + start).astype(np.int32))
                some_locals.append(np.full(len(rows), local, dtype=np.uint8))
                keys.append(face_keys_of(chunk[list(face)][:, rows]))
    if not keys:
        return np.full(asked.shape[1], -1, dtype=np.int32), np.zeros(asked.shape[1], dtype=np.uint8)
    cells, locals_ = np.concatenate(some_cells), np.concatenate(some_locals)
    place = first_equal(np.concatenate(keys, axis=1), asked)
    return np.where(place >= 0, cells[place], -1).astype(np.int32), np.where(place >= 0, locals_[place], 0)


def edges_there(corners: Ids, vertex_count: int, edges: Array) -> NDArray[np.bool_]:
    """Tell which of (2, n) pairs of vertices are edges of cells, (n,) bool.

    >>> cube = np.arange(8, dtype=np.int32).reshape(8, 1)
    >>> edges_there(cube, 8, np.array([[1, 0], [0, 2]]).T).tolist()
    [True, False]
    """
    edges = np.asarray(edges)
    wanted = np.zeros(vertex_count, dtype=bool)
    wanted[edges] = True
    found: list[NDArray[np.int64]] = [np.zeros(0, dtype=np.int64)]
    for start in range(0, corners.shape[1], CHUNK):
        chunk = corners[:, start : start + CHUNK]
        there = wanted[chunk]
        for a, b in EDGES:
            rows = np.flatnonzero(there[a] & there[b])
            if len(rows):
                found.append(edge_keys(chunk[a, rows], chunk[b, rows]))
    known = np.unique(np.concatenate(found))
    asked = edge_keys(*edges)
    if not len(known):
        return np.zeros(len(asked), dtype=bool)
    place = np.searchsorted(known, asked).clip(max=len(known) - 1)
    return np.asarray((known[place] == asked) & (edges[0] != edges[1]))


def edge_keys(one: Array, other: Array) -> NDArray[np.int64]:
    """One number for each pair of vertices."""
    return np.minimum(one, other).astype(np.int64) << 32 | np.maximum(one, other).astype(np.int64)


def face_keys_of(faces: Array) -> NDArray[np.int64]:
    """(2, n) keys of (4, n) faces: equal for equal sets of vertices; a repeated vertex is its largest again."""
    rows = np.sort(faces, axis=0).astype(np.int64)
    for place in (0, 1):  # 3 3 5 9 becomes 3 5 9 9
        again = rows[place] == rows[place + 1]
        rows[place + 1 : 3, again] = rows[place + 2 :, again]
    return np.stack([rows[0] << 32 | rows[1], rows[2] << 32 | rows[3]])


def first_equal(known: NDArray[np.int64], asked: NDArray[np.int64]) -> NDArray[np.intp]:
    """Place among (2, m) known keys of each of (2, n) asked ones, the first of equal ones; -1 where it is not there."""
    order = np.lexsort((known[1], known[0]))
    ranked = known[:, order]
    new = np.append(True, (ranked[:, 1:] != ranked[:, :-1]).any(axis=0))
    firsts = ranked[:, new]
    mixed = np.concatenate([firsts, asked], axis=1)
    place = np.lexsort((np.arange(mixed.shape[1]) >= firsts.shape[1], mixed[1], mixed[0]))
    same = np.append(True, (mixed[:, place[1:]] != mixed[:, place[:-1]]).any(axis=0))
    leader = place[same][np.cumsum(same) - 1]
    of_asked = np.empty(mixed.shape[1], dtype=np.intp)
    of_asked[place] = leader
    leader = of_asked[firsts.shape[1] :]
    there = leader < firsts.shape[1]
    return np.where(there, order[new][np.where(there, leader, 0)], -1)
