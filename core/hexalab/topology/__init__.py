"""Topology: faces, edges, adjacency, boundary, hop distance, components.

All of it is by vertex ids alone, for hexahedra and for the cells that collapse from them. Each part is
computed at its first use and kept; the first picture needs the faces only.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..cells import FACES
from .edges import FACE_EDGES, Edges, cells_around, find_edges, repeating_cells
from .faces import Faces, find_faces
from .hops import components, depth
from .interface import Interface, InterfaceFinder
from .repeats import repeated_cells
from .stars import Stars

__all__ = ["FACE_EDGES", "Edges", "Faces", "Interface", "Topology"]

_FACE_PLACES = np.array(FACES, dtype=np.intp)
_EDGE_PLACES = np.array(FACE_EDGES, dtype=np.intp)


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

    @cached_property
    def repeated_cells(self) -> Ids:
        """(N,) int32: cells that have the very vertices of a cell before them, ascending."""
        return repeated_cells(self.corners, self.faces)

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

    def neighbours_of(self, cells: Array) -> Ids:
        """Cells across the six faces, (6, N) int32, of N cells; -1 outside and where a face has vanished."""
        rows = self.cell_faces[:, cells]
        if not self.face_count:  # every cell has collapsed to less than a face
            return np.full(rows.shape, -1, dtype=np.int32)
        left, right = self.face_cells[0][rows], self.face_cells[1][rows]
        across = np.where(left == cells, right, left)
        across[rows < 0] = -1
        return across

    @cached_property
    def stars(self) -> Stars:
        """The cells around each vertex."""
        return Stars(self.corners, self.vertex_count)

    @cached_property
    def _interface_finder(self) -> InterfaceFinder:
        return InterfaceFinder(self.faces)

    def interface(self, shown: NDArray[np.bool_]) -> Interface:
        """The faces with exactly one shown side; quick where few cells changed since the last call."""
        return self._interface_finder.find(shown)

    @cached_property
    def edges(self) -> Edges:
        """All edges as arrays."""
        return find_edges(self.corners, self.vertex_count)

    @property
    def edge_count(self) -> int:
        """Number of edges."""
        return int(self.edges.vertices.shape[1])

    @property
    def edge_vertices(self) -> Ids:
        """(2, E) int32: smaller and larger vertex id of each edge."""
        return self.edges.vertices

    @property
    def cell_edges(self) -> Ids:
        """(12, C) int32: edge at each place (`EDGES`) of each cell, -1 for an edge that has vanished."""
        return self.edges.rows

    @cached_property
    def repeating_cells(self) -> NDArray[np.bool_]:
        """(C,) bool: whether the cell has a vertex at more than one of its eight corners."""
        return repeating_cells(self.corners)

    @cached_property
    def edge_cells(self) -> Ids:
        """(E,) int32: number of distinct cells around each edge, its valence."""
        return cells_around(self.edges, np.flatnonzero(self.repeating_cells))

    @cached_property
    def edge_on_boundary(self) -> NDArray[np.bool_]:
        """(E,) bool: whether the edge belongs to a face of the boundary."""
        on = np.zeros(self.edge_count + 1, dtype=bool)
        rows = self.faces.boundary
        on[self.edges_of(self.face_cells[0, rows], self.face_locals[0, rows])] = True
        return on[:-1]

    def edges_of(self, cells: Array, local: Array) -> Ids:
        """Edges of some cells' faces, (4, N) int32, in no particular order; -1 where an edge has vanished.

        Parameters
        ----------
        cells : (N,) int
        local : (N,) int
            Index into `FACES` for each.
        """
        flat = self.cell_edges.reshape(-1)
        out = np.empty((4, len(cells)), np.int32)
        for place in range(4):
            where = (_EDGE_PLACES[:, place] * self.cell_count)[local]
            where += cells
            out[place] = flat[where]
        return out

    @cached_property
    def interior_edge_valence(self) -> dict[int, int]:
        """Number of interior edges of each valence."""
        return _counts(self.edge_cells[~self.edge_on_boundary])

    @cached_property
    def boundary_edge_valence(self) -> dict[int, int]:
        """Number of boundary edges of each valence."""
        return _counts(self.edge_cells[self.edge_on_boundary])

    @cached_property
    def depth(self) -> Ids:
        """(C,) int32: hop distance from the boundary over faces; -1 where no way leads there."""
        return depth(self.faces)

    @cached_property
    def max_depth(self) -> int:
        """Depth of the deepest cell; 0 for a mesh without cells."""
        return int(max(self.depth.max(initial=0), 0))

    @property
    def cells_per_depth(self) -> list[int]:
        """Number of cells of each depth, 0 first."""
        reached = self.depth[self.depth >= 0]
        return [int(count) for count in np.bincount(reached)]

    @cached_property
    def _components(self) -> tuple[Ids, int]:
        return components(self.faces)

    @property
    def components(self) -> Ids:
        """(C,) int32: each cell's face-connected component, numbered in order of their first cells."""
        return self._components[0]

    @cached_property
    def parts(self) -> tuple[Ids, Ids]:
        """(C,) int32 part that each cell is in, and (P,) int32 cells of each part: components, the largest first."""
        labels, count = self._components
        sizes = np.bincount(labels, minlength=count)
        order = np.argsort(-sizes, kind="stable")
        rank = np.empty(count, np.int32)
        rank[order] = np.arange(count, dtype=np.int32)
        return rank[labels], sizes[order].astype(np.int32)

    @property
    def component_count(self) -> int:
        """Number of face-connected components."""
        return self._components[1]


def _counts(values: Array) -> dict[int, int]:
    """How often each value occurs."""
    counts = np.bincount(values)
    return {int(value): int(counts[value]) for value in np.flatnonzero(counts)}
