"""Fissures, one cell and one face at a time as the paper tells it."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from hexalab.cells import FACES
from hexalab.mesh import Mesh
from hexalab.surface import DrawnMesh, extract_surface
from tests.core.surface.checks import points_of, rings_of
from tests.core.surface.shapes import KINDS, grid, random_mask, split_grid, unit_cube
from tests.core.topology.brute_force import BruteForce


def exposed_vertices(mesh: Mesh, shown: NDArray[np.bool_]) -> set[int]:
    """Vertices of all faces with exactly one shown side."""
    found: set[int] = set()
    for face, around in BruteForce(mesh.cells.tolist()).face_sides.items():
        if sum(bool(shown[cell]) for cell, _ in around) == 1:
            found |= face
    return found


def expected(mesh: Mesh, shown: NDArray[np.bool_], gap: float) -> dict[tuple[int, int], list[NDArray]]:
    """For each face drawn, by cell and local face, the corners in order."""
    exposed = exposed_vertices(mesh, shown)
    points = (mesh.points - mesh.centre) / mesh.diagonal
    found = {}
    for cell in np.flatnonzero(shown).tolist():
        ids = mesh.cells[cell].tolist()
        middle = points[sorted(set(ids))].mean(axis=0)
        for local, places in enumerate(FACES):
            ring = [ids[place] for place in places]
            ring = [v for i, v in enumerate(ring) if v != ring[i - 1]]
            if len(ring) > 2 and exposed & set(ring):
                found[cell, local] = [points[v] + gap * (middle - points[v]) * (v in exposed) for v in ring]
    return found


def check(mesh: Mesh, shown: NDArray[np.bool_], gap: float) -> None:
    surface = extract_surface(DrawnMesh(mesh), shown, "fissure", gap=gap)
    truth = expected(mesh, shown, gap)
    sides = [(int(tag) // 8, int(tag) % 8) for tag in surface.faces]
    assert sorted(sides) == sorted(truth)
    for side, ring in zip(sides, points_of(surface)[rings_of(surface)], strict=True):
        corners = ring if (ring[2] != ring[3]).any() else ring[:3]
        start = np.abs(np.array(truth[side]) - corners[0]).sum(axis=1).argmin()
        assert np.allclose(np.roll(truth[side], -start, axis=0), corners, atol=1e-6)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("share", [0.2, 0.7, 0.95])
def test_V1_fissure_as_the_paper_tells_it(kind: str, share: float) -> None:
    mesh = split_grid(kind, 3, 0.1)
    check(mesh, random_mask(mesh.cell_count, 3, share), 0.15)


def test_V1_fissure_shrinks_a_cube_by_the_gap() -> None:
    surface = extract_surface(DrawnMesh(unit_cube()), np.ones(1, bool), "fissure", gap=0.25)
    assert np.allclose(np.abs(surface.positions), 0.75 * 0.5 / np.sqrt(3), atol=1e-7)
    assert len(surface.faces) == 6


def test_V1_fissure_draws_nothing_of_cells_within() -> None:
    mesh = grid(5, 5, 5, turned=False)
    surface = extract_surface(DrawnMesh(mesh), np.ones(125, bool), "fissure")
    cells = set(surface.cells.tolist())
    assert len(cells) == 125 - 27
    # A cell in the middle of a side shows five faces: the one opposite has no exposed corner.
    middle = 2 + 5 * 2
    assert sorted((surface.faces[surface.faces // 8 == middle] % 8).tolist()) == [0, 2, 3, 4, 5]
