"""Face keys: what two cells must agree on to share a face.

A face is known by its set of distinct vertices. Its smallest id chooses a handful of slots of a table, the
three others make its key, so that two faces in one slot with equal keys are one face: nothing is left to
chance. A triangle, of which a cell repeats a corner, writes its largest id twice, which no quad does.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids

Slots = NDArray[np.intp]

SLOTS_PER_VERTEX = 4
"""In a grid a vertex is the smallest of three faces; four slots settle most faces at the first look."""

NARROW_BITS = 21
"""Three ids of that many bits fit in one 64-bit key; wider ids take two keys."""

CHUNK = 16384
"""Cells in a chunk: the temporaries of the sorting network stay in the second-level cache."""

_MIX = np.int64(-7046029254386353131)

# Each face by two opposite edges, so that the first comparisons of the sorting network serve two faces.
_EDGE_PAIRS = ((0, 3), (1, 2), (4, 5), (6, 7), (0, 4), (1, 5), (2, 6), (3, 7))
_FACE_EDGES = ((0, 1), (2, 3), (4, 5), (5, 6), (6, 7), (7, 4))


class FaceKeys(NamedTuple):
    """Keys of all 6 C sides of cells, side `local * C + cell`.

    Attributes
    ----------
    slot : (6 C,) intp
        Place in a table of `SLOTS_PER_VERTEX * V`; equal for equal faces; -1 where the face has vanished.
    parts : tuple of (6 C,) int64 or int32
        Faces of one slot are the same if and only if all parts are equal.
    vanished : bool
        Whether any slot is -1.
    """

    slot: Slots
    parts: tuple[NDArray[np.int64] | Ids, ...]
    vanished: bool


def face_keys(corners: Ids, vertex_count: int) -> FaceKeys:
    """Keys of the six faces of each cell.

    Parameters
    ----------
    corners : (8, C) int32
    vertex_count : int
        More than any id in `corners`.
    """
    count = corners.shape[1]
    narrow = vertex_count <= 1 << NARROW_BITS
    slot = np.empty((6, count), np.intp)
    key = np.empty((6, count), np.int64)
    last = None if narrow else np.empty((6, count), np.int32)
    vanished = False
    for start in range(0, count, CHUNK):
        part = slice(start, min(start + CHUNK, count))
        chunk = corners[:, part]
        low = [np.minimum(chunk[a], chunk[b]) for a, b in _EDGE_PAIRS]
        high = [np.maximum(chunk[a], chunk[b]) for a, b in _EDGE_PAIRS]
        for face, (one, other) in enumerate(_FACE_EDGES):
            first = np.minimum(low[one], low[other])
            fourth = np.maximum(high[one], high[other])
            inner = np.maximum(low[one], low[other])
            third = np.minimum(high[one], high[other])
            second = np.minimum(inner, third)
            np.maximum(inner, third, out=third)
            gone = _collapse(first, second, third, fourth)
            k = key[face, part]
            k[:] = second
            if last is None:
                k <<= NARROW_BITS
                k += third
                k <<= NARROW_BITS
                k += fourth
                mixed = k * _MIX
            else:
                k <<= 32
                k += third
                last[face, part] = fourth
                mixed = (k + fourth) * _MIX
            mixed >>= 62
            mixed &= SLOTS_PER_VERTEX - 1
            where = slot[face, part]
            where[:] = first
            where *= SLOTS_PER_VERTEX
            np.add(where, mixed, out=where, casting="same_kind")
            if gone is not None:
                where[gone] = -1
                vanished = True
    parts = (key.reshape(-1),) if last is None else (key.reshape(-1), last.reshape(-1))
    return FaceKeys(slot.reshape(-1), parts, vanished)


def _collapse(first: Ids, second: Ids, third: Ids, fourth: Ids) -> NDArray[np.bool_] | None:
    """Bring triangles (of sorted ids, in place) to one form; tell which faces have fewer than three ids."""
    low, middle, high = first == second, second == third, third == fourth
    if not (low.any() or middle.any() or high.any()):
        return None
    gone = (low & middle) | (middle & high) | (low & high)
    early = (low | middle) & ~gone
    second[early] = third[early]
    third[early] = fourth[early]
    return gone if gone.any() else None
