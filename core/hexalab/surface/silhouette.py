"""Silhouette: the boundary faces of the cells that filters hide."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .drawn_mesh import DrawnMesh
from .flat import flat_quads
from .records import Silhouette


def extract_silhouette(drawn_mesh: DrawnMesh, shown: NDArray[np.bool_]) -> Silhouette:
    """Boundary faces of hidden cells, outward.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    shown : (C,) bool
    """
    faces = drawn_mesh.topology.faces
    hidden = np.flatnonzero(~shown[faces.cells[0, faces.boundary]]) + faces.boundary.start
    hidden = hidden[~drawn_mesh.exposed(hidden)]
    cells, local = faces.cells[0, hidden], faces.locals[0, hidden]
    points = drawn_mesh.points(drawn_mesh.topology.corners_of(cells, local))
    return Silhouette(*flat_quads(points, lambda which: drawn_mesh.barycentres(cells[which])))
