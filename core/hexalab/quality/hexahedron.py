"""Verdict's metrics of hexahedra: one function per metric, from a block's shared intermediates into `out`.

Formulas: C. J. Stimpson, C. D. Ernst, P. Knupp, P. P. Pebay, D. Thompson, "The Verdict Geometric Quality Library",
SAND2007-1751, chapter 6. Thresholds of VTK 9.6's Verdict were found by experiment: those that are relative to the
cell's size are taken over, those in the file's unit are not. At a corner, (u, v, w) are its edges; X, Y, Z are the
principal axes, the sums of four edges. Where a metric is not defined (Verdict returns its sentinel, +-1e30), `out`
gets the infinity at its worst end.
"""

from __future__ import annotations

from math import inf, sqrt

import numpy as np

from ..arrays import Floats
from .arena import dot
from .block import TOLERANCE, HexahedronBlock


def short_edges(block: HexahedronBlock, with_axes: bool) -> Floats | None:
    """Where an edge (or X, Y, Z) is too short for Verdict: squared, below `TOLERANCE` times the squared box diagonal.

    None if the whole block is plainly sound: a box's diagonal is at most sqrt(27) times the longest edge.
    """
    squares = block.squares
    least, most = squares.min(), squares.max()
    if with_axes:
        least = min(least, block.axis_squares.min())
    if least > 27 * TOLERANCE * most and least > TOLERANCE**2:
        return None
    shortest = squares.min(axis=0)
    if with_axes:
        shortest = np.minimum(shortest, block.axis_squares.min(axis=0))
    return np.asarray(shortest <= TOLERANCE * block.size**2)


def diagonal(block: HexahedronBlock, out: Floats) -> None:
    """Shortest over longest space diagonal; -inf where all vanish."""
    shortest, longest = block.diagonals
    np.divide(shortest, longest, out=out)
    out[longest <= TOLERANCE * block.size] = -inf


def stretch(block: HexahedronBlock, out: Floats) -> None:
    """sqrt(3) shortest edge / longest space diagonal; -inf where all diagonals vanish."""
    longest = block.diagonals[1]
    np.min(block.squares, axis=0, out=out)
    np.sqrt(out, out=out)
    out /= longest
    out *= sqrt(3)
    out[longest <= TOLERANCE * block.size] = -inf


def edge_ratio(block: HexahedronBlock, out: Floats) -> None:
    """Longest over shortest edge; inf where the shortest, squared, is below 2.2e-15 of the squared box diagonal.

    VTK 9.6 looks for the longest among edges 01, 12, 23, 30, 45, 56 alone; here it is the longest of all twelve.
    """
    squares = block.squares
    np.max(squares, axis=0, out=out)
    out /= squares.min(axis=0)
    np.sqrt(out, out=out)
    short = short_edges(block, with_axes=False)
    if short is not None:
        out[short] = inf


def max_edge_ratio(block: HexahedronBlock, out: Floats) -> None:
    """Longest over shortest of X, Y, Z; inf where one is below 2.2e-15 of the box diagonal."""
    lengths = block.axis_lengths
    shortest = lengths.min(axis=0)
    np.max(lengths, axis=0, out=out)
    out /= shortest
    out[shortest <= TOLERANCE * block.size] = inf


def skew(block: HexahedronBlock, out: Floats) -> None:
    """Largest |cosine| between X, Y and Z; inf where one is below 4.4e-15 of the box diagonal."""
    cosine, scratch = block.array("own_1"), block.array("scratch_1")
    axes, lengths = block.axes, block.axis_lengths
    units = block.array("units", 3, 3)
    for unit, axis, length in zip(units, axes, lengths, strict=True):
        np.divide(axis, length, out=unit)
    out.fill(0)
    for i, j in ((0, 1), (0, 2), (1, 2)):
        dot(units[i], units[j], cosine, scratch)
        np.abs(cosine, out=cosine)
        np.maximum(out, cosine, out=out)
    out[lengths.min(axis=0) <= 2 * TOLERANCE * block.size] = inf


def taper(block: HexahedronBlock, out: Floats) -> None:
    """Largest |XY| / min(|X|, |Y|) over pairs of axes, XY the mixed second difference of the corners.

    inf where X, Y or Z is below 2.2e-15 of the box diagonal.
    """
    mixed, square, scratch = block.array("mixed", 3), block.array("own_1"), block.array("scratch_1")
    lengths = block.axis_lengths
    out.fill(0)
    for i, j, edges, (a, b, c, d) in (
        (0, 1, block.u, (1, 0, 3, 2)),
        (0, 2, block.w, (2, 0, 1, 3)),
        (1, 2, block.v, (3, 0, 2, 1)),
    ):
        np.subtract(edges[:, a], edges[:, b], out=mixed)
        mixed += edges[:, c]
        mixed -= edges[:, d]
        dot(mixed, mixed, square, scratch)
        np.sqrt(square, out=square)
        np.minimum(lengths[i], lengths[j], out=scratch)
        square /= scratch
        np.maximum(out, square, out=out)
    out[lengths.min(axis=0) <= TOLERANCE * block.size] = inf


def jacobian(block: HexahedronBlock, out: Floats) -> None:
    """Smallest of u.(v x w) over corners and X.(Y x Z) / 64 at the centre."""
    np.divide(block.centre_determinant, 64, out=out)
    for row in block.determinants:
        np.minimum(out, row, out=out)


def scaled_jacobian(block: HexahedronBlock, out: Floats) -> None:
    """Smallest of u.(v x w) / (|u| |v| |w|) over corners and of the same for X, Y, Z.

    -inf where an edge or axis, squared, is below 2.2e-15 of the squared box diagonal (a repeated vertex: always).
    """
    x, y, z = block.axis_squares
    np.multiply(x, y, out=out)
    out *= z
    np.sqrt(out, out=out)
    np.divide(block.centre_determinant, out, out=out)
    np.minimum(out, _corner_minimum(block), out=out)
    short = short_edges(block, with_axes=True)
    if short is not None:
        out[short] = -inf


def shear(block: HexahedronBlock, out: Floats) -> None:
    """Smallest of u.(v x w) / (|u| |v| |w|) over corners.

    0 where an edge, squared, is below 2.2e-15 of the squared box diagonal, or a corner's determinant is not above
    2.2e-15 of the cubed one.
    """
    np.maximum(_corner_minimum(block), 0, out=out)
    out[~(block.determinants.min(axis=0) > TOLERANCE * block.size**3)] = 0
    short = short_edges(block, with_axes=False)
    if short is not None:
        out[short] = 0


def _corner_minimum(block: HexahedronBlock) -> Floats:
    """(n,) smallest determinant of unit edges over the corners."""
    known: Floats | None = block.known.get("corner_minimum")
    if known is not None:
        return known
    scaled, n = block.array("own_8", 8), block.count
    for odd, half in enumerate((scaled[:4].reshape(2, 2, n), scaled[4:].reshape(2, 2, n))):
        u, v, w = (
            block.at_corners(block.squares[4 * i : 4 * i + 4], name, bool(odd))
            for i, name in enumerate("uvw")
        )
        np.multiply(u, v, out=half)
        half *= w
    np.sqrt(scaled, out=scaled)
    np.divide(block.determinants, scaled, out=scaled)
    out: Floats = np.min(scaled, axis=0, out=block.array("corner_minimum"))
    block.known["corner_minimum"] = out
    return out
