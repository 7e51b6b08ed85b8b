"""The distance of the points of one surface to the triangles of another that nearly is the same."""

from __future__ import annotations

import subprocess
import sys
from functools import partial
from pathlib import Path

import numpy as np

from hexalab.arrays import Floats, Ids
from hexalab.comparison import TriangleIndex

from .clock import median_ms, table

SIZES = {"100k": 100_000, "400k": 400_000}
"""Name to how many points there are, and how many triangles."""


def run(folder: Path) -> None:
    """Print the table; natively also that of the Python that browsers have."""
    browser = sys.platform == "emscripten"
    table(
        f"{'Pyodide under Node' if browser else 'native'}: points of a surface against the triangles of another [ms]",
        ["points and triangles", "apart by", "index", "nearest", "us for a point"],
        [_times(name, apart) for name in SIZES for apart in (0.001, 0.05)],
    )
    if not browser:
        subprocess.run(["node", "benchmarks/in_pyodide.mjs", "distance"], check=True)


def _times(name: str, apart: float) -> list[object]:
    points, triangles = bumpy_sphere(SIZES[name], 0.03)
    queries, _ = bumpy_sphere(2 * SIZES[name], 0.03 + apart, turned=0.3)
    index = TriangleIndex(points, triangles)
    build = median_ms(partial(TriangleIndex, points, triangles))
    nearest = median_ms(partial(index.nearest, queries))
    return [name, f"{apart}", build, nearest, nearest / queries.shape[1] * 1000]


def bumpy_sphere(count: int, bumps: float, turned: float = 0.0) -> tuple[Floats, Ids]:
    """A unit sphere with bumps of a height, its grid turned about the z axis by an angle.

    Returns
    -------
    points : (3, V) float64
    triangles : (3, T) int32
        About so many; there are half as many points.
    """
    down, about = round((count / 4) ** 0.5), round(count**0.5)
    polar = np.linspace(0, np.pi, down + 1)[:, None]
    angle = np.linspace(0, 2 * np.pi, about, endpoint=False) + turned
    x, y, z = np.sin(polar) * np.cos(angle), np.sin(polar) * np.sin(angle), np.cos(polar) + 0 * angle
    radius = 1 + bumps * np.sin(9 * x + 1) * np.cos(7 * y) * np.sin(8 * z + 2)
    ids = np.arange(x.size, dtype=np.int32).reshape(x.shape)
    right = np.roll(ids, -1, axis=1)
    a, b, c, d = (part.reshape(-1) for part in (ids[:-1], right[:-1], right[1:], ids[1:]))
    return np.stack([x, y, z]).reshape(3, -1) * radius.reshape(-1), np.stack(
        [np.concatenate(parts) for parts in ((a, a), (b, c), (c, d))]
    )
