"""Pairs of numbers that occur again, and the different pairs with how often they occur; without sorting all."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from .slots import last_writers


def repeated_pairs(one: Ids, other: Ids) -> NDArray[np.intp]:
    """Rows of pairs that occur in another row, too: of n equal pairs at least n - 1 are told.

    Parameters
    ----------
    one, other : (N,) int32

    Examples
    --------
    >>> one, other = np.array([7, 3, 7, 7], np.int32), np.array([1, 1, 2, 1], np.int32)
    >>> repeated_pairs(one, other).tolist()
    [0]
    """
    bits = max(int(2 * len(one)).bit_length(), 4)
    table = np.empty(1 << bits, np.int32)
    rows = np.arange(len(one), dtype=np.int32)
    found = []
    multiplier = 0x9E3779B1
    while len(rows):
        a, b = one[rows], other[rows]
        mixed = a.view(np.uint32) * np.uint32(multiplier) + b.view(np.uint32) * np.uint32(0x85EBCA77)
        mixed ^= mixed >> np.uint32(15)
        mixed *= np.uint32(0xC2B2AE3D)
        winner = last_writers(table, mixed >> np.uint32(32 - bits), rows)
        lost = np.flatnonzero(winner != rows)
        same = (one[winner[lost]] == a[lost]) & (other[winner[lost]] == b[lost])
        found.append(rows[lost[same]])
        rows = rows[lost[~same]]
        multiplier = (multiplier * 3 + 2) & 0xFFFFFFFF
    return np.concatenate(found).astype(np.intp) if found else np.empty(0, np.intp)


def counted_pairs(one: Array, other: Array, span: int) -> tuple[Ids, Ids, NDArray[np.int64]]:
    """Find the different pairs, ascending, and how often each occurs.

    Parameters
    ----------
    one, other : (N,) int
        Not negative, `other` below `span`.
    span : int

    Returns
    -------
    one, other : (P,) int32
    counts : (P,) int64

    Examples
    --------
    >>> one, other, counts = counted_pairs(np.array([7, 3, 7, 7]), np.array([1, 1, 2, 1]), 3)
    >>> one.tolist(), other.tolist(), counts.tolist()
    ([3, 7, 7], [1, 1, 2], [1, 2, 1])
    """
    keys, counts = np.unique(one.astype(np.int64) * span + other, return_counts=True)
    return (keys // max(span, 1)).astype(np.int32), (keys % max(span, 1)).astype(np.int32), counts
