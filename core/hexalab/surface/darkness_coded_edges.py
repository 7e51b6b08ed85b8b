"""Darkness-coded edges: the faces of the interface, and for each edge how many shown cells lie around it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..mesh import Ids
from ..topology import Interface
from .buffers import Bytes, Surface
from .drawing import Drawing
from .edges import Indices, one_of_each, quad_sides
from .fan import fan_sizes
from .lines import edge_lines, interface_surface


def darkness_coded_edges(drawing: Drawing, shown: NDArray[np.bool_]) -> Surface:
    """Surface with edges that know the number of shown cells around them.

    Parameters
    ----------
    drawing : Drawing
    shown : (C,) bool
    """
    interface = drawing.topology.interface(shown)
    corners = drawing.topology.corners_of(interface.cells, interface.locals)
    start, end, side = quad_sides(corners)
    winner = one_of_each(start, end)
    drawn = np.flatnonzero(winner == np.arange(len(winner)))

    quads = corners.shape[1]
    place, quad = np.divmod(side, max(quads, 1))
    place[(corners[2] == corners[3])[quad]] = -1
    around = _cells_around(drawing, shown, interface, winner, start, end, place, quad)
    edges = edge_lines(drawing, start[drawn], end[drawn])
    counts: Bytes = np.minimum(around[drawn], 255).astype(np.uint8)
    return interface_surface(drawing, "darkness_coded_edges", interface, corners, edges, counts)


def _cells_around(
    drawing: Drawing,
    shown: NDArray[np.bool_],
    interface: Interface,
    winner: Indices,
    start: Ids,
    end: Ids,
    place: Indices,
    quad: Indices,
) -> Ids:
    """Number of shown cells around the edge of each side that stands for its edge.

    An edge that two quads share has one fan, from one quad's cell to the other's. Where more meet, each fan
    is walked from both its ends and counts by halves.
    """
    cells = interface.cells[quad]
    sides = np.bincount(winner, minlength=len(winner))[winner]
    simple = np.flatnonzero((sides == 2) & (winner != np.arange(len(winner))))
    first = winner[simple]
    around = np.ones(len(winner), np.int32)

    def walk(which: Indices, last: Ids) -> Ids:
        local = interface.locals[quad[which]].astype(np.intp)
        which_cells = cells[which]
        return fan_sizes(
            drawing.topology, shown, which_cells, local, place[which], start[which], end[which], last
        )

    two_cells = np.flatnonzero(cells[simple] != cells[first])
    around[first[two_cells]] = walk(simple[two_cells], cells[first[two_cells]])
    crowded = np.flatnonzero(sides != 2)
    if len(crowded):
        fans = walk(crowded, np.full(len(crowded), -1, np.int32))
        total = np.bincount(winner[crowded], weights=fans, minlength=len(winner))
        around[winner[crowded]] = (total[winner[crowded]] / 2).astype(np.int32)
    return around
