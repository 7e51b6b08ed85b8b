"""Which way round cells are: signed volumes, Jacobians at corners, and turning a mesh round."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..mesh import COLLAPSE, CORNERS_OF_KIND, FACES, HEXAHEDRON, KINDS, Array, Floats, Mesh

CHUNK = 16384
"""Cells in a chunk: some seventy temporaries of it stay in the cache."""

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


def signs(mesh: Mesh) -> Signs:
    """Signs of the volume and of the Jacobians at corners of all cells.

    The volume is that within the six bilinear faces. Corners are those of `NODES`; where a hexahedron repeats
    vertices, a corner at which two of the four vertices are one has no Jacobian and is passed over.
    """
    volume = np.empty(mesh.cell_count, np.int8)
    invalid = np.zeros(mesh.cell_count, dtype=bool)
    reach = float(np.abs(mesh.extent).max())
    mixed = bool(mesh.kinds.any())
    with np.errstate(all="ignore"):
        for start in range(0, mesh.cell_count, CHUNK):
            part = slice(start, start + CHUNK)
            corners = mesh.corners[:, part]
            points = mesh.coordinates[:, corners]
            volume[part] = _volume_signs(points, reach)
            for kind in np.unique(mesh.kinds[part]) if mixed else (HEXAHEDRON,):
                of_kind: Any = np.flatnonzero(mesh.kinds[part] == kind) if mixed else slice(None)
                own = np.array(CORNERS_OF_KIND[kind])
                invalid[part][of_kind] = _invalid(
                    points[:, own][:, :, of_kind], corners[own][:, of_kind], NODES[kind]
                )
    return Signs(volume, invalid)


def _volume_signs(points: Floats, reach: float) -> NDArray[np.int8]:
    """Sign of the volume of cells, (3, 8, N) corners; `reach` bounds the coordinates, and so their rounding.

    A bilinear face a b c d and the origin enclose (a + b + c + d) . ((c - a) x (d - b)) / 24.
    """
    points = points - points[:, :1]
    total = np.zeros(points.shape[2])
    for a, b, c, d in FACES:
        middle = points[:, a] + points[:, b]
        middle += points[:, c]
        middle += points[:, d]
        total += _det(middle, points[:, c] - points[:, a], points[:, d] - points[:, b])
    total /= 24
    x, y, z = (_principal(points, axis) for axis in range(3))
    least = ROUNDING * (x * y * z) + 4 * np.finfo(np.float64).eps * reach * (x * y + y * z + z * x)
    found: NDArray[np.int8] = np.sign(total).astype(np.int8)
    found[~(np.abs(total) > least)] = 0
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
    points: Floats, corners: Array, nodes: tuple[tuple[int, int, int, int], ...]
) -> NDArray[np.bool_]:
    """Whether a Jacobian is zero or negative at one of the nodes of cells, (3, k, N) own corners."""
    out = np.zeros(points.shape[2], dtype=bool)
    for node, *others in nodes:
        u, v, w = (points[:, other] - points[:, node] for other in others)
        bad = ~(_det(u, v, w) > ROUNDING * (_length(u) * _length(v) * _length(w)))
        if bad.any():
            where = np.flatnonzero(bad)
            four = np.sort(corners[[node, *others]][:, where], axis=0)
            bad[where[(four[1:] == four[:-1]).any(axis=0)]] = False
        out |= bad
    return out


def _det(u: Floats, v: Floats, w: Floats) -> Floats:
    total = u[0] * (v[1] * w[2] - v[2] * w[1])
    total += u[1] * (v[2] * w[0] - v[0] * w[2])
    total += u[2] * (v[0] * w[1] - v[1] * w[0])
    return np.asarray(total)


def _length(u: Floats) -> Floats:
    return np.asarray(np.sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]))


def all_inverted(mesh: Mesh) -> bool:
    """Whether cells have negative volumes only, or none; the first positive one ends the search."""
    reach = float(np.abs(mesh.extent).max())
    negative = False
    with np.errstate(all="ignore"):
        for start in range(0, mesh.cell_count, CHUNK):
            found = _volume_signs(mesh.coordinates[:, mesh.corners[:, start : start + CHUNK]], reach)
            if (found > 0).any():
                return False
            negative = negative or bool((found < 0).any())
    return negative


def turn_round(mesh: Mesh) -> Mesh:
    """Turn every cell of a mesh whose cells are all inverted, and note it; any other mesh is returned as it
    is.

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
