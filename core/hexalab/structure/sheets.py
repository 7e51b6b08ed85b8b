"""Sheets: layers of cells that the dual surfaces of a mesh run through (Murdoch et al. 1997; SPEC T2).

Two edges are of one sheet if they are opposite in a quadrilateral face, or if a way of such steps leads from
one to the other.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Ids, tally
from ..cells import EDGES
from ..topology.classes import by_appearance, directed_classes
from ..topology.pairs import repeated_labels
from .frame import DIRECTIONS, SENSE, Frame


@dataclass(frozen=True)
class Sheets:
    """All sheets, numbered as they are met going through the cells and their three directions.

    Attributes
    ----------
    of_edges : (E,) int32
        Sheet of each edge.
    of_cells : (3, N) int32
        Sheet that crosses each cell in each direction.
    cells : (S,) int32
        Cells of each; a cell that it crosses twice counts once.
    edges : (S,) int32
        Edges of each.
    crossings : (S,) int32
        How often each crosses a cell.
    closed, self_intersecting, self_touching, one_sided : (S,) bool
        No edge of it is on the boundary; it crosses a cell more than once; it doesn't, and two of its edges
        share a vertex; its edges can't be directed alike.
    """

    of_edges: Ids
    of_cells: Ids
    cells: Ids
    edges: Ids
    crossings: Ids
    closed: NDArray[np.bool_]
    self_intersecting: NDArray[np.bool_]
    self_touching: NDArray[np.bool_]
    one_sided: NDArray[np.bool_]

    @property
    def count(self) -> int:
        """Number of sheets."""
        return len(self.cells)


def find_sheets(frame: Frame) -> Sheets:
    """Trace all sheets."""
    found = directed_classes(frame.edge_count, lambda: _links(frame))
    raw, count = found.labels, found.count
    crossing = np.stack([raw[frame.cell_edges[places[0]]] for places in DIRECTIONS])
    number = by_appearance(crossing.T, count)
    of_edges, of_cells = number[raw], number[crossing]
    sided = np.empty(count, dtype=bool)
    sided[number] = found.one_sided
    crossings = tally(of_cells, count)
    a, b, c = of_cells
    twice = (a == b, b == c, a == c)
    again = np.zeros(count, np.int32)
    for one, same in ((a, twice[0]), (b, twice[1]), (a, twice[2] & ~twice[0] & ~twice[1])):
        np.add.at(again, one[same], np.int32(1))
    intersecting = again > 0
    open_ = np.zeros(count, dtype=bool)
    open_[of_edges[frame.edge_on_boundary]] = True
    return Sheets(
        of_edges=of_edges,
        of_cells=of_cells,
        cells=crossings - again,
        edges=tally(of_edges, count),
        crossings=crossings,
        closed=~open_,
        self_intersecting=intersecting,
        self_touching=_touching(frame, of_edges, count) & ~intersecting,
        one_sided=sided,
    )


def _links(frame: Frame) -> Iterator[tuple[Ids, Ids, NDArray[np.bool_]]]:
    """Parallel edges of cells, three links for each direction, and whether they point against each other.

    An edge points from its smaller vertex to its larger.
    """
    for start in range(0, frame.count, CHUNK):
        corners = frame.topology.corners[:, start : start + CHUNK]
        edges = frame.cell_edges[:, start : start + CHUNK]
        for first, *others in DIRECTIONS:
            sense = _points(corners, first)
            for place in others:
                yield edges[first], edges[place], sense ^ _points(corners, place)


def _points(corners: Ids, place: int) -> NDArray[np.bool_]:
    """(N,) bool: whether the edge at a place of each cell points against the cell's direction."""
    a, b = EDGES[place]
    points: NDArray[np.bool_] = (corners[a] > corners[b]) ^ SENSE[place]
    return points


def _touching(frame: Frame, of_edges: Ids, count: int) -> NDArray[np.bool_]:
    """(S,) bool: whether two edges of a sheet share a vertex."""
    out = np.zeros(count, dtype=bool)
    out[repeated_labels(frame.edge_vertices, of_edges, frame.topology.vertex_count)] = True
    return out
