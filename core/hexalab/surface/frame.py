"""Which box of a mesh the drawing is centred on and scaled by."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, Floats
from ..mesh import Mesh, diagonal_of
from .records import Floats32

STRAY = 100
"""A part so many times smaller than the extent, though it is the largest, has the drawing for itself."""

SLABS = 16
"""Of the extent's longest side, to see whether there are gaps: no mesh of many cells has any but between its parts."""

LOOKED_AT = 16_384
"""Vertices that are looked at to see whether there are gaps."""

MOST = 131_072
"""Vertices of the boundary that stand for the body, at the most twice as many."""

SLENDER = 4
"""Spread along a body over that across, from which on it is a needle."""

BINS = 12
"""Directions from the centre are told apart by so many steps along each side of a cube around it."""

SLAB, FEW, FOOT, ELSEWHERE = 0.02, 0.01, 3.2, 1.5
"""Part of a body's longest side that is an end; of its points that even a bare end may hold; how many times more a foot
holds than the opposite end; and than the end where z begins, if the foot isn't there."""


@dataclass(frozen=True)
class Frame:
    """The box that drawing coordinates are made of: its centre is their origin, its diagonal their unit.

    Parameters
    ----------
    low, high : (3,) float64
        In the unit of the mesh.
    cells : int
        Cells within: all of the mesh, or those of its largest part.
    """

    low: Floats
    high: Floats
    cells: int

    @property
    def centre(self) -> Floats:
        """(3,) float64: middle of the box."""
        return np.asarray(self.low / 2 + self.high / 2)

    @property
    def diagonal(self) -> float:
        """Length of the box's diagonal; 1 for a single point."""
        return diagonal_of(self.low, self.high)


def frame_of(mesh: Mesh) -> Frame:
    """The box that a mesh is drawn by: its extent; of parts so far apart that none would be seen, the largest one's.

    That is the case of a mesh at map coordinates with a stray cell at their origin. The largest part is the one of
    most cells, connected over faces. Parts are looked for only where the longest side of the extent has gaps.
    """
    low, high = mesh.extent
    whole = Frame(low, high, mesh.cell_count)
    if not _has_gaps(mesh, low, high):
        return whole
    labels = mesh.topology.components
    sizes = np.bincount(labels)
    largest = int(sizes.argmax())
    corners = mesh.corners[:, labels == largest]
    part = mesh.coordinates[:, corners.reshape(-1)]
    own = Frame(part.min(axis=1), part.max(axis=1), int(sizes[largest]))
    return own if own.diagonal * STRAY < whole.diagonal else whole


def _has_gaps(mesh: Mesh, low: Floats, high: Floats) -> bool:
    """Whether one of `SLABS` slabs across the longest side holds no vertex, of those looked at."""
    axis = int((high / 2 - low / 2).argmax())
    half = high[axis] / 2 - low[axis] / 2
    if not half > 0:
        return False
    along: Array = mesh.coordinates[axis, :: max(1, mesh.vertex_count // LOOKED_AT)]
    share = (along / 2 - low[axis] / 2) / half
    slabs = (share[(share >= 0) & (share <= 1)] * SLABS).astype(np.int64)
    return bool((np.bincount(slabs, minlength=SLABS)[:SLABS] == 0).any())


def skin(mesh: Mesh, frame: Frame) -> Floats:
    """(3, n) float64 drawing coordinates of the boundary's vertices within the frame: nothing stands out of them.

    Of more than `MOST` every second, third, ... is taken.
    """
    topology = mesh.topology
    rows = topology.faces.boundary
    own = np.zeros(mesh.vertex_count, dtype=bool)
    own[topology.corners_of(topology.face_cells[0, rows], topology.face_locals[0, rows])] = True
    vertices = np.flatnonzero(own if topology.boundary_face_count else mesh.referenced)
    points = mesh.coordinates[:, vertices[:: max(1, len(vertices) // MOST)]]
    within = ((points >= frame.low[:, None]) & (points <= frame.high[:, None])).all(axis=0)
    return np.asarray((points[:, within] - frame.centre[:, None]) / frame.diagonal)


def outline(points: Floats) -> Floats32:
    """(n, 3) float32: points that stand for a body when a camera is fitted to it.

    In each of 6 x 12 x 12 directions from the centre it is the farthest one; of a body that has holes or arms
    nothing stands out of these by more than the margin of a picture.

    Parameters
    ----------
    points : (3, n) float64
        Drawing coordinates.
    """
    sizes = np.abs(points)
    axis = sizes.argmax(axis=0)
    each = np.arange(points.shape[1])
    largest = points[axis, each]
    with np.errstate(invalid="ignore", divide="ignore"):
        u, v = (np.nan_to_num(points[(axis + step) % 3, each] / np.abs(largest)) for step in (1, 2))
    steps = [np.minimum(((part + 1) / 2 * BINS).astype(np.int64), BINS - 1) for part in (u, v)]
    direction = ((2 * axis + (largest > 0)) * BINS + steps[0]) * BINS + steps[1]
    nearest_first = np.argsort((points * points).sum(axis=0), kind="stable")
    farthest = np.full(6 * BINS * BINS, -1)
    farthest[direction[nearest_first]] = nearest_first  # the last one stays
    return np.ascontiguousarray(points[:, farthest[farthest >= 0]].T, dtype=np.float32)


def long_axis(points: Floats) -> Floats | None:
    """(3,) float64 unit vector along a body several times longer than wide, such as a needle; None for others.

    It is the first principal axis of the points, (3, n).
    """
    if points.shape[1] < 2:
        return None
    aside = points - points.mean(axis=1)[:, None]
    spread, axes = np.linalg.eigh([[float((a * b).sum()) for b in aside] for a in aside])
    return np.asarray(axes[:, 2]) if spread[2] > SLENDER**2 * spread[1] else None


def upward(points: Floats) -> str:
    """The axis along which a body stands, as far as its points tell: "z" unless it has a foot elsewhere.

    A foot is an end of the body, `SLAB` of its longest side thick, that holds a good share of the points, and much more
    than the opposite end does. Most machine parts have none, since both of their ends are flat: of these z points up.

    Parameters
    ----------
    points : (3, n) float64
        Of the boundary.

    Returns
    -------
    str
        "z", "y", "x", "-z", "-y" or "-x".
    """
    if not points.shape[1]:
        return "z"
    low, high = points.min(axis=1), points.max(axis=1)
    slab = SLAB * float((high - low).max())
    feet = {}
    for name, at in (("z", 2), ("y", 1), ("x", 0)):
        ends = [float(np.mean(points[at] <= low[at] + slab)), float(np.mean(points[at] >= high[at] - slab))]
        feet[name] = ends[0] if ends[0] > FOOT * max(ends[1], FEW) else 0.0
        feet[f"-{name}"] = ends[1] if ends[1] > FOOT * max(ends[0], FEW) else 0.0
    found = max(feet, key=lambda name: feet[name])  # of equal ones the first
    standing = float(np.mean(points[2] <= low[2] + slab))
    return found if feet[found] > ELSEWHERE * standing else "z"
