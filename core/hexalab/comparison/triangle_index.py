"""The nearest of many triangles to each of many points, exactly.

Points go down a tree of boxes together, as pairs of a point and a box. Each box knows a spot on one of its triangles;
the nearest spot seen so far limits how far the nearest triangle can be, and boxes beyond the limit are left out. Near a
surface of 100,000 triangles, some 200 boxes and less than ten triangles are looked at for each point.

Every eighth point along a curve goes first; what these have found limits the others from the start.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array, Floats, Ids
from .curve import curve_order
from .triangle_distance import closest_points, squared_distances
from .triangle_tree import WIDTH, Level, TriangleTree, tree_of, within_reach

STRIDE = 8
"""Each so-manieth point is a sample that goes first."""

PIECE = 8192
"""Pairs of a point and a box that go down at once."""

ROUNDING = 2.0**-48
"""Part of the sizes involved that distances may be wrong by: what is so little beyond the limit is looked at too."""

NO_NUMBER = np.int32(2**31 - 1)


class Nearest(NamedTuple):
    """The nearest triangle to each query.

    Attributes
    ----------
    distance : (n,) float64
        NaN for a query without finite coordinates, and where there is no triangle.
    triangle : (n,) int32
        Its number; of several equally far the smallest. -1 where there is none.
    closest : (3, n) float64
        The point of the triangle that is closest to the query; NaN where there is none.
    """

    distance: Floats
    triangle: Ids
    closest: Floats


class TriangleIndex:
    """Triangles, put in order so that the nearest to a point is found without looking at all.

    Parameters
    ----------
    points : (3, V) float64
    triangles : (3, T) int32
        Vertices of each triangle. It may be degenerate: with collinear corners it is a segment, with equal ones a
        point. One with a coordinate that is not finite, or beyond 1e150, is never the nearest.
    """

    def __init__(self, points: Floats, triangles: Ids) -> None:
        self._tree = tree_of(points, triangles)

    def nearest(self, queries: Floats) -> Nearest:
        """Find the nearest triangle to each query, its distance and its closest point.

        The answer is exact up to rounding: the one of computing the distance to all triangles.

        Parameters
        ----------
        queries : (3, n) float64
        """
        tree, count = self._tree, queries.shape[1]
        distance, closest = np.full(count, np.nan), np.full((3, count), np.nan)
        triangle = np.full(count, -1, np.int32)
        there = np.flatnonzero(within_reach(queries))
        if len(there) and len(tree.numbers):
            order = there[curve_order(queries[:, there])]
            search = _Search(tree, queries[:, order])
            search.run()
            distance[order] = np.sqrt(search.squared)
            triangle[order] = search.number
            for start in range(0, len(order), CHUNK):
                some = order[start : start + CHUNK]
                frames = tree.frames.some(tree.places[triangle[some]])
                closest[:, some] = closest_points(queries[:, some], frames)
        return Nearest(distance, triangle, closest)


class _Search:
    """What is known of each query: the nearest triangle so far, and a square beyond which none needs be looked at."""

    def __init__(self, tree: TriangleTree, queries: Floats) -> None:
        self.tree, self.queries = tree, queries
        count = queries.shape[1]
        self.squared = np.full(count, np.inf)
        self.number = np.full(count, NO_NUMBER)
        self.limit = np.full(count, np.inf)
        self.slack = (np.abs(queries).max(axis=0) + tree.size) * ROUNDING

    def run(self) -> None:
        """Samples first; then the others, which start with what the samples before and after them have found."""
        every = np.arange(len(self.squared))
        samples, others = every[::STRIDE], every[every % STRIDE > 0]
        self.go_down(samples)
        before = others - others % STRIDE
        for near in (before, np.minimum(before + STRIDE, samples[-1])):
            rows = self.tree.places[self.number[near]]
            for start in range(0, len(others), PIECE):
                self.measure(others[start : start + PIECE], rows[start : start + PIECE])
        self.go_down(others)

    def go_down(self, queries: Array) -> None:
        """Find the nearest triangles to some queries.

        What is to be looked at waits in pieces, and the last goes first: so memory is bounded, however many triangles
        have to be looked at. At the centre of a sphere it is all of them.
        """
        top = len(self.tree.levels) - 1
        for start in range(0, len(queries), PIECE):
            some = queries[start : start + PIECE]
            waiting: list[tuple[int, Array, Array]] = [(top, some, np.zeros(len(some), np.intp))]
            while waiting:
                level, who, nodes = waiting.pop()
                if level < 0:
                    self.measure(who, nodes)
                    continue
                who, nodes = self._children(self.tree.levels[level], who, nodes)
                for first in range(0, len(who), PIECE):
                    piece = slice(first, first + PIECE)
                    waiting.append((level - 1, who[piece], nodes[piece]))

    def _children(self, level: Level, who: Array, nodes: Array) -> tuple[Array, Array]:
        """Pairs of queries and those children of their nodes that are within the limit.

        Pairs (4, 0), (4, 2), (9, 1) have children 0 to 7, 16 to 23, 8 to 15; of the flat list of these 24, places 3,
        8 and 20 may be left, which are the pairs (4, 3), (4, 16), (9, 12).
        """
        squared, to_spots = self._distances(level, who, nodes)
        starts = _starts(who)
        self._narrow(who[starts], np.minimum.reduceat(to_spots.reshape(-1), starts * WIDTH))
        left = np.flatnonzero(squared <= self.limit[who][:, None])
        rows = left // WIDTH
        children = nodes[rows]
        children *= WIDTH
        children += left % WIDTH
        return who[rows], children

    def _distances(self, level: Level, who: Array, nodes: Array) -> tuple[Floats, Floats]:
        """(m, 8) squared distances to the boxes of a node's children, and to the spots in them."""
        to_boxes = np.zeros((len(who), WIDTH))
        to_spots = np.zeros((len(who), WIDTH))
        for axis in range(3):
            at = self.queries[axis][who].repeat(WIDTH).reshape(-1, WIDTH)
            outside = level.low[axis].take(nodes, axis=0)
            outside -= at
            above = level.high[axis].take(nodes, axis=0)
            np.subtract(at, above, out=above)
            np.maximum(outside, above, out=outside)
            np.maximum(outside, 0, out=outside)
            outside *= outside
            to_boxes += outside
            off = level.spots[axis].take(nodes, axis=0)
            off -= at
            off *= off
            to_spots += off
        return to_boxes, to_spots

    def measure(self, who: Array, rows: Array) -> None:
        """Take pairs of a query and a triangle into account; those of one query stand together.

        Of queries 4, 4, 4, 9 with squares 3, 2, 2, 7 the runs start at 0 and 3, the least are 2 and 7, repeated 2, 2,
        2, 7; where a square is the least the triangle's number is looked at.
        """
        squared = squared_distances(self.queries[:, who], self.tree.frames.some(rows))
        starts = _starts(who)
        least = np.minimum.reduceat(squared, starts)
        of_pairs = least.repeat(np.diff(starts, append=len(who)))
        number = np.minimum.reduceat(
            np.where(squared == of_pairs, self.tree.numbers[rows], NO_NUMBER), starts
        )
        who = who[starts]
        before = self.squared[who]
        better = (least < before) | ((least == before) & (number < self.number[who]))
        found = who[better]
        self.squared[found], self.number[found] = least[better], number[better]
        self._narrow(found, least[better])

    def _narrow(self, who: Array, squared: Floats) -> None:
        """Something is that near to each of some queries; the limit is a little more than that."""
        reach = np.sqrt(squared) * (1 + ROUNDING)
        reach += self.slack[who]
        reach *= reach
        self.limit[who] = np.minimum(self.limit[who], reach)


def _starts(who: Array) -> NDArray[np.intp]:
    """Where runs of equal numbers start."""
    new = np.empty(len(who), dtype=bool)
    new[0] = True
    np.not_equal(who[1:], who[:-1], out=new[1:])
    return np.flatnonzero(new)
