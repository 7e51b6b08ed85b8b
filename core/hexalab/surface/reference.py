"""A reference surface over the mesh: what it is compared with."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats, Ids
from .flat import flat_quads
from .frame import Frame
from .records import Silhouette


def extract_reference(points: Floats, triangles: Ids, frame: Frame) -> Silhouette:
    """Triangles in drawing coordinates of a mesh, as quads that repeat their last vertex.

    Parameters
    ----------
    points : (3, V) float64
    triangles : (3, T) int32
    frame : Frame
        Of the mesh over which they are drawn.
    """
    placed = ((points - frame.centre[:, None]) / frame.diagonal).astype(np.float32)

    def middle(which: NDArray[np.intp]) -> Array:
        return np.zeros((3, len(which)), np.float32)  # what has no area shows no side

    return Silhouette(*flat_quads(placed[:, triangles[[0, 1, 2, 2]]], middle))
