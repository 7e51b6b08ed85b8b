"""Lines and darkness-coded edges against dictionaries."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from hexalab.cells import FACES
from hexalab.mesh import Mesh
from hexalab.surface import DrawnMesh, Surface, extract_surface
from tests.core.surface.checks import check_manifold, points_of, rings_of
from tests.core.surface.shapes import (
    KINDS,
    grid,
    mesh_of,
    random_mask,
    split_grid,
    three_around_an_edge,
    unit_cube,
)
from tests.core.topology.brute_force import BruteForce


def expected_faces(mesh: Mesh, shown: NDArray[np.bool_]) -> set[tuple[int, int]]:
    """Cell and local face of each face with exactly one shown side."""
    found = set()
    for around in BruteForce(mesh.cells.tolist()).face_sides.values():
        visible = [side for side in around if shown[side[0]]]
        if len(visible) == 1:
            found.add(visible[0])
    return found


def expected_edges(mesh: Mesh, shown: NDArray[np.bool_]) -> dict[frozenset[int], int]:
    """Edges of those faces, with the number of shown cells that have the edge."""
    truth = BruteForce(mesh.cells.tolist())
    found = {}
    for cell, local in expected_faces(mesh, shown):
        ring = [int(mesh.corners[place, cell]) for place in FACES[local]]
        for pair in zip(ring, ring[1:] + ring[:1], strict=True):
            if pair[0] != pair[1]:
                edge = frozenset(pair)
                found[edge] = sum(bool(shown[around]) for around in truth.edge_cells[edge])
    return found


def edges_of(drawing: DrawnMesh, surface: Surface) -> list[frozenset[int]]:
    """The surface's edges by vertex ids, found by position; the mesh has no coincident vertices."""
    place = {tuple(point): i for i, point in enumerate(drawing.coordinates.T.tolist())}
    ends = surface.edges.reshape(-1, 2, 3).tolist()
    return [frozenset((place[tuple(a)], place[tuple(b)])) for a, b in ends]


def check_against_dictionaries(mesh: Mesh, shown: NDArray[np.bool_]) -> None:
    drawing = DrawnMesh(mesh)
    expected = expected_edges(mesh, shown)
    for mode in ("lines", "darkness_coded_edges"):
        surface = extract_surface(drawing, shown, mode)
        sides = [(int(tag) // 8, int(tag) % 8) for tag in surface.faces]
        assert Counter(sides) == Counter(expected_faces(mesh, shown))
        place = {tuple(point): i for i, point in enumerate(drawing.coordinates.T.tolist())}
        for side, ring in zip(sides, points_of(surface)[rings_of(surface)].tolist(), strict=True):
            corners = {int(mesh.corners[k, side[0]]) for k in FACES[side[1]]}
            assert {place[tuple(point)] for point in ring} == corners
        edges = edges_of(drawing, surface)
        assert Counter(edges) == Counter(expected.keys())
        if mode == "darkness_coded_edges":
            assert dict(zip(edges, surface.edge_cells.tolist(), strict=True)) == expected
        else:
            assert len(surface.edge_cells) == 0


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("share", [0.1, 0.5, 0.9, 1.0])
def test_V1_faces_edges_and_counts_of_all_kinds(kind: str, share: float) -> None:
    mesh = split_grid(kind, 3)
    check_against_dictionaries(mesh, random_mask(mesh.cell_count, 5, share))


def test_V1_unit_cube_exactly() -> None:
    surface = extract_surface(DrawnMesh(unit_cube()), np.ones(1, bool), "lines")
    half = np.float32(0.5 / np.sqrt(3))
    assert (np.abs(surface.positions) == half).all()
    assert len(surface.faces) == 6 and len(surface.edges) == 12 * 6
    normals = surface.normals.reshape(6, 4, 4)
    assert (normals == normals[:, :1]).all()
    axis = {0: (0, 0, -1), 1: (0, 0, 1), 2: (0, -1, 0), 3: (1, 0, 0), 4: (0, 1, 0), 5: (-1, 0, 0)}
    for tag, normal in zip(surface.faces.tolist(), normals[:, 0, :3].tolist(), strict=True):
        assert tuple(round(x / 32767) for x in normal) == axis[tag]
    check_manifold(surface)


def test_V1_cubes_that_touch_along_an_edge_draw_it_once() -> None:
    mesh = grid(2, 2, 1, turned=False)
    drawing = DrawnMesh(mesh)
    shown = np.array([True, False, False, True])
    surface = extract_surface(drawing, shown, "darkness_coded_edges")
    assert len(surface.edges) == 6 * 23
    assert Counter(surface.edge_cells.tolist()) == {1: 22, 2: 1}


def test_V1_counts_around_edges_of_a_notch() -> None:
    """Four cubes but one: the concave edge has three cells, flat ones two, convex ones one."""
    surface = extract_surface(
        DrawnMesh(grid(2, 2, 1, turned=False)), np.array([True, True, True, False]), "darkness_coded_edges"
    )
    assert Counter(surface.edge_cells.tolist()) == {3: 1, 2: 6, 1: 21}


def test_V1_many_cells_around_an_edge_are_counted_to_255() -> None:
    """A wheel of 300 wedges with one spoke hidden."""
    n = 300
    angle = np.arange(n) * 2 * np.pi / n
    rim = np.column_stack([np.cos(angle), np.sin(angle)])
    layer = np.concatenate([[[0.0, 0.0]], rim])
    points = np.concatenate([np.column_stack([layer, np.full(n + 1, z)]) for z in (0.0, 1.0)])
    i = np.arange(n)
    a, b = 1 + i, 1 + (i + 1) % n
    zero = np.zeros(n, int)
    base = np.stack([zero, a, b, b], axis=1)
    mesh = mesh_of(points, np.concatenate([base, base + n + 1], axis=1), 1)
    shown = np.ones(n, bool)
    shown[0] = False
    drawing = DrawnMesh(mesh)
    surface = extract_surface(drawing, shown, "darkness_coded_edges")
    counts = dict(zip(edges_of(drawing, surface), surface.edge_cells.tolist(), strict=True))
    assert counts[frozenset((0, n + 1))] == 255
    shown[100:] = False
    surface = extract_surface(drawing, shown, "darkness_coded_edges")
    counts = dict(zip(edges_of(drawing, surface), surface.edge_cells.tolist(), strict=True))
    assert counts[frozenset((0, n + 1))] == 99


def test_V1_neighbours_of_opposite_orientation_keep_their_edges() -> None:
    """One cell inverted: its quads run against their neighbours', and still every edge is drawn once."""
    mesh = grid(3, 2, 2, turned=False)
    corners = mesh.corners.copy()
    corners[:, 4] = corners[[4, 5, 6, 7, 0, 1, 2, 3], 4]
    mesh = replace(mesh, corners=corners)
    for seed in range(6):
        check_against_dictionaries(mesh, random_mask(mesh.cell_count, seed, 0.7))


def test_V1_three_cells_around_an_edge() -> None:
    mesh = three_around_an_edge(2)
    for seed in range(6):
        check_against_dictionaries(mesh, random_mask(mesh.cell_count, seed, 0.6))


def test_V1_a_face_of_three_cells_is_drawn_for_the_odd_one() -> None:
    """Three cubes on one square: a pair hides it from each other, the third shows it."""
    mesh = grid(2, 1, 1, turned=False)
    points = np.concatenate([mesh.points, mesh.points[[2, 5, 8, 11]] + [0.4, 0, 0.3]])
    third = [1, 12, 13, 4, 7, 14, 15, 10]
    mesh = mesh_of(points, np.concatenate([mesh.cells, [third]]))
    surface = extract_surface(DrawnMesh(mesh), np.ones(3, bool), "lines")
    assert len(surface.faces) == 5 + 5 + 5 + 1
    odd = (surface.inside.reshape(-1, 4) == 255).all(axis=1)
    assert odd.sum() == 1
    surface = extract_surface(DrawnMesh(mesh), np.array([True, False, False]), "lines")
    assert len(surface.faces) == 6
