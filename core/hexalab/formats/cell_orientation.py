"""Which way round cells are that were rebuilt from faces: one decision for the whole file.

Formats say from which side the faces of a cell are seen, and files do not keep to it. But all cells of a file are
meant in one way; the majority of them is not inverted, and so tells it.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Floats, Ids
from ..cells import COLLAPSE, FACES, HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from .assembly import Assembly, CellBlock, check_ids

MIRROR = {
    HEXAHEDRON: (0, 3, 2, 1, 4, 7, 6, 5),
    WEDGE: (0, 2, 1, 3, 5, 4),
    PYRAMID: (0, 3, 2, 1, 4),
    TETRAHEDRON: (0, 2, 1, 3),
}
"""A kind's corners in an order that turns the cell inside out."""


@dataclass
class Orientation:
    """Gathers the blocks of a file, of all its pieces, and turns them.

    Parameters
    ----------
    inwards : bool
        Whether the format lets the normals of faces point into the cell; only for what is told.
    faces : str
        What the format calls faces; only for what is told.
    """

    inwards: bool
    faces: str
    blocks: list[tuple[CellBlock, NDArray[np.bool_], NDArray[np.int8]]] = field(default_factory=list)

    def add(self, block: CellBlock, agreeing: NDArray[np.bool_], coordinates: Floats) -> None:
        """Add a block of cells whose corners are what the format's convention makes of them.

        Parameters
        ----------
        block : CellBlock
            Own corners of the cells.
        agreeing : (n,) bool
            Whether all faces of the cell are seen from the same side.
        coordinates : (3, V) float64

        Raises
        ------
        MeshReadError
            A corner is no vertex of the mesh.
        """
        check_ids(block, coordinates.shape[1])
        signs = np.empty(len(agreeing), dtype=np.int8)
        for start in range(0, len(agreeing), CHUNK):
            part = slice(start, start + CHUNK)
            signs[part] = np.sign(signed_volumes(block.kind, block.corners[:, part], coordinates))
        self.blocks.append((block, agreeing, signs))

    def settle(self, out: Assembly) -> None:
        """Turn all cells if most have a negative volume, and each whose own faces disagree if it has; notes tell it."""
        kept = sum(int((agreeing & (signs > 0)).sum()) for _, agreeing, signs in self.blocks)
        broken = sum(int((agreeing & (signs < 0)).sum()) for _, agreeing, signs in self.blocks)
        contrary = sum(int((~agreeing).sum()) for _, agreeing, _ in self.blocks)
        for block, agreeing, signs in self.blocks:
            turned = np.where(agreeing, broken > kept, signs < 0)
            block.corners[:, turned] = block.corners[list(MIRROR[block.kind])][:, turned]
        if broken > kept:
            way = "out of" if self.inwards else "into"
            out.note(
                f"The normals of {self.faces} point {way} most cells ({broken:,} of {broken + kept:,}), against the "
                "format's convention: all cells were turned round."
            )
        if contrary:
            out.note(
                f"Cells of which some {self.faces} are seen from inside and some from outside: {contrary:,}. They "
                "were taken not to be inverted."
            )


def signed_volumes(kind: int, own: Ids, coordinates: Floats) -> Floats:
    """(n,) volumes, from the outward faces by the divergence theorem; of quadrilaterals the mean of both splits."""
    place = coordinates[:, own]
    with np.errstate(over="ignore", invalid="ignore"):
        place = place - place[:, :1]
        total = np.zeros(own.shape[1])
        for face in FACES:
            p, q, r, s = (place[:, COLLAPSE[kind][corner]] for corner in face)
            for a, b, c in ((p, q, r), (p, r, s), (q, r, s), (q, s, p)):
                total += (
                    a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
                )
        return np.nan_to_num(total / 12, nan=0.0)
