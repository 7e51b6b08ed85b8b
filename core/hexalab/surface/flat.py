"""Flat quads, four vertices each: the form that lines, fissures and the silhouette share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from .drawn_mesh import DrawnMesh
from .normals import pack, quad_normals
from .records import Bytes, Floats32, Int16s, Surface, UInt32s

NO_LINES: Floats32 = np.empty(0, np.float32)
NO_COUNTS: Bytes = np.empty(0, np.uint8)
NO_FACES: UInt32s = np.empty(0, np.uint32)


class Edges(NamedTuple):
    """The lines of a surface, as `Surface` describes them."""

    edges: Floats32 = NO_LINES
    edge_cells: Bytes = NO_COUNTS
    edge_faces: UInt32s = NO_FACES


NO_EDGES = Edges()


def flat_surface(
    drawn_mesh: DrawnMesh,
    mode: str,
    points: Floats32,
    cells: Array,
    local: Array,
    inside: NDArray[np.bool_],
    edges: Edges = NO_EDGES,
) -> Surface:
    """Surface of flat quads.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    mode : str
    points : (3, 4, Q) float32
        Axis, corner, quad, counter-clockwise as seen from outside; a triangle repeats its last corner.
    cells, local : (Q,) int
        Cell of each quad, and which of its faces it is.
    inside : (Q,) bool
        Whether filters expose it.
    edges : Edges
    """
    positions, normals = flat_quads(points, lambda which: drawn_mesh.barycentres(cells[which]))
    own = cells.astype(np.uint32)
    return Surface(
        mode=mode,
        positions=positions,
        normals=normals,
        cells=fourfold(own),
        inside=fourfold(inside.view(np.uint8) * np.uint8(255)),
        quads=None,
        faces=own * np.uint32(8) + local.astype(np.uint32),
        **edges._asdict(),
    )


def flat_quads(
    points: Floats32, inner_points: Callable[[NDArray[np.intp]], Array]
) -> tuple[Floats32, Int16s]:
    """Positions (12 Q,) and normals (16 Q,) of (3, 4, Q) points, with one normal for each quad."""
    normals = pack(quad_normals(points, inner_points))
    return interleave(points), fourfold(normals.view(np.int64).reshape(-1)).view(np.int16)


def interleave(points: Floats32) -> Floats32:
    """(3, k, N) points as one flat array: for each N the k points, x y z each."""
    axes, places, count = points.shape
    out = np.empty((count, places, axes), np.float32)
    for place in range(places):
        for axis in range(axes):
            out[:, place, axis] = points[axis, place]
    return out.reshape(-1)


def fourfold(values: NDArray[Any]) -> NDArray[Any]:
    """Each value four times, for the four vertices of its quad."""
    out = np.empty((len(values), 4), values.dtype)
    out[:] = values[:, None]
    return out.reshape(-1)
