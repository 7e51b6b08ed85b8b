"""Faces of the boundary that lie on faces of another group without being joined to them (SPEC R12).

A face lies on another if its middle does: within the other's outline, no further from its plane than a small part of
its size, the two looking at each other. So parts are found that were meshed apart, whether their faces match or not.

Faces are sorted into cubes whose side is the power of two above their own size, so that each lies in few; a middle
looks into the one cube of each size that it lies in.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .arrays import Array, Floats, Ids
from .mesh import Mesh

NEAR = 0.05
"""Part of a face's size by which another may stand off it: faces of two meshes of one curved surface do."""

OPPOSITE = -0.5
"""Cosine of the angle between the normals of faces that look at each other, at the most."""

EDGE = 1e-9
"""Part of a triangle's area by which a point may lie beyond its edge: rounding."""

BITS = 21
"""Of a cube's number along each axis."""


class Sides(NamedTuple):
    """Faces of the boundary of labelled cells.

    Attributes
    ----------
    labels : (n,) int32
    corners : (4, 3, n) float64
        A triangle repeats its last one.
    middles, normals : (3, n) float64
        The normals have length 1, and point outward.
    sizes : (n,) float64
        Longest side of the box around the face.
    """

    labels: Ids
    corners: Floats
    middles: Floats
    normals: Floats
    sizes: Floats

    def some(self, which: Array) -> Sides:
        """Some of them."""
        corners, middles, normals = (part[..., which] for part in self[1:4])
        return Sides(self.labels[which], corners, middles, normals, self.sizes[which])


def contacts(mesh: Mesh, labels: Ids) -> dict[tuple[int, int], int]:
    """Count the faces by which labelled cells touch cells of another label that they are not joined to.

    Parameters
    ----------
    mesh : Mesh
    labels : (C,) int32
        Label of each cell.

    Returns
    -------
    dict of (int, int) to int
        For each pair of labels that touch, the smaller first: how many faces of the one lie on the other, or of the
        other on the one, whichever are more.
    """
    mesh, _ = mesh.within_reach
    sides = _sides(mesh, labels)
    if not len(sides.labels) or (sides.labels == sides.labels[0]).all():
        return {}
    low = sides.corners.min(axis=(0, 2))
    levels = np.frexp(np.maximum(sides.sizes, sides.sizes.max() * 2.0 ** -(BITS - 2)))[1]
    found: list[NDArray[np.int64]] = []
    for level in np.unique(levels).tolist():
        found.append(_lying_on(sides, sides.some(levels == level), low, 2.0**level))
    pairs = np.unique(np.concatenate(found, axis=1), axis=1)
    counts: dict[tuple[int, int], int] = {}
    both = np.stack([sides.labels[pairs[0]], pairs[1]])
    kinds, numbers = np.unique(both, axis=1, return_counts=True)
    for (one, other), count in zip(kinds.T.tolist(), numbers.tolist(), strict=True):
        pair = min(one, other), max(one, other)
        counts[pair] = max(counts.get(pair, 0), count)
    return counts


def _sides(mesh: Mesh, labels: Ids) -> Sides:
    """The faces of the boundary that have an area."""
    topology = mesh.topology
    rows = topology.faces.boundary
    cells, local = topology.face_cells[0, rows], topology.face_locals[0, rows]
    corners = mesh.coordinates[:, topology.corners_of(cells, local)].transpose(1, 0, 2)
    one, other = corners[2] - corners[0], corners[3] - corners[1]
    normals = np.stack(
        [
            one[1] * other[2] - one[2] * other[1],
            one[2] * other[0] - one[0] * other[2],
            one[0] * other[1] - one[1] * other[0],
        ]
    )
    lengths = np.sqrt((normals * normals).sum(axis=0))
    triangle = (corners[3] == corners[2]).all(axis=0)
    middles = np.where(triangle, corners[:3].sum(axis=0) / 3, corners.sum(axis=0) / 4)
    sizes = (corners.max(axis=0) - corners.min(axis=0)).max(axis=0)
    flat = np.flatnonzero(lengths > 0)
    whole = Sides(labels[cells], corners, middles, normals / np.where(lengths > 0, lengths, 1), sizes)
    return whole.some(flat)


def _lying_on(sides: Sides, below: Sides, low: Floats, side: float) -> NDArray[np.int64]:
    """(2, n): faces that lie on some others of another label, and that label; the others fit into cubes of a side."""
    first = np.floor((below.corners.min(axis=0) - NEAR * below.sizes - low[:, None]) / side).astype(np.int64)
    last = np.floor((below.corners.max(axis=0) + NEAR * below.sizes - low[:, None]) / side).astype(np.int64)
    keys, owners = [], []
    for step in np.ndindex(3, 3, 3):
        cube = first + np.array(step)[:, None]
        inside = np.flatnonzero((cube <= last).all(axis=0))
        keys.append(_key(cube[:, inside]))
        owners.append(inside)
    key, owner = np.concatenate(keys), np.concatenate(owners)
    order = np.argsort(key, kind="stable")
    key, owner = key[order], owner[order]
    asked = _key(np.floor((sides.middles - low[:, None]) / side).astype(np.int64))
    begin, end = np.searchsorted(key, asked, "left"), np.searchsorted(key, asked, "right")
    number = end - begin
    upper = np.repeat(np.arange(len(asked)), number)
    place = np.arange(len(upper)) - np.repeat(np.cumsum(number) - number, number) + np.repeat(begin, number)
    lower = owner[place]
    other = np.flatnonzero(sides.labels[upper] != below.labels[lower])
    upper, lower = upper[other], lower[other]
    facing = (sides.normals[:, upper] * below.normals[:, lower]).sum(axis=0) < OPPOSITE
    upper, lower = upper[facing], lower[facing]
    on = _within(sides.middles[:, upper], below.some(lower))
    label = below.labels[lower[on]]
    found: NDArray[np.int64] = np.stack([upper[on].astype(np.int64), label.astype(np.int64)])
    return found


def _key(cubes: NDArray[np.int64]) -> NDArray[np.int64]:
    """One number for each cube."""
    x, y, z = cubes + 1  # the first may lie a little before the lowest corner
    keys: NDArray[np.int64] = (x << 2 * BITS) + (y << BITS) + z
    return keys


def _within(points: Floats, faces: Sides) -> NDArray[np.bool_]:
    """(n,) whether each point lies on its face: near its plane, and within one of its two triangles."""
    offset = points - faces.middles
    height = np.abs((offset * faces.normals).sum(axis=0))
    a, b, c, d = faces.corners
    inside = _in_triangle(points, (a, b, c), faces.normals) | _in_triangle(points, (a, c, d), faces.normals)
    near: NDArray[np.bool_] = (height <= NEAR * faces.sizes) & inside
    return near


def _in_triangle(
    points: Floats, corners: tuple[Floats, Floats, Floats], normals: Floats
) -> NDArray[np.bool_]:
    """Whether points, seen along the normals, lie within triangles."""
    areas = []
    for place in range(3):
        start, end = corners[place], corners[(place + 1) % 3]
        u, v = end - start, points - start
        areas.append(
            (u[1] * v[2] - u[2] * v[1]) * normals[0]
            + (u[2] * v[0] - u[0] * v[2]) * normals[1]
            + (u[0] * v[1] - u[1] * v[0]) * normals[2]
        )
    whole = areas[0] + areas[1] + areas[2]
    least = -EDGE * np.abs(whole)
    inside: NDArray[np.bool_] = (areas[0] >= least) & (areas[1] >= least) & (areas[2] >= least) & (whole > 0)
    return inside
