"""What must not change when a cell is moved, scaled, turned or numbered anew."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from hexalab.quality import METRICS, certify, quality_many
from tests.core.quality.verdict import CUBE, mesh_of


@settings(max_examples=50, deadline=None)
@given(seed=st.integers(0, 2**32), scale=st.floats(1e-3, 1e3))
def test_Q1_shape_does_not_depend_on_place_size_or_turn(seed: int, scale: float) -> None:
    random = np.random.default_rng(seed)
    cell = CUBE + random.uniform(-0.25, 0.25, (8, 3))
    turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    moved = scale * (cell @ turn + random.uniform(-2, 2, 3))
    before, after = (quality_many(mesh_of(c[None])) for c in (cell, moved))
    for metric in METRICS.values():
        if "size" not in metric.id:
            assert_allclose(
                after[metric.id], before[metric.id] * scale**metric.length_power, rtol=1e-7, atol=1e-9
            )


@settings(max_examples=50, deadline=None)
@given(seed=st.integers(0, 2**32))
def test_Q1_numbering_of_the_corners_does_not_matter(seed: int) -> None:
    cell = CUBE + np.random.default_rng(seed).uniform(-0.25, 0.25, (8, 3))
    turned = cell[[1, 2, 3, 0, 5, 6, 7, 4]]
    before, after = (quality_many(mesh_of(c[None])) for c in (cell, turned))
    for metric in METRICS:
        assert_allclose(after[metric], before[metric], rtol=1e-10, atol=1e-12)


@settings(max_examples=30, deadline=None)
@given(seed=st.integers(0, 2**32), power=st.integers(-300, 300))
def test_Q6_a_power_of_two_changes_nothing(seed: int, power: int) -> None:
    cells = CUBE + np.random.default_rng(seed).uniform(-0.5, 0.5, (20, 8, 3))
    np.testing.assert_array_equal(certify(mesh_of(cells)).state, certify(mesh_of(cells * 2.0**power)).state)
