"""Any points and triangles, drawn at random, beside exact arithmetic."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import example, given, settings
from hypothesis import strategies as st

from hexalab.comparison import TriangleIndex
from tests.core.comparison.brute_force import check, exact, root

LATTICE = st.integers(-2, 2).map(float)
ANY = st.floats(-10, 10, width=32)
POINT = st.one_of(st.tuples(LATTICE, LATTICE, LATTICE), st.tuples(ANY, ANY, ANY))


@given(POINT, POINT, POINT, POINT, st.sampled_from([0.0, 1e6, -1e9]), st.sampled_from([1e-9, 1.0, 1e9]))
@settings(max_examples=300)
@example((0, 0, 0), (0, 0, 0), (0, 0, 0), (0, 0, 0), 0.0, 1.0)
@example((1, 1, 0), (0, 0, 0), (0, 0, 0), (2, 0, 0), 0.0, 1.0)
@example((0.5, 3, 0), (0, 0, 0), (0, 1, 0), (0, 1e-160, 0), 0.0, 1.0)
def test_any_point_and_any_triangle(
    p: tuple[float, ...],
    a: tuple[float, ...],
    b: tuple[float, ...],
    c: tuple[float, ...],
    offset: float,
    scale: float,
) -> None:
    corners = np.array([a, b, c]) * scale + offset
    check((np.array([p]) * scale + offset), corners[None])


WHOLE = st.integers(-3, 3).map(float)
PLACE = st.tuples(WHOLE, WHOLE, WHOLE)


@given(
    st.lists(st.tuples(PLACE, PLACE, PLACE), min_size=1, max_size=40),
    st.lists(PLACE, min_size=1, max_size=12),
)
@settings(max_examples=100)
def test_any_few_triangles_many_of_them_degenerate_touching_or_equal(
    corners: list[Any], queries: list[Any]
) -> None:
    places = np.array(corners)
    triangles = np.arange(3 * len(corners), dtype=np.int32).reshape(-1, 3).T
    found = TriangleIndex(places.reshape(-1, 3).T, triangles).nearest(np.array(queries).T)
    for query, far, triangle in zip(np.array(queries), *found[:2], strict=True):
        squares = [exact(query, own) for own in places]
        assert abs(far - root(min(squares))) <= 1e-14
        assert abs(root(squares[triangle]) - far) <= 1e-14
