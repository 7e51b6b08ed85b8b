"""Normals of quads and triangles, and the form in which they go to the graphics card."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from .records import Floats32, Int16s

FLAT = np.float32(1e-13)
"""Squared area over the fourth power of the size: below it float32 says nothing about a direction."""

FULL = np.float32(32767)


def quad_normals(points: Floats32, inner_points: Callable[[NDArray[np.intp]], Array]) -> Floats32:
    """Unit normals of quads a b c d, triangles among them (c = d).

    The normal is the sum of the four crosses of neighbouring sides at the corners, each as long as its
    area; that sum is twice the cross of the diagonals. Where it vanishes, the normal points from inside the
    cell to the face's middle.

    Parameters
    ----------
    points : (3, 4, N) float32
        Axis, corner, face.
    inner_points : callable
        Given indices of faces, (3, n) points inside their cells.

    Returns
    -------
    (3, N) float32
    """
    ax, ay, az = points[:, 2] - points[:, 0]
    bx, by, bz = points[:, 3] - points[:, 1]
    out = np.empty((3, points.shape[2]), np.float32)
    x, y, z = out
    np.subtract(ay * bz, az * by, out=x)
    np.subtract(az * bx, ax * bz, out=y)
    np.subtract(ax * by, ay * bx, out=z)
    square = x * x + y * y + z * z
    size = (ax * ax + ay * ay + az * az) * (bx * bx + by * by + bz * bz)
    size *= FLAT
    flat = np.flatnonzero(~(square > size))
    if len(flat):
        middle = points[:, :, flat].sum(axis=1, dtype=np.float64) / 4
        out[:, flat] = middle - inner_points(flat)
    return unit(out)


def unit(vectors: Floats32) -> Floats32:
    """Scale (3, N) vectors to length 1, in place; one without length becomes 0 0 1."""
    x, y, z = vectors
    length = np.sqrt(x * x + y * y + z * z)
    none = np.flatnonzero(~((length > 0) & (length < np.inf)))
    if len(none):
        vectors[:, none] = np.array([[0], [0], [1]], np.float32)
        length[none] = 1
    vectors /= length
    return vectors


def pack(normals: Floats32) -> Int16s:
    """Unit normals (3, N) as (N, 4) int16, the last number 0: eight bytes for each vertex."""
    out = np.zeros((normals.shape[1], 4), np.int16)
    for axis in range(3):
        scaled = normals[axis] * FULL
        out[:, axis] = np.rint(scaled, out=scaled)
    return out
