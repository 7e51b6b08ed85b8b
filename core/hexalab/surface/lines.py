"""Lines: the faces of the interface as they are, and their edges."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids
from ..topology import Interface
from .drawn_mesh import DrawnMesh
from .edges import faces_beside, one_of_each, quad_sides
from .flat import NO_EDGES, Edges, flat_surface, interleave
from .records import Floats32, Surface


def lines(drawn_mesh: DrawnMesh, shown: NDArray[np.bool_]) -> Surface:
    """Surface with plain edges.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    shown : (C,) bool
    """
    interface = drawn_mesh.topology.interface(shown)
    corners = drawn_mesh.topology.corners_of(interface.cells, interface.locals)
    start, end, side = quad_sides(corners)
    winner = one_of_each(start, end)
    drawn = np.flatnonzero(winner == np.arange(len(start)))
    quad = side % max(corners.shape[1], 1)
    edges = Edges(
        edges=edge_lines(drawn_mesh, start[drawn], end[drawn]),
        edge_faces=faces_beside(winner, drawn, quad),
    )
    return interface_surface(drawn_mesh, "lines", interface, corners, edges)


def interface_quads(drawn_mesh: DrawnMesh, shown: NDArray[np.bool_], mode: str) -> Surface:
    """Surface of a mode that draws lines, without them."""
    interface = drawn_mesh.topology.interface(shown)
    corners = drawn_mesh.topology.corners_of(interface.cells, interface.locals)
    return interface_surface(drawn_mesh, mode, interface, corners)


def interface_surface(
    drawn_mesh: DrawnMesh, mode: str, interface: Interface, corners: Ids, edges: Edges = NO_EDGES
) -> Surface:
    """Flat quads of an interface, (4, Q) corners, with edges already found."""
    points = drawn_mesh.points(corners)
    inside = drawn_mesh.exposed(interface.rows)
    return flat_surface(drawn_mesh, mode, points, interface.cells, interface.locals, inside, edges)


def edge_lines(drawn_mesh: DrawnMesh, start: Ids, end: Ids) -> Floats32:
    """(6 E,) end points of edges."""
    return interleave(drawn_mesh.points(np.stack([start, end])))
