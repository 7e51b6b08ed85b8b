"""Signed inverse condition number: how far corners are from those of the ideal cell.

Definition and ideal cells are Gmsh's ("SICN" of its plugin AnalyseMeshQuality, `minSICN` of its interface): A maps the
edges of the ideal cell's corner to those of the cell's, and 3 det(A) / (|A| |adj A|), in Frobenius norms, is 1 for a
cell of the ideal shape and negative for an inverted corner. Gmsh's manual calls it the inverse condition number of the
Jacobian; after P. M. Knupp, "Algebraic mesh quality metrics", SIAM J. Sci. Comput. 23 (2001).
"""

from __future__ import annotations

import numpy as np

from ..arrays import Floats
from ..cells import PYRAMID, TETRAHEDRON, WEDGE
from .block import HexahedronBlock
from .cells import CellBlock, cross, times

IDEAL_CORNERS = {
    TETRAHEDRON: ((1, 0, 0), (0.5, 0.75**0.5, 0), (0.5, 0.75**0.5 / 3, (2 / 3) ** 0.5)),
    PYRAMID: ((1, 0, 0), (0, 1, 0), (0.5, 0.5, 0.5**0.5)),
    WEDGE: ((1, 0, 0), (0.5, 0.75**0.5, 0), (0, 0, 1)),
}
"""Edges of the ideal cell's corners (of a pyramid's base), right-handed: all edges are 1."""

TO_IDEAL = {kind: np.linalg.inv(np.array(edges).T) for kind, edges in IDEAL_CORNERS.items()}
"""What edges as columns are multiplied with to become A."""


def hexahedron_sicn(block: HexahedronBlock, out: Floats) -> None:
    """Smallest 3 det / (|A| |adj A|) over the corners; 0 where a corner has no extent."""
    product = np.multiply(block.adjugate_squares, block.corner_squares, out=block.array("own_8", 8))
    np.sqrt(product, out=product)
    np.divide(block.determinants, product, out=product)
    np.copyto(product, 0, where=np.isnan(product))
    np.min(product, axis=0, out=out)
    out *= 3


def sicn(block: CellBlock, out: Floats) -> None:
    """Smallest 3 det(A) / (|A| |adj A|) over the corners (of a pyramid's base); 0 where a corner has no extent."""
    out.fill(1)
    for edges in block.vectors:
        a, b, c = (
            sum(edge * weight for edge, weight in zip(edges, column, strict=True))
            for column in TO_IDEAL[block.kind].T
        )
        sides = (cross(b, c), cross(c, a), cross(a, b))
        norms = sum(times(x, x) for x in (a, b, c)) * sum(times(x, x) for x in sides)
        value = 3 * times(a, sides[0]) / np.sqrt(norms)
        np.minimum(out, np.where(np.isnan(value), 0, value), out=out)
