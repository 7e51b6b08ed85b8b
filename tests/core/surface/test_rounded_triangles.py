"""Large radii on triangles: their flat side shrinks to the middle and goes no further."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.cells import FACES
from hexalab.surface import DrawnMesh, extract_surface
from tests.core.surface.checks import points_of, rings_of
from tests.core.surface.shapes import split_grid


@pytest.mark.parametrize(("kind", "triangles"), [("wedge", 2), ("pyramid", 4), ("tetrahedron", 4)])
@pytest.mark.parametrize("radius", [0.2, 1 / 3, 0.4, 0.5])
def test_V1_the_flat_side_of_a_triangle_never_turns_inside_out(
    kind: str, triangles: int, radius: float
) -> None:
    """Its corner at vertex v of v a b lies at v + r (a - v) + r (b - v); with r = 1/3 that is the barycentre."""
    mesh = split_grid(kind, 2, 0.1)
    shown = np.zeros(mesh.cell_count, bool)
    shown[3] = True
    surface = extract_surface(DrawnMesh(mesh), shown, "rounded", radius=radius)
    drawn = points_of(surface)[rings_of(surface)]

    points = (mesh.points - mesh.centre) / mesh.diagonal
    rings = [set(mesh.cells[3, list(face)].tolist()) for face in FACES]
    corners = [points[sorted(ring)] for ring in rings if len(ring) == 3]
    assert len(corners) == triangles
    for triangle in corners:
        side = triangle + min(radius, 1 / 3) * (triangle.sum(axis=0) - 3 * triangle)
        # Of each face drawn, how far its corners are from those of the flat side, and those from its own.
        distance = np.linalg.norm(drawn[:, :, None] - side, axis=3)
        apart = np.maximum(distance.min(axis=1).max(axis=1), distance.min(axis=2).max(axis=1))
        assert apart.min() < 1e-6
