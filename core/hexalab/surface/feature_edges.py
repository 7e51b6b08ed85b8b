"""Feature edges: where the boundary bends, told by the angle between the normals of the two faces that meet.

Angles are found once for each mesh and kept, so that another threshold is one comparison per edge of the boundary.
"""

from __future__ import annotations

from typing import NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats, Ids
from ..cells import FACES
from ..mesh import Mesh, cell_barycentres
from .edges import one_of_each

FLAT = 8 * np.finfo(np.float64).eps
"""A face is flat if its vector area is below that part of the product of its diagonals: its direction is rounding."""

_FACE_PLACES = np.array(FACES, dtype=np.intp)


class BoundaryEdges(NamedTuple):
    """The edges of the boundary's faces, each once, in no particular order.

    Attributes
    ----------
    vertices : (2, e) int32
        Smaller and larger vertex id.
    angles : (e,) float64
        Between the outward normals of the two faces, in degrees: 0 where the boundary goes straight on, 180 where it
        turns back. Infinite where other than two faces of the boundary meet; NaN where one of them has no normal.
    """

    vertices: Ids
    angles: Floats

    @property
    def nonmanifold_count(self) -> int:
        """Number of edges at which other than two faces of the boundary meet."""
        return int(np.isinf(self.angles).sum())


_KEPT: WeakKeyDictionary[Mesh, BoundaryEdges] = WeakKeyDictionary()


def sharp_edges(mesh: Mesh, angle_degrees: float) -> Ids:
    """Edges of the boundary at which it bends by more than an angle.

    Parameters
    ----------
    mesh : Mesh
        To be drawn it is `DrawnMesh.mesh`: cells that repeat others hide each other's boundary.
    angle_degrees : float
        Between the outward normals of both faces, 0 to 180.

    Returns
    -------
    (2, n) int32
        Smaller and larger vertex id of each. Those at which other than two faces of the boundary meet are always among
        them; `boundary_edge_angles(mesh).nonmanifold_count` tells how many.
    """
    vertices, angles = boundary_edge_angles(mesh)
    sharp: Ids = vertices[:, angles > angle_degrees]
    return sharp


def boundary_edge_angles(mesh: Mesh) -> BoundaryEdges:
    """Find the edges of the boundary and the angles at them; kept as long as the mesh is.

    The normal of a face is the cross of its diagonals, which is that of its mean plane. A face that is flat has the
    direction from its cell's barycentre to its own. Faces that have folded onto themselves (a b a c) part nothing and
    are left out. Of two faces that go round their edge the same way one belongs to a cell of opposite orientation, and
    its normal is turned.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    BoundaryEdges
    """
    kept = _KEPT.get(mesh)
    if kept is None:
        kept = _KEPT[mesh] = _find(mesh)
    return kept


def _find(mesh: Mesh) -> BoundaryEdges:
    cells, rings = _boundary_faces(mesh)
    face_count = len(cells)
    start: Ids = rings.reshape(-1)
    end: Ids = np.concatenate([rings[1:], rings[:1]]).reshape(-1)
    sides = np.flatnonzero(start != end)  # a triangle's fourth side is none
    start, end = start[sides], end[sides]
    winner = one_of_each(start, end)
    around = np.bincount(winner, minlength=len(winner))
    edges = np.flatnonzero(around)
    vertices = np.stack([np.minimum(start, end)[edges], np.maximum(start, end)[edges]])

    angles = np.full(len(edges), np.inf)
    two = np.flatnonzero(around[edges] == 2)
    first = edges[two]
    others = np.flatnonzero(winner != np.arange(len(winner)))
    partner = np.empty(len(winner), np.intp)
    partner[winner[others]] = others
    second = partner[first]
    normals = _normals(mesh, cells, rings)
    one, other = (normals[:, sides[side] % max(face_count, 1)] for side in (first, second))
    alike = start[first] == start[second]
    angles[two] = _angles(one, np.where(alike, -other, other))
    return BoundaryEdges(vertices, angles)


def _boundary_faces(mesh: Mesh) -> tuple[Ids, Ids]:
    """The cell of each face of the boundary, (N,), and its corners, (4, N): a triangle has one of them twice."""
    topology = mesh.topology
    rows = topology.faces.boundary
    cells: Ids = topology.face_cells[0, rows]
    places = _FACE_PLACES[topology.face_locals[0, rows]].T
    rings: Ids = mesh.corners[places, cells]
    a, b, c, d = rings
    folded = (a == c) | (b == d)
    if folded.any():
        cells, rings = cells[~folded], rings[:, ~folded]
    return cells, rings


def _normals(mesh: Mesh, cells: Ids, rings: Ids) -> Floats:
    """Unit normals of faces, (3, N) float64; NaN where a face has none."""
    near, _ = mesh.within_reach
    points = near.coordinates[:, rings]
    with np.errstate(all="ignore"):
        along, across = points[:, 2] - points[:, 0], points[:, 3] - points[:, 1]
        normals = _cross(along, across)
        size = _length(normals)
        flat = np.flatnonzero(~(size > FLAT * _length(along) * _length(across)))
        if len(flat):
            own = cells[flat]
            inner = cell_barycentres(near.coordinates, near.corners[:, own], near.kinds[own])
            normals[:, flat] = points[:, :, flat].mean(axis=1) - inner
            size[flat] = _length(normals[:, flat])
        normals /= size
    return normals


def _angles(one: Floats, other: Floats) -> Floats:
    """Angles between unit vectors (3, n) in degrees, exact to rounding from 0 to 180 (W. Kahan)."""
    with np.errstate(invalid="ignore"):
        halves: NDArray[np.float64] = np.arctan2(_length(one - other), _length(one + other))
    return np.degrees(2 * halves)


def _cross(one: Floats, other: Floats) -> Floats:
    (ax, ay, az), (bx, by, bz) = one, other
    return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


def _length(vectors: Array) -> Floats:
    x, y, z = vectors
    return np.asarray(np.sqrt(x * x + y * y + z * z))
