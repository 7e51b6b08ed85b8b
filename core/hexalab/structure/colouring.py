"""Colours of blocks: those that share a face never have the same, as far as there are colours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array, Ids
from ..topology.pairs import counted_pairs
from .base_complex import BaseComplex
from .frame import Frame


def block_colours(frame: Frame, base: BaseComplex, colours: int) -> NDArray[np.uint8]:
    """(B,) uint8: the colour of each block, below `colours`."""
    ones, others = [], []
    for start in range(0, frame.paired, CHUNK):
        part = slice(start, min(start + CHUNK, frame.paired))
        walls = np.flatnonzero(base.complex_faces[part])
        one, other = (base.of_cells[cells[part][walls]] for cells in frame.face_cells)
        ones.append(np.minimum(one, other))
        others.append(np.maximum(one, other))
    count = base.count
    one, other, _ = (
        counted_pairs(np.concatenate(ones), np.concatenate(others), count) if ones else (NONE, NONE, NONE)
    )
    apart = one != other
    return coloured(count, one[apart], other[apart], colours)


NONE = np.empty(0, np.int32)


def coloured(count: int, one: Ids, other: Ids, colours: int) -> NDArray[np.uint8]:
    """Colour things so that those of a pair differ.

    All whose number, scrambled, is larger than those of all their neighbours without a colour take one at the
    same time, the first that no neighbour has, counted from a colour of their own so that all are used. If
    there is none left they take that.

    Parameters
    ----------
    count : int
    one, other : (P,) int32
        Pairs, each once, of different things.
    colours : int
        At most 32.

    Examples
    --------
    >>> square = coloured(4, np.array([0, 1, 2, 0], np.int32), np.array([1, 2, 3, 3], np.int32), 12)
    >>> [bool(square[a] != square[b]) for a, b in ((0, 1), (1, 2), (2, 3), (0, 3))]
    [True, True, True, True]
    """
    rank = _scrambled(count)
    out = np.zeros(count, np.uint8)
    taken = np.zeros(count, np.uint64)
    waiting = np.ones(count, dtype=bool)
    while waiting.any():
        first = waiting.copy()
        first[np.where(rank[one] < rank[other], one, other)] = False
        now = np.flatnonzero(first)
        out[now] = _free(taken[now], rank[now] % colours, colours)
        waiting[now] = False
        for mine, theirs in ((one, other), (other, one)):
            told = first[mine]
            np.bitwise_or.at(taken, theirs[told], np.uint64(1) << out[mine[told]].astype(np.uint64))
        left = waiting[one] & waiting[other]
        one, other = one[left], other[left]
    return out


def _scrambled(count: int) -> Array:
    """The numbers from 0 on in another order, the same each time."""
    mixed = np.arange(count, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)
    rank = np.empty(count, np.int64)
    rank[np.argsort(mixed, kind="stable")] = np.arange(count)
    return rank


def _free(taken: Array, start: Array, colours: int) -> Array:
    """For each set of bits the first that is not in it, counted from a start; the start where all are."""
    out = start.copy()
    open_ = np.ones(len(taken), dtype=bool)
    for step in range(colours):
        colour = (start + step) % colours
        hit = open_ & ((taken >> colour.astype(np.uint64)) & np.uint64(1) == 0)
        out[hit] = colour[hit]
        open_ &= ~hit
    return out
