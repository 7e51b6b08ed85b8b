"""Wedges whose numbering differs between releases of VTK, and between the programs that write them."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

import numpy as np

from ..arrays import CHUNK, Floats
from .assembly import Assembly, CellBlock, check_ids
from .cell_orientation import signed_volumes

DOUBTS = {
    (13, 26): "All wedges of type 13 or 26 ({:,}) are inverted as VTK numbered wedges until 9.6. "
    "As VTK 9.7 and many programs (Gmsh, CGNS, Exodus) number them they are not.",
    (31, 32, 73, 80): "All wedges of type 31, 32, 73 or 80 ({:,}) are inverted as VTK numbers these types. "
    "As VTK numbered those of type 13 until 9.6, and some programs (MFEM) these too, they are not.",
}
"""Types of wedges that are numbered alike, and what is told where all of them are inverted.

The normal of 0 1 2 points away from 3 4 5 in types 13 and 26 up to VTK 9.6, and towards it since 9.7 (release notes);
it always pointed towards it in the others.
"""

TYPES = {number: numbers for numbers in DOUBTS for number in numbers}
"""The types that are numbered as each one is."""


@dataclass
class WedgeNumbering:
    """Finds out whether all wedges of a file that are numbered alike are inverted.

    They are read as VTK numbered them until 9.6, as all files of before must be; files do not tell who numbered them. A
    note says that a file may be meant in the other way.
    """

    upright: set[tuple[int, ...]] = field(default_factory=set)
    inverted: Counter[tuple[int, ...]] = field(default_factory=Counter)

    def add(self, number: int, block: CellBlock, coordinates: Floats) -> None:
        """Look at a block of cells of a type; raises MeshReadError if a corner is no vertex of the mesh."""
        alike = TYPES.get(number)
        if alike is None or alike in self.upright or not block.corners.shape[1]:
            return
        check_ids(block, coordinates.shape[1])
        for start in range(0, block.corners.shape[1], CHUNK):
            volumes = signed_volumes(block.kind, block.corners[:, start : start + CHUNK], coordinates)
            self.inverted[alike] += int(np.count_nonzero(volumes < 0))
            if (volumes > 0).any():
                self.upright.add(alike)
                return

    def settle(self, out: Assembly) -> None:
        """Note it if all of them are."""
        for alike, count in self.inverted.items():
            if count and alike not in self.upright:
                out.note(DOUBTS[alike].format(count))
