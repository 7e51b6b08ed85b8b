"""Fissures: cells shrink at their exposed corners, and gaps open between them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..cells import FACES
from .collapse import first_places
from .drawn_mesh import DrawnMesh
from .exposure import ExposedCells, exposed_cells
from .flat import flat_surface
from .records import Floats32, Surface

_PLACES = np.array(FACES, np.intp)
_BITS = [np.uint8(sum(1 << place for place in ring)) for ring in FACES]


def fissure(drawn_mesh: DrawnMesh, shown: NDArray[np.bool_], gap: float = 0.15) -> Surface:
    """Surface with a gap around each cell (the paper's section on mesh extraction in fissure mode).

    Every face with an exposed corner is drawn, from each of its cells. Exposed corners go towards the
    barycentre of their cell; the others stay, so that the gaps close inwards and the surface is closed.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    shown : (C,) bool
    gap : float
        How far exposed corners go: 0 nowhere, 1 all the way. The original's slider gives 0.04 to 0.2.
    """
    found = exposed_cells(drawn_mesh, shown)
    count = len(found.cells)
    points = _shrunk(found, gap)

    owner = [np.flatnonzero(found.codes & bits) for bits in _BITS]
    local = np.repeat(np.arange(6), [len(part) for part in owner])
    which = np.concatenate(owner)
    rows = drawn_mesh.topology.cell_faces.reshape(-1)[local * drawn_mesh.mesh.cell_count + found.cells[which]]
    if rows.size and rows.min() < 0:
        kept = np.flatnonzero(rows >= 0)
        local, which, rows = local[kept], which[kept], rows[kept]
    places = np.stack([_PLACES[:, i][local] for i in range(4)])
    places *= count
    places += which
    _close_triangles(places, found.corners.reshape(-1))
    quads = np.empty((3, 4, len(which)), np.float32)
    for axis in range(3):
        quads[axis] = points[axis].reshape(-1)[places]
    inside = drawn_mesh.exposed(rows)
    return flat_surface(drawn_mesh, "fissure", quads, found.cells[which], local, inside)


def _shrunk(found: ExposedCells, gap: float) -> Floats32:
    """Corners, (3, 8, n), the exposed ones moved towards the mean of the cell's distinct corners."""
    first = first_places(found.corners)
    points = found.points.copy()
    weights = [((found.codes >> np.uint8(place)) & np.uint8(1)) * np.float32(gap) for place in range(8)]
    for axis in points:
        if first is None:
            middle = axis.sum(axis=0) / np.float32(8)
        else:
            own = first == np.arange(8, dtype=np.uint8)[:, None]
            middle = (axis * own).sum(axis=0) / own.sum(axis=0, dtype=np.float32)
        for place in range(8):
            axis[place] += weights[place] * (middle - axis[place])
    return points


def _close_triangles(places: NDArray[np.intp], vertices: NDArray[np.int32]) -> None:
    """Turn rings (4, N), in place, so that two neighbours that are the same vertex stand last."""
    ids = vertices[places]
    for i in (3, 0, 1):
        same = np.flatnonzero(ids[i] == ids[(i + 1) % 4])
        if len(same):
            places[:, same] = np.roll(places[:, same], 2 - i, axis=0)
            ids[:, same] = np.roll(ids[:, same], 2 - i, axis=0)
