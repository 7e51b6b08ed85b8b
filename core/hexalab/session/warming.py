"""Warming up: the same steps on a small mesh, so that a browser has compiled them well before the first real one.

WebAssembly starts in a quick but slow translation and earns a better one by being run; the first mesh would pay for it.
"""

from __future__ import annotations

import numpy as np

from ..mesh import Array

SIDE = 16
"""Cells along each side of the grid."""


def medit_grid(side: int = SIDE) -> bytes:
    """Write a grid of cubes as a Medit file, its inner vertices a little off their places."""
    places = np.arange(side + 1)
    points = np.stack(np.meshgrid(places, places, places, indexing="ij"), axis=-1).reshape(-1, 3) + 0.0
    inner = ((points > 0) & (points < side)).all(axis=1)
    points[inner] += 0.2 * np.sin(np.arange(3 * len(points)).reshape(-1, 3))[inner]
    ids = np.arange(1, len(points) + 1).reshape((side + 1,) * 3)
    ring = ((0, 0), (1, 0), (1, 1), (0, 1))
    corners = [ids[i : i + side, j : j + side, k : k + side].ravel() for k in (0, 1) for i, j in ring]
    parts = ["MeshVersionFormatted 2\nDimension 3\nVertices", str(len(points)), _rows(points, "%.16g")]
    parts += ["Hexahedra", str(side**3), _rows(np.stack(corners, axis=1), "%d"), "End\n"]
    return "\n".join(parts).encode()


def _rows(numbers: Array, form: str) -> str:
    line = " ".join([form] * numbers.shape[1]) + " 0\n"
    return (line * len(numbers) % tuple(numbers.ravel().tolist())).rstrip()
