"""Curves and points of the structure: arcs with their nodes, chords through their cells, edges of the base complex."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..cells import EDGES
from ..structure.base_complex import Skeleton
from ..structure.chords import Chords
from ..structure.frame import OPPOSITE, Frame
from ..structure.graph import Graph
from .drawn_mesh import DrawnMesh
from .edges import one_of_each
from .exploded import ExplodedMesh
from .flat import interleave
from .records import Bytes, Curves, Floats32

LEAST, MOST = 2, 6
"""Valences below and above look alike."""

BASE = MOST - LEAST + 1
"""Row of the base complex' edges, behind those of valences."""

CHORDS = BASE + 1
"""First row of chords."""

CHORD_ROWS = 6
"""So many rows of chords there are before they begin again."""


NODES, VERTICES = 0, 1
"""Rows of points: nodes of the graph, vertices of the base complex."""


@dataclass
class Drawing:
    """What is collected to be drawn.

    Attributes
    ----------
    edges, points : list of (positions, rows, faint)
        Positions are (3, 2, n) or (3, 1, n) drawing coordinates, rows those of the viewer's styles.
    """

    edges: list[tuple[Floats32, Array, Array]] = field(default_factory=list)
    points: list[tuple[Floats32, Array, Array]] = field(default_factory=list)

    def record(self) -> Curves:
        """All of it."""
        edges, edge_rows, edge_faint = _joined(self.edges, 2)
        points, point_rows, point_faint = _joined(self.points, 1)
        return Curves(edges, edge_rows, edge_faint, points, point_rows, point_faint)

    def arcs(self, drawn_mesh: DrawnMesh, graph: Graph, chosen: NDArray[np.bool_]) -> None:
        """Add arcs and loops by valence, and nodes; those not chosen, and nodes at none that is, are faint.

        Parameters
        ----------
        drawn_mesh : DrawnMesh
        graph : Graph
        chosen : (A,) bool
        """
        first = np.ones(len(graph.vertices), dtype=bool)
        first[graph.starts[1:] - 1] = False
        begin = np.flatnonzero(first)
        own = np.repeat(np.arange(graph.count), graph.lengths)
        ends = np.stack([graph.vertices[begin], graph.vertices[begin + 1]])
        rows = np.clip(graph.valence, LEAST, MOST) - LEAST
        self.edges.append((drawn_mesh.points(ends), rows[own], ~chosen[own]))
        if graph.count:
            tips = graph.vertices[np.stack([graph.starts[:-1], graph.starts[1:] - 1])[:, chosen]]
            near = np.isin(graph.nodes, tips)
            self._add_points(drawn_mesh, graph.nodes, NODES, ~near)

    def _add_points(self, drawn_mesh: DrawnMesh, vertices: Ids, row: int, faint: Array) -> None:
        self.points.append((drawn_mesh.points(vertices[None]), np.full(len(vertices), row), faint))

    def chords(
        self, drawn_mesh: DrawnMesh, frame: Frame, chords: Chords, chosen: Ids, shown: NDArray[np.bool_]
    ) -> None:
        """Add chords as lines from face to face through the shown cells, each in a colour of its own.

        Parameters
        ----------
        drawn_mesh : DrawnMesh
        frame : Frame
        chords : Chords
        chosen : (n,) int32
            Their numbers.
        shown : (C,) bool
            Which cells of the mesh.
        """
        place = np.full(chords.count, -1, np.int32)
        place[chosen] = np.arange(len(chosen), dtype=np.int32)
        visible = shown if frame.cells is None else shown[frame.cells]
        for direction, sides in enumerate(OPPOSITE):
            number = place[chords.of_cells[direction]]
            cells = np.flatnonzero((number >= 0) & visible).astype(np.int32)
            middles = [_middles(drawn_mesh, frame, cells, side) for side in sides]
            rows = CHORDS + number[cells] % CHORD_ROWS
            self.edges.append((np.stack(middles, axis=1), rows, np.zeros(len(cells), bool)))

    def base_complex(self, drawn_mesh: DrawnMesh, frame: Frame, skeleton: Skeleton) -> None:
        """Add edges and vertices of the base complex; of blocks drawn apart those of each block."""
        if isinstance(drawn_mesh, ExplodedMesh):
            ends, tips = _of_pieces(drawn_mesh, frame, skeleton)
        else:
            ends, tips = frame.edge_vertices[:, skeleton.mesh_edges], skeleton.vertices
        none = np.zeros(ends.shape[1], bool)
        self.edges.append((drawn_mesh.points(ends), np.full(len(none), BASE), none))
        self._add_points(drawn_mesh, tips, VERTICES, np.zeros(len(tips), bool))


def _middles(drawn_mesh: DrawnMesh, frame: Frame, cells: Ids, side: int) -> Floats32:
    corners = frame.topology.corners_of(cells, np.full(len(cells), side, np.uint8))
    out: Floats32 = drawn_mesh.points(corners).mean(axis=1)
    return out


def _of_pieces(drawn_mesh: ExplodedMesh, frame: Frame, skeleton: Skeleton) -> tuple[Ids, Ids]:
    """Edges (2, n) and vertices of the base complex for every piece that has them."""
    on = np.zeros(frame.edge_count, dtype=bool)
    on[skeleton.mesh_edges] = True
    corners = drawn_mesh.mesh.corners if frame.cells is None else drawn_mesh.mesh.corners[:, frame.cells]
    found = []
    for place, (a, b) in enumerate(EDGES):
        cells = np.flatnonzero(on[frame.cell_edges[place]])
        found.append(np.stack([corners[a][cells], corners[b][cells]]))
    ends = np.concatenate(found, axis=1)
    winner = one_of_each(ends[0], ends[1])
    ends = ends[:, winner == np.arange(len(winner))]
    tip = np.zeros(drawn_mesh.pieces.drawn_mesh.mesh.vertex_count, dtype=bool)
    tip[skeleton.vertices] = True
    own = np.unique(ends)
    return ends, own[tip[drawn_mesh.pieces.source[own]]]


def _joined(parts: list[tuple[Floats32, Array, Array]], width: int) -> tuple[Any, Bytes, Bytes]:
    positions = np.concatenate(
        [np.empty((3, width, 0), np.float32), *(place for place, _, _ in parts)], axis=2
    )
    rows = np.concatenate([np.empty(0, np.uint8), *(rows.astype(np.uint8) for _, rows, _ in parts)])
    faint = np.concatenate([np.empty(0, np.uint8), *(faint.astype(np.uint8) for _, _, faint in parts)])
    return interleave(positions), rows, faint
