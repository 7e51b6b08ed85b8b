"""The distance of a point to triangles in exact arithmetic, by cases, one pair after the other."""

from __future__ import annotations

from fractions import Fraction
from math import sqrt

import numpy as np

from hexalab.comparison import closest_points, frames_of, squared_distances

Vector = tuple[Fraction, Fraction, Fraction]
EPSILON = 2.0**-52


def exact(point: np.ndarray, corners: np.ndarray) -> Fraction:
    """Squared distance of a point, (3,), to a triangle, (3 corners, 3), without any rounding.

    It is the least of the three to the edges and, where the foot on the plane lies within, of that to the plane.
    """
    p = vector(point)
    a, b, c = map(vector, corners)
    found = [to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)]
    normal = cross(minus(b, a), minus(c, a))
    square = dot(normal, normal)
    if square:
        sides = [dot(normal, cross(minus(e, s), minus(p, s))) for s, e in ((a, b), (b, c), (c, a))]
        if min(sides) >= 0:
            found.append(dot(normal, minus(p, a)) ** 2 / square)
    return min(found)


def to_segment(p: Vector, a: Vector, b: Vector) -> Fraction:
    along = minus(b, a)
    square = dot(along, along)
    share = min(max(dot(minus(p, a), along) / square, Fraction(0)), Fraction(1)) if square else Fraction(0)
    off = minus(p, (a[0] + share * along[0], a[1] + share * along[1], a[2] + share * along[2]))
    return dot(off, off)


def vector(values: np.ndarray) -> Vector:
    x, y, z = map(Fraction, values.tolist())
    return x, y, z


def minus(one: Vector, other: Vector) -> Vector:
    return one[0] - other[0], one[1] - other[1], one[2] - other[2]


def dot(one: Vector, other: Vector) -> Fraction:
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]


def cross(one: Vector, other: Vector) -> Vector:
    (a, b, c), (x, y, z) = one, other
    return b * z - c * y, c * x - a * z, a * y - b * x


def root(square: Fraction) -> float:
    """Of a fraction, however small or large."""
    if not square:
        return 0.0
    shift = (square.numerator.bit_length() - square.denominator.bit_length()) // 2
    return sqrt(square / Fraction(4) ** shift) * 2.0**shift


def distance(point: np.ndarray, corners: np.ndarray) -> float:
    """Of a point, (3,), to a triangle, (3 corners, 3)."""
    return root(exact(point, corners))


def least(point: np.ndarray, corners: np.ndarray, far: float) -> float:
    """Distance of a point to the nearest of triangles, (n, 3 corners, 3); looked at are those whose box is so far."""
    low, high = corners.min(axis=1), corners.max(axis=1)
    boxes = np.linalg.norm(np.maximum(np.maximum(low - point, point - high), 0), axis=1)
    near = np.flatnonzero(boxes <= far * (1 + 1e-9) + rounding(point, corners[boxes.argmin()]))
    return root(min(exact(point, own) for own in corners[near]))


def rounding(point: np.ndarray, corners: np.ndarray) -> float:
    """What differences of coordinates, and products of them, may be wrong by."""
    sizes = [np.abs(point - corner).max() for corner in corners]
    sizes += [np.abs(one - other).max() for one in corners for other in corners]
    return 16 * EPSILON * float(max(sizes))


def measured(points: np.ndarray, corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Distances (n,) and closest points (n, 3) of points (n, 3) and triangles (n, 3 corners, 3)."""
    frames = frames_of(np.ascontiguousarray(corners.transpose(1, 2, 0)))
    squared = squared_distances(points.T, frames)
    assert squared.dtype == np.float64
    return np.sqrt(squared), closest_points(points.T, frames).T


def check(points: np.ndarray, corners: np.ndarray) -> None:
    """Each distance is right up to rounding; the closest point lies on the triangle, and is that far away."""
    for point, own, found, closest in zip(points, corners, *measured(points, corners), strict=True):
        within = rounding(point, own)
        assert abs(found - distance(point, own)) <= within
        within += 4 * EPSILON * float(np.abs(own).max())
        assert distance(closest, own) <= within
        assert abs(np.linalg.norm(point - closest) - found) <= 2 * within
