"""The meshes to measure with: cubic grids whose inner vertices are moved by seeded noise."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from hexalab import Mesh, write

SIZES = {"25k": 29, "216k": 60, "1M": 100}
"""Name to cells along each side."""

LARGE = {"4M": 160, "10M": 216}
"""More than a browser's Python can hold: for the native core."""

PICKED = 100_000
"""Cells picked by hand, a quarter of the mesh at the most: they lie behind the planes that are measured, so that a
slice must cost what it costs without them."""


def noisy_grid(side: int, noise: float = 0.2, seed: int = 7) -> Mesh:
    """A unit cube of side**3 hexahedra, inner vertices moved by up to `noise` of a cell's side.

    Coordinates have six decimals, as most published meshes have: a million cells are some 90 MB of text.
    """
    line = np.arange(side + 1)
    x, y, z = np.meshgrid(line, line, line, indexing="ij")
    points = np.stack([x, y, z], axis=-1).reshape(-1, 3).astype(float)
    inner = ((points > 0) & (points < side)).all(axis=1)
    moves = np.random.default_rng(seed).uniform(-noise, noise, points.shape)
    points[inner] += moves[inner]
    ids = np.arange((side + 1) ** 3, dtype=np.int32).reshape(side + 1, side + 1, side + 1)
    low, high = slice(None, -1), slice(1, None)
    ring = ((low, low), (high, low), (high, high), (low, high))
    corners = [ids[i, j, k].ravel() for k in (low, high) for i, j in ring]
    return Mesh.from_cells(np.round(points / side, 6), np.stack(corners, axis=1))


def grid_file(name: str, suffix: str, folder: Path) -> Path:
    """The grid of that name as a file, made at first use."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"grid-{name}{suffix}"
    if not path.is_file():
        write(noisy_grid((SIZES | LARGE)[name]), path)
    return path
