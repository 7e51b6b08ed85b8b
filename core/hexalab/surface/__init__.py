"""Surfaces: a module for each separation mode; silhouette; irregular and sharp edges; arrows; what shows structure."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .arrows import VectorField, extract_arrows
from .darkness_coded_edges import darkness_coded_edges
from .drawn_mesh import DrawnMesh
from .dual import dual_surface, walls
from .exploded import ExplodedMesh, Pieces
from .feature_edges import BoundaryEdges, boundary_edge_angles, sharp_edges
from .fissure import fissure
from .frame import Frame, long_axis, outline, skin, upward
from .irregular import extract_irregular
from .lines import interface_quads, lines
from .records import NO_SILHOUETTE, Arrows, Irregular, Silhouette, Surface
from .reference import extract_reference
from .rounded import rounded
from .silhouette import extract_silhouette

__all__ = [
    "LINED",
    "MODES",
    "NO_SILHOUETTE",
    "Arrows",
    "BoundaryEdges",
    "DrawnMesh",
    "ExplodedMesh",
    "Frame",
    "Irregular",
    "Pieces",
    "Silhouette",
    "Surface",
    "VectorField",
    "boundary_edge_angles",
    "dual_surface",
    "extract_arrows",
    "extract_irregular",
    "extract_reference",
    "extract_silhouette",
    "extract_surface",
    "long_axis",
    "outline",
    "sharp_edges",
    "skin",
    "upward",
    "walls",
]

MODES = ("lines", "darkness_coded_edges", "fissure", "rounded")
"""The separation modes."""

LINED = ("lines", "darkness_coded_edges")
"""Those that draw lines."""


def extract_surface(
    drawn_mesh: DrawnMesh,
    shown: NDArray[np.bool_],
    mode: str = "lines",
    gap: float = 0.15,
    radius: float = 0.075,
    edges: bool = True,
) -> Surface:
    """The surface of the shown cells.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
        Made once for each mesh.
    shown : (C,) bool
    mode : str
        One of `MODES`.
    gap : float
        Of fissures: how far exposed corners go towards their cell's barycentre, 0 to 1.
    radius : float
        Of roundings, over the length of the edge, 0 to 0.5.
    edges : bool
        Whether lines are wanted where the mode has them: they cost as much as the rest.

    Raises
    ------
    ValueError
        If there is no such mode.
    """
    if mode in LINED and not edges:
        return interface_quads(drawn_mesh, shown, mode)
    if mode == "lines":
        return lines(drawn_mesh, shown)
    if mode == "darkness_coded_edges":
        return darkness_coded_edges(drawn_mesh, shown)
    if mode == "fissure":
        return fissure(drawn_mesh, shown, gap)
    if mode == "rounded":
        return rounded(drawn_mesh, shown, radius)
    raise ValueError(f"no separation mode {mode!r}; there are {', '.join(MODES)}")
