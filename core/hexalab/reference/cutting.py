"""Polygons cut into triangles, all at once.

A quadrilateral is cut along its shorter diagonal, and where both have one length along the one through its smallest
vertex id: so its triangles do not depend on the corner that it begins with, nor on the side that it is seen from.
VTK's vtkTriangleFilter takes the shorter diagonal too; where both have one length it goes by the corner, and where a
corner is reflex it may take the longer one. Polygons of more corners are cut as fans from their first corner.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array, Floats, Ids

WITHIN = 50
"""Coordinates between 10^-50 and 10^50 have products, up to the fourth power, that float64 can hold."""


def triangles_of(points: Floats, ids: Array, starts: Array | range, sizes: Array) -> Ids:
    """Cut polygons, in their order, into triangles that go round as they do.

    Parameters
    ----------
    points : (3, V) float64
    ids : (n,) integers
        Vertex ids, those of each polygon in a row.
    starts : (P,) integers or range
        Where each begins in `ids`.
    sizes : (P,) integers
        How many corners each has, at least 3.

    Returns
    -------
    (3, T) int32

    Examples
    --------
    A triangle, a kite whose shorter diagonal is 1 3, and a pentagon. All are cut as fans at first; then the two
    triangles 0 1 2, 0 2 3 of the kite become 0 1 3, 1 2 3.

    >>> points = np.array([[0, 3, 9, 3, 0], [0, -1, 0, 1, 5], [0, 0, 0, 0, 0]], dtype=float)
    >>> ids = np.array([2, 3, 4, 0, 1, 2, 3, 0, 1, 2, 3, 4])
    >>> triangles_of(points, ids, np.array([0, 3, 7]), np.array([3, 4, 5])).T.tolist()
    [[2, 3, 4], [0, 1, 3], [1, 2, 3], [0, 1, 2], [0, 2, 3], [0, 3, 4]]
    """
    scale = scale_of(points)
    begins = np.arange(starts.start, starts.stop, starts.step) if isinstance(starts, range) else starts
    counts = np.asarray(sizes).astype(np.intp) - 2
    out = np.empty((3, int(counts.sum())), np.int32)
    done = 0
    for start in range(0, len(counts), CHUNK):
        part = slice(start, start + CHUNK)
        begin, count = begins[part], counts[part]
        ends = np.cumsum(count)
        first = np.repeat(begin, count)
        place = first + np.arange(len(first)) - np.repeat(ends - count, count)
        chunk = out[:, done : done + len(first)]
        chunk[0], chunk[1], chunk[2] = ids[first], ids[place + 1], ids[place + 2]
        quads = np.flatnonzero(count == 2)
        row = ends[quads] - 2
        a, b, c, d = chunk[0, row], chunk[1, row], chunk[2, row], chunk[2, row + 1]
        across = shorter_across(points, a, b, c, d, scale)
        row, b, d = row[across], b[across], d[across]
        chunk[2, row] = d
        chunk[0, row + 1] = b
        done += len(first)
    return out


def shorter_across(points: Floats, a: Ids, b: Ids, c: Ids, d: Ids, scale: float) -> NDArray[np.bool_]:
    """(n,) bool: whether quadrilaterals a b c d are cut along b d, and not along a c."""
    own, other = squared(points, a, c, scale), squared(points, b, d, scale)
    lower: NDArray[np.bool_] = np.minimum(b, d) < np.minimum(a, c)
    across: NDArray[np.bool_] = (other < own) | ((other == own) & lower)
    return across


def squared(points: Floats, one: Ids, other: Ids, scale: float) -> Floats:
    """(n,) float64: squared distances of vertices, in units of 1 / scale; exactly as long from either end."""
    total = np.zeros(len(one))
    for axis in points:
        step = axis[one] * scale - axis[other] * scale
        total += step * step
    return total


def scale_of(points: Floats) -> float:
    """A power of two by which coordinates are multiplied so that their products stay within float64; mostly 1."""
    largest = max((float(np.abs(axis).max(initial=0)) for axis in points), default=0.0)
    if largest == 0 or 10.0**-WITHIN < largest < 10.0**WITHIN:
        return 1.0
    return float(2.0 ** max(-1000, min(1000, -int(np.frexp(largest)[1]))))
