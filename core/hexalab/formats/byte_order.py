"""Numbers as they lie in a file's bytes, made this machine's numbers."""

from __future__ import annotations

import numpy as np

from ..mesh import Array

ROWS = 8192
"""Rows that are converted at a time: few enough that reading them column by column stays in cache."""


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
    """(3, n) float64 from (n, 3) rows of x, y, z in any number type, byte order and alignment."""
    out = np.empty((3, len(rows)))
    with np.errstate(invalid="ignore"):
        for start in range(0, len(rows), ROWS):
            part = slice(start, start + ROWS)
            out[:, part] = native(rows[part]).T
    return out
