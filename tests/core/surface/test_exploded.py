"""Blocks drawn apart (SPEC T4): held against each piece drawn alone and moved, and against faces counted one by one."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from hexalab.mesh import Mesh
from hexalab.surface import (
    MODES,
    DrawnMesh,
    ExplodedMesh,
    Pieces,
    Surface,
    VectorField,
    extract_arrows,
    extract_silhouette,
    extract_surface,
)
from tests.core.surface.checks import check_closed, check_form, rings_of
from tests.core.surface.shapes import KINDS, grid, random_mask, split_grid
from tests.core.surface.test_repeated_cells import with_repeats
from tests.core.topology.brute_force import BruteForce

Labels = NDArray[np.int32]


def slabs(mesh: Mesh, thick: float = 1.5) -> Labels:
    """Pieces by where the cells stand along x: slabs, the last of which is not traced."""
    along = (mesh.barycentres[0] // thick).astype(np.int32)
    along[along == along.max()] = -1
    return along


def moves(drawn_mesh: DrawnMesh, labels: Labels) -> NDArray[np.float64]:
    """(3, C): the middle of each cell's piece, one piece at a time."""
    mesh, frame = drawn_mesh.mesh, drawn_mesh.frame
    out = np.zeros((3, mesh.cell_count))
    for label in set(labels.tolist()):
        own = np.flatnonzero(labels == label)
        middle = np.mean([mesh.barycentres[:, cell] for cell in own], axis=0)
        out[:, own] = ((middle - frame.centre) / frame.diagonal)[:, None]
    return out


def parted(mesh: Mesh, labels: Labels) -> list[tuple[int, int, bool]]:
    """Sides of cells, (cell, local, within the mesh), that lie between two pieces or on the boundary."""
    truth = BruteForce(mesh.cells.tolist())
    return [
        (cell, local, len(sides) > 1)
        for sides in truth.face_sides.values()
        for cell, local in sides
        if len({labels[one] for one, _ in sides}) > 1 or len(sides) == 1
    ]


def tags(surface: Surface) -> set[int]:
    found = surface.faces.tolist()
    assert len(set(found)) == len(found)
    return set(found)


def rows(surface: Surface) -> NDArray[np.float64]:
    """A row for each quad, in an order that is the same for the same quads: tag, corners, inside."""
    rings = rings_of(surface)
    points = surface.positions.reshape(-1, 3).astype(float)[rings].reshape(-1, 12)
    table = np.column_stack([surface.faces, points, surface.inside[rings[:, :1]]])
    return table[np.lexsort(np.round(table[:, ::-1], 4).T)]


def test_T4_two_cells_in_a_row_have_the_vertices_between_them_twice() -> None:
    mesh = grid(2, 1, 1, turned=False)
    pieces = Pieces(DrawnMesh(mesh), np.array([0, 1], np.int32))
    assert pieces.count == 2 and pieces.mesh.vertex_count == 16
    assert sorted(pieces.source.tolist()) == sorted([*range(12), 1, 4, 7, 10])
    assert pieces.source[:12].tolist() == list(range(12))
    assert not set(pieces.mesh.corners[:, 0].tolist()) & set(pieces.mesh.corners[:, 1].tolist())
    assert pieces.source[pieces.mesh.corners].tolist() == mesh.corners.tolist()


def test_T4_one_piece_has_nothing_twice() -> None:
    mesh = grid(3, 2, 2)
    for label in (0, -1):
        pieces = Pieces(DrawnMesh(mesh), np.full(12, label, np.int32))
        assert pieces.count == 1 and pieces.mesh.vertex_count == mesh.vertex_count


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("share", [0.0, 0.4, 1.0])
def test_T4_each_cell_keeps_its_shape_and_moves_by_a_share_of_its_pieces_middle(
    kind: str, share: float
) -> None:
    mesh = split_grid(kind, 3, jitter=0.1)
    base, labels = DrawnMesh(mesh), np.random.default_rng(3).integers(-1, 4, mesh.cell_count, dtype=np.int32)
    pieces = Pieces(base, labels)
    exploded = ExplodedMesh(pieces, share)
    corners = exploded.mesh.corners
    assert pieces.source[corners].tolist() == mesh.corners.tolist()
    piece = np.where(labels < 0, labels.max() + 1, labels)
    assert (pieces.piece[corners] == piece).all()
    used = np.unique(corners)
    pairs = list(zip(pieces.source[used].tolist(), pieces.piece[used].tolist(), strict=True))
    assert len(set(pairs)) == len(pairs), "a vertex is there once for each piece"
    expected = base.points(mesh.corners) + share * moves(base, labels)[:, None]
    assert np.allclose(exploded.points(corners), expected, atol=2e-6)
    cells = np.arange(mesh.cell_count)
    middles = base.barycentres(cells) + share * moves(base, labels)
    assert np.allclose(exploded.barycentres(cells), middles, atol=2e-6)
    assert np.allclose([exploded.moved(cell) for cell in cells], share * moves(base, labels).T, atol=1e-9)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("kind", ["hexahedron", "wedge", "tetrahedron"])
def test_T4_pieces_are_drawn_as_each_would_be_alone(mode: str, kind: str) -> None:
    mesh = split_grid(kind, 3, jitter=0.1)
    base, labels = DrawnMesh(mesh), slabs(mesh)
    shown = random_mask(mesh.cell_count, 5, 0.8)
    exploded = extract_surface(ExplodedMesh(Pieces(base, labels), 0.5), shown, mode)
    check_form(exploded)
    check_closed(exploded)
    moved = 0.5 * moves(base, labels)
    for label in sorted(set(labels.tolist())):
        alone = rows(extract_surface(base, shown & (labels == label), mode))
        alone[:, 1:13] += np.tile(moved[:, np.flatnonzero(labels == label)[0]], 4)
        own = rows(exploded)
        own = own[labels[(own[:, 0] // 8).astype(int)] == label]
        order = lambda table: table[np.lexsort(np.round(table[:, ::-1], 3).T)]  # noqa: E731
        assert own.shape == alone.shape and len(own)
        assert np.allclose(order(own), order(alone), atol=3e-6)


@pytest.mark.parametrize("mode", ["lines", "darkness_coded_edges"])
def test_T4_edges_of_pieces_are_those_of_each_alone(mode: str) -> None:
    mesh = grid(4, 3, 2, jitter=0.1)
    base, labels = DrawnMesh(mesh), slabs(mesh, 1.7)
    shown = random_mask(mesh.cell_count, 2, 0.7)
    whole = extract_surface(ExplodedMesh(Pieces(base, labels), 1.0), shown, mode)
    found, counts = [], []
    for label in sorted(set(labels.tolist())):
        own = labels == label
        alone = extract_surface(base, shown & own, mode)
        ends = alone.edges.reshape(-1, 2, 3) + moves(base, labels)[:, np.flatnonzero(own)[0]]
        found += [tuple(sorted(map(tuple, np.round(pair, 4).tolist()))) for pair in ends]
        counts += alone.edge_cells.tolist()
    mine = [
        tuple(sorted(map(tuple, np.round(pair, 4).tolist())))
        for pair in whole.edges.reshape(-1, 2, 3).astype(float)
    ]
    near = lambda pairs: sorted(np.ravel(pair).tolist() for pair in pairs)  # noqa: E731
    assert len(mine) == len(found)
    assert np.allclose(near(mine), near(found), atol=3e-4)
    assert sorted(whole.edge_cells.tolist()) == sorted(counts)


@pytest.mark.parametrize("kind", KINDS)
def test_T4_faces_between_pieces_are_drawn_and_flagged_inside(kind: str) -> None:
    mesh = split_grid(kind, 2)
    labels = np.random.default_rng(1).integers(0, 3, mesh.cell_count, dtype=np.int32)
    every = np.ones(mesh.cell_count, bool)
    surface = extract_surface(ExplodedMesh(Pieces(DrawnMesh(mesh), labels), 0.3), every, "lines")
    expected = {8 * cell + local: within for cell, local, within in parted(mesh, labels)}
    assert tags(surface) == set(expected)
    inside = dict(zip(surface.faces.tolist(), surface.inside[::4].tolist(), strict=True))
    assert inside == {tag: 255 * within for tag, within in expected.items()}


def test_T4_a_share_of_nothing_draws_the_same_and_walls() -> None:
    mesh = grid(4, 3, 3, jitter=0.1)
    base, labels = DrawnMesh(mesh), slabs(mesh)
    shown = random_mask(mesh.cell_count, 4, 0.8)
    plain = rows(extract_surface(base, shown, "lines"))
    apart = rows(extract_surface(ExplodedMesh(Pieces(base, labels), 0.0), shown, "lines"))
    truth = BruteForce(mesh.cells.tolist())
    walls = {
        8 * cell + local
        for sides in truth.face_sides.values()
        if len({labels[cell] for cell, _ in sides}) > 1 and all(shown[cell] for cell, _ in sides)
        for cell, local in sides
    }
    assert walls and walls == set(apart[:, 0].tolist()) - set(plain[:, 0].tolist())
    assert np.array_equal(apart[~np.isin(apart[:, 0], list(walls))], plain)


def test_T4_the_silhouette_of_pieces_leaves_walls_out() -> None:
    mesh = grid(4, 3, 2)
    base, labels = DrawnMesh(mesh), slabs(mesh)
    shown = random_mask(mesh.cell_count, 6, 0.4)
    found = extract_silhouette(ExplodedMesh(Pieces(base, labels), 0.5), shown)
    truth = BruteForce(mesh.cells.tolist())
    quads = []
    for face in truth.boundary:
        ((cell, _),) = truth.face_sides[face]
        if not shown[cell]:
            corners = np.array(sorted(face))
            middle = base.points(corners).mean(axis=1) + 0.5 * moves(base, labels)[:, cell]
            quads.append(tuple(np.round(middle, 4).tolist()))
    middles = np.round(found.positions.reshape(-1, 4, 3).astype(float).mean(axis=1), 4).tolist()
    assert np.allclose(sorted(map(tuple, middles)), sorted(quads), atol=3e-4)


@pytest.mark.parametrize("kind", ["hexahedron", "pyramid"])
def test_T4_arrows_of_vertices_stay_with_their_vertices(kind: str) -> None:
    mesh = split_grid(kind, 2, jitter=0.1)
    base, labels = DrawnMesh(mesh), slabs(mesh, 0.9)
    pieces = Pieces(base, labels)
    field = VectorField(mesh.points - mesh.points.mean(axis=0), "point")
    every = np.ones(mesh.cell_count, bool)
    found = extract_arrows(ExplodedMesh(pieces, 0.7), every, field.of(pieces.source))
    sides = parted(mesh, labels)
    assert len(found.cells) == len(sides)
    moved = 0.7 * moves(base, labels)
    homes = found.positions.reshape(-1, 3) - moved[:, found.cells].T
    frame = base.frame
    places = homes * frame.diagonal + frame.centre
    expected = (places - mesh.points.mean(axis=0)) / field.longest
    assert np.allclose(found.vectors.reshape(-1, 3), expected, atol=1e-5)
    of_cells = VectorField(np.zeros((mesh.cell_count, 3)), "cell")
    assert of_cells.of(pieces.source) is of_cells


def test_T4_a_cell_that_is_there_twice_is_drawn_once() -> None:
    mesh = with_repeats(grid(3, 1, 1), 1)
    labels = np.array([0, 1, 1, -1], np.int32)
    every = np.ones(4, bool)
    surface = extract_surface(ExplodedMesh(Pieces(DrawnMesh(mesh), labels), 0.5), every, "lines")
    assert set(surface.cells.tolist()) == {0, 1, 2}
    assert len(surface.faces) == 6 + 10
    check_closed(surface)


def test_T4_pieces_whose_middle_passes_all_bounds_stay() -> None:
    mesh = grid(2, 1, 1, turned=False)
    mesh = Mesh(0.8e308 * mesh.coordinates, mesh.corners, mesh.kinds)
    with np.errstate(over="ignore"):
        assert not np.isfinite(mesh.barycentres[0]).all()
    pieces = Pieces(DrawnMesh(mesh), np.array([0, 1], np.int32))
    assert np.isfinite(pieces.middles).all() and pieces.middles[0, 1] == 0


def test_T4_no_cells_no_pieces() -> None:
    none = DrawnMesh(Mesh.from_cells(np.zeros((3, 3)), np.empty((0, 8), int)))
    pieces = Pieces(none, np.empty(0, np.int32))
    surface = extract_surface(ExplodedMesh(pieces, 1.0), np.empty(0, bool), "lines")
    assert len(surface.faces) == 0
