"""A block of hexahedra: gathered corners and what the metrics share, each computed once and only when asked for.

Arrays are components first and cells last, so that every operation is a long run over contiguous memory. Corner
triples and edges are kept in an order in which both halves of the eight corners meet every edge exactly once:

========  =====================  =====================  =====================
row       u edges                v edges                w edges
========  =====================  =====================  =====================
0 1 2 3   01, 32, 45, 76         03, 12, 56, 47         04, 26, 15, 37
========  =====================  =====================  =====================

Corners 0, 2, 5, 7 take rows 0 1 2 3 of u, v, w; corners 1, 3, 4, 6 take rows 0 1 2 3 of u, 1 0 3 2 of v and 2 3 0 1
of w. At every corner (u, v, w) is a right-handed triple of a sound cell.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np

from ..mesh import Array, Floats, Ids

BLOCK = 2048
"""Cells computed together: the few megabytes of intermediates stay in cache."""

BITS = (0, 1, 3, 2, 4, 5, 7, 6)
"""Corner at each place 4c + 2b + a, where a, b, c say which end of the u, v, w direction it is at."""

T = TypeVar("T")


def shared(compute: Callable[[Any], T]) -> Any:
    """Make a method a property that is computed once per block."""
    key = compute.__name__

    def get(self: Any) -> T:
        if key not in self.known:
            self.known[key] = compute(self)
        value: T = self.known[key]
        return value

    get.__doc__ = compute.__doc__
    return property(get)


def dot(a: Floats, b: Floats, out: Floats, scratch: Floats) -> Floats:
    """Sum of the products of the components (first axis)."""
    np.multiply(a[0], b[0], out=out)
    np.multiply(a[1], b[1], out=scratch)
    out += scratch
    np.multiply(a[2], b[2], out=scratch)
    out += scratch
    return out


def cross(a: Floats, b: Floats, out: Floats, scratch: Floats) -> Floats:
    """Cross product over the components (first axis)."""
    for axis, (i, j) in enumerate(((1, 2), (2, 0), (0, 1))):
        np.multiply(a[i], b[j], out=out[axis])
        np.multiply(a[j], b[i], out=scratch)
        out[axis] -= scratch
    return out


class Arena:
    """Memory for one block at a time, handed out by name and kept between blocks."""

    def __init__(self, size: int = BLOCK) -> None:
        self.size = size
        self.count = size
        self.known: dict[str, Any] = {}
        self._arrays: dict[str, Array] = {}

    def array(self, name: str, *shape: int, dtype: Any = np.float64) -> Array:
        """Array of `shape` + (cells of the block,), the same memory whenever the name comes again."""
        whole = self._arrays.get(name)
        if whole is None:
            whole = self._arrays[name] = np.empty((*shape, self.size), dtype=dtype)
        return whole if self.count == self.size else whole[..., : self.count]

    def begin(self, count: int) -> None:
        """Forget what was computed, for a block of `count` cells."""
        self.count = count
        self.known.clear()


class HexahedronBlock(Arena):
    """Hexahedra of one block; see the module's description for the order of edges and corners."""

    def load(self, coordinates: Floats, corners: Ids) -> None:
        """Gather the corners (8, n) of the block's cells."""
        self.begin(corners.shape[1])
        points = self.array("points", 3, 8)
        for place, corner in enumerate(BITS):
            for axis in range(3):
                np.take(coordinates[axis], corners[corner], out=points[axis, place], mode="clip")
        self.points = points

    def corner(self, corner: int) -> Floats:
        """(3, n) view of a corner's coordinates."""
        return self.points[:, BITS.index(corner)]

    @shared
    def u(self) -> Floats:
        """(3, 4, n) edges of the first direction."""
        out = self.array("u", 3, 4)
        return np.subtract(self.points[:, 1::2], self.points[:, ::2], out=out)

    @shared
    def v(self) -> Floats:
        """(3, 4, n) edges of the second direction."""
        out, points = self.array("v", 3, 4), self.points
        np.subtract(points[:, 2:4], points[:, 0:2], out=out[:, :2])
        np.subtract(points[:, 7:5:-1], points[:, 5:3:-1], out=out[:, 2:])
        return out

    @shared
    def w(self) -> Floats:
        """(3, 4, n) edges of the third direction."""
        out, points = self.array("w", 3, 4), self.points
        np.subtract(points[:, 4::3], points[:, 0:4:3], out=out[:, :2])
        np.subtract(points[:, 5:7], points[:, 1:3], out=out[:, 2:])
        return out

    @property
    def odd(self) -> tuple[Floats, Floats, Floats]:
        """(3, 2, 2, n) views of u, v, w as corners 1, 3, 4, 6 take them."""
        u, v, w = (edges.reshape(3, 2, 2, self.count) for edges in (self.u, self.v, self.w))
        return u, v[:, :, ::-1], w[:, ::-1]

    @shared
    def determinants(self) -> Floats:
        """(8, n) u.(v x w) at corners 0, 2, 5, 7, 1, 3, 4, 6."""
        out = self.array("determinants", 8)
        product, scratch = self.array("product", 3, 4), self.array("scratch", 4)
        cross(self.v, self.w, product, scratch)
        dot(self.u, product, out[:4], scratch)
        u, v, w = self.odd
        product, scratch = product.reshape(3, 2, 2, self.count), scratch.reshape(2, 2, self.count)
        cross(u, w, product, scratch)
        dot(v, product, out[4:].reshape(2, 2, self.count), scratch)
        np.negative(out[4:], out=out[4:])
        return out

    @shared
    def squares(self) -> tuple[Floats, Floats, Floats]:
        """Squared lengths of the u, v, w edges, (4, n) each."""
        scratch = self.array("scratch", 4)
        out = self.array("squares", 12)
        return (
            dot(self.u, self.u, out[:4], scratch),
            dot(self.v, self.v, out[4:8], scratch),
            dot(self.w, self.w, out[8:], scratch),
        )

    @shared
    def shortest_square(self) -> Floats:
        """(n,) squared length of the shortest edge."""
        u, v, w = self.squares
        out = self.array("shortest_square")
        np.min(u, axis=0, out=out)
        for rows in (v, w):
            np.minimum(out, rows.min(axis=0), out=out)
        return out

    @shared
    def centre_determinant(self) -> Floats:
        """(n,) X.(Y x Z): 64 times the Jacobian at the centre."""
        x, y, z = self.axes
        product, scratch = self.array("axes_product", 3), self.array("scratch_1")
        cross(y, z, product, scratch)
        return dot(x, product, self.array("centre_determinant"), scratch)

    @shared
    def axis_squares(self) -> Floats:
        """(3, n) squared lengths of X, Y, Z."""
        out, scratch = self.array("axis_squares", 3), self.array("scratch_1")
        for axis, square in zip(self.axes, out, strict=True):
            dot(axis, axis, square, scratch)
        return out

    @shared
    def axes(self) -> tuple[Floats, Floats, Floats]:
        """Principal axes X, Y, Z, (3, n) each, summed from the corners in Verdict's order (rounding is then the same)."""
        out = self.array("axes", 3, 3)
        for axis, ends in zip(out, ((1, 2, 5, 6), (2, 3, 6, 7), (4, 5, 6, 7)), strict=True):
            np.add(self.corner(ends[0]), self.corner(ends[1]), out=axis)
            axis += self.corner(ends[2])
            axis += self.corner(ends[3])
            for corner in range(8):
                if corner not in ends:
                    axis -= self.corner(corner)
        return out[0], out[1], out[2]
