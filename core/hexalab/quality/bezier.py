"""The Jacobian determinant of the trilinear hexahedron in Bezier form: coefficients, bounds, subdivision.

The determinant of the map from the unit cube is a polynomial of degree 2 in each variable that lacks every monomial
with two squares: 20 dimensions, so that its values at the 8 corners and 12 edge middles fix its 27 Bezier coefficients
(A. Johnen, J.-C. Weill, J.-F. Remacle, "Robust and efficient validation of the linear hexahedral element", 2017). The
missing monomials say that on each square of 3 x 3 coefficients the second difference in both directions vanishes: the
middle one is half the sum of the edges' middles minus a quarter of the sum of the corners.

Arrays have the axes w, v, u first (0, 1, 2 along each), cells last.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Floats, Ids
from .arena import Arena, cross, dot

DEGREES = (slice(None, None, 2), 1)
"""Index of the ends and of the middle of three Bezier coefficients."""


class BezierBlock(Arena):
    """Hexahedra of one block: gathered corners, edges, Bezier coefficients, bound of the rounding errors."""

    def load(self, coordinates: Floats, corners: Ids) -> None:
        """Gather the corners (8, n) of the block's cells."""
        self.begin(corners.shape[1])
        points = self.array("points", 3, 2, 2, 2)
        for corner, place in enumerate(((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0))):
            for high in (0, 1):
                for axis in range(3):
                    target = points[(axis, high, *place[1:])]
                    np.take(coordinates[axis], corners[corner + 4 * high], out=target, mode="clip")
        self.u = np.subtract(points[:, :, :, 1], points[:, :, :, 0], out=self.array("u", 3, 2, 2))
        self.v = np.subtract(points[:, :, 1], points[:, :, 0], out=self.array("v", 3, 2, 2))
        self.w = np.subtract(points[:, 1], points[:, 0], out=self.array("w", 3, 2, 2))

    def magnitude(self) -> Floats:
        """(n,) bound of the products that make up a determinant: six times it bounds any determinant.

        The smaller of the product of the largest components of u, of v and of w edges, and the product of the largest
        x, y and z components of all: cells that are flat along an axis would drown in the first.
        """
        most, absolute = self.array("most", 3, 3), self.array("absolute", 3, 2, 2)
        for place, edges in enumerate((self.u, self.v, self.w)):
            np.abs(edges, out=absolute)
            np.max(absolute, axis=(1, 2), out=most[place])
        by_direction, by_axis = most.max(axis=1), most.max(axis=0)
        out = self.array("magnitude")
        np.multiply(by_direction[0], by_direction[1], out=out)
        out *= by_direction[2]
        other = by_axis[0] * by_axis[1]
        other *= by_axis[2]
        np.minimum(out, other, out=out)
        return out

    def corners(self) -> Floats:
        """(2, 2, 2, n) determinants at the corners."""
        out = self.array("corners", 2, 2, 2)
        product, scratch = self.array("product_8", 3, 2, 2, 2), self.array("scratch_8", 2, 2, 2)
        cross(self.v[:, :, None], self.w[:, None], product, scratch)
        return dot(self.u[:, :, :, None], product, out, scratch)

    def coefficients(self, corners: Floats) -> Floats:
        """(3, 3, 3, n) Bezier coefficients from the corners' determinants and the edge middles."""
        out = self.array("coefficients", 3, 3, 3)
        ends, middle = DEGREES
        out[ends, ends, ends] = corners
        u, v, w = self.u, self.v, self.w
        product, scratch = self.array("product_4", 3, 2, 2), self.array("scratch_4", 2, 2)
        value = self.array("value", 2, 2)
        for axis, fixed, first, second, place in (
            (2, u, self._sum("v", 2)[:, :, None], self._sum("w", 2)[:, None], (ends, ends, middle)),
            (1, v, self._sum("w", 1)[:, None], self._sum("u", 2)[:, :, None], (ends, middle, ends)),
            (0, w, self._sum("u", 1)[:, :, None], self._sum("v", 1)[:, None], (middle, ends, ends)),
        ):
            cross(first, second, product, scratch)
            dot(fixed, product, value, scratch)
            for end in (0, 1):
                value -= corners[(slice(None),) * axis + (end,)]
            np.multiply(value, 0.5, out=out[place])
        fill_middles(out, exact=False)
        return out

    def _sum(self, name: str, axis: int) -> Floats:
        """(3, 2, n) sums of the u, v or w edges over the first or the second of the directions they differ in."""
        edges: Floats = getattr(self, name)
        first, second = (edges[(slice(None),) * axis + (end,)] for end in (0, 1))
        out: Floats = np.add(first, second, out=self.array(f"sum_{name}_{axis}", 3, 2))
        return out


def fill_middles(coefficients: Array, exact: bool) -> None:
    """Fill the six face middles and the centre from corners and edge middles, in place.

    Parameters
    ----------
    coefficients : (3, 3, 3, n) array
    exact : bool
        Whether they are integers (multiples of eight, so that the divisions leave no rest).
    """
    ends, middle = DEGREES
    for axis in range(3):
        square = np.moveaxis(coefficients, axis, 0)[ends]
        square[:, 1, 1] = _middle(square, exact)
    coefficients[1, 1, 1] = _middle(coefficients[middle], exact)


def _middle(square: Array, exact: bool) -> Array:
    """Middle of (..., 3, 3, n) coefficients whose mixed second difference vanishes: edges / 2 - corners / 4."""
    out = square[..., 0, 1, :] + square[..., 2, 1, :]
    out += square[..., 1, 0, :]
    out += square[..., 1, 2, :]
    out *= 2
    for i in (0, 2):
        for j in (0, 2):
            out -= square[..., i, j, :]
    if exact:
        out //= 4
    else:
        out *= 0.25
    return np.asarray(out)


def halves(coefficients: Array, axis: int, exact: bool) -> tuple[Array, Array]:
    """Bezier coefficients on both halves of an interval, by de Casteljau's algorithm.

    Parameters
    ----------
    coefficients : (3, 3, 3, n) array
    axis : int
        Which of the first three axes to halve.
    exact : bool
        Multiply by four instead of dividing, so that integers stay integers.
    """
    b = np.moveaxis(coefficients, axis, 0)
    left, right = np.empty_like(b), np.empty_like(b)
    one, two, four = (4, 2, 1) if exact else (1.0, 0.5, 0.25)
    left[0], right[2] = b[0] * one, b[2] * one
    left[1], right[1] = (b[0] + b[1]) * two, (b[1] + b[2]) * two
    left[2] = right[0] = (b[0] + 2 * b[1] + b[2]) * four
    return np.moveaxis(left, 0, axis), np.moveaxis(right, 0, axis)


def octants(coefficients: Array, exact: bool) -> Array:
    """(3, 3, 3, 8 n) coefficients on the eight halves of halves of halves, octant by octant."""
    boxes = [coefficients]
    for axis in range(3):
        boxes = [half for box in boxes for half in halves(box, axis, exact)]
    return np.concatenate(boxes, axis=-1)
