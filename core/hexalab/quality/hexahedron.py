"""Verdict's metrics of hexahedra: one function per metric, from a block's shared intermediates into `out`.

Formulas: Stimpson, Ernst, Knupp, Pebay, Thompson, "The Verdict Geometric Quality Library", SAND2007-1751, section 6.
Thresholds are those that VTK 9.6's Verdict shows by experiment.
"""

from __future__ import annotations

from math import inf

import numpy as np

from ..mesh import Floats
from .block import HexahedronBlock

TINY = 1e-30
"""Verdict's VERDICT_DBL_MIN, compared with lengths, their squares and volumes alike."""

HUGE = 1e30
"""Verdict's VERDICT_DBL_MAX: its sentinel, and the bound that it clamps results to."""


def scaled_jacobian(block: HexahedronBlock, out: Floats) -> None:
    """Smallest of u.(v x w) / (|u| |v| |w|) over corners and centre; -inf where an edge vanishes."""
    lengths = block.array("own_8", 8)
    u, v, w = block.squares
    np.multiply(u, v, out=lengths[:4])
    lengths[:4] *= w
    odd, shape = lengths[4:].reshape(2, 2, -1), (2, 2, block.count)
    np.multiply(u.reshape(shape), v.reshape(shape)[:, ::-1], out=odd)
    odd *= w.reshape(shape)[::-1]
    np.sqrt(lengths, out=lengths)
    np.divide(block.determinants, lengths, out=lengths)
    np.min(lengths, axis=0, out=out)
    x, y, z = block.axis_squares
    centre = block.array("own_1")
    np.multiply(x, y, out=centre)
    centre *= z
    np.sqrt(centre, out=centre)
    np.divide(block.centre_determinant, centre, out=centre)
    np.minimum(out, centre, out=out)
    shortest = block.array("own_1")
    np.minimum(block.shortest_square, block.axis_squares.min(axis=0), out=shortest)
    out[shortest <= TINY] = -inf
