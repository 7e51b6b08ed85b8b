"""Blocks of tetrahedra, pyramids and wedges, with what their metrics share.

These kinds are rare beside hexahedra, so that their kernels are written plainly, over (3, n) arrays of corners.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Floats, Ids
from ..cells import CORNERS_OF_KIND
from .arena import Arena, shared
from .cube_root import cube_root

Triple = tuple[int, int, int, int]


def times(a: Floats, b: Floats) -> Floats:
    """Dot product over the first axis."""
    return np.asarray(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


def cross(a: Floats, b: Floats) -> Floats:
    """Cross product over the first axis."""
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def determinant(u: Floats, v: Floats, w: Floats) -> Floats:
    """u.(v x w)."""
    return times(u, cross(v, w))


class CellBlock(Arena):
    """Cells of one kind by their own corners, in VTK's order but for wedges.

    A wedge's corners stand as in its collapsed hexahedron: triangle 0 1 2 is counter-clockwise seen from 3 4 5 (VTK's
    is seen from the other side).

    Parameters
    ----------
    kind : int
        Index into `KINDS`.
    edges : sequence of pairs
        Edges by own corners.
    triples : sequence of (corner, a, b, c)
        Corners with their neighbours, right-handed.
    """

    def __init__(self, kind: int, edges: tuple[tuple[int, int], ...], triples: tuple[Triple, ...]) -> None:
        super().__init__()
        self.kind = kind
        self.places = sorted(CORNERS_OF_KIND[kind])
        self.edges = edges
        self.triples = triples
        self.corners: list[Floats] = []

    def load(self, coordinates: Floats, corners: Ids) -> None:
        """Gather the corners (8, n) of the block's cells."""
        self.begin(corners.shape[1])
        self.corners = [coordinates[:, corners[place]] for place in self.places]

    @shared
    def lengths(self) -> Floats:
        """(edges, n) lengths."""
        spans = [self.corners[b] - self.corners[a] for a, b in self.edges]
        return np.sqrt([times(span, span) for span in spans])

    @shared
    def vectors(self) -> list[tuple[Floats, Floats, Floats]]:
        """Edges u, v, w of each triple."""
        return [
            tuple(self.corners[node] - self.corners[corner] for node in nodes)  # type: ignore[misc]
            for corner, *nodes in self.triples
        ]

    @shared
    def determinants(self) -> Floats:
        """(triples, n) u.(v x w)."""
        return np.stack([determinant(*triple) for triple in self.vectors])

    @shared
    def squares(self) -> Floats:
        """(triples, n) |u|^2 + |v|^2 + |w|^2."""
        return np.stack([sum(times(x, x) for x in triple) for triple in self.vectors])

    @shared
    def size(self) -> Floats:
        """(n,) diagonal of the cell's axis-parallel box; 1 where it is a point."""
        span = np.max(self.corners, axis=0) - np.min(self.corners, axis=0)
        out = np.sqrt(times(span, span))
        out[out == 0] = 1
        return out

    @shared
    def aspects(self) -> Floats:
        """(triples, n) Frobenius aspect of the tetrahedron at each triple: 1 if regular (manual, chapter 5)."""
        out = []
        for (u, v, w), det, squares in zip(self.vectors, self.determinants, self.squares, strict=True):
            norm = 1.5 * squares - (times(u, v) + times(v, w) + times(w, u))
            out.append(norm / (3 * cube_root(np.sqrt(2) * det) ** 2))
        return np.stack(out)
