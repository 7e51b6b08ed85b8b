"""Distances of pairs of a point and a triangle beside exact arithmetic: every region, and triangles that are none."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from tests.core.comparison.brute_force import check, measured

REGIONS = (
    ((0.25, 0.5, 2.0), (0.25, 0.5, 0.0)),
    ((0.25, 0.5, 0.0), (0.25, 0.5, 0.0)),
    ((0.25, -3.0, 4.0), (0.25, 0.0, 0.0)),
    ((-3.0, 0.75, -4.0), (0.0, 0.75, 0.0)),
    ((3.0, 3.0, 1.0), (0.5, 0.5, 0.0)),
    ((-3.0, -4.0, 12.0), (0.0, 0.0, 0.0)),
    ((5.0, 1.0, 2.0), (1.0, 0.0, 0.0)),
    ((-1.0, 5.0, 2.0), (0.0, 1.0, 0.0)),
)
"""Points and what is closest to them of the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0)."""


@pytest.mark.parametrize("turn", list(itertools.permutations(range(3))))
@pytest.mark.parametrize("axes", list(itertools.permutations(range(3))))
def test_each_region_of_a_triangle_along_the_axes_to_the_bit(
    turn: tuple[int, ...], axes: tuple[int, ...]
) -> None:
    points, closest = (np.array(part) for part in zip(*REGIONS, strict=True))
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])[list(turn)]
    found, places = measured(points[:, axes], np.repeat(corners[None, :, axes], len(points), axis=0))
    assert places.tolist() == closest[:, axes].tolist()
    assert (found**2).tolist() == pytest.approx(((points - closest) ** 2).sum(axis=1).tolist(), rel=4e-16)


SHAPES = {
    "equilateral": [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75**0.5]],
    "needle": [[0.0, 0.0], [1.0, 0.0], [1.0, 1e-9]],
    "thinner needle": [[0.0, 0.0], [1.0, 0.0], [1.0, 1e-15]],
    "cap": [[0.0, 0.0], [1.0, 0.0], [0.3, 1e-9]],
    "flatter cap": [[0.0, 0.0], [1.0, 0.0], [0.3, 1e-16]],
    "collinear": [[0.0, 0.0], [1.0, 0.0], [0.3, 0.0]],
    "two at one place": [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]],
    "all at one place": [[0.5, 0.5], [0.5, 0.5], [0.5, 0.5]],
}


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("offset", [0.0, 1e6])
def test_slivers_however_thin_in_any_position(shape: str, offset: float) -> None:
    """Points near, far, on the edges, in the plane and off it by next to nothing."""
    rng = np.random.default_rng(5)
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    flat = np.array(SHAPES[shape])
    weights = rng.dirichlet([0.5] * 3, 60)
    weights[:20, rng.integers(3)] = 0
    weights /= weights.sum(axis=1)[:, None]
    on = weights @ flat
    off = rng.normal(size=(60, 3)) * 10.0 ** rng.integers(-17, 3, size=(60, 1))
    off[::3, 2] = 0
    points = (np.column_stack([on, np.zeros(60)]) + off) @ axes + offset
    for turn in itertools.permutations(range(3)):
        corners = np.column_stack([flat[list(turn)], np.zeros(3)]) @ axes + offset
        check(points, np.repeat(corners[None], 60, axis=0))


def test_a_point_is_not_measured_by_its_neighbours_in_the_array() -> None:
    rng = np.random.default_rng(2)
    points, corners = rng.normal(size=(500, 3)), rng.normal(size=(500, 3, 3))
    corners[::5, 2] = corners[::5, 1]
    together, _ = measured(points, corners)
    alone = [measured(points[[i]], corners[[i]])[0][0] for i in range(500)]
    assert together.tolist() == alone


def test_no_pairs() -> None:
    found, closest = measured(np.zeros((0, 3)), np.zeros((0, 3, 3)))
    assert found.shape == (0,)
    assert closest.shape == (0, 3)
