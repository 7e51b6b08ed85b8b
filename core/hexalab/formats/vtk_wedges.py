"""Wedges whose numbering differs between releases of VTK, and between the programs that write them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import CHUNK, Floats
from .assembly import Assembly, CellBlock, check_ids
from .cell_orientation import signed_volumes

CHANGED_TYPES = (13, 26)
"""Types whose normal of 0 1 2 points away from 3 4 5 up to VTK 9.6, and towards it since 9.7 (release notes)."""


@dataclass
class ChangedWedges:
    """Finds out whether all wedges of those types in a file are inverted.

    They are read as VTK numbered them until 9.6, as all files of before must be; files do not tell who numbered them. A
    note says that a file may be meant in the other way.
    """

    upright: bool = False
    inverted: int = 0

    def add(self, block: CellBlock, coordinates: Floats) -> None:
        """Look at a block of such wedges; raises MeshReadError if a corner is no vertex of the mesh."""
        if self.upright or not block.corners.shape[1]:
            return
        check_ids(block, coordinates.shape[1])
        for start in range(0, block.corners.shape[1], CHUNK):
            volumes = signed_volumes(block.kind, block.corners[:, start : start + CHUNK], coordinates)
            self.inverted += int(np.count_nonzero(volumes < 0))
            if (volumes > 0).any():
                self.upright = True
                return

    def settle(self, out: Assembly) -> None:
        """Note it if all of them are."""
        if self.inverted and not self.upright:
            out.note(
                f"All wedges of type 13 or 26 ({self.inverted}) are inverted as VTK numbered wedges until 9.6. "
                "As VTK 9.7 and many programs (Gmsh, CGNS, Exodus) number them they are not."
            )
