"""Distances between two surfaces, vertex by vertex, and what is told of them (SPEC S7)."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..arrays import Array, Floats
from ..reference import TriangleSurface
from .triangle_index import TriangleIndex

STEP = 16_384
"""Vertices that are measured at a time, so that other work can come between."""


class Measuring:
    """The distance of each vertex of a surface to another surface, measured step by step.

    Parameters
    ----------
    surface : TriangleSurface
        Whose vertices are measured: those that a triangle uses.
    index : TriangleIndex
        Of the other surface.

    >>> measuring = Measuring(surface, other_index)                              # doctest: +SKIP
    >>> while not measuring.step(): pass                                         # doctest: +SKIP
    """

    def __init__(self, surface: TriangleSurface, index: TriangleIndex) -> None:
        self.surface = surface
        self.vertices = surface.vertices_used
        self.distances = np.full(len(self.vertices), np.nan)
        self.done = 0
        self._index = index

    @property
    def count(self) -> int:
        """How many vertices are measured."""
        return len(self.vertices)

    @property
    def rows(self) -> Array:
        """(n,) rows of these vertices: in the mesh, if the surface is one's boundary, else in the surface."""
        return self.vertices if self.surface.rows is None else self.surface.rows[self.vertices]

    def turned(self, other: TriangleSurface) -> Measuring:
        """The same the other way round: from the other surface to this one."""
        return Measuring(other, TriangleIndex(self.surface.points, self.surface.triangles))

    def step(self) -> bool:
        """Measure some more vertices; whether all are."""
        if self.done < self.count:
            part = slice(self.done, self.done + STEP)
            found = self._index.nearest(self.surface.points[:, self.vertices[part]])
            self.distances[part] = found.distance
            self.done = min(self.done + STEP, self.count)
        return self.done == self.count

    def finish(self) -> Measuring:
        """Measure all that is left."""
        while not self.step():
            pass
        return self

    def of_vertices(self, count: int) -> Floats:
        """(count,) float64: the distance of each vertex of the mesh that the surface is the boundary of; NaN inside."""
        out = np.full(count, np.nan)
        out[self.rows] = self.distances
        return out

    def facts(self, diagonal: float) -> dict[str, Any]:
        """Tell largest, mean and root mean square distance; and where the largest is.

        Parameters
        ----------
        diagonal : float
            What percents are of.

        Returns
        -------
        dict
            `vertices` (how many were measured), `max`, `mean`, `rms` in the file's unit, the same with `_percent`,
            `worst` ([x, y, z] of the vertex that is farthest away).
        """
        distances = self.distances
        largest = float(distances.max())
        scale = largest or 1.0
        told = {
            "max": largest,
            "mean": float(distances.mean()),
            "rms": scale * float(np.sqrt(((distances / scale) ** 2).mean())),
        }
        return {
            "vertices": len(distances),
            **told,
            **{f"{name}_percent": 100 * value / diagonal for name, value in told.items()},
            "worst": self.surface.points[:, self.vertices[int(distances.argmax())]].tolist(),
        }


def both_ways(there: dict[str, Any], back: dict[str, Any]) -> dict[str, Any]:
    """Join the facts of both directions: `a_to_b`, `b_to_a`, and `hausdorff`, the larger of the two largest."""
    return {
        "a_to_b": there,
        "b_to_a": back,
        **{name.replace("max", "hausdorff"): max(there[name], back[name]) for name in ("max", "max_percent")},
    }
