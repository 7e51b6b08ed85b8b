"""Points in an order in which neighbours in space mostly are neighbours in number: Morton's curve."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats

BITS = 21
"""Along each axis; three times so many fit into an int64."""

RUN = 64
"""So many points in one cube of the curve are put in order by a curve of their own; below it pays for nobody."""

STEPS = (
    (32, 0x001F00000000FFFF),
    (16, 0x001F0000FF0000FF),
    (8, 0x100F00F00F00F00F),
    (4, 0x10C30C30C30C30C3),
    (2, 0x1249249249249249),
)
"""Halves of ever shorter runs of bits are moved apart, until two places are free behind each (`_spread`)."""


def curve_order(points: Floats) -> NDArray[np.intp]:
    """Sort points along Morton's curve through a cube around them.

    Where a stray point makes the cube so large that many others share one of its 2^63 cells, these are sorted again
    within a cube of their own.

    Parameters
    ----------
    points : (3, n) float64
        Finite.

    Returns
    -------
    (n,) intp
        Places in `points`; of points in one cell, in the order there.

    >>> curve_order(np.array([[0.0, 1, 0, 1], [0, 0, 1, 1], [0, 0, 0, 0]])[:, ::-1]).tolist()
    [3, 2, 1, 0]
    """
    if not points.shape[1]:
        return np.zeros(0, np.intp)
    low = points.min(axis=1)[:, None]
    side = float((points.max(axis=1)[:, None] - low).max())
    if side == 0:
        return np.arange(points.shape[1], dtype=np.intp)
    x, y, z = ((points - low) / side * (2**BITS - 1)).astype(np.int64)
    codes = _spread(x) | _spread(y) << 1 | _spread(z) << 2
    order = np.argsort(codes, kind="stable")
    codes = codes[order]
    starts = np.flatnonzero(np.append(True, codes[1:] != codes[:-1]))
    ends = np.append(starts[1:], len(codes))
    crowded = ends - starts > RUN
    for start, end in zip(starts[crowded].tolist(), ends[crowded].tolist(), strict=True):
        own = order[start:end]
        order[start:end] = own[curve_order(points[:, own])]
    return order


def _spread(values: NDArray[np.int64]) -> NDArray[np.int64]:
    """Numbers below 2^21 with two zeros between their bits.

    In small, with four bits 1101: first 11 and 01 are moved apart, to 110000 01, of which the mask of the last step
    but one is 11000011; then the bits of each, to 1001000001, with a mask of 1001001001.
    """
    for shift, mask in STEPS:
        values = (values | values << shift) & mask
    return values
