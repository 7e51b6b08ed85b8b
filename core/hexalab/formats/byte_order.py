"""Numbers as they lie in a file's bytes, made this machine's numbers."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..arrays import Array

STRETCH = 1 << 18
"""Bytes that are converted at a time: few enough that reading them column by column stays in cache."""


def stretches(rows: Array) -> Iterator[tuple[slice, Array]]:
    """Some rows of a C-contiguous (n, k) table after others: which they are, and they, at even addresses.

    Where they are copied for it, then always to the same memory: fresh memory costs more than the copy, so
    each stretch is to be used up before the next is taken.
    """
    most = max(1, STRETCH // max(1, rows.shape[1] * rows.itemsize))
    parts = (slice(start, min(start + most, len(rows))) for start in range(0, len(rows), most))
    if rows.flags.aligned:
        yield from ((part, rows[part]) for part in parts)
        return
    memory = np.empty(rows[:most].nbytes, dtype=np.uint8)
    for part in parts:
        copied = memory[: rows[part].nbytes]
        copied[:] = rows[part].reshape(-1).view(np.uint8)
        yield part, copied.view(rows.dtype).reshape(-1, rows.shape[1])


def native(values: Array) -> Array:
    """The values in this machine's byte order and at even addresses; no copy where they are already.

    Numpy swaps and casts numbers one by one where they lie at odd addresses, which is four times slower
    than to copy their bytes to an even one before.
    """
    if not values.flags.aligned and values.ndim and values.strides[-1] == values.itemsize:
        values = values.view(np.uint8).copy().view(values.dtype)
        if not values.dtype.isnative:
            values = values.byteswap(inplace=True).view(values.dtype.newbyteorder("="))
    return values.astype(values.dtype.newbyteorder("="), copy=False)


def as_coordinates(rows: Array) -> Array:
    """Coordinates as the mesh holds them, from rows as files do.

    Parameters
    ----------
    rows : (n, 3) array
        x, y, z, C-contiguous, in any number type, byte order and alignment.

    Returns
    -------
    (3, n) float64
    """
    out = np.empty((3, len(rows)))
    with np.errstate(invalid="ignore"):
        for part, stretch in stretches(rows):
            out[:, part] = stretch.T
    return out
