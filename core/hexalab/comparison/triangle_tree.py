"""Triangles as a tree of boxes.

They are sorted along a curve that keeps neighbours together. Eight in a row share a box, eight boxes in a row the next
one, up to a single one. So no links are kept: the children of box i are 8 i to 8 i + 7.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Floats, Ids
from .curve import curve_order
from .triangle_distance import Frames, frames_of

WIDTH = 8
"""Children of a box."""

FARTHEST = 1e150
"""Coordinates beyond, whose squares pass what float64 can hold, count as unknown."""


class Level(NamedTuple):
    """The children of the boxes of one level, eight to a row; those beyond the last are infinitely far.

    Attributes
    ----------
    low, high : (3, n, 8) float64
    spots : (3, n, 8) float64
        A point of one of the triangles within.
    """

    low: Floats
    high: Floats
    spots: Floats


class TriangleTree(NamedTuple):
    """Triangles in the order of a curve, and the boxes around them.

    Attributes
    ----------
    levels : tuple of Level
        The first one's children are the triangles, the last one has a single box.
    frames : Frames
    numbers : (n,) int32
        What each triangle's number was before they were sorted.
    places : (T,) int32
        Where each triangle is now; -1 for those left out.
    size : float
        A coordinate as most have it, without its sign.
    """

    levels: tuple[Level, ...]
    frames: Frames
    numbers: Ids
    places: Ids
    size: float


def tree_of(points: Floats, triangles: Ids) -> TriangleTree:
    """Sort triangles into boxes.

    Parameters
    ----------
    points : (3, V) float64
    triangles : (3, T) int32
        Those with a corner that is not finite are left out.
    """
    whole = np.flatnonzero(within_reach(points)[triangles].all(axis=0))
    corners = triangles[:, whole]
    middles = (points[:, corners[0]] + points[:, corners[1]] + points[:, corners[2]]) / 3
    order = curve_order(middles)
    corners, middles = corners[:, order], middles[:, order]
    count = len(order)
    numbers = whole[order].astype(np.int32)
    places = np.full(triangles.shape[1], -1, np.int32)
    places[numbers] = np.arange(count)
    frames = Frames.empty(count)
    low, high = np.empty((3, count)), np.empty((3, count))
    for start in range(0, count, CHUNK):
        part = slice(start, start + CHUNK)
        own = points[:, corners[:, part]]
        frames.rows[part] = frames_of(own.transpose(1, 0, 2)).rows
        low[:, part], high[:, part] = own.min(axis=1), own.max(axis=1)
    sizes = np.abs(middles).max(axis=0)
    size = float(np.partition(sizes, count // 2)[count // 2]) if count else 0.0  # a median
    return TriangleTree(_levels(low, high, middles), frames, numbers, places, size)


def _levels(low: Floats, high: Floats, spots: Floats) -> tuple[Level, ...]:
    """From the triangles up to a single box. The spot of a box is its first child's: another is no better."""
    levels = []
    while low.shape[1] > 0:
        level = Level(_in_rows(low, np.inf), _in_rows(high, -np.inf), _in_rows(spots, np.inf))
        levels.append(level)
        if level.low.shape[1] == 1:
            break
        low, high = level.low.min(axis=2), level.high.max(axis=2)
        spots = level.spots[:, :, 0]
    return tuple(levels)


def _in_rows(values: Floats, beyond: float) -> Floats:
    """(3, n) values as (3, rows, 8), the last row filled up."""
    rows = -(-values.shape[1] // WIDTH)
    out = np.full((3, rows * WIDTH), beyond)
    out[:, : values.shape[1]] = values
    return out.reshape(3, rows, WIDTH)


def within_reach(coordinates: Floats) -> NDArray[np.bool_]:
    """(n,) whether all of (k, n) coordinates are numbers to compute with."""
    return np.asarray((np.abs(coordinates) < FARTHEST).all(axis=0))
