"""Points at the same place made one, for files that know no vertices: equal to the last bit, without sorting."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..topology.slots import last_writers

ROUNDS = 12
"""After so many rounds the rest is sorted: only points that were chosen to collide get there."""

_ODD = (0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9)


def welded(axes: list[Array]) -> tuple[Ids, Ids]:
    """Find equal points.

    Each writes its number into a slot that its coordinates choose, the first one last (`topology/slots.py`); who finds
    one of the same coordinates there has met the first of its equals, the others try again in another slot.

    Parameters
    ----------
    axes : list of (n,) float32 or float64
        Coordinates, finite; 0 and -0 are one place.

    Returns
    -------
    first : (V,) int32
        The first point of each place, ascending.
    ids : (n,) int32
        Which of them each point is.

    Examples
    --------
    >>> first, ids = welded([np.array([5.0, 0.0, 5.0, -0.0]), np.array([1.0, 2.0, 1.0, 2.0])])
    >>> first.tolist(), ids.tolist()
    ([0, 1], [0, 1, 0, 1])
    """
    keys = [bits_of(axis) for axis in axes]
    count = len(keys[0])
    same_as = np.empty(count, np.int32)
    left = np.arange(count, dtype=np.int32)
    width = max(4, count.bit_length() + 1)
    table = np.empty(1 << width, np.int32)
    for step in range(ROUNDS):
        if not len(left):
            break
        slots = slots_of([key[left] for key in keys] if step else keys, step, width)
        winners = last_writers(table, slots[::-1], left[::-1])[::-1]
        met = np.ones(len(left), dtype=bool)
        for key in keys:
            met &= key[winners] == key[left]
        same_as[left[met]] = winners[met]
        left = left[~met]
    if len(left):
        _, first, ids = np.unique(
            np.stack([key[left] for key in keys]), axis=1, return_index=True, return_inverse=True
        )
        same_as[left] = left[first[ids.reshape(-1)]]
    own = same_as == np.arange(count, dtype=np.int32)
    number = np.cumsum(own, dtype=np.int32) - np.int32(1)
    return np.flatnonzero(own).astype(np.int32), number[same_as]


def bits_of(axis: Array) -> Array:
    """Numbers as their bits; those of 0 for -0."""
    positive = axis + axis.dtype.type(0)
    bits: Array = positive.view(np.uint32 if positive.itemsize == 4 else np.uint64)
    return bits


def slots_of(keys: list[Array], step: int, width: int) -> NDArray[np.int64]:
    """Slots below 2^width, others in each step: the upper bits of a sum of products with odd numbers."""
    mixed = np.zeros(len(keys[0]), np.uint64)
    for key, odd in zip(keys, _ODD, strict=False):
        wide = key.astype(np.uint64)
        wide ^= wide >> np.uint64(32)  # the lower bits of round numbers are all zero
        wide *= np.uint64((odd * (2 * step + 1)) & 0xFFFFFFFFFFFFFFFF)
        mixed += wide
    mixed ^= mixed >> np.uint64(29)
    mixed *= np.uint64(_ODD[0])
    return (mixed >> np.uint64(64 - width)).astype(np.int64)
