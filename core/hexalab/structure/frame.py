"""The hexahedra of a mesh with their faces and edges: what structure is traced in.

Cells that are no hexahedra, or repeat a vertex or another cell, are left out: towards them the mesh ends. So it
does at a face of more than two cells, where there is no way on: each of its cells has that face for itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..cells import EDGES, FACES, HEXAHEDRON
from ..mesh import Mesh
from ..topology import FACE_EDGES, Topology
from .joints import MEETING, Joints, find_joints

DIRECTIONS = ((0, 2, 4, 6), (1, 3, 5, 7), (8, 9, 10, 11))
"""The edges that are parallel in a cell, as indices into `EDGES`: its three directions."""

SENSE = (False, False, True, True, False, False, True, True, False, False, False, False)
"""For each of `EDGES`, whether it points against the first of its direction."""


def _edge_between(a: int, b: int) -> int:
    return next(row for row, ends in enumerate(EDGES) if {a, b} == set(ends))


OPPOSITE = ((5, 3), (2, 4), (0, 1))
"""For each direction, the faces at its beginning and at its end, as indices into `FACES`."""

DIRECTION_OF_EDGE = np.array([0, 1, 0, 1, 0, 1, 0, 1, 2, 2, 2, 2], np.int32)
"""Direction of each of `EDGES`."""

DIRECTION_OF_FACE = np.array([2, 2, 1, 0, 1, 0], np.int32)
"""Direction that leads through each of `FACES`."""

ROUND = np.array([[_edge_between(face[k], face[(k + 1) % 4]) for k in range(4)] for face in FACES], np.intp)
"""(6, 4): the edges of each of `FACES` in order around it, the first between its first two corners."""

ACROSS = np.array(
    [
        [next(f for f in range(6) if f != face and edge in FACE_EDGES[f]) for edge in ROUND[face]]
        for face in range(6)
    ],
    np.intp,
)
"""(6, 4): the other face of the cell at each of these edges."""

ROUND_SENSE = np.array(
    [[(EDGES[ROUND[f][k]][0] == FACES[f][k]) ^ SENSE[ROUND[f][k]] for k in range(4)] for f in range(6)]
)
"""(6, 4) bool: whether the direction of each of these edges leads the way that the ring goes."""

AT_END = np.array([face == end for face in range(6) for _, end in [next(o for o in OPPOSITE if face in o)]])
"""(6,) bool: whether each of `FACES` is at the end of the direction that leads through it."""

SIDES = np.array([[f for f in range(6) if edge in FACE_EDGES[f]] for edge in range(12)], np.intp)
"""(12, 2): the two faces of the cell at each of `EDGES`."""


@dataclass
class Frame:
    """Hexahedra with eight vertices each.

    Attributes
    ----------
    topology : Topology
        Of these cells alone.
    cells : (N,) int32 or None
        Their rows in the mesh; None if they are all of it.
    others, repeating, again : int
        Cells of the mesh that are left out: those of another kind, hexahedra that repeat a vertex, and those that
        are there once already.
    """

    topology: Topology
    cells: Ids | None
    others: int
    repeating: int
    again: int

    @classmethod
    def of(cls, mesh: Mesh) -> Frame:
        """The frame of a mesh."""
        topology = mesh.topology
        hexahedra = mesh.kinds == HEXAHEDRON
        repeating = topology.repeating_cells & hexahedra
        proper = hexahedra & ~repeating
        again = topology.repeated_cells[proper[topology.repeated_cells]]
        proper[again] = False
        cells = None if proper.all() else np.flatnonzero(proper).astype(np.int32)
        if cells is not None:
            corners = np.ascontiguousarray(mesh.corners[:, cells])
            topology = Topology(corners, topology.vertex_count)
        left_out = int(np.count_nonzero(~hexahedra)), int(np.count_nonzero(repeating)), len(again)
        return cls(topology, cells, *left_out)

    @property
    def skipped(self) -> str:
        """What is not traced, and what tracing stops at, counted; empty if there is nothing."""
        found = (
            (self.others, "cell that isn't a hexahedron", "cells that aren't hexahedra"),
            (self.repeating, "cell repeats a vertex", "cells repeat a vertex"),
            (self.joints.crowded, "face has more than two cells", "faces have more than two cells"),
            (
                self.joints.disordered,
                "face has its vertices in another order in its other cell",
                "faces have their vertices in another order in their other cell",
            ),
            (
                self.again,
                "cell has the same eight vertices as another",
                "cells have the same eight vertices as others",
            ),
        )
        return "; ".join(f"{number} {one if number == 1 else many}" for number, one, many in found if number)

    @property
    def count(self) -> int:
        """Number of cells."""
        return self.topology.cell_count

    @cached_property
    def joints(self) -> Joints:
        """The faces."""
        return find_joints(self.topology)

    @property
    def face_cells(self) -> Ids:
        """(2, F) int32: cells of each face, -1 outside; faces between two cells come first."""
        return self.joints.cells

    @property
    def face_locals(self) -> NDArray[np.uint8]:
        """(2, F) uint8: which of `FACES` it is of each of the two."""
        return self.joints.locals

    @property
    def cell_faces(self) -> Ids:
        """(6, N) int32: face at each place of each cell."""
        return self.joints.rows

    @property
    def paired(self) -> int:
        """Number of faces between two cells; those from there on are the boundary."""
        return self.joints.paired

    @property
    def face_count(self) -> int:
        """Number of faces."""
        return int(self.face_cells.shape[1])

    @property
    def edge_count(self) -> int:
        """Number of edges."""
        return self.topology.edge_count

    @property
    def cell_edges(self) -> Ids:
        """(12, N) int32: edge at each place of each cell."""
        return self.topology.cell_edges

    @property
    def edge_vertices(self) -> Ids:
        """(2, E) int32: smaller and larger vertex of each edge."""
        return self.topology.edge_vertices

    @cached_property
    def valence(self) -> Ids:
        """(E,) int32: cells around each edge."""
        return self.topology.edge_cells

    @cached_property
    def edge_on_boundary(self) -> NDArray[np.bool_]:
        """(E,) bool: whether the edge belongs to a face of the boundary."""
        on = np.zeros(self.edge_count, dtype=bool)
        on[self.edges_of(slice(self.paired, None))] = True
        return on

    @cached_property
    def irregular(self) -> NDArray[np.bool_]:
        """(E,) bool: interior edges of other than four cells, boundary edges of other than two."""
        irregular: NDArray[np.bool_] = self.valence != np.where(self.edge_on_boundary, 2, 4)
        return irregular

    @cached_property
    def vertex_on_boundary(self) -> NDArray[np.bool_]:
        """(V,) bool: whether the vertex belongs to a face of the boundary."""
        on = np.zeros(self.topology.vertex_count, dtype=bool)
        on[self.edge_vertices[:, self.edge_on_boundary]] = True
        return on

    @cached_property
    def vertex_used(self) -> NDArray[np.bool_]:
        """(V,) bool: whether a cell has the vertex."""
        used = np.zeros(self.topology.vertex_count, dtype=bool)
        used[self.topology.corners.reshape(-1)] = True
        return used

    def meeting(self, faces: Ids, k: int | Array, cells: Ids | None = None) -> Array:
        """(n,): which edge of `ROUND` the k-th edge of some faces is as the cell behind has it.

        Parameters
        ----------
        faces : (n,) int32
            Between two cells.
        k : int or (n,) int
        cells : (n,) int32, optional
            The cell that has it as its k-th; the first of the two by default.
        """
        second = 0 if cells is None else (self.face_cells[0, faces] != cells).astype(np.intp)
        found: Array = MEETING[second, self.joints.turns[faces], k]
        return found

    def behind(self, cells: Ids, side: int | Array) -> tuple[Ids, NDArray[np.uint8], Ids]:
        """The cell behind a side of each, which of its faces that is, and the row of the face."""
        through = self.cell_faces[side, cells]
        behind = self.face_cells[0, through] ^ self.face_cells[1, through] ^ cells
        local = self.face_locals[0, through] ^ self.face_locals[1, through] ^ np.asarray(side, np.uint8)
        return behind, local, through

    def edges_of(self, faces: slice | Array) -> Ids:
        """(4, n) int32: edges of some faces, in order round each, as its first cell has it."""
        return self.topology.edges_of(self.face_cells[0, faces], self.face_locals[0, faces])

    def in_mesh(self, labels: Ids, cell_count: int) -> Ids:
        """Labels of the mesh's cells (last axis) out of labels of these cells; -1 for those left out."""
        if self.cells is None:
            return labels
        out = np.full((*labels.shape[:-1], cell_count), -1, np.int32)
        out[..., self.cells] = labels
        return out
