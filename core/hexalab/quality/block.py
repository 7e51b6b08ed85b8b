"""A block of hexahedra: gathered corners and what the metrics share, each computed at most once.

Arrays are components first and cells last, so that every operation is a long run over contiguous memory.
Edges are kept in an order in which each half of the eight corners meets every edge exactly once:

=======  =====================
 edges   rows 0, 1, 2, 3
=======  =====================
   u     01, 32, 45, 76
   v     03, 12, 56, 47
   w     04, 26, 15, 37
=======  =====================

Corners 0, 2, 5, 7 ("even") take rows 0 1 2 3 of u, v and w; corners 1, 3, 4, 6 ("odd") take rows 0 1 2 3 of u,
1 0 3 2 of v and 2 3 0 1 of w. At every corner (u, v, w) is a right-handed triple of a sound cell. Arrays over
corners have the even four first.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Floats, Ids
from .arena import Arena, cross, dot, shared
from .cube_root import cube_root

BITS = (0, 1, 3, 2, 4, 5, 7, 6)
"""Corner at place 4c + 2b + a, where a, b, c say which end of the u, v, w direction it is at; its own inverse."""

TOLERANCE = 10 * float(np.finfo(np.float64).eps)
"""Verdict's threshold, found by bisection: relative to the diagonal of the cell's box, its square or its cube."""

EDGE_ORDER = ((0, 1, 2, 3), (0, 1, 3, 2), (0, 2, 1, 3))
"""Rows of u, v, w in the order of Verdict's manual."""

QUADS = ((3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
"""The faces with Verdict's first corner, which matters to rounding, and where the last two corners coincide."""

DIAGONALS = ((0, 6), (1, 7), (2, 4), (3, 5))

INNER, OUTER, BOTH = (
    (slice(None), slice(None, None, -1)),
    (slice(None, None, -1),),
    (slice(None, None, -1),) * 2,
)
"""Index of the (2, 2) rows of edges that swaps 0 1 2 3 to 1 0 3 2, to 2 3 0 1, to 3 2 1 0."""

U_FLIPS, V_FLIPS, W_FLIPS = (OUTER, INNER), (BOTH, INNER), (BOTH, OUTER)
"""Which swaps lead from an edge to its two neighbours of the same direction."""


def triple_products(u: Floats, v: Floats, w: Floats, out: Floats, product: Floats, scratch: Floats) -> Floats:
    """Determinants (u, v, w) at the eight meetings of four edges in each direction.

    Parameters
    ----------
    u, v, w : (3, 4, n)
        Edges in the block's order.
    out : (8, n)
        Receives the even corners' determinants, then the odd ones'. Both come out as Verdict rounds them.
    product, scratch : (3, 4, n), (4, n)
    """
    n = out.shape[-1]
    dot(u, cross(v, w, product, scratch), out[:4], scratch)
    product, scratch, odd = product.reshape(3, 2, 2, n), scratch.reshape(2, 2, n), out[4:].reshape(2, 2, n)
    u, v, w = (edges.reshape(3, 2, 2, n) for edges in (u, v, w))
    v, w = v[:, :, ::-1], w[:, ::-1]
    dot(v, cross(w, u, product, scratch), odd, scratch)
    return out


class HexahedronBlock(Arena):
    """Hexahedra of one block; see the module's description for the order of edges and corners."""

    points: Floats
    """(3, 8, n) coordinates of the corners, in the order of `BITS`."""

    def load(self, coordinates: Floats, corners: Ids) -> None:
        """Gather the corners (8, n) of the block's cells."""
        self.begin(corners.shape[1])
        self.points = self.array("points", 3, 8)
        for place, corner in enumerate(BITS):
            for axis in range(3):
                np.take(coordinates[axis], corners[corner], out=self.points[axis, place], mode="clip")

    def corner(self, corner: int) -> Floats:
        """(3, n) view of a corner's coordinates."""
        return self.points[:, BITS[corner]]

    @shared
    def seen_from_corner(self) -> Floats:
        """(3, 8, n) the points less corner 0, in the order of `BITS`."""
        return np.subtract(self.points, self.points[:, :1], out=self.array("seen_from_corner", 3, 8))

    @shared
    def u(self) -> Floats:
        """(3, 4, n) edges of the first direction."""
        out = self.array("u", 3, 4)
        np.subtract(self.points[:, 1::2], self.points[:, ::2], out=out)
        return out

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

    def at_corners(self, edges: Floats, direction: str, odd: bool) -> Floats:
        """(..., 2, 2, n) view of u, v or w edges as the even or the odd corners take them."""
        rows = edges.reshape(*edges.shape[:-2], 2, 2, self.count)
        if not odd or direction == "u":
            return rows
        return rows[..., ::-1, :] if direction == "v" else rows[..., ::-1, :, :]

    @shared
    def determinants(self) -> Floats:
        """(8, n) u.(v x w) at the corners."""
        out = self.array("determinants", 8)
        product, scratch = self.array("product", 3, 4), self.array("scratch_4", 4)
        return triple_products(self.u, self.v, self.w, out, product, scratch)

    @shared
    def squares(self) -> Floats:
        """(12, n) squared lengths of the u, then v, then w edges."""
        out, scratch = self.array("squares", 12), self.array("scratch_4", 4)
        for place, edges in enumerate((self.u, self.v, self.w)):
            dot(edges, edges, out[4 * place : 4 * place + 4], scratch)
        return out

    @shared
    def lengths(self) -> Floats:
        """(12, n) lengths of the u, then v, then w edges."""
        return np.asarray(np.sqrt(self.squares, out=self.array("lengths", 12)))

    @shared
    def corner_squares(self) -> Floats:
        """(8, n) |u|^2 + |v|^2 + |w|^2 at the corners."""
        out, n = self.array("corner_squares", 8), self.count
        u, v, w = (self.squares[i : i + 4] for i in (0, 4, 8))
        for odd, half in enumerate((out[:4].reshape(2, 2, n), out[4:].reshape(2, 2, n))):
            np.add(self.at_corners(u, "u", bool(odd)), self.at_corners(v, "v", bool(odd)), out=half)
            half += self.at_corners(w, "w", bool(odd))
        return out

    @shared
    def roots(self) -> Floats:
        """(9, n) cube roots of the corners' determinants and of the centre's X.(Y x Z)."""
        out = self.array("roots", 9)
        cube_root(self.determinants, out=out[:8])
        cube_root(self.centre_determinant, out=out[8])
        return out

    @shared
    def dots(self) -> Floats:
        """(3, 8, n) u.v, v.w and w.u at the corners."""
        out, n = self.array("dots", 3, 8), self.count
        scratch = self.array("scratch_4", 4).reshape(2, 2, n)
        for odd in (False, True):
            rows = out[:, 4 * odd : 4 * odd + 4].reshape(3, 2, 2, n)
            u, v, w = (self.at_corners(getattr(self, name), name, odd) for name in "uvw")
            for product, (a, b) in zip(rows, ((u, v), (v, w), (w, u)), strict=True):
                dot(a, b, product, scratch)
        return out

    @shared
    def crosses(self) -> Floats:
        """(3, 3, 8, n) u x v, v x w and w x u at the corners (component second)."""
        out, n = self.array("crosses", 3, 3, 8), self.count
        scratch = self.array("scratch_4", 4).reshape(2, 2, n)
        for odd in (False, True):
            rows = out[:, :, 4 * odd : 4 * odd + 4].reshape(3, 3, 2, 2, n)
            u, v, w = (self.at_corners(getattr(self, name), name, odd) for name in "uvw")
            for product, (a, b) in zip(rows, ((u, v), (v, w), (w, u)), strict=True):
                cross(a, b, product, scratch)
        return out

    @shared
    def adjugate_squares(self) -> Floats:
        """(8, n) |u x v|^2 + |v x w|^2 + |w x u|^2 at the corners."""
        out, scratch = self.array("adjugate_squares", 8), self.array("scratch_8", 8)
        for kind in range(3):
            for component in range(3):
                side = self.crosses[kind, component]
                if kind or component:
                    np.multiply(side, side, out=scratch)
                    out += scratch
                else:
                    np.multiply(side, side, out=out)
        return out

    @shared
    def axes(self) -> tuple[Floats, Floats, Floats]:
        """Principal axes X, Y, Z, (3, n) each: the sums of the edges, added up in the manual's order."""
        out = self.array("axes", 3, 3)
        for axis, edges, (a, b, c, d) in zip(out, (self.u, self.v, self.w), EDGE_ORDER, strict=True):
            np.add(edges[:, a], edges[:, b], out=axis)
            axis += edges[:, c]
            axis += edges[:, d]
        return out[0], out[1], out[2]

    @shared
    def axis_squares(self) -> Floats:
        """(3, n) squared lengths of X, Y, Z."""
        out, scratch = self.array("axis_squares", 3), self.array("scratch_1")
        for axis, square in zip(self.axes, out, strict=True):
            dot(axis, axis, square, scratch)
        return out

    @shared
    def axis_lengths(self) -> Floats:
        """(3, n) lengths of X, Y, Z."""
        return np.asarray(np.sqrt(self.axis_squares, out=self.array("axis_lengths", 3)))

    @shared
    def centre_determinant(self) -> Floats:
        """(n,) X.(Y x Z): 64 times the Jacobian at the centre."""
        x, y, z = self.axes
        product, scratch = self.array("axes_product", 3), self.array("scratch_1")
        return dot(x, cross(y, z, product, scratch), self.array("centre_determinant"), scratch)

    @shared
    def diagonals(self) -> Floats:
        """(2, n) shortest and longest of the four space diagonals."""
        out, square, scratch = self.array("diagonals", 2), self.array("square_1"), self.array("scratch_1")
        span = self.array("span", 3)
        for place, (a, b) in enumerate(DIAGONALS):
            np.subtract(self.corner(a), self.corner(b), out=span)
            dot(span, span, square, scratch)
            if place:
                np.minimum(out[0], square, out=out[0])
                np.maximum(out[1], square, out=out[1])
            else:
                out[:] = square
        return np.asarray(np.sqrt(out, out=out))

    @shared
    def size(self) -> Floats:
        """(n,) diagonal of the cell's axis-parallel box; 1 where it is a point."""
        low, high = self.array("box_low", 3), self.array("box_high", 3)
        np.min(self.points, axis=1, out=low)
        np.max(self.points, axis=1, out=high)
        high -= low
        out = dot(high, high, self.array("size"), self.array("scratch_1"))
        np.sqrt(out, out=out)
        out[out == 0] = 1
        return out

    @shared
    def gauss_determinants(self) -> Floats:
        """(8, n) determinants at the eight Gauss points (order 2) of edges interpolated there."""
        near, far = (1 + 1 / np.sqrt(3)) / 2, (1 - 1 / np.sqrt(3)) / 2
        edges = []
        for name, flips in (("u", U_FLIPS), ("v", V_FLIPS), ("w", W_FLIPS)):
            rows: Floats = getattr(self, name).reshape(3, 2, 2, self.count)
            for step, flip in enumerate(flips):
                mixed: Floats = self.array(f"gauss_{name}{step}", 3, 4).reshape(3, 2, 2, self.count)
                other = self.array("product", 3, 4).reshape(3, 2, 2, self.count)
                np.multiply(rows, near, out=mixed)
                np.multiply(rows[(slice(None), *flip)], far, out=other)
                mixed += other
                rows = mixed
            edges.append(rows.reshape(3, 4, self.count))
        u, v, w = edges
        product, scratch = self.array("product", 3, 4), self.array("scratch_4", 4)
        return triple_products(u, v, w, self.array("gauss_determinants", 8), product, scratch)

    @shared
    def gauss_volume(self) -> Floats:
        """(n,) signed volume of the trilinear cell, the mean of the determinants at the Gauss points."""
        out = self.array("gauss_volume")
        np.sum(self.gauss_determinants, axis=0, out=out)
        out /= 8
        return out

    @shared
    def volume(self) -> Floats:
        """(n,) signed volume of the trilinear cell, from the faces' centres and area vectors.

        Verdict cuts the cell into 24 tetrahedra by the centres of its faces. The four tetrahedra of a face add up to a
        third of the product of its centre with its area vector, half the cross product of its diagonals. Centres are
        seen from corner 0, so that they don't round far from the origin.
        """
        out, product, scratch = self.array("volume"), self.array("product_1"), self.array("scratch_1")
        middle, centre, points = self.array("middle", 3), self.array("face_centre", 3), self.seen_from_corner
        first, second, area = self.array("first", 3), self.array("second", 3), self.array("area", 3)
        np.multiply(points[:, BITS[6]], 0.5, out=middle)
        out.fill(0)
        for a, b, c, d in QUADS:
            np.add(points[:, BITS[a]], points[:, BITS[b]], out=centre)
            centre += points[:, BITS[c]]
            centre += points[:, BITS[d]]
            centre *= 0.25
            centre -= middle
            np.subtract(self.corner(c), self.corner(a), out=first)
            np.subtract(self.corner(d), self.corner(b), out=second)
            out += dot(centre, cross(first, second, area, scratch), product, scratch)
        out /= 6
        return out
