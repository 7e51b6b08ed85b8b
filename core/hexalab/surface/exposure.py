"""Exposed vertices and the cells that have any: what fissures and roundings start from."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array, Ids
from .drawn_mesh import DrawnMesh
from .records import Bytes, Floats32


class ExposedCells(NamedTuple):
    """The shown cells with an exposed corner.

    Attributes
    ----------
    cells : (n,) int32
    codes : (n,) uint8
        Bit k tells whether corner k is exposed.
    corners : (8, n) int32
        Vertex ids.
    points : (3, 8, n) float32
        Drawing coordinates of the corners.
    """

    cells: Ids
    codes: Bytes
    corners: Ids
    points: Floats32

    def part(self, which: Array | slice) -> ExposedCells:
        """Some of the cells."""
        return ExposedCells(
            self.cells[which], self.codes[which], self.corners[:, which], self.points[:, :, which]
        )


def exposed_cells(drawn_mesh: DrawnMesh, shown: NDArray[np.bool_]) -> ExposedCells:
    """Find the vertices on the interface, then the shown cells that have one."""
    topology, mesh = drawn_mesh.topology, drawn_mesh.mesh
    interface = topology.interface(shown)
    exposed = np.zeros(mesh.vertex_count, np.uint8)
    exposed[topology.corners_of(interface.cells, interface.locals).reshape(-1)] = 1
    found = []
    for begin in range(0, mesh.cell_count, CHUNK):
        part = slice(begin, begin + CHUNK)
        touched = exposed[mesh.corners[0, part]]
        for corner in mesh.corners[1:, part]:
            touched |= exposed[corner]
        touched &= shown[part].view(np.uint8)
        found.append(np.flatnonzero(touched.view(bool)) + begin)
    cells = np.concatenate(found).astype(np.int32) if found else np.empty(0, np.int32)
    corners = np.empty((8, len(cells)), np.int32)
    codes = np.zeros(len(cells), np.uint8)
    for place in range(8):
        corners[place] = mesh.corners[place][cells]
        codes |= exposed[corners[place]] << np.uint8(place)
    return ExposedCells(cells, codes, corners, drawn_mesh.points(corners))
