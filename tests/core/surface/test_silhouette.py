"""The silhouette of what is hidden."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.surface import DrawnMesh, extract_silhouette, extract_surface
from tests.core.surface.shapes import KINDS, grid, random_mask, split_grid
from tests.core.topology.brute_force import BruteForce


@pytest.mark.parametrize("kind", KINDS)
def test_V3_silhouette_is_the_boundary_of_hidden_cells(kind: str) -> None:
    mesh = split_grid(kind, 3)
    drawing = DrawnMesh(mesh)
    shown = random_mask(mesh.cell_count, 2)
    silhouette = extract_silhouette(drawing, shown)
    truth = BruteForce(mesh.cells.tolist())
    hidden = [face for face in truth.boundary if not shown[next(iter(truth.face_cells[face]))]]
    place = {tuple(point): i for i, point in enumerate(drawing.coordinates.T.tolist())}
    quads = silhouette.positions.reshape(-1, 4, 3).tolist()
    assert len(silhouette.normals) == 16 * len(quads)
    assert {frozenset(place[tuple(point)] for point in quad) for quad in quads} == set(hidden)
    assert len(quads) == len(hidden)


def test_V3_silhouette_and_lines_make_the_whole_boundary() -> None:
    mesh = grid(4, 4, 4, jitter=0.1)
    drawing = DrawnMesh(mesh)
    shown = random_mask(mesh.cell_count, 2)
    silhouette = extract_silhouette(drawing, shown)
    surface = extract_surface(drawing, shown, "lines")
    outer = surface.inside.reshape(-1, 4)[:, 0] == 0
    rows = np.concatenate([silhouette.positions.reshape(-1, 12), surface.positions.reshape(-1, 12)[outer]])
    normals = np.concatenate([silhouette.normals.reshape(-1, 16), surface.normals.reshape(-1, 16)[outer]])
    whole = extract_surface(drawing, np.ones(64, bool), "lines")
    assert {tuple(row) for row in rows.tolist()} == {
        tuple(row) for row in whole.positions.reshape(-1, 12).tolist()
    }
    assert len(rows) == len(whole.faces) == 96
    middles = rows.reshape(-1, 4, 3).mean(axis=1)
    assert ((middles * normals.reshape(-1, 4, 4)[:, 0, :3]).sum(axis=1) > 0).all()


def test_V3_nothing_hidden_no_silhouette() -> None:
    silhouette = extract_silhouette(DrawnMesh(grid(2, 2, 2)), np.ones(8, bool))
    assert len(silhouette.positions) == len(silhouette.normals) == 0
    assert set(silhouette.arrays()) == {"positions", "normals"}
