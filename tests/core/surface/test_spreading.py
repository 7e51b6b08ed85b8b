"""Places spread over a surface, against the same choice made one place at a time."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from hexalab.surface.spreading import spread

Floats32 = NDArray[np.float32]


def sphere(count: int, seed: int) -> tuple[Floats32, Floats32]:
    """Places on a sphere and the normals there, (3, N)."""
    normals = np.random.default_rng(seed).normal(size=(3, count))
    normals /= np.linalg.norm(normals, axis=0)
    return (0.3 * normals).astype(np.float32), normals.astype(np.float32)


def sheet(count: int, seed: int) -> tuple[Floats32, Floats32]:
    """Places on both sides of a tilted sheet without thickness."""
    rng = np.random.default_rng(seed)
    u, v = rng.uniform(-0.4, 0.4, (2, count))
    normal = np.array([[0.36], [0.48], [0.8]])
    places = np.array([[0.8], [-0.6], [0]]) * u + np.array([[0.48], [0.64], [-0.6]]) * v
    return places.astype(np.float32), (normal * rng.choice([-1, 1], count)).astype(np.float32)


def one_by_one(places: Floats32, normals: Floats32, most: int) -> list[int]:
    """The choice, by the words of `spread`: the smallest cubes, who is nearest to their middles, the better of two."""
    for step in range(40, -40, -1):
        side = np.float32(2 ** (-step / 4))
        cubes: dict[tuple[float, ...], list[tuple[float, int]]] = {}
        for row, place in enumerate(places.T):
            cube = np.rint(place / side)
            aside = float((((place / side) - cube) ** 2).sum())
            cubes.setdefault(tuple(cube.tolist()), []).append((aside, row))
        candidates = []
        for inside in cubes.values():
            first = min(inside)
            mates = [one for one in inside if normals[:, one[1]] @ normals[:, first[1]] < -0.5]
            candidates += [first, *([min(mates)] if mates else [])]
        if len(candidates) <= most:
            break
    kept: list[int] = []
    for _, row in sorted(candidates):
        near = (
            np.linalg.norm(places[:, row] - places[:, other]) < 0.5 * side
            and normals[:, row] @ normals[:, other] > -0.5
            for other in kept
        )
        if not any(near):
            kept.append(row)
    return sorted(kept)


@pytest.mark.parametrize("surface", [sphere, sheet])
@pytest.mark.parametrize(("count", "most"), [(2000, 100), (2000, 333), (5000, 20)])
def test_R8_the_choice_is_that_of_its_words(surface, count: int, most: int) -> None:  # type: ignore[no-untyped-def]
    places, normals = surface(count, seed=most)
    chosen = spread(places, normals, most)
    assert chosen.tolist() == one_by_one(places, normals, most)
    assert most / 4 < len(chosen) <= most


def test_R8_few_places_are_all_taken_even_where_they_are_one() -> None:
    places = np.zeros((3, 50), np.float32)
    normals = np.tile(np.float32([[0], [0], [1]]), 50)
    assert spread(places, normals, 50).tolist() == list(range(50))
    assert spread(places, normals, 49).tolist() == [0]


def test_R8_places_far_beyond_the_frame_do_no_harm() -> None:
    places, normals = sphere(3000, seed=1)
    places[0, ::300] = 1e30
    chosen = spread(places, normals, 100)
    assert 25 < len(chosen) <= 100 and (places[0, chosen] == np.float32(1e30)).any()
    assert (places[0, chosen] < 1).sum() > 20


def test_R8_a_sparse_curve_through_space_needs_no_table_of_all_cubes() -> None:
    t = np.linspace(-0.5, 0.5, 60_000)
    places = np.stack([t, t, t]).astype(np.float32)
    normals = np.tile(np.float32([[1], [0], [0]]), len(t))
    chosen = spread(places, normals, 1000)
    assert 500 < len(chosen) <= 1000
    gaps = np.diff(places[0, chosen])
    assert gaps.max() < 4 * gaps.min()
