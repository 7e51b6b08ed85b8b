"""Coincident vertices: different ids at one place, which part cells that look joined."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Floats, Ids
from ..mesh import Mesh

TOLERANCE = 1e-9
"""Vertices nearer than this part of the mesh's diagonal are at one place."""

DIRECTIONS = (
    (0.5773502691896258, 0.6180339887498949, 0.5337605129462457),
    (-0.7390851332151607, 0.5671432904097838, 0.3634217676852149),
    (0.2807764064044152, -0.6922006275553464, 0.6648271123870012),
)
"""Three directions in general position, along which the points of a grid fall apart."""


def coincident_vertices(mesh: Mesh) -> Ids:
    """Ids of the vertices that another vertex of a cell coincides with, ascending.

    Vertices at one place have one position along any direction. After sorting along a first direction only
    those with a near neighbour are left, hardly more than what is looked for; a second and a third direction
    settle it.
    """
    mesh, _ = mesh.within_reach
    ids: Array = np.flatnonzero(mesh.referenced)
    near = TOLERANCE * mesh.diagonal
    run: Array = np.zeros(len(ids), np.int32)
    for direction in DIRECTIONS:
        along = _along(mesh.coordinates, ids, direction)
        order = np.argsort(along) if run.max(initial=0) == 0 else np.lexsort((along, run))
        ids, run, along = ids[order], run[order], along[order]
        joined = (np.diff(along) <= near) & (run[1:] == run[:-1])
        kept = np.zeros(len(ids), dtype=bool)
        kept[1:] |= joined
        kept[:-1] |= joined
        starts = np.ones(len(ids), dtype=bool)
        starts[1:] = ~joined
        run = np.cumsum(starts, dtype=np.int32)[kept]
        ids = ids[kept]
    return np.sort(ids).astype(np.int32)


def _along(coordinates: Floats, ids: Array, direction: tuple[float, float, float]) -> Floats:
    x, y, z = direction
    whole = len(ids) == coordinates.shape[1]
    px, py, pz = coordinates if whole else coordinates[:, ids]
    along: Floats = px * x
    along += py * y
    along += pz * z
    return along
