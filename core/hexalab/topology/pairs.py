"""Pairs of numbers: which occur again, and how often the different ones do; without sorting all."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array, Ids
from .slots import last_writers

SLOT_BITS = 3
"""Eight slots for each end: in a grid six edges meet at a vertex."""

ROUNDS = 12
"""After so many rounds the rest is sorted: an end at which very many meet."""

_ODD = 0x9E3779B1


def repeated_labels(ends: Ids, labels: Ids, span: int) -> Ids:
    """Labels of which two rows share an end, ascending.

    Rows write their number into a slot that an end and a mixture of their label choose, as in `slots`. Whoever
    finds a row of the same label there has met its equal; whoever finds another tries again in the next round.

    Parameters
    ----------
    ends : (k, N) int32
        From 0 on, below `span`; those of a row differ.
    labels : (N,) int32
    span : int

    Examples
    --------
    Edges 0 1, 1 2, 2 3 with the labels 5, 7, 5: they are in a row, but equal ones do not touch. Then they do.

    >>> ends = np.array([[0, 1, 2], [1, 2, 3]], np.int32)
    >>> repeated_labels(ends, np.array([5, 7, 5], np.int32), 4).tolist()
    []
    >>> repeated_labels(ends, np.array([5, 5, 7], np.int32), 4).tolist()
    [5]
    """
    table = np.empty(span << SLOT_BITS, np.int32)
    count = len(labels)
    found: list[Array] = []
    left: list[Array] = []
    chunks = [slice(start, start + CHUNK) for start in range(0, count, CHUNK)]
    for part in chunks:
        rows = np.arange(part.start, min(part.stop, count), dtype=np.int32)
        for end in ends:
            table[_slots(end[part], labels[part], _ODD)] = rows
    for part in chunks:
        rows = np.arange(part.start, min(part.stop, count), dtype=np.int32)
        for number, end in enumerate(ends):
            winner = table[_slots(end[part], labels[part], _ODD)]
            lost = np.flatnonzero(winner != rows)
            same = labels[winner[lost]] == labels[rows[lost]]
            found.append(labels[rows[lost[same]]])
            left.append(rows[lost[~same]].astype(np.int64) + number * count)
    entries = np.concatenate(left) if left else np.empty(0, np.int64)
    at, of = ends.reshape(-1)[entries], labels[entries % max(count, 1)]
    for step in range(2, 2 + ROUNDS):
        if not len(at):
            break
        slot, order = _slots(at, of, _ODD * step | 1), np.arange(len(at), dtype=np.int32)
        winner = last_writers(table, slot, order)
        lost = np.flatnonzero(winner != order)
        same = of[winner[lost]] == of[lost]
        found.append(of[lost[same]])
        lost = lost[~same]
        at, of = at[lost], of[lost]
    keys, times = np.unique(at.astype(np.int64) << 32 | of, return_counts=True)
    found.append((keys[times > 1] & 0xFFFFFFFF).astype(np.int32))
    repeated: Ids = np.unique(np.concatenate(found))
    return repeated


def _slots(ends: Ids, labels: Ids, multiplier: int) -> Ids:
    """One of the slots of each end, chosen by the label."""
    mixed = labels.astype(np.uint32)
    mixed *= np.uint32(multiplier & 0xFFFFFFFF)
    mixed >>= np.uint32(32 - SLOT_BITS)
    out: Ids = ends << SLOT_BITS
    out |= mixed.view(np.int32)
    return out


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
