"""Blocks: their kinds and dimensions, told by counting how their cells meet the walls (SPEC T3)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids, tally
from .closing import turned_blocks
from .frame import ACROSS, ROUND, SIDES, Frame

KINDS = ("box", "ring", "twisted", "shell", "solid", "other")
BOX, RING, TWISTED, SHELL, SOLID, OTHER = range(6)


@dataclass(frozen=True)
class Blocks:
    """All blocks, numbered in the order of their first cells.

    Attributes
    ----------
    cells : (B,) int32
    kinds : (B,) uint8
        Index into `KINDS`.
    dimensions : (B, 3) int32
        Of a box its cells along its three edges, ascending; of a ring its section's, ascending, and its length;
        0 else.
    """

    cells: Ids
    kinds: NDArray[np.uint8]
    dimensions: Ids

    @property
    def count(self) -> int:
        """Number of blocks."""
        return len(self.cells)


def measured(frame: Frame, complex_faces: NDArray[np.bool_], labels: Ids, count: int) -> Blocks:
    """Tell what blocks are.

    Where a cell has two complex faces at an edge, its block has an edge there, and a corner where it has three;
    a single complex face must go on straight in the next cell of the block. If it does everywhere, the block is
    convex: a box, or what closes onto itself. Of a box i x j x k there are 8 corners, 4 (i + j + k) such edges
    of cells, 2 (ij + jk + ki) faces and ijk cells, so i, j, k are the roots of x**3 - (i + j + k) x**2 + (ij +
    jk + ki) x - ijk.
    """
    cells = tally(labels, count)
    walled = complex_faces[frame.cell_faces]  # (6, N)
    faces, one_more = np.zeros(count, np.int64), np.int64(1)
    for side in walled:
        np.add.at(faces, labels[side], one_more)
    touching = np.flatnonzero(walled.any(axis=0)).astype(np.int32)
    walled = walled[:, touching]
    own = labels[touching]
    edges = np.zeros(count, np.int64)
    convex = np.ones(count, dtype=bool)
    for place, (one, other) in enumerate(SIDES):
        both = walled[one] & walled[other]
        np.add.at(edges, own[both], one_more)
        for wall, free in ((one, other), (other, one)):
            at = np.flatnonzero(walled[wall] & ~walled[free])
            convex[own[at[~_goes_on(frame, complex_faces, touching[at], int(free), place)]]] = False
    corners = np.zeros(count, np.int64)
    for a, b, c in CORNER_FACES:
        np.add.at(corners, own[walled[a] & walled[b] & walled[c]], one_more)
    kinds = np.full(count, OTHER, np.uint8)
    dimensions = np.zeros((count, 3), np.int32)
    box = np.flatnonzero(convex & (corners == 8))
    sides = _roots(edges[box] // 4, faces[box] // 2, cells[box])
    dimensions[box] = sides
    kinds[box[sides[:, 0] > 0]] = BOX
    ring = np.flatnonzero(convex & (corners == 0) & (edges > 0))
    if len(ring):
        length = edges[ring] // 4
        area, half = cells[ring] // length, faces[ring] // (2 * length)
        root = np.sqrt(np.maximum(half * half - 4 * area, 0)).round().astype(np.int64)
        dimensions[ring] = np.stack([(half - root) // 2, (half + root) // 2, length], axis=1)
        kinds[ring] = RING
    closed = convex & (corners == 0) & (edges == 0)
    kinds[closed] = np.where(faces[closed] > 0, SHELL, SOLID)
    closing = kinds != BOX
    if closing.any():
        turned = turned_blocks(frame, complex_faces, labels, closing)
        kinds[turned], dimensions[turned] = TWISTED, 0
    return Blocks(cells, kinds, dimensions)


CORNER_FACES = ((0, 2, 5), (0, 2, 3), (0, 3, 4), (0, 4, 5), (1, 2, 5), (1, 2, 3), (1, 3, 4), (1, 4, 5))
"""The three faces of a cell at each of its corners."""


def _goes_on(
    frame: Frame, complex_faces: NDArray[np.bool_], cells: Ids, free: int, place: int
) -> NDArray[np.bool_]:
    """Whether, behind the free side of each cell, the other face at its edge of that place is complex."""
    behind, local, through = frame.behind(cells, free)
    k = int(np.flatnonzero(ROUND[free] == place)[0])
    turned = frame.meeting(through, k, cells)
    out: NDArray[np.bool_] = complex_faces[frame.cell_faces[ACROSS[local, turned], behind]]
    return out


def _roots(sums: Array, pairs: Array, product: Array) -> Array:
    """(n, 3): the whole numbers with these elementary symmetric sums, ascending; 0 where there are none."""
    table, back = np.unique(np.stack([sums, pairs, product], axis=1), axis=0, return_inverse=True)
    found = np.zeros((len(table), 3), np.int64)
    for row, (s, p, n) in enumerate(table.tolist()):
        found[row] = next(
            (
                sorted((i, j, n // (i * j)))
                for i in range(1, round(n ** (1 / 3)) + 2)
                if n % i == 0
                for j in range(i, s - i + 1)
                if (n // i) % j == 0 and i + j + n // (i * j) == s and i * j + (i + j) * (n // (i * j)) == p
            ),
            (0, 0, 0),
        )
    out: Array = found[back.reshape(-1)]
    return out
