"""Which corners of a cell coincide: the pattern by which a hexahedron collapses."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids
from ..cells import FACES

Places = NDArray[np.uint8]
Pattern = tuple[int, ...]

HEXAHEDRON: Pattern = (0, 1, 2, 3, 4, 5, 6, 7)


def first_places(corners: Ids) -> Places | None:
    """For each corner of (8, n) cells the first place of the same vertex; None if all are distinct."""
    first: Places | None = None
    for late in range(7, 0, -1):
        for early in range(late - 1, -1, -1):
            same = corners[late] == corners[early]
            if not same.any():
                continue
            if first is None:
                first = np.repeat(np.arange(8, dtype=np.uint8)[:, None], corners.shape[1], axis=1)
            first[late][same] = early
    return first


def by_pattern(corners: Ids) -> list[tuple[Pattern, NDArray[np.intp]]]:
    """Split (8, n) cells by the pattern in which they collapse.

    A pattern says for each of the eight places the first one that holds the same vertex: 0 to 7 for a true
    hexahedron, (0, 1, 2, 2, 4, 5, 6, 6) for one whose edges 2-3 and 6-7 have no length.

    Returns
    -------
    list of (pattern, (m,) intp)
        Each pattern that occurs, and the indices of its cells.
    """
    first = first_places(corners)
    if first is None:
        return [(HEXAHEDRON, np.arange(corners.shape[1]))]
    code = np.zeros(corners.shape[1], np.int32)
    for place in range(8):
        code <<= 3
        code |= first[place]
    order = np.argsort(code, kind="stable")
    starts = np.flatnonzero(np.diff(code[order], prepend=-1))
    groups = np.split(order, starts[1:])
    return [(tuple(int(place) for place in first[:, group[0]]), group) for group in groups]


def polygons(pattern: Pattern) -> list[tuple[int, Pattern]]:
    """The faces that a collapsed cell still has: place in `FACES`, and its three or four corners in order.

    A face that has folded onto itself (a b a c) has no area and parts nothing: it is left out too.
    """
    out = []
    for face, places in enumerate(FACES):
        ring = [pattern[place] for place in places]
        kept = tuple(ring[i] for i in range(4) if ring[i] != ring[i - 1])
        if len(kept) >= 3 and len(set(kept)) == len(kept):
            out.append((face, kept))
    return out
