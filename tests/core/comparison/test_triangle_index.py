"""The nearest of many triangles beside looking at all of them, in exact arithmetic and by the same formula."""

from __future__ import annotations

import tracemalloc
from typing import Any

import numpy as np
import pytest

from hexalab.comparison import TriangleIndex, frames_of, squared_distances, triangle_index
from tests.core.comparison.brute_force import distance, exact, least, rounding
from tests.core.comparison.surfaces import SURFACES, Surface, also, heap, sheet, sphere


def queries_of(surface: Surface, count: int = 40) -> np.ndarray:
    """(3, n) points: vertices, on triangles, beside them, farther off, at the middle of all, in no order."""
    rng = np.random.default_rng(3)
    corners = surface.corners[np.abs(surface.corners).max(axis=(1, 2)) < 1e20]
    some = corners[rng.integers(len(corners), size=count)]
    on = (some * rng.dirichlet([1] * 3, count)[:, :, None]).sum(axis=1)
    sizes = np.abs(some - some[:, :1]).max() + np.abs(corners - corners.mean(axis=(0, 1))).max() / 1000
    beside = on + rng.normal(size=on.shape) * sizes / 3
    off = corners.mean(axis=(0, 1)) + rng.normal(size=on.shape) * 100 * np.abs(corners).max()
    middle = corners.mean(axis=(0, 1))[None]
    return np.concatenate([some[:, 0], on, beside, off[:5], middle])[::-1].T


def of_all(surface: Surface, queries: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Least squared distance of each query, and the first triangle that has it, of the pairs with all triangles."""
    count = surface.triangles.shape[1]
    frames = frames_of(surface.points[:, surface.triangles].transpose(1, 0, 2))
    squares = [squared_distances(np.repeat(query[:, None], count, axis=1), frames) for query in queries.T]
    return np.min(squares, axis=1), np.argmin(squares, axis=1)


@pytest.mark.parametrize("name", SURFACES)
def test_no_triangle_is_nearer(name: str) -> None:
    """In exact arithmetic."""
    surface = SURFACES[name]()
    queries = queries_of(surface)
    found = TriangleIndex(*surface).nearest(queries)
    assert found.distance.dtype == np.float64
    assert found.triangle.dtype == np.int32
    corners = surface.corners
    for query, far, triangle, closest in zip(queries.T, *found[:2], found.closest.T, strict=True):
        own = corners[triangle]
        within = rounding(query, own)
        assert far <= least(query, corners, far) + within
        assert abs(far - distance(query, own)) <= within
        assert distance(closest, own) <= within + 1e-15 * np.abs(own).max()


@pytest.mark.parametrize("name", SURFACES)
def test_it_is_the_answer_of_looking_at_all_to_the_bit(name: str) -> None:
    """Even of which of several equally far: the first."""
    surface = SURFACES[name]()
    queries = queries_of(surface, 150)
    found = TriangleIndex(*surface).nearest(queries)
    squares, triangles = of_all(surface, queries)
    assert found.distance.tolist() == np.sqrt(squares).tolist()
    assert found.triangle.tolist() == triangles.tolist()


@pytest.mark.parametrize("count", [0, 1, 7, 8, 9, 20_000])
def test_of_triangles_equally_far_it_is_the_smallest_number(count: int) -> None:
    """At a corner of squares up to six meet; on an edge of squares two or three."""
    side = 12
    surface = sheet(side)
    shuffled = np.random.default_rng(1).permutation(surface.triangles.shape[1])
    surface = Surface(surface.points, surface.triangles[:, shuffled])
    rng = np.random.default_rng(8)
    queries = np.concatenate(
        [rng.integers(0, 2 * side + 1, size=(2, count)) / 2, rng.integers(0, 3, (1, count))]
    )
    found = TriangleIndex(*surface).nearest(queries)
    assert found.distance.tolist() == queries[2].tolist()
    assert found.closest.tolist() == (queries * [[1], [1], [0]]).tolist()
    low, high = surface.corners[:, :, :2].min(axis=1), surface.corners[:, :, :2].max(axis=1)
    for query, triangle in zip(queries.T[:300], found.triangle[:300], strict=True):
        inside = ((low <= query[:2]) & (query[:2] <= high)).all(axis=1)
        near = [
            int(one) for one in np.flatnonzero(inside) if exact(query, surface.corners[one]) == query[2] ** 2
        ]
        assert triangle == near[0]


def test_equal_triangles_are_one() -> None:
    surface = heap(300)
    twice = Surface(surface.points, np.concatenate([surface.triangles, surface.triangles], axis=1))
    queries = queries_of(surface, 200)
    once, again = TriangleIndex(*surface).nearest(queries), TriangleIndex(*twice).nearest(queries)
    assert again.triangle.tolist() == once.triangle.tolist()
    assert again.distance.tolist() == once.distance.tolist()


def test_the_order_of_queries_is_none_of_its_business() -> None:
    surface = sphere(20, 30)
    queries = queries_of(surface, 100)
    index = TriangleIndex(*surface)
    together = index.nearest(queries)
    order = np.random.default_rng(4).permutation(queries.shape[1])
    again = index.nearest(queries[:, order])
    alone = [index.nearest(query[:, None]) for query in queries.T]
    for part in (again.distance, again.triangle, again.closest):
        assert part.shape[-1] == len(order)
    assert again.distance.tolist() == together.distance[order].tolist()
    assert again.triangle.tolist() == together.triangle[order].tolist()
    assert again.closest.tolist() == together.closest[:, order].tolist()
    assert [float(one.distance[0]) for one in alone] == together.distance.tolist()
    assert [int(one.triangle[0]) for one in alone] == together.triangle.tolist()


def test_nothing_to_find() -> None:
    index = TriangleIndex(np.zeros((3, 0)), np.zeros((3, 0), np.int32))
    found = index.nearest(np.zeros((3, 2)))
    assert np.isnan(found.distance).all()
    assert found.triangle.tolist() == [-1, -1]
    assert np.isnan(found.closest).all()
    found = TriangleIndex(*sheet(2)).nearest(np.zeros((3, 0)))
    assert [part.shape for part in found] == [(0,), (0,), (3, 0)]


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf, 1e200])
def test_what_has_no_place_is_left_out(wrong: float) -> None:
    """A triangle with such a corner is never the nearest, a query with such a coordinate has no answer."""
    surface = also(sheet(4), [[0, 0, 5.0], [1, 0, 5.0], [0, wrong, 5.0]])
    queries = np.array([[0.5, 0.25, 5.0], [1.0, wrong, 0.0], [3.0, 3.0, 1.0]]).T
    found = TriangleIndex(*surface).nearest(queries)
    assert found.distance.tolist() == pytest.approx([5.0, np.nan, 1.0], nan_ok=True)
    assert found.triangle[1] == -1
    assert (found.triangle[[0, 2]] > 0).all()
    assert found.closest[:, [0, 2]].tolist() == [[0.5, 3.0], [0.25, 3.0], [0.0, 0.0]]
    assert np.isnan(found.closest[:, 1]).all()


class Counter:
    """How many pairs are looked at, and how many at once at the most."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.triangles = self.boxes = self.most = 0
        measure, distances = triangle_index.squared_distances, triangle_index._Search._distances

        def counted(points: np.ndarray, frames: Any) -> np.ndarray:
            self.triangles += points.shape[1]
            self.most = max(self.most, points.shape[1])
            return measure(points, frames)

        def counted_boxes(search: Any, level: Any, who: np.ndarray, nodes: np.ndarray) -> Any:
            self.boxes += 8 * len(nodes)
            self.most = max(self.most, len(nodes))
            return distances(search, level, who, nodes)

        monkeypatch.setattr(triangle_index, "squared_distances", counted)
        monkeypatch.setattr(triangle_index._Search, "_distances", counted_boxes)


@pytest.mark.parametrize("radius", [0.999, 1.0, 1.01])
def test_near_a_sphere_of_100000_triangles_few_are_looked_at(
    radius: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    surface, other = sphere(180, 278), sphere(150, 100)
    index, queries = TriangleIndex(*surface), radius * other.points[:, 100:-100]
    counted = Counter(monkeypatch)
    found = index.nearest(queries)
    count = queries.shape[1]
    assert surface.triangles.shape[1] > 100_000
    assert counted.triangles < 13 * count
    assert counted.boxes < 240 * count
    assert np.abs(found.distance - abs(radius - 1)).max() < 5e-4


def test_a_stray_vertex_far_away_spoils_no_order(monkeypatch: pytest.MonkeyPatch) -> None:
    """All others lie in one cell of the curve then."""
    surface = sphere(60, 80)
    queries = 1.01 * surface.points[:, ::7]
    counted = Counter(monkeypatch)
    TriangleIndex(*surface).nearest(queries)
    usual, counted.boxes, counted.triangles = (counted.boxes, counted.triangles), 0, 0
    found = TriangleIndex(*also(surface, [[1e12, 0, 0], [1e12, 1, 0], [1e12, 0, 1]])).nearest(queries)
    assert counted.boxes < 1.5 * usual[0]
    assert counted.triangles < 1.5 * usual[1]
    assert (found.triangle > 0).all()


def test_at_the_centre_of_a_sphere_memory_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    """All 20,000 triangles have to be looked at for each of 60 queries: at once they would take hundreds of MB."""
    surface = sphere(100, 100)
    queries = np.random.default_rng(6).normal(size=(3, 60)) * 1e-9
    index = TriangleIndex(*surface)
    counted = Counter(monkeypatch)
    tracemalloc.start()
    found = index.nearest(queries)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert counted.triangles > 5_000 * 60
    assert counted.most <= triangle_index.PIECE
    assert peak < 20 * 2**20
    heights = np.linalg.norm(surface.corners.mean(axis=1), axis=1)
    assert found.distance == pytest.approx(heights.min(), rel=1e-3)
