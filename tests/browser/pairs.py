"""Small meshes to compare: before and after, and another."""

from __future__ import annotations

from dataclasses import replace

import hexalab

from .conftest import grid


def smoothed(mesh: hexalab.Mesh, calm: hexalab.Mesh, worse: int) -> hexalab.Mesh:
    """The calm mesh of the same cells, but for one vertex of the first that went the other way."""
    coordinates = calm.coordinates.copy()
    coordinates[:, worse] -= 0.3
    return replace(mesh, coordinates=coordinates)


def of_file(mesh: hexalab.Mesh) -> hexalab.Mesh:
    """As it is read from a Medit file, which counts from 1."""
    return replace(mesh, first_number=1)


BEFORE = of_file(grid(5, 4, 3, noise=0.35))
AFTER = smoothed(BEFORE, grid(5, 4, 3, noise=0.1), worse=26)
OTHER = grid(4, 4, 4, noise=0.1)
