"""Topology: faces, edges, adjacency, boundary, hop distance, components.

All of it is by vertex ids alone, for hexahedra and for the cells that collapse from them. Each part is
computed at its first use and kept; the first picture needs the faces only.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..mesh import FACES, Array, Ids
from .faces import Faces, find_faces
from .interface import Interface, InterfaceFinder

__all__ = ["Faces", "Interface", "Topology"]

_FACE_PLACES = np.array(FACES, dtype=np.intp)


class Topology:
    """What meets what in a mesh.

    Parameters
    ----------
    corners : (8, C) int32
        Vertex ids of each cell's corners.
    vertex_count : int
        Number of vertices, more than any id.
    """

    def __init__(self, corners: Ids, vertex_count: int) -> None:
        self.corners = corners
        self.vertex_count = vertex_count

    @property
    def cell_count(self) -> int:
        """Number of cells."""
        return int(self.corners.shape[1])

    @cached_property
    def faces(self) -> Faces:
        """All faces as arrays, pairs first, then the boundary."""
        return find_faces(self.corners, self.vertex_count)

    @property
    def face_cells(self) -> Ids:
        """(2, F) int32: the cells on both sides of each face, -1 outside.

        A face that n > 2 cells share stands in (n + 1) // 2 rows: pairs, and one left over.
        """
        return self.faces.cells

    @property
    def face_locals(self) -> NDArray[np.uint8]:
        """(2, F) uint8: which of the six faces (an index into `FACES`) it is of the cells in `face_cells`."""
        return self.faces.locals

    @property
    def cell_faces(self) -> Ids:
        """(6, C) int32: row of each face of each cell, -1 for a face that has vanished."""
        return self.faces.rows

    @cached_property
    def face_corners(self) -> Ids:
        """(4, F) int32: corners as seen from outside of the first cell; a triangle repeats its last."""
        return self.corners_of(self.face_cells[0], self.face_locals[0])

    def corners_of(self, cells: Array, local: Array) -> Ids:
        """Corners of some cells' faces, counter-clockwise as seen from outside the cell.

        Parameters
        ----------
        cells : (N,) int
        local : (N,) int
            Index into `FACES` for each.

        Returns
        -------
        (4, N) int32
            A triangle repeats its last corner.
        """
        flat = self.corners.reshape(-1)
        out = np.empty((4, len(cells)), np.int32)
        for place in range(4):
            where = (_FACE_PLACES[:, place] * self.cell_count)[local]
            where += cells
            out[place] = flat[where]
        a, b, c, d = out
        early = np.flatnonzero((a == b) | (b == c))
        late = np.flatnonzero((d == a) | (b == d))
        middle = np.flatnonzero(a == c)
        first = np.flatnonzero(a == b)
        if len(late):
            d[late] = c[late]
        if len(first):
            b[first] = c[first]
        for some in (early, middle):
            if len(some):
                c[some] = d[some]
        return out

    @property
    def face_count(self) -> int:
        """Number of faces, by their sets of vertices."""
        return self.faces.count

    @property
    def boundary_face_count(self) -> int:
        """Number of faces that exactly one cell has."""
        return self.faces.boundary_count

    @property
    def nonmanifold_face_count(self) -> int:
        """Number of faces that more than two cells share."""
        return self.faces.nonmanifold_count

    @property
    def nonmanifold_face_rows(self) -> Ids:
        """(M,) int32: rows of the faces that more than two cells share."""
        return self.faces.nonmanifold_rows

    @cached_property
    def boundary_faces(self) -> Ids:
        """(B,) int32: rows of the faces that exactly one cell has.

        The odd one of three cells at a non-manifold face has a row without second cell too, which is drawn
        but is not the boundary. A cell that has the same face twice, and no other cell has it, counts here
        with two rows.
        """
        return np.arange(self.faces.paired, self.faces.boundary_end, dtype=np.int32)

    @cached_property
    def boundary_vertices(self) -> NDArray[np.bool_]:
        """(V,) bool: whether the vertex lies on a face of the boundary."""
        rows = slice(self.faces.paired, self.faces.boundary_end)
        on = np.zeros(self.vertex_count, dtype=bool)
        for ids in self.corners_of(self.face_cells[0, rows], self.face_locals[0, rows]):
            on[ids] = True
        return on

    def neighbours_of(self, cells: Array) -> Ids:
        """Cells across the six faces, (6, N) int32, of N cells; -1 outside and where a face has vanished."""
        rows = self.cell_faces[:, cells]
        left, right = self.face_cells[0][rows], self.face_cells[1][rows]
        across = np.where(left == cells, right, left)
        across[rows < 0] = -1
        return across

    @cached_property
    def _interface_finder(self) -> InterfaceFinder:
        return InterfaceFinder(self.faces)

    def interface(self, shown: NDArray[np.bool_]) -> Interface:
        """The faces with exactly one shown side; quick where few cells changed since the last call."""
        return self._interface_finder.find(shown)
