"""Ratios of a hexahedron's smallest to its largest Jacobian.

See `hexahedron` for the conventions.
"""

from __future__ import annotations

from math import inf

import numpy as np

from ..arrays import Floats
from .block import TOLERANCE, HexahedronBlock


def nodal_jacobian_ratio(block: HexahedronBlock, out: Floats) -> None:
    """Smallest over largest determinant of the corners; -inf where no corner is positive.

    VTK 9.6 expands each determinant from raw coordinates, which loses digits far from the origin, asks for a largest
    above 2.2e-15 in the file's unit, and starts at 1e30 when it looks for the smallest: not taken over.
    """
    _ratio(block, block.determinants, out)


def gauss_jacobian_ratio(block: HexahedronBlock, out: Floats) -> None:
    """Smallest over largest determinant of the 2 x 2 x 2 Gauss points; -inf where none is positive."""
    _ratio(block, block.gauss_determinants, out)


def _ratio(block: HexahedronBlock, determinants: Floats, out: Floats) -> None:
    """Smallest over largest; -inf where the largest is not above 2.2e-15 of the cubed diagonal of the cell's box."""
    largest = np.max(determinants, axis=0, out=block.array("own_1"))
    np.min(determinants, axis=0, out=out)
    out /= largest
    out[~(largest > TOLERANCE * block.size**3)] = -inf
