"""Cells rebuilt from their faces, for formats that know cells by faces: which vertex stands where.

A face is a loop of vertices. A cell is a hexahedron, wedge, pyramid or tetrahedron if its loops are the faces of one,
whatever their order and wherever each begins. Loops also say how a cell is oriented: all of them are seen
counter-clockwise from outside, or all from inside. Which of both is meant is the format's convention, not always kept.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array, Ids
from ..cells import CORNERS_OF_KIND, HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from .face_windings import windings

MOST_FACES = 6
LARGEST_FACE = 4
BASE_SIZE = {HEXAHEDRON: 4, WEDGE: 3, PYRAMID: 4, TETRAHEDRON: 3}
"""Corners of the face that a cell is built up from."""

SHAPES = (
    (HEXAHEDRON, 6, {4: 6}),
    (WEDGE, 5, {3: 2, 4: 3}),
    (PYRAMID, 5, {3: 4, 4: 1}),
    (TETRAHEDRON, 4, {3: 4}),
)
"""Kind, number of faces, how many of them have so many corners."""


@dataclass
class Rebuilt:
    """Cells that were found among polyhedra.

    Parameters
    ----------
    kinds : (n,) int8
        Index into KINDS, -1 for what is none of them.
    corners : (8, n) int32
        Own corners in VTK's order in the first rows, as if all loops were seen counter-clockwise from outside.
    agreeing : (n,) bool
        Whether all loops of the cell are seen from the same side.
    """

    kinds: NDArray[np.int8]
    corners: Ids
    agreeing: NDArray[np.bool_]

    def of(self, kind: int) -> tuple[NDArray[np.intp], Ids, NDArray[np.bool_]]:
        """Which cells are of the kind, their own corners, (k, m), and whether their loops agree."""
        which = np.flatnonzero(self.kinds == kind)
        return which, self.corners[: len(CORNERS_OF_KIND[kind]), which], self.agreeing[which]


def rebuild(loops_of: Callable[[slice], Array], count: int) -> Rebuilt:
    """Find the hexahedra, wedges, pyramids and tetrahedra.

    Parameters
    ----------
    loops_of : callable
        For a slice of cells the (m, 6, 4) vertices of their faces; a triangle's last is -1, and so are all of faces
        that a cell does not have, which come last. All are -1 for cells that have more or larger faces.
    count : int
        How many cells there are.
    """
    out = Rebuilt(np.full(count, -1, np.int8), np.zeros((8, count), np.int32), np.ones(count, bool))
    for start in range(0, count, CHUNK):
        part = slice(start, min(start + CHUNK, count))
        loops = loops_of(part)
        triangles = ((loops[..., 2] >= 0) & (loops[..., 3] < 0)).sum(axis=1)
        quadrilaterals = (loops[..., 3] >= 0).sum(axis=1)
        for kind, face_count, shape in SHAPES:
            which = np.flatnonzero((triangles == shape.get(3, 0)) & (quadrilaterals == shape.get(4, 0)))
            if not len(which):
                continue
            own, good = from_loops(kind, loops[which, :face_count])
            turns, whole = windings(kind, own, loops[which, :face_count])
            good &= whole
            places = start + which[good]
            out.kinds[places] = kind
            out.corners[: len(own), places] = own[:, good]
            out.agreeing[places] = (turns[good] > 0).all(axis=1)
    return out


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
    return from_loops(kind, polygons(faces, origins, face_starts, sizes))


def from_loops(kind: int, loops: Array) -> tuple[NDArray[np.int32], NDArray[np.bool_]]:
    """Corners of cells of one kind from the (n, m, 4) loops of their faces; see `rebuilt`.

    The first face of the right size is the base; what its corners are joined to outside of it stands above them.
    """
    count, face_count = loops.shape[:2]
    base_size = BASE_SIZE[kind]
    sizes = np.where(loops[..., 3] < 0, 3, 4)
    first = np.argmax(sizes == base_size, axis=1)
    cells = np.arange(count)
    base = loops[cells, first, :base_size].astype(np.int32)
    tops = np.full((count, base_size), -1, dtype=np.int32)
    for face in range(face_count):
        size = sizes[:, face]
        for place in range(LARGEST_FACE):
            here = loops[:, face, place]
            for step in (1, -1):
                other = loops[cells, face, (place + step) % size]
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


def rows_of(ids: Array, starts: Array, counts: Array) -> Array:
    """(n, 6) the ids of rows that begin at `starts`, -1 behind a row's end; none of rows that are longer."""
    place = np.arange(MOST_FACES)
    there = (place < counts[:, None]) & (counts[:, None] <= MOST_FACES)
    out = np.full(there.shape, -1, dtype=np.intp)
    out[there] = ids[(starts[:, None] + place)[there]]
    return out


def polygons(faces: Array, origins: Array, face_starts: Array, sizes: Array) -> Array:
    """(n, m, 4) vertices of each half-face in its order.

    -1 are a triangle's last one, all of a half-face that is -1, and all of a cell that has a face of another size.
    """
    known = faces >= 0
    face = np.where(known, faces >> 1, 0)
    size = np.where(known, sizes[face], 3) if len(sizes) else np.full(faces.shape, 3)
    known &= ((size == 3) | (size == LARGEST_FACE)).all(axis=1, keepdims=True)
    out = np.full((*faces.shape, LARGEST_FACE), -1, dtype=np.int32)
    for place in range(LARGEST_FACE):
        # the other side runs backwards: its half-edges are the opposite ones, in reverse
        own = np.where((faces & 1) == 0, place, size - 1 - place)
        there = known & (place < size)
        out[..., place][there] = origins[(face_starts[face] + own)[there]]
    return out
