"""What cells are, or have collapsed to."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..cells import FACES, HEXAHEDRON, KINDS, PYRAMID, TETRAHEDRON, WEDGE

SHAPES = (*KINDS, "other")
"""The kinds of cells, and what a hexahedron can collapse to that is none of them."""

OTHER = len(KINDS)

FORMS = {WEDGE: (6, 2, 3), PYRAMID: (5, 4, 1), TETRAHEDRON: (4, 4, 0)}
"""Of each kind: vertices, triangles, quadrilaterals."""


def shapes(kinds: NDArray[np.uint8], corners: Ids, repeating: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Class each cell by its kind; a hexahedron that repeats vertices by the kind that it has collapsed to.

    It has if it has as many vertices, triangles and quadrilaterals, no two with the same vertices, as that kind.

    Parameters
    ----------
    kinds : (C,) uint8
    corners : (8, C) int32
    repeating : (C,) bool
        Whether the cell has a vertex at more than one of its corners.

    Returns
    -------
    (C,) uint8
        Index into `SHAPES`.

    >>> prism = np.array([[0, 1, 2, 2, 3, 4, 5, 5]], dtype=np.int32).T
    >>> SHAPES[shapes(np.zeros(1, np.uint8), prism, np.array([True]))[0]]
    'wedge'
    """
    out = kinds.copy()
    cells = np.flatnonzero(repeating & (kinds == HEXAHEDRON))
    own = corners[:, cells]
    vertices = _distinct(own)
    triangles, quads = (np.zeros(len(cells), dtype=np.int64) for _ in range(2))
    faces = np.sort([own[list(face)] for face in FACES], axis=1)  # (6, 4, n)
    sides = np.array([_distinct(face) for face in faces]).reshape(6, -1)
    for number, count in ((3, triangles), (4, quads)):
        count += (sides == number).sum(axis=0)
    twice = np.zeros(len(cells), dtype=bool)
    for one in range(6):
        for other in range(one):
            twice |= (_sets(faces[one]) == _sets(faces[other])).all(axis=0) & (sides[one] >= 3)
    out[cells] = OTHER
    for kind, form in FORMS.items():
        fits = (vertices == form[0]) & (triangles == form[1]) & (quads == form[2]) & ~twice
        out[cells[fits]] = kind
    return out


def _distinct(vertices: Array) -> Array:
    """How many distinct vertices stand in each column."""
    rows = np.sort(vertices, axis=0)
    return np.asarray(1 + (rows[1:] != rows[:-1]).sum(axis=0))


def _sets(rows: Array) -> Array:
    """Sorted columns in which each vertex stands as often as it may: a repeated one is the largest again."""
    repeats = np.zeros(rows.shape, dtype=bool)
    repeats[1:] = rows[1:] == rows[:-1]
    return np.sort(np.where(repeats, rows[-1], rows), axis=0)
