"""Triangles of closed and flat surfaces, and other heaps of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np


class Surface(NamedTuple):
    """Points (3, V) float64 and triangles (3, T) int32."""

    points: np.ndarray
    triangles: np.ndarray

    @property
    def corners(self) -> np.ndarray:
        """(T, 3 corners, 3)."""
        return self.points[:, self.triangles].transpose(2, 1, 0)


def grid_triangles(rows: int, columns: int, round_about: bool = False) -> np.ndarray:
    """(3, 2 rows columns): a grid of so many squares, or of so many around a tube."""
    wide = columns + (not round_about)
    i, j = (part.reshape(-1) for part in np.meshgrid(range(rows), range(columns), indexing="ij"))
    right = (j + 1) % wide
    a, b, c, d = i * wide + j, i * wide + right, (i + 1) * wide + right, (i + 1) * wide + j
    return np.concatenate([np.stack([a, b, c]), np.stack([a, c, d])], axis=1).astype(np.int32)


def sphere(parallels: int, meridians: int) -> Surface:
    """A unit sphere, with collapsed triangles at its poles."""
    down = np.linspace(0, np.pi, parallels + 1)[:, None]
    round_about = np.linspace(0, 2 * np.pi, meridians, endpoint=False)
    points = np.stack(
        [
            np.sin(down) * np.cos(round_about),
            np.sin(down) * np.sin(round_about),
            np.repeat(np.cos(down), meridians, axis=1),
        ]
    )
    return Surface(points.reshape(3, -1), grid_triangles(parallels, meridians, True))


def sheet(side: int) -> Surface:
    """A square of side x side unit squares in the plane z = 0, at whole coordinates."""
    x, y = np.meshgrid(range(side + 1), range(side + 1), indexing="ij")
    points = np.stack([x, y, 0 * x]).reshape(3, -1).astype(float)
    return Surface(points, grid_triangles(side, side))


def heap(count: int, size: float = 0.1) -> Surface:
    """Triangles anywhere in a cube of side 2."""
    rng = np.random.default_rng(9)
    middles = rng.uniform(-1, 1, size=(3, count, 1))
    points = middles + rng.uniform(-size, size, size=(3, count, 3))
    return Surface(points.reshape(3, -1), np.arange(3 * count, dtype=np.int32).reshape(-1, 3).T)


def also(surface: Surface, *corners: list[list[float]]) -> Surface:
    """With more triangles, at the front."""
    more = np.array(corners).reshape(-1, 3).T
    new = np.arange(more.shape[1], dtype=np.int32).reshape(-1, 3).T
    return Surface(
        np.concatenate([more, surface.points], axis=1),
        np.concatenate([new, surface.triangles + more.shape[1]], axis=1).astype(np.int32),
    )


def moved(surface: Surface, scale: float, offset: float = 0.0) -> Surface:
    return Surface(surface.points * scale + offset, surface.triangles)


def one_point_each(surface: Surface) -> Surface:
    return Surface(surface.points, np.repeat(surface.triangles[:1], 3, axis=0))


def sizes_of_all_kinds() -> Surface:
    """Each triangle ten times less or more than another, from 1e-6 to 1e6."""
    points = np.concatenate([heap(20, 10.0**power).points * 10.0**power for power in range(-6, 7)], axis=1)
    return Surface(points, np.arange(points.shape[1], dtype=np.int32).reshape(-1, 3).T)


SURFACES: dict[str, Callable[[], Surface]] = {
    "sphere": lambda: sphere(20, 30),
    "sheet": lambda: sheet(17),
    "sheet across": lambda: Surface(sheet(17).points[[2, 0, 1]], sheet(17).triangles),
    "heap": lambda: heap(900),
    "one triangle": lambda: heap(1, 1.0),
    "eight triangles": lambda: heap(8),
    "nine triangles": lambda: heap(9),
    "one huge beside many": lambda: also(sphere(20, 30), [[0, 0, 1e4], [1e4, 0, -1e4], [0, 1e4, 3.0]]),
    "a stray one": lambda: also(sphere(20, 30), [[1e30, 0, 0], [1e30, 1e25, 0], [1e30, 0, 1e25]]),
    "sizes of all kinds": sizes_of_all_kinds,
    "all identical": lambda: Surface(heap(1, 1.0).points, np.tile(np.int32([[0], [1], [2]]), 20)),
    "points": lambda: one_point_each(sphere(20, 30)),
    "off by a million": lambda: moved(sphere(20, 30), 1, 1e6),
    "a billion large": lambda: moved(sphere(20, 30), 1e9),
    "a billionth large": lambda: moved(sphere(20, 30), 1e-9),
}
