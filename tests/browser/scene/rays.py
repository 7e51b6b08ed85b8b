"""Openness to light by brute force: every ray against every triangle. The independent truth for the GPU's term."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

CORNER_PULL = 0.15
"""How far a flat face's corner is drawn to the middle of its diagonal before it gathers light."""


def openness(surface: dict[str, Any], vertices: NDArray[np.intp], directions: Floats) -> Floats:
    """Return the share of the light from the directions, by the cosine law, that reaches some drawn vertices.

    Parameters
    ----------
    surface : dict
        Buffers of a surface.
    vertices : (n,) indices
    directions : (d, 3) unit vectors towards the light
    """
    corners = surface["positions"].reshape(-1, 3).astype(np.float64)
    normals = surface["normals"].reshape(-1, 4)[:, :3].astype(np.float64)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    places = corners.copy()
    quads = surface["quads"]
    if quads is None:
        four = corners.reshape(-1, 4, 3)
        triangle = np.all(four[:, 2] == four[:, 3], axis=1)[:, None, None]
        middle = np.where(
            triangle, four[:, :3].mean(axis=1, keepdims=True), four[:, ::2].mean(axis=1, keepdims=True)
        )
        places = (four + CORNER_PULL * (middle - four)).reshape(-1, 3)
        quads = np.arange(len(corners))
    quads = quads.reshape(-1, 4)
    triangles = corners[np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])]
    area = np.linalg.norm(
        np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1
    )
    triangles = triangles[area > 1e-14]
    origins = places[vertices] + 1e-4 * normals[vertices]
    cosines = normals[vertices] @ directions.T
    free = np.zeros_like(cosines, dtype=bool)
    for k, direction in enumerate(directions):
        lit = np.flatnonzero(cosines[:, k] > 0)
        free[lit, k] = ~hits(origins[lit], direction, triangles)
    weights = np.maximum(cosines, 0)
    return np.asarray((weights * free).sum(axis=1) / weights.sum(axis=1))


def hits(origins: Floats, direction: Floats, triangles: Floats) -> NDArray[np.bool_]:
    """Return whether rays in one direction meet any triangle: point in triangle, in the plane across the direction."""
    right = np.cross(direction, [0.0, 0.0, 1.0] if abs(direction[2]) < 0.9 else [1.0, 0.0, 0.0])
    right /= np.linalg.norm(right)
    up = np.cross(direction, right)
    frame = np.stack([right, up, direction])
    points = origins @ frame.T
    a, b, c = (triangles[:, k] @ frame.T for k in range(3))
    order = np.argsort(points[:, 0])
    out = np.zeros(len(points), bool)
    low = np.searchsorted(points[order, 0], np.minimum(np.minimum(a[:, 0], b[:, 0]), c[:, 0]))
    high = np.searchsorted(points[order, 0], np.maximum(np.maximum(a[:, 0], b[:, 0]), c[:, 0]), side="right")
    count = high - low
    which = np.repeat(np.arange(len(a)), count)
    start = np.repeat(low - np.concatenate([[0], np.cumsum(count)[:-1]]), count)
    point = order[np.arange(count.sum()) + start]
    p = points[point]
    areas = [cross(q[which], r[which], p) for q, r in ((b, c), (c, a), (a, b))]
    total = areas[0] + areas[1] + areas[2]
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = [area / total for area in areas]
        depth = shares[0] * a[which, 2] + shares[1] * b[which, 2] + shares[2] * c[which, 2]
        inside = (shares[0] >= 0) & (shares[1] >= 0) & (shares[2] >= 0) & (depth > p[:, 2])
    out[point[inside]] = True
    return out


def cross(a: Floats, b: Floats, p: Floats) -> Floats:
    """Return twice the signed areas of triangles (a, b, p) in the first two coordinates."""
    return np.asarray((b[:, 0] - a[:, 0]) * (p[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (p[:, 0] - a[:, 0]))
