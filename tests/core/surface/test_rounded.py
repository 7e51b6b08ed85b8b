"""Roundings against the original's lattice of 4 x 4 x 4 nodes, one cell and one node at a time."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from numpy.typing import NDArray

from hexalab.mesh import Mesh
from hexalab.surface import DrawnMesh, Surface, extract_surface
from tests.core.surface.checks import check_closed, check_manifold, points_of, rings_of
from tests.core.surface.shapes import (
    CORNERS,
    KINDS,
    grid,
    random_mask,
    split_grid,
    unit_cube,
)
from tests.core.surface.test_fissure import exposed_vertices

Node = tuple[int, int, int]


def lattice_nodes(
    corners: dict[Node, NDArray], exposed: dict[Node, bool], radius: float
) -> dict[Node, NDArray]:
    """Nodes on the surface of the lattice that are kept, displaced."""
    found: dict[Node, NDArray] = {}
    for node in product(range(4), repeat=3):
        near = tuple(int(i > 1) for i in node)
        middle = [axis for axis in range(3) if node[axis] in (1, 2)]
        if len(middle) == 3:
            continue
        kept = exposed[near]
        if len(middle) == 1:
            far = list(near)
            far[middle[0]] = 1 - far[middle[0]]
            kept |= exposed[tuple(far)]
        if not kept:
            continue
        point = corners[near].copy()
        if exposed[near]:
            for axis in range(3):
                across = list(near)
                across[axis] = 1 - across[axis]
                edge = corners[tuple(across)] - corners[near]
                if axis in middle:
                    point += radius * edge
                elif len(middle) == 1:
                    point += radius * (1 - np.sqrt(2) / 2) * edge
                elif not middle:
                    point += radius * (1 - np.sqrt(3) / 3) * edge
        found[node] = point
    return found


def lattice_faces(kept: dict[Node, NDArray]) -> list[tuple[int, int, list[Node]]]:
    """Axis, side and nodes of each sub-face of four nodes, and of three along an edge of the cell."""
    found = []
    for axis, side in product(range(3), (0, 3)):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for i, j in product(range(3), repeat=2):
            ring: list[Node] = []
            for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                node = [0, 0, 0]
                node[axis], node[u], node[v] = side, a, b
                ring.append((node[0], node[1], node[2]))
            here = [node for node in ring if node in kept]
            along_edge = (i == 1) != (j == 1)
            if len(here) == 4 or (len(here) == 3 and along_edge):
                found.append((axis, side, here))
    return found


def expected(mesh: Mesh, shown: NDArray[np.bool_], radius: float) -> list[tuple[int, NDArray]]:
    """Cell and corners of each sub-face."""
    exposed = exposed_vertices(mesh, shown)
    points = (mesh.points - mesh.centre) / mesh.diagonal
    found = []
    for cell in np.flatnonzero(shown).tolist():
        ids = dict(zip(CORNERS, mesh.cells[cell].tolist(), strict=True))
        kept = lattice_nodes(
            {place: points[v] for place, v in ids.items()},
            {place: v in exposed for place, v in ids.items()},
            radius,
        )
        found += [(cell, np.array([kept[node] for node in ring])) for _, _, ring in lattice_faces(kept)]
    return found


def canonical(cell: int, ring: NDArray) -> NDArray:
    """Numbers by which equal faces lie close together: cell, number of corners, mean, spread."""
    ring = np.asarray(ring)
    return np.array([cell, len(ring), *ring.mean(axis=0), *np.abs(ring - ring.mean(axis=0)).sum(axis=0)])


def check_lattice(mesh: Mesh, shown: NDArray[np.bool_], radius: float) -> None:
    surface = extract_surface(DrawnMesh(mesh), shown, "rounded", radius=radius)
    truth = expected(mesh, shown, radius)
    assert len(surface.faces) == len(truth)
    want: dict[int, list[NDArray]] = {}
    for cell, ring in truth:
        want.setdefault(cell, []).append(canonical(cell, ring))
    for tag, places in zip(surface.faces.tolist(), rings_of(surface), strict=True):
        ring = points_of(surface)[places if places[2] != places[3] else places[:3]]
        left = want[tag // 8]
        distance = [np.abs(one - canonical(tag // 8, ring)).max() for one in left]
        best = int(np.argmin(distance))
        assert distance[best] < 1e-5
        del left[best]


def test_V1_rounded_is_the_lattice_where_corners_are_not_exposed() -> None:
    mesh = grid(4, 4, 4, jitter=0.1)
    check_lattice(mesh, mesh.barycentres.sum(axis=0) < 7.2, 0.075)
    check_lattice(mesh, random_mask(64, 4, 0.8), 0.2)


def test_V1_rounded_cube_of_largest_radius_is_a_sphere() -> None:
    surface = extract_surface(DrawnMesh(unit_cube()), np.ones(1, bool), "rounded", radius=0.5)
    points = points_of(surface) * np.sqrt(3)
    assert len(points) == 56 and len(surface.faces) == 54
    assert np.allclose(np.linalg.norm(points, axis=1), 0.5, atol=1e-6)
    sizes = np.sort(np.abs(points), axis=1).round(5)
    tip, edge = 0.5 / np.sqrt(3), 0.5 / np.sqrt(2)
    kinds = {(0.0, 0.0, 0.5): 24, (0.0, round(edge, 5), round(edge, 5)): 24, (round(tip, 5),) * 3: 8}
    for kind, count in kinds.items():
        assert np.isclose(sizes, kind, atol=2e-5).all(axis=1).sum() == count


def test_V1_rounded_unit_cube_exactly() -> None:
    s = 0.075
    surface = extract_surface(DrawnMesh(unit_cube()), np.ones(1, bool), "rounded", radius=s)
    points = np.sort(0.5 - np.abs(points_of(surface)) * np.sqrt(3), axis=1)
    edge, tip = s * (1 - np.sqrt(0.5)), s * (1 - np.sqrt(1 / 3))
    for kind, count in (((0, s, s), 24), ((edge, edge, s), 24), ((tip, tip, tip), 8)):
        assert np.isclose(points, kind, atol=1e-6).all(axis=1).sum() == count
    check_manifold(surface)


def corner_normals(surface: Surface) -> NDArray[np.float64]:
    return surface.normals.reshape(-1, 4)[:, :3] / 32767


def test_V1_rounded_cells_are_flat_on_their_sides_and_smooth_between() -> None:
    surface = extract_surface(DrawnMesh(unit_cube()), np.ones(1, bool), "rounded")
    number = (np.abs(corner_normals(surface)) > 0.1).sum(axis=1)
    expected_length = 1 / np.sqrt(number)
    assert sorted(number.tolist()) == [1] * 24 + [2] * 24 + [3] * 8
    filled = np.abs(corner_normals(surface)).max(axis=1)
    assert np.allclose(filled, expected_length, atol=1e-4)
    face_node = number == 1
    rings = rings_of(surface)
    flat = face_node[rings].all(axis=1)
    assert flat.sum() == 6
    for ring in rings[flat]:
        assert (corner_normals(surface)[ring] == corner_normals(surface)[ring[0]]).all()


@pytest.mark.parametrize(
    ("kind", "vertices", "edges", "triangles", "quads"),
    [
        ("hexahedron", 8, 12, 0, 6),
        ("wedge", 6, 9, 2, 3),
        ("pyramid", 5, 8, 4, 1),
        ("tetrahedron", 4, 6, 4, 0),
    ],
)
def test_V1_rounded_counts_by_the_cells_own_vertices_edges_and_faces(
    kind: str, vertices: int, edges: int, triangles: int, quads: int
) -> None:
    """A cell alone: a node for each vertex, two for each edge, one for each corner of a face."""
    mesh = split_grid(kind, 2)
    shown = np.zeros(mesh.cell_count, bool)
    shown[3] = True
    surface = extract_surface(DrawnMesh(mesh), shown, "rounded")
    corners = 3 * triangles + 4 * quads
    assert len(surface.cells) == vertices + 2 * edges + corners
    assert len(surface.faces) == corners + 2 * edges + triangles + quads


def test_V1_rounded_tetrahedron_is_the_same_from_every_corner() -> None:
    """A regular tetrahedron: however the cell repeats its corners, the surface has its symmetry."""
    mesh = split_grid("tetrahedron", 2)
    ids = np.unique(mesh.cells[0])
    coordinates = mesh.coordinates.copy()
    coordinates[:, ids] = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]).T
    mesh = replace(mesh, coordinates=coordinates)
    shown = np.zeros(mesh.cell_count, bool)
    shown[0] = True
    surface = extract_surface(DrawnMesh(mesh), shown, "rounded", radius=0.2)
    own = points_of(surface) * mesh.diagonal + mesh.centre
    distance = np.linalg.norm(own, axis=1).round(4)
    _, counts = np.unique(distance, return_counts=True)
    assert sorted(counts.tolist()) == [4, 12, 12]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("radius", [0.04, 0.2, 1 / 3, 0.5])
def test_V1_rounded_closed_at_any_radius(kind: str, radius: float) -> None:
    mesh = split_grid(kind, 3, 0.1)
    for seed in range(3):
        shown = random_mask(mesh.cell_count, seed, 0.8)
        check_closed(extract_surface(DrawnMesh(mesh), shown, "rounded", radius=radius))
