"""Lines: the faces of the interface as they are, and their edges."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..topology import Interface
from .buffers import Bytes, Floats32, Surface
from .drawing import Drawing
from .edges import one_of_each, quad_sides
from .flat import NO_COUNTS, NO_LINES, flat_surface, interleave


def lines(drawing: Drawing, shown: NDArray[np.bool_]) -> Surface:
    """Surface with plain edges.

    Parameters
    ----------
    drawing : Drawing
    shown : (C,) bool
    """
    interface = drawing.topology.interface(shown)
    corners = drawing.topology.corners_of(interface.cells, interface.locals)
    start, end, _ = quad_sides(corners)
    drawn = np.flatnonzero(one_of_each(start, end) == np.arange(len(start)))
    edges = edge_lines(drawing, start[drawn], end[drawn])
    return interface_surface(drawing, "lines", interface, corners, edges, NO_COUNTS)


def interface_quads(drawing: Drawing, shown: NDArray[np.bool_], mode: str) -> Surface:
    """Surface of a mode that draws lines, without them."""
    interface = drawing.topology.interface(shown)
    corners = drawing.topology.corners_of(interface.cells, interface.locals)
    return interface_surface(drawing, mode, interface, corners, NO_LINES, NO_COUNTS)


def interface_surface(
    drawing: Drawing, mode: str, interface: Interface, corners: Ids, edges: Floats32, edge_cells: Bytes
) -> Surface:
    """Flat quads of an interface, (4, Q) corners, with edges already found."""
    points = drawing.points(corners)
    inside = exposed_by_filters(drawing, interface.rows)
    return flat_surface(drawing, mode, points, interface.cells, interface.locals, inside, edges, edge_cells)


def exposed_by_filters(drawing: Drawing, rows: Array) -> NDArray[np.bool_]:
    """Which faces, by their rows, are not the mesh's own boundary."""
    faces = drawing.topology.faces
    return np.asarray((rows < faces.paired) | (rows >= faces.boundary_end))


def edge_lines(drawing: Drawing, start: Ids, end: Ids) -> Floats32:
    """(6 E,) end points of edges."""
    return interleave(drawing.points(np.stack([start, end])))
