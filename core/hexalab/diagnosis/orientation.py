"""Which way round cells are: signed volumes, Jacobians at corners, and turning a mesh round."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats
from ..cells import COLLAPSE, CORNERS_OF_KIND, FACES, HEXAHEDRON, KINDS
from ..mesh import Mesh

CHUNK = 8192
"""Cells in a chunk: some seventy temporaries of it stay in the cache."""

FIRST = 64
"""Cells that are looked at before all others: in a mesh that is not inverted, one of them tells."""

ROUNDING = 1e-12
"""A determinant below this part of the product of its vectors' lengths is zero."""

TURNED = "Every cell was inverted (negative volume): the mesh has been turned round."
"""Note of a mesh that `turn_round` has changed."""

NODES = (
    (
        (0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7),
        (4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2), (7, 6, 4, 3),
    ),
    ((0, 2, 1, 3), (1, 0, 2, 4), (2, 1, 0, 5), (3, 4, 5, 0), (4, 5, 3, 1), (5, 3, 4, 2)),
    ((0, 1, 3, 4), (1, 2, 0, 4), (2, 3, 1, 4), (3, 0, 2, 4)),
    ((0, 1, 2, 3),),
)  # fmt: skip
"""For each kind, corners with three edges: the corner and its right-handed neighbours, by own corners."""

MIRROR = ((0, 3, 2, 1, 4, 7, 6, 5), (0, 2, 1, 3, 5, 4), (0, 3, 2, 1, 4), (0, 2, 1, 3))
"""For each kind, its own corners in an order of the other orientation."""


class Signs(NamedTuple):
    """What signs tell of each cell.

    Attributes
    ----------
    volume : (C,) int8
        Sign of the volume: 0 if it is zero but for rounding.
    invalid_corner : (C,) bool
        Whether the Jacobian is zero or negative at a corner.
    """

    volume: NDArray[np.int8]
    invalid_corner: NDArray[np.bool_]


@np.errstate(all="ignore")
def signs(mesh: Mesh) -> Signs:
    """Signs of the volume and of the Jacobians at corners of all cells.

    The volume is that within the six bilinear faces. Corners are those of `NODES`; where a hexahedron repeats
    vertices, a corner at which two of the four vertices are one has no Jacobian and is passed over.
    """
    mesh, _ = mesh.within_reach
    volume = np.empty(mesh.cell_count, np.int8)
    invalid = np.zeros(mesh.cell_count, dtype=bool)
    mixed, reach = bool(mesh.kinds.any()), _reach(mesh.extent)
    for start in range(0, mesh.cell_count, CHUNK):
        part = slice(start, start + CHUNK)
        corners, kinds = mesh.corners[:, part], mesh.kinds[part]
        points = _points(mesh, corners)
        size = _size(points)
        volume[part] = _volume_signs(points, size, reach)
        for kind in np.unique(kinds).tolist() if mixed else (HEXAHEDRON,):
            own = CORNERS_OF_KIND[kind]
            if not mixed:
                invalid[part] = _invalid(points, size, corners, own, NODES[kind])
                continue
            which = np.flatnonzero(kinds == kind)
            of_kind = [points[:, place, which] for place in range(8)]
            invalid[part][which] = _invalid(
                np.stack(of_kind, axis=1), size[which], corners[:, which], own, NODES[kind]
            )
    return Signs(volume, invalid)


def _points(mesh: Mesh, corners: Array) -> Floats:
    """(3, 8, N) corners of cells, seen from the first."""
    points = np.empty((3, *corners.shape))
    for axis, coordinate in enumerate(mesh.coordinates):
        first = coordinate[corners[0]]
        points[axis, 0] = 0
        for place in range(1, 8):
            np.subtract(coordinate[corners[place]], first, out=points[axis, place])
    return points


def _size(points: Floats) -> Floats:
    """A length that no edge of the cell exceeds, quick to have: most determinants are far from zero by it."""
    size = np.zeros(points.shape[2])
    for axis in points:
        for place in axis[1:]:
            size += np.abs(place)
    return size


def _reach(coordinates: Floats) -> float:
    """How far from the origin coordinates lie, which bounds their rounding."""
    return max(float(coordinates.max(initial=0)), -float(coordinates.min(initial=0)))


def _volume_signs(points: Floats, size: Floats, reach: float) -> NDArray[np.int8]:
    """Sign of the volume of cells.

    A bilinear face a b c d and the origin enclose (a + b + c + d) . ((c - a) x (d - b)) / 24.
    """
    total = np.zeros(points.shape[2])
    for a, b, c, d in FACES:
        middle = points[:, a] + points[:, b]
        middle += points[:, c]
        middle += points[:, d]
        total += _det(middle, points[:, c] - points[:, a], points[:, d] - points[:, b])
    total /= 24
    found = (total > 0).astype(np.int8)
    found -= total < 0
    rounding = 4 * np.finfo(np.float64).eps * reach if np.isfinite(reach) else 0.0
    small = np.flatnonzero(~(np.abs(total) > ROUNDING * size**3 + rounding * size**2))
    if len(small):
        x, y, z = (_principal(points[:, :, small], axis) for axis in range(3))
        least = ROUNDING * (x * y * z) + rounding * (x * y + y * z + z * x)
        found[small[~(np.abs(total[small]) > least)]] = 0
    return found


def _principal(points: Floats, axis: int) -> Floats:
    """Mean length of the cell along one of its own three axes."""
    starts, ends = (((0, 3, 4, 7), (1, 2, 5, 6)), ((0, 1, 4, 5), (3, 2, 7, 6)), ((0, 1, 2, 3), (4, 5, 6, 7)))[
        axis
    ]
    total = np.zeros(points.shape[2])
    for start, end in zip(starts, ends, strict=True):
        total += _length(points[:, end] - points[:, start])
    return total / 4


def _invalid(
    points: Floats, size: Floats, corners: Array, own: tuple[int, ...], nodes: tuple[tuple[int, ...], ...]
) -> NDArray[np.bool_]:
    """Whether a Jacobian is not positive at one of the nodes; `own` are the places of the corners."""
    out = np.zeros(points.shape[2], dtype=bool)
    most = ROUNDING * size**3
    for row in nodes:
        node, *others = (own[place] for place in row)
        u, v, w = (points[:, other] - points[:, node] for other in others)
        det = _det(u, v, w)
        small = np.flatnonzero(~(det > most))
        if not len(small):
            continue
        least = ROUNDING * (_length(u[:, small]) * _length(v[:, small]) * _length(w[:, small]))
        four = np.sort(corners[[node, *others]][:, small], axis=0)
        apart = (four[1:] != four[:-1]).all(axis=0)
        out[small[apart & ~(det[small] > least)]] = True
    return out


def _det(u: Floats, v: Floats, w: Floats) -> Floats:
    total = v[1] * w[2]
    total -= v[2] * w[1]
    total *= u[0]
    term = v[2] * w[0]
    term -= v[0] * w[2]
    term *= u[1]
    total += term
    term = v[0] * w[1]
    term -= v[1] * w[0]
    term *= u[2]
    total += term
    return np.asarray(total)


def _length(u: Floats) -> Floats:
    return np.asarray(np.sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]))


@np.errstate(all="ignore")
def all_inverted(mesh: Mesh) -> bool:
    """Whether cells have negative volumes only, or none; the first positive one ends the search."""
    if _begins_upright(mesh):
        return False
    mesh, _ = mesh.within_reach
    negative, reach = False, _reach(mesh.extent)
    for start in range(0, mesh.cell_count, CHUNK):
        found = _signs_of(mesh, slice(start, start + CHUNK), reach)
        if (found > 0).any():
            return False
        negative = negative or bool((found < 0).any())
    return negative


def _begins_upright(mesh: Mesh) -> bool:
    """Whether one of the first cells is positive for certain.

    They are judged by the reach of all vertices, which costs much less than to look which of them cells use,
    and which finds no cell positive that is not: the rounding it allows is the larger.
    """
    reach = _reach(mesh.coordinates)
    return np.isfinite(reach) and bool((_signs_of(mesh, slice(0, FIRST), reach) > 0).any())


def _signs_of(mesh: Mesh, part: slice, reach: float) -> NDArray[np.int8]:
    """Sign of the volume of a stretch of cells."""
    points = _points(mesh, mesh.corners[:, part])
    return _volume_signs(points, _size(points), reach)


def turn_round(mesh: Mesh) -> Mesh:
    """Turn every cell of a mesh whose cells are all inverted, and note it; another mesh comes back as it is.

    Tools differ in which side of a hexahedron they number first; a mesh from one that differs is inverted as
    a whole.
    """
    if not all_inverted(mesh):
        return mesh
    corners = mesh.corners.copy()
    for kind in range(len(KINDS)):
        which = np.flatnonzero(mesh.kinds == kind)
        own = mesh.corners[:, which][list(CORNERS_OF_KIND[kind])]
        corners[:, which] = own[list(MIRROR[kind])][list(COLLAPSE[kind])]
    return replace(mesh, corners=corners, notes=[*mesh.notes, TURNED])
