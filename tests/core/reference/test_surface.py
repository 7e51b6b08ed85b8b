"""The record of a surface: what it checks, and its area, volume and closedness against closed formulas."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from hexalab.reference import TriangleSurface
from hexalab.reference.cutting import triangles_of
from tests.core.reference.surfaces import CUBE, CUBE_QUADS, assert_same, ball, cut_by_vtk, poly_data, vtk


def surface(points: object, triangles: object) -> TriangleSurface:
    return TriangleSurface(np.transpose(points), np.transpose(triangles))  # type: ignore[arg-type]


def cube() -> TriangleSurface:
    quads = CUBE_QUADS.reshape(-1)
    return TriangleSurface(CUBE.T, triangles_of(CUBE.T, quads, range(0, 24, 4), np.full(6, 4)))


def moved(one: TriangleSurface, size: float, step: float) -> TriangleSurface:
    return TriangleSurface(one.points * size + step, one.triangles)


def prism(sides: int) -> TriangleSurface:
    """A regular prism in the unit circle, of height 2."""
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    points = np.concatenate([np.insert(ring, 2, -1, axis=1), np.insert(ring, 2, 1, axis=1)])
    low = np.arange(sides)
    after = (low + 1) % sides
    ids = np.concatenate(
        [low[::-1], low + sides, np.stack([low, after, after + sides, low + sides], axis=1).reshape(-1)]
    )
    sizes = np.array([sides, sides, *[4] * sides])
    return TriangleSurface(points.T, triangles_of(points.T, ids, np.cumsum(sizes) - sizes, sizes))


def test_a_cube() -> None:
    found = cube()
    assert (found.count, found.closed) == (12, True)
    assert found.area == pytest.approx(6, rel=1e-14) and found.volume == pytest.approx(1, rel=1e-14)
    assert found.extent.tolist() == [[0, 0, 0], [1, 1, 1]] and found.diagonal == math.sqrt(3)


@pytest.mark.parametrize("sides", [3, 4, 5, 6, 17, 1000])
def test_prisms(sides: int) -> None:
    found = prism(sides)
    base = sides / 2 * math.sin(2 * math.pi / sides)
    assert found.closed
    assert found.volume == pytest.approx(2 * base, rel=1e-12)
    assert found.area == pytest.approx(2 * base + 4 * sides * math.sin(math.pi / sides), rel=1e-12)


@pytest.mark.parametrize(
    ("size", "step"), [(1, 1e8), (2, -3), (1e-120, 0), (1e90, 0), (1e-300, 0), (1e100, 1e100), (1e60, -1e60)]
)
def test_far_away_small_and_large(size: float, step: float) -> None:
    found = moved(cube(), size, step)
    error = 8 * np.finfo(float).eps * abs(step / size)
    assert found.area == pytest.approx(6 * size * size, rel=1e-12 + error)
    assert found.volume == pytest.approx(size * size * size, rel=1e-12 + 3 * error)


def test_what_is_too_large_is_infinite_and_nothing_is_warned_of() -> None:
    assert moved(cube(), 1e200, 0).area == math.inf
    assert moved(cube(), 1e300, -1e300).volume == math.inf


def test_inside_out_and_open() -> None:
    found = cube()
    turned = TriangleSurface(found.points, found.triangles[::-1])
    assert turned.closed and turned.volume == pytest.approx(-1, rel=1e-14) and turned.area == found.area
    assert not TriangleSurface(found.points, found.triangles[:, 1:]).closed
    one_turned = found.triangles.copy()
    one_turned[:, 3] = one_turned[::-1, 3]
    assert not TriangleSurface(found.points, one_turned).closed


def test_two_bodies_that_share_an_edge_are_not_closed_but_two_apart_are() -> None:
    tetrahedron = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    points = np.random.default_rng(0).random((8, 3))
    assert surface(points, np.concatenate([tetrahedron, tetrahedron + 4])).closed
    shared = np.array([0, 1, 4, 5])[tetrahedron]
    assert not surface(points, np.concatenate([tetrahedron, shared])).closed
    assert not surface(points, np.concatenate([tetrahedron, tetrahedron])).closed
    assert not surface(points, np.concatenate([tetrahedron, tetrahedron[:, ::-1]])).closed


def test_vertices_that_no_triangle_uses() -> None:
    found = surface([[9, 9, 9], [0, 0, 0], [1, 0, 0], [0, 2, 0], [-9, 0, 0]], [[1, 2, 3]])
    assert found.vertices_used.tolist() == [1, 2, 3] and found.vertices_used.dtype == np.int32
    assert found.extent.tolist() == [[0, 0, 0], [1, 2, 0]]
    assert found.area == 1 and not found.closed


def test_none_at_all() -> None:
    found = TriangleSurface(np.empty((3, 0)), np.empty((3, 0), np.int32))
    assert (found.count, found.area, found.volume, found.closed) == (0, 0, 0, False)


def test_arrays_are_kept_as_they_should_be_and_can_not_be_written() -> None:
    found = TriangleSurface(np.asfortranarray(np.eye(3, dtype=np.float32)), [[0], [1], [2]], notes=["a"])
    for array, dtype in ((found.points, np.float64), (found.triangles, np.int32)):
        assert array.dtype == dtype and array.flags.c_contiguous and not array.flags.writeable
    assert found.notes == ("a",) and found.rows is None


@pytest.mark.parametrize(
    ("points", "triangles", "words"),
    [
        (np.eye(3)[:2], np.zeros((3, 1), int), r"points must be \(3, V\) numbers, not \(2, 3\)"),
        (np.eye(3), np.zeros((2, 1), int), r"triangles must be \(3, T\), not \(2, 1\)"),
        (np.eye(3), [[0], [1], [3]], "vertices 0 to 3, expected 0 to 2"),
        (np.eye(3), [[0], [-1], [2]], "vertices -1 to 2, expected 0 to 2"),
        (np.eye(3), [[0.0], [1.0], [2.0]], "expected integers"),
        (np.array([[0, 1, 2], [0, np.nan, 1], [0, 0, 0.0]]), [[0], [1], [2]], "point 1 is .*nan.*finite"),
        (np.array([[0, 1, 2], [0, 5, 1], [0, np.inf, 0.0]]), [[0], [1], [2]], "point 1 is .*inf.*finite"),
    ],
)
def test_what_is_refused(points: NDArray[np.float64], triangles: object, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        TriangleSurface(points, triangles)  # type: ignore[arg-type]


def test_area_and_volume_against_vtk() -> None:
    points, triangles = ball(3)
    measured = vtk.vtkMassProperties()
    measured.SetInputData(poly_data(points, *triangles))
    found = surface(points, triangles)
    assert found.closed
    assert found.area == pytest.approx(measured.GetSurfaceArea(), rel=1e-12)
    assert found.volume == pytest.approx(measured.GetVolume(), rel=1e-9)


def test_convex_quadrilaterals_are_cut_as_vtk_cuts_them() -> None:
    random = np.random.default_rng(0)
    quads = random.random((4000, 4, 3)) * np.where(np.arange(4000) % 2, 1, [[1], [1], [0]]).T[:, None]
    a, b, c, d = quads.swapaxes(0, 1)
    normal = np.cross(c - a, d - b)
    turns = [np.cross(q - p, r - q) for p, q, r in ((d, a, b), (a, b, c), (b, c, d), (c, d, a))]
    quads = quads[np.all([(turn * normal).sum(axis=1) > 0 for turn in turns], axis=0)]
    count = len(quads)
    points, ids = quads.reshape(-1, 3), np.arange(4 * count)
    found = TriangleSurface(points.T, triangles_of(points.T, ids, range(0, 4 * count, 4), np.full(count, 4)))
    assert count > 1000
    cut = vtk.vtkTrivialProducer()
    cut.SetOutput(poly_data(points, *ids.reshape(-1, 4)))
    assert_same(found, cut_by_vtk(cut.GetOutputPort()))


def test_polygons_are_cut_whatever_there_are_many_or_few_of(monkeypatch: pytest.MonkeyPatch) -> None:
    """In chunks of two, of three, and all at once."""
    random = np.random.default_rng(8)
    points = random.random((3, 40))
    sizes = random.integers(3, 9, 50)
    gaps = random.integers(0, 3, 50)
    starts = np.cumsum(sizes + gaps) - sizes
    ids = np.full(int(starts[-1] + sizes[-1]), -5)
    for start, size in zip(starts, sizes, strict=True):
        ids[start : start + size] = random.choice(40, size, replace=False)
    whole = triangles_of(points, ids, starts, sizes)
    expected = []
    for start, size in zip(starts, sizes, strict=True):
        row = ids[start : start + size].tolist()
        own = [[row[0], row[at], row[at + 1]] for at in range(1, size - 1)]
        if size == 4:
            a, b, c, d = (points[:, one] for one in row)
            if ((b - d) ** 2).sum() < ((a - c) ** 2).sum():
                own = [[row[0], row[1], row[3]], [row[1], row[2], row[3]]]
        expected += own
    assert whole.T.tolist() == expected
    for chunk in (2, 3):
        monkeypatch.setattr("hexalab.reference.cutting.CHUNK", chunk)
        assert triangles_of(points, ids, starts, sizes).T.tolist() == expected


@pytest.mark.parametrize("size", [1.0, 1e-200, 1e200])
def test_a_tie_goes_through_the_smallest_vertex_however_the_face_is_numbered(size: float) -> None:
    square = size * np.array([[0, 1, 1, 0], [0, 0, 1, 1], [0, 0, 0, 0.0]])
    for names in ([0, 1, 2, 3], [3, 0, 1, 2], [2, 1, 0, 3]):
        points = np.empty((3, 4))
        points[:, names] = square
        for turn in range(4):
            for step in (1, -1):
                ring = np.roll(names, turn)[::step]
                found = triangles_of(points, ring, range(0, 4, 4), np.array([4])).T.tolist()
                assert all(0 in triangle for triangle in found), "the diagonal ends at vertex 0"
