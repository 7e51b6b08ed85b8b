r"""The distance of points to triangles, pair by pair: exact up to rounding, of slivers and collapsed triangles too.

Each triangle has a frame of its own: the origin at one end of an edge, the base, whose angles are both at most 90
degrees; `u` along the base, `v` across it in the plane, `n` across the plane. In it the triangle is (0, 0),
(length, 0), (x, y) with 0 <= x <= length and y >= 0; a point is (a, b) and its height above the plane.

      b |    (x, y)
        |     /|\
        |    / | \
        |   /  |  \
        +------------ a
     (0, 0)   (length, 0)

Right of the apex all is mirrored. So there are three places for a point, each with a plain answer: beyond the edge on
the left, below the base, or inside. No number of them is a difference that vanishes as the triangle does: a corner of
1e-9 or 0 degrees costs no digits, as it does with barycentric coordinates by Cramer's rule (Ericson, Real-Time
Collision Detection, 5.1.5; Eberly, Distance Between Point and Triangle in 3D).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats

ROUNDING = 2.0**-50
"""Part of a side that the height of a triangle may be by rounding alone."""

SHORTEST = 1e-150
"""Shorter vectors count as none: digits of their squares are lost."""

COLUMNS = 17


class Frames(NamedTuple):
    """Triangles in frames of their own.

    Attributes
    ----------
    rows : (n, 17) float64
        Origin (3), u (3), v (3), n (3), length, x, y, and the inverse squared lengths of the edges on the left and
        on the right of the apex, 0 for an edge without length. One triangle after the other, since WebAssembly
        picks rows at random several times faster than numbers.
    """

    rows: Floats

    @classmethod
    def empty(cls, count: int) -> Frames:
        """Room for so many."""
        return cls(np.empty((count, COLUMNS)))

    def some(self, which: Array) -> Frames:
        """Some of them, in any order."""
        return Frames(self.rows.take(which, axis=0))


def frames_of(corners: Floats) -> Frames:
    """Frames of triangles.

    The base is the edge opposite to an obtuse corner, else the one of middle length: it has no length only where all
    three corners are at one place, and of a right triangle it is the longer leg, so that triangles along the axes have
    frames along the axes, without rounding.

    Parameters
    ----------
    corners : (3, 3, n) float64
        Corner, axis, triangle. Lengths between some 1e-150 and 1e150.
    """
    edges = corners[[2, 0, 1]] - corners[[1, 2, 0]]  # each opposite to the corner of its number
    squares = _dot(edges.transpose(1, 0, 2), edges.transpose(1, 0, 2))
    short, middle, long = np.argsort(squares, axis=0, kind="stable")
    each = np.arange(corners.shape[2])
    obtuse = squares[long, each] > squares[middle, each] + squares[short, each]
    apex = np.where(obtuse, long, middle)
    start, end = (apex + 1) % 3, (apex + 2) % 3
    origin = corners[start, :, each].T
    base = corners[end, :, each].T - origin
    side = corners[apex, :, each].T - origin
    u, length = _unit(base, np.array([[1.0], [0.0], [0.0]]), SHORTEST)
    # Of a sliver the first is across up to rounding over height only; below a few roundings of height, any way will do.
    least = np.maximum(ROUNDING * np.sqrt(_dot(side, side)), SHORTEST)
    v, _ = _unit(_across(side, u), _any_across(u), least)
    v, _ = _unit(_across(v, u), v, 0)
    x = np.clip(_dot(side, u), 0, length)
    y = np.maximum(_dot(side, v), 0)
    left, right = (_inverse(part * part + y * y) for part in (x, length - x))
    columns = *origin, *u, *v, *_cross(u, v), length, x, y, left, right
    return Frames(np.stack(columns, axis=1))


def squared_distances(points: Floats, frames: Frames) -> Floats:
    """(n,) float64 squared distance of each point, (3, n), to its triangle."""
    at = _placed(points, frames)
    along, across, height = at.a, at.b, at.height
    along -= at.s
    across -= at.t
    along *= along
    across *= across
    height *= height
    along += across
    along += height
    return along


def closest_points(points: Floats, frames: Frames) -> Floats:
    """(3, n) float64: of each triangle the point that is closest to its point, (3, n)."""
    at = _placed(points, frames)
    columns = frames.rows.T
    s = np.where(at.mirrored, columns[12] - at.s, at.s)
    return np.asarray(columns[0:3] + (columns[3:6] * s + columns[6:9] * at.t))


class _Places(NamedTuple):
    """In each frame, of which some are mirrored: a point (a, b), its height, the closest point (s, t)."""

    mirrored: NDArray[np.bool_]
    a: Floats
    b: Floats
    height: Floats
    s: Floats
    t: Floats


def _placed(points: Floats, frames: Frames) -> _Places:
    """Find the closest points, each in its frame.

    Triangle (0, 0), (4, 0), (1, 3), points (1, 1) inside, (-1, 3) beyond the left edge, (5, -1) below the base and
    beyond its end, where it is (-1, -1) mirrored: (s, t) are (1, 1), (0.8, 2.4) and (0, 0), mirrored too.
    """
    ox, oy, oz, ux, uy, uz, vx, vy, vz, nx, ny, nz, length, x, y, left, right = frames.rows.T
    px, py, pz = points[0] - ox, points[1] - oy, points[2] - oz
    a = px * ux
    a += py * uy
    a += pz * uz
    b = px * vx
    b += py * vy
    b += pz * vz
    height = px * nx
    height += py * ny
    height += pz * nz
    mirrored = a > x
    a = np.where(mirrored, length - a, a)
    x = np.where(mirrored, length - x, x)
    beyond = x * b > y * a
    share = np.clip((x * a + y * b) * np.where(mirrored, right, left), 0, 1)
    s = np.where(beyond, share * x, np.maximum(a, 0))
    t = np.where(beyond, share * y, np.clip(b, 0, y))
    return _Places(mirrored, a, b, height, s, t)


def _dot(one: Floats, other: Floats) -> Floats:
    return np.asarray(one[0] * other[0] + one[1] * other[1] + one[2] * other[2])


def _cross(one: Floats, other: Floats) -> Floats:
    (a, b, c), (x, y, z) = one, other
    return np.stack([b * z - c * y, c * x - a * z, a * y - b * x])


def _across(vectors: Floats, u: Floats) -> Floats:
    """Their part across unit vectors."""
    return np.asarray(vectors - u * _dot(vectors, u))


def _unit(vectors: Floats, instead: Floats, least: float | Floats) -> tuple[Floats, Floats]:
    """Vectors of length 1, (3, n), and the lengths; others instead of those whose length is not above the least."""
    lengths = np.sqrt(_dot(vectors, vectors))
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(lengths > least, vectors / lengths, instead), lengths


def _inverse(squares: Floats) -> Floats:
    """1 / squares; 0 for those of lengths that count as none."""
    known = squares > SHORTEST * SHORTEST
    return np.where(known, 1 / np.where(known, squares, 1), 0)


def _any_across(u: Floats) -> Floats:
    """(3, n) unit vectors across others: across the axis too that each leans to least."""
    axis = np.zeros_like(u)
    axis[np.abs(u).argmin(axis=0), np.arange(u.shape[1])] = 1
    across = _cross(u, axis)
    return np.asarray(across / np.sqrt(_dot(across, across)))
