"""Cells rebuilt from their half-faces: which vertex stands where."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE

BASE_SIZE = {HEXAHEDRON: 4, WEDGE: 3, PYRAMID: 4, TETRAHEDRON: 3}
"""Corners of the face that a cell is built up from."""


def rebuilt(
    kind: int, faces: Array, origins: Array, face_starts: Array, sizes: Array
) -> tuple[NDArray[np.int32], NDArray[np.bool_]]:
    """Corners of cells of one kind, in VTK's order.

    Parameters
    ----------
    kind : int
        Index into KINDS; every cell has the faces of that kind.
    faces : (n, m) ids
        Half-faces of each cell, seen counter-clockwise from outside.
    origins : (h,) ids
        For each half-edge of each face the vertex it leaves, rows of `sizes` values that begin at
        `face_starts`.

    Returns
    -------
    corners : (k, n) int32
    good : (n,) bool
        Whether the faces close up to a cell of that kind.
    """
    count, face_count = faces.shape
    base_size = BASE_SIZE[kind]
    loops = polygons(faces, origins, face_starts, sizes)
    is_base = sizes[faces >> 1] == base_size
    first = np.argmax(is_base, axis=1)
    cells = np.arange(count)
    base = loops[cells, first, :base_size].astype(np.int32)
    tops = np.full((count, base_size), -1, dtype=np.int32)
    for face in range(face_count):
        size = sizes[faces[:, face] >> 1]
        for place in range(4):
            here = loops[:, face, place]
            for step in (1, -1):
                other = loops[cells, face, (place + step) % np.maximum(size, 1)]
                outside = (place < size) & (first != face) & (other[:, None] != base).all(axis=1)
                for corner in range(base_size):
                    hit = outside & (here == base[:, corner])
                    tops[hit, corner] = other[hit]
    good: NDArray[np.bool_] = np.all(tops >= 0, axis=1)
    if kind == HEXAHEDRON:
        corners = [*base[:, [0, 3, 2, 1]].T, *tops[:, [0, 3, 2, 1]].T]
    elif kind == WEDGE:
        corners = [*base.T, *tops.T]
    elif kind == PYRAMID:
        corners = [*base[:, [0, 3, 2, 1]].T, tops[:, 0]]
    else:
        corners = [*base[:, [0, 2, 1]].T, tops[:, 0]]
    if kind in (PYRAMID, TETRAHEDRON):
        good &= np.all(tops == tops[:, :1], axis=1)
    return np.stack(corners).astype(np.int32), good


def polygons(faces: Array, origins: Array, face_starts: Array, sizes: Array) -> Array:
    """(n, m, 4) vertices of each half-face in its order; a triangle's last is -1."""
    face = faces >> 1
    size = np.minimum(sizes[face], 4)
    out = np.full((*faces.shape, 4), -1, dtype=np.int32)
    for place in range(4):
        # the other side runs backwards: its half-edges are the opposite ones, in reverse
        own = np.where((faces & 1) == 0, place, size - 1 - place)
        there = place < size
        out[..., place][there] = origins[(face_starts[face] + own)[there]]
    return out
