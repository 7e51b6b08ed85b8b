"""Diagnosis: meshes with one fault each, cells of every kind and orientation, sizes from tiny to huge."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations

import numpy as np
import pytest
from numpy.typing import NDArray

from hexalab.cells import COLLAPSE, CORNERS_OF_KIND, HEXAHEDRON, KINDS, PYRAMID, TETRAHEDRON, WEDGE
from hexalab.diagnosis import Finding, diagnose, turn_round
from hexalab.diagnosis.coincidence import coincident_vertices
from hexalab.diagnosis.orientation import MIRROR, NODES, signs
from hexalab.mesh import Mesh
from tests.core.filters.boxes import box

POINTS_OF_KIND = (
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
    [[0, 0, 0], [0, 1, 0], [1, 0, 0], [0, 0, 1], [0, 1, 1], [1, 0, 1]],
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]],
    [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
)
"""One positive cell of each kind, its corners in its own (VTK's) order."""


def one_of(kind: int, points: NDArray[np.float64] | None = None) -> Mesh:
    own = np.array(POINTS_OF_KIND[kind] if points is None else points, dtype=float)
    return Mesh(own.T, np.array([COLLAPSE[kind]]).T, np.array([kind], np.uint8))


def found(mesh: Mesh) -> dict[str, Finding]:
    return {finding.id: finding for finding in diagnose(mesh)}


def changed(mesh: Mesh, points: NDArray[np.float64]) -> Mesh:
    return Mesh(points.T, mesh.corners, mesh.kinds)


@pytest.mark.parametrize("kind", range(4))
def test_R9_nothing_to_say_of_a_sound_cell(kind: int) -> None:
    assert diagnose(one_of(kind)) == []
    assert diagnose(box(3, 2, 2)) == []


@pytest.mark.parametrize("kind", range(4))
@pytest.mark.parametrize("size", [1e-12, 1, 1e12])
@pytest.mark.parametrize("away", [0, 1e4])
def test_R9_signs_at_any_size_and_place(kind: int, size: float, away: float) -> None:
    own = (np.array(POINTS_OF_KIND[kind]) + away) * size
    mirrored = own * [-1, 1, 1]
    flat = own * [1, 1, 0] + [0, 0, away * size]
    for points, volume in ((own, 1), (mirrored, -1), (flat, 0)):
        result = signs(one_of(kind, points))
        assert result.volume.tolist() == [volume]
        assert result.invalid_corner.tolist() == [volume <= 0]


@pytest.mark.parametrize("thin", [1e-2, 1e-5])
def test_R9_thin_is_not_flat(thin: float) -> None:
    for stretch in permutations((1, 1, thin)):
        assert signs(one_of(HEXAHEDRON, np.array(POINTS_OF_KIND[0]) * stretch)).volume.tolist() == [1]
        assert not signs(one_of(HEXAHEDRON, np.array(POINTS_OF_KIND[0]) * stretch)).invalid_corner.any()


def test_R9_volume_is_that_within_bilinear_faces() -> None:
    """Against the integral of the Jacobian over the cell: two Gauss points in each direction are exact."""
    random = np.random.default_rng(5)
    gauss = np.array([-1, 1]) / np.sqrt(3) / 2 + 0.5
    for _ in range(300):
        points = np.array(POINTS_OF_KIND[0]) + random.normal(size=(8, 3)) * 0.6
        volume = sum(jacobian(points, u, v, w) for u in gauss for v in gauss for w in gauss) / 8
        assert signs(one_of(HEXAHEDRON, points)).volume[0] == np.sign(volume)


def jacobian(points: NDArray[np.float64], u: float, v: float, w: float) -> float:
    """Of the trilinear map, by its definition."""
    places = np.array(POINTS_OF_KIND[0], dtype=float)
    at = np.array([u, v, w])
    factor = np.where(places == 1, at, 1 - at)
    slope = np.where(places == 1, 1.0, -1.0)
    columns = []
    for axis in range(3):
        weights = slope[:, axis] * np.delete(factor, axis, axis=1).prod(axis=1)
        columns.append(weights @ points)
    return float(np.linalg.det(np.array(columns)))


def test_R9_invalid_corners_of_hexahedra_by_the_jacobian_there() -> None:
    random = np.random.default_rng(6)
    for _ in range(300):
        points = np.array(POINTS_OF_KIND[0]) + random.normal(size=(8, 3)) * 0.35
        least = min(jacobian(points, *corner) for corner in POINTS_OF_KIND[0])
        assert signs(one_of(HEXAHEDRON, points)).invalid_corner[0] == (least <= 0)


@pytest.mark.parametrize("kind", [WEDGE, PYRAMID])
def test_R9_each_corner_of_a_kind_counts(kind: int) -> None:
    """A corner pulled through the cell makes it invalid there, wherever it is."""
    centre = np.mean(POINTS_OF_KIND[kind], axis=0)
    for row in NODES[kind]:
        points = np.array(POINTS_OF_KIND[kind], dtype=float)
        points[row[0]] += 1.8 * (centre - points[row[0]])
        assert signs(one_of(kind, points)).invalid_corner[0], (KINDS[kind], row)
    assert len({row[0] for row in NODES[kind]}) == len(NODES[kind]) == (6, 4)[kind - 1]


def test_R9_inverted_degenerate_and_invalid_cells_with_their_ids() -> None:
    mesh = box(4, 1, 1)
    cells = mesh.cells.copy()
    cells[1] = cells[1][list(MIRROR[HEXAHEDRON])]
    points = np.concatenate([mesh.points, [[3.5, 0.5, 0.5]] * 8])
    points[cells[3, 6]] -= 0.9
    spoilt = Mesh.from_cells(points, cells)
    report = found(spoilt)
    assert report["inverted_cells"].cells.tolist() == [1]
    assert report["inverted_cells"].message == "1 cell has negative volume."
    assert report["invalid_corner_cells"].cells.tolist() == [1, 3]
    assert report["opposite_orientation"].count == 2
    assert report["opposite_orientation"].cells.tolist() == [0, 1, 2]
    assert "all_inverted" not in report
    flat = changed(mesh, mesh.points * [1, 1, 0])
    assert found(flat)["degenerate_cells"].count == 4
    assert "inverted_cells" not in found(flat)


def test_R9_repeated_vertices_of_hexahedra_only() -> None:
    mesh = box(3, 1, 1)
    cells = mesh.cells.copy()
    cells[2][[5, 6]] = cells[2][[1, 2]]
    report = found(Mesh.from_cells(mesh.points, cells))
    assert report["repeated_vertices"].cells.tolist() == [2]
    assert "repeated_vertices" not in found(one_of(TETRAHEDRON))
    twice = Mesh(np.eye(3, 4), np.array([[0, 1, 1, 1, 2, 2, 2, 2]]).T, np.array([TETRAHEDRON], np.uint8))
    assert found(twice)["repeated_vertices"].count == 1


def test_R9_a_wedge_written_as_a_hexahedron_is_valid() -> None:
    """At-Most-Hexa meshes: a corner whose edge has vanished has no Jacobian to be invalid by."""
    points = np.array(POINTS_OF_KIND[0], dtype=float)
    report = found(Mesh.from_cells(points, [[0, 1, 2, 2, 4, 5, 6, 6]]))
    assert set(report) == {"repeated_vertices", "unreferenced_vertices"}


def test_R9_unreferenced_vertices() -> None:
    mesh = box(2, 2, 2)
    stray = Mesh(np.hstack([mesh.coordinates[:, :5], [[9.0], [9], [9]], mesh.coordinates[:, 5:]]),
                 np.where(mesh.corners >= 5, mesh.corners + 1, mesh.corners), mesh.kinds)  # fmt: skip
    report = found(stray)
    assert set(report) == {"unreferenced_vertices"}
    assert report["unreferenced_vertices"].vertices.tolist() == [5]
    assert report["unreferenced_vertices"].message == "1 vertex belongs to no cell."


@pytest.mark.parametrize("size", [1e-9, 1, 1e9])
def test_R9_coincident_vertices_at_any_size(size: float) -> None:
    """Two boxes that touch, each with its own vertices; some of them off by rounding."""
    one, other = box(2, 2, 2), box(2, 2, 2)
    shifted = other.points + np.array([2, 0, 0])
    shifted[::2] += 1e-13
    both = Mesh.from_cells(
        np.concatenate([one.points, shifted]) * size, np.concatenate([one.cells, other.cells + 27])
    )
    where = np.concatenate([one.points, other.points + np.array([2, 0, 0])])
    double = [v for v in range(54) if (np.abs(where - where[v]).max(axis=1) < 0.5).sum() > 1]
    assert len(double) == 18
    assert coincident_vertices(both).tolist() == double
    report = found(both)
    assert report["coincident_vertices"].vertices.tolist() == double
    assert report["components"].count == 2
    assert report["components"].cells.tolist() == list(range(8, 16))


def test_R9_coincident_vertices_against_all_pairs() -> None:
    random = np.random.default_rng(8)
    for _ in range(20):
        points = random.integers(0, 4, size=(80, 3)) + random.normal(size=(80, 3)) * random.choice(
            [0, 1e-12, 1e-3]
        )
        mesh = Mesh.from_cells(points, random.permutation(80).reshape(10, 8))
        near = 1e-9 * mesh.diagonal
        distance = np.linalg.norm(points[:, None] - points[None], axis=2)
        double = np.flatnonzero((distance < near).sum(axis=1) > 1)
        assert coincident_vertices(mesh).tolist() == double.tolist()


def test_R9_faces_of_more_than_two_cells() -> None:
    mesh = box(2, 1, 1)
    face = mesh.cells[0][[1, 2, 6, 5]]
    more = np.concatenate([mesh.points, mesh.points[face] + [-0.5, 3, 3]])
    third = [face[0], *range(12, 12 + 1), 13, face[1], face[3], 15, 14, face[2]]
    report = found(Mesh.from_cells(more, [*mesh.cells.tolist(), third]))
    assert report["nonmanifold_faces"].count == 1
    assert report["nonmanifold_faces"].cells.tolist() == [0, 1, 2]


@pytest.mark.parametrize("kind", range(4))
def test_R9_a_mesh_inside_out_is_turned_round(kind: int) -> None:
    inverted = one_of(kind, np.array(POINTS_OF_KIND[kind]) * [1, -1, 1])
    assert {"all_inverted", "inverted_cells"} <= set(found(inverted))
    turned = turn_round(inverted)
    report = found(turned)
    assert set(report) == {"turned_round"}
    assert turned.notes == [report["turned_round"].message]
    assert sorted(set(turned.cells[0])) == sorted(set(inverted.cells[0]))
    own = turned.corners[list(CORNERS_OF_KIND[kind])]
    assert turned.corners.tolist() == own[list(COLLAPSE[kind])].tolist(), "still in collapsed form"


def test_R9_turning_round_keeps_everything_else() -> None:
    mesh = box(3, 3, 3)
    inverted = Mesh(
        mesh.coordinates * [[-1], [1], [1]], mesh.corners, mesh.kinds, cell_data={"t": np.arange(27)}
    )
    turned = turn_round(inverted)
    assert turned.cell_data.keys() == {"t"} and turned.coordinates is inverted.coordinates
    assert turned.topology.face_count == inverted.topology.face_count
    assert (signs(turned).volume == 1).all() and not signs(turned).invalid_corner.any()


def test_R9_a_mesh_with_one_positive_cell_is_left_as_it_is() -> None:
    mesh = box(3, 1, 1)
    cells = mesh.cells.copy()
    cells[1:] = cells[1:][:, list(MIRROR[HEXAHEDRON])]
    mixed = Mesh.from_cells(mesh.points, cells)
    assert turn_round(mixed) is mixed
    assert turn_round(mesh) is mesh
    flat = changed(mesh, mesh.points * [1, 1, 0])
    assert turn_round(flat) is flat


def test_R9_what_was_noted_in_reading_is_a_finding_and_errors_stand_first() -> None:
    mesh = box(1, 1, 1)
    noted = Mesh(
        mesh.coordinates * [[-1], [1], [1]], mesh.corners, mesh.kinds, notes=["3 bars were left out."]
    )
    report = diagnose(noted)
    assert [finding.severity for finding in report] == ["error", "error", "error", "note"]
    assert (report[-1].id, report[-1].message) == ("reading", "3 bars were left out.")


def test_R9_no_cells() -> None:
    empty = Mesh(np.zeros((3, 2)), np.empty((8, 0)), np.empty(0))
    assert set(found(empty)) == {"unreferenced_vertices"}
    assert turn_round(empty) is empty


def test_R9_coordinates_that_are_no_numbers() -> None:
    mesh = box(3, 1, 1)
    coordinates = mesh.coordinates.copy()
    coordinates[:, 0] = [np.nan, np.inf, 0]
    mesh = replace(mesh, coordinates=coordinates)
    with np.errstate(all="raise"):
        report = found(mesh)
    assert report["degenerate_cells"].cells.tolist() == report["invalid_corner_cells"].cells.tolist() == [0]
    assert turn_round(mesh) is mesh


def test_R9_a_vertex_far_away_that_no_cell_uses_does_not_hide_the_only_positive_cell() -> None:
    cells = box(2, 1, 1)
    corners = cells.corners.copy()
    corners[:, 0] = corners[list(MIRROR[HEXAHEDRON]), 0]
    points = np.concatenate([cells.points * 1e-8, [[1e9, 0, 0]]])
    mesh = Mesh(points.T, corners, cells.kinds)
    assert signs(mesh).volume.tolist() == [-1, 1]
    assert turn_round(mesh) is mesh
