"""Each edge of a surface once.

On a closed surface two quads cross most edges, four or more at an edge where it touches itself. A table
settles who draws: each quad's side writes its number into the slot of its edge, and the last writer wins.
Whoever finds another edge's number there tries again in the next round; a round settles three of four, and
sorts nothing.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids
from ..topology.slots import last_writers
from .records import UInt32s

Indices = NDArray[np.intp]

_MIX = np.int64(-7046029254386353131)
_SPARE = 2
"""The table has at least that many slots for each side: with two sides to an edge, four for each edge."""


def quad_sides(corners: Ids) -> tuple[Ids, Ids, Indices]:
    """Sides of (4, N) quads: start, end, index `place * N + quad`; a triangle's fourth side is left out."""
    start = corners.reshape(-1)
    end = np.concatenate([corners[1:], corners[:1]]).reshape(-1)
    real = start != end
    if real.all():
        return start, end, np.arange(len(start))
    kept = np.flatnonzero(real)
    return start[kept], end[kept], kept


def one_of_each(start: Ids, end: Ids) -> Indices:
    """For each side the one that stands for its edge, the same for all between the same two vertices."""
    key = np.minimum(start, end).astype(np.int64)
    key <<= 32
    key |= np.maximum(start, end)
    bits = max((len(key) * _SPARE - 1).bit_length(), 1)
    mixed = key ^ (key >> 29)
    mixed *= _MIX
    mixed >>= 64 - bits
    mixed &= (1 << bits) - 1
    slot = mixed.astype(np.intp)
    table = np.empty(1 << bits, np.intp)
    winner = np.empty(len(key), np.intp)
    sides: Indices = np.arange(len(key))
    while len(sides):
        first = last_writers(table, slot, sides)
        same = key[first] == key[sides]
        if same.all():
            winner[sides] = first
            break
        agree, rest = np.flatnonzero(same), np.flatnonzero(~same)
        winner[sides[agree]] = first[agree]
        sides, slot = sides[rest], slot[rest]
    return winner


def faces_beside(winner: Indices, drawn: Indices, quad: Indices) -> UInt32s:
    """(2 E,) two quads that meet at each drawn side's edge; the same twice where there is but one.

    Parameters
    ----------
    winner : (S,) intp
        As `one_of_each` returns it.
    drawn : (E,) intp
        Sides that stand for their edges.
    quad : (S,) intp
        Quad of each side.
    """
    partner = np.arange(len(winner))
    others = np.flatnonzero(winner != partner)
    partner[winner[others]] = others
    beside = np.empty((len(drawn), 2), np.uint32)
    beside[:, 0] = quad[drawn]
    beside[:, 1] = quad[partner[drawn]]
    return beside.reshape(-1)
