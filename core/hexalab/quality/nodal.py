"""Verdict's nodal Jacobian ratio of hexahedra, with the sum that it takes the determinants from.

See `hexahedron` for the source and the conventions.
"""

from __future__ import annotations

from math import inf

import numpy as np

from ..arrays import Floats
from .block import TOLERANCE, HexahedronBlock
from .hexahedron import HUGE, overflow

TRIPLES = (
    (0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7),
    (4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2), (7, 6, 4, 3),
)  # fmt: skip
"""Each corner and its three neighbours, right-handed."""

PAIRS = sorted({pair for corner in TRIPLES for pair in ((a, b) for a in corner for b in corner if a < b)})
"""The 12 edges and the 12 face diagonals."""


def nodal_jacobian_ratio(block: HexahedronBlock, out: Floats) -> None:
    """Smallest over largest determinant of the corners; -inf where the largest is not above 2.2e-15 (with a unit!).

    VTK 9.6 expands each determinant along z, with minors of the raw x and y, which loses digits far from the
    origin: we add in its order, to agree with it to the last bit. It starts at 1e30 when it looks for the smallest,
    so that cells whose determinants are all larger get 1e30 / largest: a cube of edge 1e12 gets 1e-6.
    """
    areas, scratch = block.array("areas", len(PAIRS)), block.array("scratch_1")
    for area, (a, b) in zip(areas, PAIRS, strict=True):
        (xa, ya, _), (xb, yb, _) = block.corner(a), block.corner(b)
        np.multiply(xa, yb, out=area)
        np.multiply(xb, ya, out=scratch)
        area -= scratch
    largest, value = block.array("own_1"), block.array("product_1")
    for place, corner in enumerate(TRIPLES):
        _determinant(block, areas, corner, value)
        if place:
            np.minimum(out, value, out=out)
            np.maximum(largest, value, out=largest)
        else:
            np.minimum(value, HUGE, out=out)
            np.copyto(largest, value)
    out /= largest
    overflow(out)
    out[~(largest > TOLERANCE)] = -inf


def _determinant(
    block: HexahedronBlock, areas: Floats, corner: tuple[int, int, int, int], out: Floats
) -> None:
    """Determinant of the edges from a corner to its neighbours: sum over the four nodes of z times a minor."""
    minor = block.array("minor")
    for place, node in enumerate(sorted(corner)):
        a, b, c = (other for other in corner if other != node)
        odd = corner.index(node) % 2 == 0
        loop = ((a, c), (c, b), (b, a)) if odd else ((a, b), (b, c), (c, a))
        lowest = min(a, b, c)
        in_order = sorted(loop, key=lambda pair: lowest not in pair)
        for step, (i, j) in enumerate(in_order):
            row = areas[PAIRS.index((min(i, j), max(i, j)))]
            if step == 0:
                np.multiply(row, 1 if i < j else -1, out=minor)
            elif i < j:
                minor += row
            else:
                minor -= row
        minor *= block.corner(node)[2]
        if place:
            out += minor
        else:
            np.copyto(out, minor)
