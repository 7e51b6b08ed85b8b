"""Dual surfaces of sheets, and walls between blocks (SPEC T4): quad by quad, against dictionaries."""

from __future__ import annotations

from collections import Counter
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import hexalab
from hexalab.mesh import Mesh
from hexalab.structure import Structure
from hexalab.surface import DrawnMesh, Surface, dual_surface, walls
from tests.core.structure.brute_force import EDGES, FACES, OPPOSITE, Slow
from tests.core.surface.checks import check_form, points_of
from tests.core.surface.shapes import grid, random_mask

REPOSITORY = Path(__file__).resolve().parents[3] / "repository"
NAMES = (
    "structures/self-crossing", "structures/o-grid", "structures/mixed", "structures/valence-5",
    "structures/moebius", "layouts/one-sided", "shapes/t-junction",
)  # fmt: skip

ALONG = tuple(
    tuple(sorted(edge for edge in EDGES if set(edge) & set(FACES[a]) and set(edge) & set(FACES[b])))
    for a, b in OPPOSITE
)
"""The edges of a cell along each direction: those that lead from one of its faces to the one opposite."""


@cache
def opened(name: str) -> tuple[DrawnMesh, Structure, Slow, list[int]]:
    """A mesh, its structure, the same of its hexahedra by dictionaries, and their rows."""
    mesh = hexalab.read(REPOSITORY / f"{name}.mesh")
    rows = [cell for cell in range(mesh.cell_count) if len(set(mesh.cells[cell].tolist())) == 8]
    return DrawnMesh(mesh), hexalab.structure(mesh), Slow(mesh.cells[rows].tolist()), rows


def masks(name: str, count: int) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Some of `count` things, and some of the cells."""
    drawn_mesh, *_ = opened(name)
    return random_mask(count, 7, 0.3), random_mask(drawn_mesh.mesh.cell_count, 3, 0.7)


def front(surface: Surface) -> NDArray[np.float64]:
    """(Q, 3): the normal of each quad."""
    return surface.normals.reshape(-1, 4, 4)[:, 0, :3] / 32767


def test_each_direction_has_four_edges() -> None:
    assert [len(edges) for edges in ALONG] == [4, 4, 4]


@pytest.mark.parametrize("name", NAMES)
def test_T4_a_sheet_has_two_quads_for_each_crossing_at_the_middles_of_its_edges(name: str) -> None:
    drawn_mesh, structure, slow, rows = opened(name)
    chosen, shown = masks(name, structure.sheets.count)
    surface = dual_surface(drawn_mesh, structure.frame, structure.sheets, chosen, shown)
    check_form(surface)
    assert surface.two_sided and (surface.inside == 255).all() and surface.quads is None
    sheet = slow.sheets()
    number = {
        sheet[frozenset((slow.cells[cell][a], slow.cells[cell][b]))]: int(structure.sheets.of_cells[d, cell])
        for cell in range(len(slow.cells))
        for d, ((a, b), *_) in enumerate(ALONG)
    }
    expected: Counter[tuple[int, frozenset[tuple[float, ...]]]] = Counter()
    for place, cell in enumerate(rows):
        for edges in ALONG:
            pairs = [(slow.cells[place][a], slow.cells[place][b]) for a, b in edges]
            (own,) = {number[sheet[frozenset(pair)]] for pair in pairs}
            if shown[cell] and chosen[own]:
                middles = drawn_mesh.points(np.array(pairs)).astype(float).mean(axis=2).T
                expected[cell, near(middles)] += 2
    found = Counter(
        (cell, near(quad))
        for cell, quad in zip(
            (surface.faces // 8).tolist(), points_of(surface).reshape(-1, 4, 3), strict=True
        )
    )
    assert found == expected and found


def near(points: NDArray[np.float64]) -> frozenset[tuple[float, ...]]:
    """Points as keys, rounded: those that lie between two steps are rounded alike in all tests here."""
    return frozenset(map(tuple, np.round(points.astype(np.float32).astype(float) * 2**14).tolist()))


@pytest.mark.parametrize("name", NAMES)
def test_T4_each_quad_is_there_for_both_of_its_sides_and_is_named_by_the_face_before_it(name: str) -> None:
    drawn_mesh, structure, _, _ = opened(name)
    every = np.ones(structure.sheets.count, bool)
    shown = masks(name, 1)[1]
    surface = dual_surface(drawn_mesh, structure.frame, structure.sheets, every, shown)
    normals, cells, local = front(surface), surface.faces // 8, surface.faces % 8
    mesh = drawn_mesh.mesh
    sides = drawn_mesh.points(mesh.corners[np.array(FACES)[local].T, cells]).astype(float).mean(axis=1)
    middles = drawn_mesh.barycentres(cells)
    ahead = ((sides - middles).T * normals).sum(axis=1)
    assert (ahead > 0).all(), "seen from the face that it is named by"
    across = {a: b for pair in OPPOSITE for a, b in (pair, pair[::-1])}
    both = dict(zip(surface.faces.tolist(), normals.round(3).tolist(), strict=True))
    assert len(both) == len(surface.faces), "a face of a cell names one quad"
    for tag, normal in both.items():
        assert np.allclose(both[tag - tag % 8 + across[tag % 8]], -np.array(normal), atol=2e-3)


@pytest.mark.parametrize("name", NAMES)
def test_T4_lines_of_a_dual_surface_are_there_once(name: str) -> None:
    drawn_mesh, structure, slow, rows = opened(name)
    chosen, shown = masks(name, structure.sheets.count)
    surface = dual_surface(drawn_mesh, structure.frame, structure.sheets, chosen, shown)
    expected = set()
    for place, cell in enumerate(rows):
        for d, edges in enumerate(ALONG):
            if not (shown[cell] and chosen[structure.sheets.of_cells[d, place]]):
                continue
            for face in FACES:
                pair = [edge for edge in edges if set(edge) <= set(face)]
                if pair:
                    assert len(pair) == 2
                    expected.add(
                        frozenset(frozenset(slow.cells[place][corner] for corner in edge) for edge in pair)
                    )
    lines = surface.edges.reshape(-1, 2, 3)
    assert len(lines) == len(expected)
    middle = {
        edge: near(drawn_mesh.points(np.array(sorted(edge))).mean(axis=1)[None]) for edge in slow.edge_cells
    }
    truth = Counter(frozenset(middle[edge] for edge in line) for line in expected)
    assert Counter(frozenset((near(a[None]), near(b[None]))) for a, b in lines) == truth


def test_T4_the_dual_surface_of_a_grid_is_a_plane() -> None:
    shape = (3, 4, 2)
    mesh = grid(*shape)
    drawn_mesh, structure = DrawnMesh(mesh), hexalab.structure(mesh)
    every = np.ones(mesh.cell_count, bool)
    found = []
    for sheet in range(structure.sheets.count):
        only = np.arange(structure.sheets.count) == sheet
        surface = dual_surface(drawn_mesh, structure.frame, structure.sheets, only, every)
        places = points_of(surface) * drawn_mesh.frame.diagonal + drawn_mesh.frame.centre
        (axis,) = np.flatnonzero(np.ptp(places, axis=0) < 1e-5)
        found.append((int(axis), round(float(places[:, axis].mean()), 3)))
        normals = np.abs(front(surface))
        assert np.allclose(normals[:, axis], 1, atol=1e-4)
        a, b = (extent for other, extent in enumerate(shape) if other != axis)
        assert len(surface.faces) == 2 * a * b
        assert len(surface.edges) / 6 == a * (b + 1) + b * (a + 1)
    assert sorted(found) == [(axis, k + 0.5) for axis in range(3) for k in range(shape[axis])]


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("variant", ["whole", "interior"])
def test_T4_walls_are_the_separating_faces_inside_twice_each(name: str, variant: str) -> None:
    drawn_mesh, structure, slow, rows = opened(name)
    base = structure.base_complex if variant == "whole" else structure.interior_base_complex
    chosen, shown = masks(name, base.blocks.count)
    block = slow.blocks(inside_only=variant == "interior")
    expected = set()
    for face in slow.walls(inside_only=variant == "interior"):
        around = slow.face_cells[face]
        if len(around) == 2 and any(chosen[block[c]] for c in around) and any(shown[rows[c]] for c in around):
            for cell in around:
                (local,) = (
                    k for k, places in enumerate(FACES) if {slow.cells[cell][p] for p in places} == face
                )
                expected.add(8 * rows[cell] + local)
    surface = walls(drawn_mesh, structure.frame, base, chosen, shown)
    check_form(surface)
    assert surface.two_sided and (surface.inside == 255).all()
    assert len(surface.faces) == len(expected) and set(surface.faces.tolist()) == expected
    cells, local = surface.faces // 8, surface.faces % 8
    corners = drawn_mesh.mesh.corners[np.array(FACES)[local].T, cells]
    assert np.array_equal(points_of(surface).reshape(-1, 4, 3), drawn_mesh.points(corners).T)
    outward = drawn_mesh.points(corners).mean(axis=1) - drawn_mesh.barycentres(cells)
    assert ((outward.T * front(surface)).sum(axis=1) > 0).all()


def test_T4_walls_of_meshes_are_there_to_be_tested() -> None:
    found = {
        name: int(np.count_nonzero(structure.base_complex.separating[: structure.frame.paired]))
        for name in NAMES
        for structure in [opened(name)[1]]
    }
    assert sum(number > 0 for number in found.values()) >= 3, found


def test_T4_nothing_chosen_or_shown_is_nothing() -> None:
    mesh = grid(2, 2, 2)
    drawn_mesh, structure = DrawnMesh(mesh), hexalab.structure(mesh)
    for chosen, shown in ((False, True), (True, False)):
        some = np.full(structure.sheets.count, chosen)
        cells = np.full(8, shown)
        dual = dual_surface(drawn_mesh, structure.frame, structure.sheets, some, cells)
        wall = walls(drawn_mesh, structure.frame, structure.base_complex, some[:1], cells)
        for surface in (dual, wall):
            check_form(surface)
            assert len(surface.faces) == len(surface.edges) == 0


def test_T4_without_hexahedra_there_is_nothing_to_draw() -> None:
    mesh = Mesh.from_cells(np.zeros((4, 3)), np.empty((0, 8), int))
    drawn_mesh, structure = DrawnMesh(mesh), hexalab.structure(mesh)
    none = np.empty(0, bool)
    assert not len(dual_surface(drawn_mesh, structure.frame, structure.sheets, none, none).faces)
    assert not len(walls(drawn_mesh, structure.frame, structure.base_complex, none, none).faces)
