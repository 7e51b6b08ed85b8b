"""Verdict's metrics of hexahedra, continued: aspect, shape, Oddy, sizes, distortion, dimension, face angles.

See `hexahedron` for the source and the conventions.
"""

from __future__ import annotations

from math import inf

import numpy as np

from ..arrays import Floats
from .arena import dot
from .block import BITS, TOLERANCE, HexahedronBlock


def max_aspect_frobenius(block: HexahedronBlock, out: Floats) -> None:
    """Largest |A| |A^-1| / 3 over corners, A = (u, v, w), in Frobenius norms.

    inf where a determinant is not above 2.2e-15 of the cubed box diagonal.
    """
    conditions = _conditions(block)
    np.max(conditions, axis=0, out=out)
    out /= 3


def mean_aspect_frobenius(block: HexahedronBlock, out: Floats) -> None:
    """Mean of |A| |A^-1| / 3 over corners; inf where a determinant is not above 2.2e-15 of the cubed diagonal."""
    conditions = _conditions(block)
    np.sum(conditions, axis=0, out=out)
    out /= 24


def _conditions(block: HexahedronBlock) -> Floats:
    """(8, n) |A| |A^-1| at the corners: sqrt of sum of squared edges times sum of squared cross products, over det."""
    if "conditions" in block.known:
        known: Floats = block.known["conditions"]
        return known
    out = block.array("conditions", 8)
    np.multiply(block.adjugate_squares, block.corner_squares, out=out)
    np.sqrt(out, out=out)
    out /= block.determinants
    out[~(block.determinants > TOLERANCE * block.size**3)] = inf
    block.known["conditions"] = out
    return out


def shape(block: HexahedronBlock, out: Floats) -> None:
    """Smallest 3 det^(2/3) / (|u|^2 + |v|^2 + |w|^2) over the corners.

    0 where a determinant is not above 2.2e-15 of the cubed box diagonal. The manual's centre is left out, as VTK does.
    """
    values = block.array("own_8", 8)
    np.multiply(block.roots[:8], block.roots[:8], out=values)
    values /= block.corner_squares
    np.min(values, axis=0, out=out)
    out *= 3
    out[~(block.determinants.min(axis=0) > TOLERANCE * block.size**3)] = 0


def oddy(block: HexahedronBlock, out: Floats) -> None:
    """Largest (|A^T A|^2 - |A|^4 / 3) / det(A)^(4/3) over corners and centre.

    inf where a determinant is not above 2.2e-15 of the cubed box diagonal. In VTK 9.6 that threshold carries the
    file's unit, so that cells of edges below 1.3e-5 have no Oddy, whatever their shape.
    """
    n = block.count
    values, scratch = block.array("own_8", 8), block.array("scratch_8", 8)
    np.multiply(block.dots[0], block.dots[0], out=values)
    for product in block.dots[1:]:
        np.multiply(product, product, out=scratch)
        values += scratch
    values *= 2
    fourth = np.multiply(block.squares, block.squares, out=block.array("fourth", 12))
    for odd in (False, True):
        half = values[4 * odd : 4 * odd + 4].reshape(2, 2, n)
        for i, name in enumerate("uvw"):
            half += block.at_corners(fourth[4 * i : 4 * i + 4], name, odd)
    np.multiply(block.corner_squares, block.corner_squares, out=scratch)
    scratch /= 3
    values -= scratch
    roots = np.multiply(block.roots[:8], block.roots[:8], out=scratch)
    roots *= roots
    values /= roots
    np.max(values, axis=0, out=out)
    np.maximum(out, _centre_oddy(block), out=out)
    np.maximum(out, 0, out=out)
    least = np.minimum(block.determinants.min(axis=0), block.centre_determinant)
    out[~(least > TOLERANCE * block.size**3)] = inf


def _centre_oddy(block: HexahedronBlock) -> Floats:
    axes, squares = block.axes, block.axis_squares
    value, product, scratch = block.array("own_1"), block.array("product_1"), block.array("scratch_1")
    value.fill(0)
    for i, j in ((0, 1), (0, 2), (1, 2)):
        dot(axes[i], axes[j], product, scratch)
        product *= product
        value += product
    value *= 2
    for square in squares:
        np.multiply(square, square, out=scratch)
        value += scratch
    np.sum(squares, axis=0, out=product)
    product *= product
    product /= 3
    value -= product
    np.multiply(block.roots[8], block.roots[8], out=scratch)
    scratch *= scratch
    value /= scratch
    return value


def volume(block: HexahedronBlock, out: Floats) -> None:
    """Signed volume of the trilinear cell."""
    np.copyto(out, block.volume)


def corner_sum(block: HexahedronBlock, out: Floats) -> None:
    """Sum of the corners' determinants, eight times the cell's size: what the size metrics start from."""
    np.sum(block.determinants, axis=0, out=out)


def distortion(block: HexahedronBlock, out: Floats) -> None:
    """Smallest determinant over corners and Gauss points (order 2) / volume, both signed; -inf where the volume is 0.

    An inverted cell of one sign so gets a positive value. The manual leaves open which Gauss points; VTK 9.6 takes
    these, and the corners. It starts at 1e30 when it looks for the smallest Jacobian: not taken over.
    """
    np.min(block.gauss_determinants, axis=0, out=out)
    np.minimum(out, block.determinants.min(axis=0), out=out)
    out /= block.gauss_volume
    out[block.gauss_volume == 0] = -inf


NODES = (
    (0, 1, 2, 3, 4, 5, 6, 7), (1, 2, 3, 0, 5, 6, 7, 4), (2, 3, 0, 1, 6, 7, 4, 5), (3, 0, 1, 2, 7, 4, 5, 6),
    (4, 7, 6, 5, 0, 3, 2, 1), (5, 4, 7, 6, 1, 0, 3, 2), (6, 5, 4, 7, 2, 1, 0, 3), (7, 6, 5, 4, 3, 2, 1, 0),
)  # fmt: skip
"""For each corner, the rotation or reflection of the cell that brings it to the place of corner 0."""


def dimension(block: HexahedronBlock, out: Floats) -> None:
    """Characteristic length |V| / sqrt(2 sum |dV/dx|^2) of the volume V and its gradients by the corners.

    Gradients: D. P. Flanagan, T. Belytschko, "A uniform strain hexahedron ...", IJNME 17 (1981), eq. 79; V is the sum
    of the x coordinates times their gradients. VTK 9.6 takes raw coordinates, so that cells far from the origin lose
    digits; here they are those seen from corner 0. -inf where V and all gradients vanish.
    """
    total, squares, scratch = block.array("own_1"), block.array("product_1"), block.array("scratch_1")
    gradient = block.array("gradient")
    squares.fill(0)
    x = block.seen_from_corner
    for axis in range(3):
        for corner in range(8):
            _volume_gradient(block, (axis + 1) % 3, (axis + 2) % 3, corner, gradient)
            if axis == 0:
                np.multiply(x[0, BITS[corner]], gradient, out=scratch)
                if corner:
                    total += scratch
                else:
                    np.copyto(total, scratch)
            gradient *= gradient
            squares += gradient
    total *= total
    total *= 0.5
    np.divide(total, squares, out=out)
    np.sqrt(out, out=out)
    out[squares == 0] = -inf


def _volume_gradient(block: HexahedronBlock, j: int, k: int, corner: int, out: Floats) -> None:
    """Derivative of the volume by one coordinate of a corner, from coordinates j and k of the others."""
    y, z = ([block.seen_from_corner[axis, BITS[node]] for node in NODES[corner]] for axis in (j, k))
    a, b = block.array("difference_a"), block.array("difference_b")
    opposite = np.subtract(z[1], z[3], out=block.array("difference_c"))
    beside = np.subtract(z[4], z[1], out=block.array("difference_d"))
    across = np.subtract(z[3], z[4], out=block.array("difference_e"))
    np.subtract(z[5], z[2], out=a)
    a -= across
    np.multiply(y[1], a, out=out)
    np.multiply(y[2], opposite, out=a)
    out += a
    np.subtract(z[2], z[7], out=a)
    a -= beside
    a *= y[3]
    out += a
    np.subtract(z[7], z[5], out=b)
    b -= opposite
    b *= y[4]
    out += b
    np.multiply(y[5], beside, out=b)
    out += b
    np.multiply(y[7], across, out=b)
    out += b
    out /= 12
