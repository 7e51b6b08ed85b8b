"""Silhouette: the boundary faces of the cells that filters hide."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .buffers import Silhouette
from .drawing import Drawing
from .flat import flat_quads


def extract_silhouette(drawing: Drawing, shown: NDArray[np.bool_]) -> Silhouette:
    """Boundary faces of hidden cells, outward.

    Parameters
    ----------
    drawing : Drawing
    shown : (C,) bool
    """
    faces = drawing.topology.faces
    hidden = np.flatnonzero(~shown[faces.cells[0, faces.boundary]])
    cells, local = faces.cells[0, faces.boundary][hidden], faces.locals[0, faces.boundary][hidden]
    points = drawing.points(drawing.topology.corners_of(cells, local))
    return Silhouette(*flat_quads(points, lambda which: drawing.barycentres(cells[which])))
