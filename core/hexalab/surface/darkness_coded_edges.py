"""Darkness-coded edges: the faces of the interface, and for each edge how many shown cells lie around it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids
from .drawn_mesh import DrawnMesh
from .edges import Indices, faces_beside, one_of_each, quad_sides
from .fan import Walks, fan_sizes
from .flat import Edges
from .lines import edge_lines, interface_surface
from .records import Surface


def darkness_coded_edges(drawn_mesh: DrawnMesh, shown: NDArray[np.bool_]) -> Surface:
    """Surface with edges that know the number of shown cells around them.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    shown : (C,) bool
    """
    interface = drawn_mesh.topology.interface(shown)
    corners = drawn_mesh.topology.corners_of(interface.cells, interface.locals)
    start, end, side = quad_sides(corners)
    winner = one_of_each(start, end)
    drawn = np.flatnonzero(winner == np.arange(len(winner)))

    place, quad = np.divmod(side, max(corners.shape[1], 1))
    place[(corners[2] == corners[3])[quad]] = -1
    local = interface.locals[quad].astype(np.intp)
    walks = Walks(interface.cells[quad], local, place, start, end)
    around = _cells_around(drawn_mesh, shown, walks, winner)
    edges = Edges(
        edges=edge_lines(drawn_mesh, start[drawn], end[drawn]),
        edge_cells=np.minimum(around[drawn], 255).astype(np.uint8),
        edge_faces=faces_beside(winner, drawn, quad),
    )
    return interface_surface(drawn_mesh, "darkness_coded_edges", interface, corners, edges)


def _cells_around(drawn_mesh: DrawnMesh, shown: NDArray[np.bool_], sides: Walks, winner: Indices) -> Ids:
    """Number of shown cells around the edge of each side that stands for its edge.

    An edge that two quads share has one fan, from one quad's cell to the other's. Where more meet, each fan
    is walked from both its ends and counts by halves. Cells that close a ring of their own around the same
    edge, apart from the surface, do not count: only in a mesh that does not meet face to face are there such.
    """
    quads = np.bincount(winner, minlength=len(winner))[winner]
    around = np.ones(len(winner), np.int32)
    simple = np.flatnonzero((quads == 2) & (winner != np.arange(len(winner))))
    from_cell, to_cell = sides.cells[simple], sides.cells[winner[simple]]
    apart = np.flatnonzero(from_cell != to_cell)
    simple = simple[apart]
    around[winner[simple]] = fan_sizes(drawn_mesh.topology, shown, sides.part(simple), to_cell[apart])
    crowded = np.flatnonzero(quads != 2)
    if len(crowded):
        nowhere = np.full(len(crowded), -1, np.int32)
        fans = fan_sizes(drawn_mesh.topology, shown, sides.part(crowded), nowhere)
        total = np.bincount(winner[crowded], weights=fans, minlength=len(winner))
        around[winner[crowded]] = (total[winner[crowded]] / 2).astype(np.int32)
    return around
