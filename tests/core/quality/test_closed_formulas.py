"""Metrics of cells whose values follow on paper."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from hexalab.quality import METRICS, quality
from tests.core.quality.verdict import CUBE, NAMES, mesh_of

OF_A_BOX: dict[str, Callable[[float, float, float], float]] = {}
"""Metrics that Verdict has not got, by what they are of a box with sides a, b and c."""


def value(corners: np.ndarray, metric: str) -> float:
    return float(quality(mesh_of(np.asarray(corners, dtype=float)[None]), metric)[0])


@pytest.mark.parametrize("metric", [m.id for m in METRICS.values() if m.unit_cube is not None])
def test_Q2_unit_cube_has_the_value_of_the_table(metric: str) -> None:
    assert value(CUBE, metric) == pytest.approx(METRICS[metric].unit_cube, abs=1e-12)


def test_Q1_box() -> None:
    a, b, c = 1.0, 2.0, 5.0
    box = CUBE * [a, b, c]
    assert value(box, "volume") == pytest.approx(a * b * c)
    assert value(box, "jacobian") == pytest.approx(a * b * c)
    assert value(box, "max_edge_ratio") == pytest.approx(c / a)
    assert value(box, "stretch") == pytest.approx(np.sqrt(3) * a / np.sqrt(a * a + b * b + c * c))
    assert value(box, "shape") == pytest.approx(3 * (a * b * c) ** (2 / 3) / (a * a + b * b + c * c))
    norm = (a**2 + b**2 + c**2) * ((b * c) ** 2 + (a * c) ** 2 + (a * b) ** 2)
    assert value(box, "max_aspect_frobenius") == pytest.approx(np.sqrt(norm) / (3 * a * b * c))
    squares = a**4 + b**4 + c**4 - (a * a + b * b + c * c) ** 2 / 3
    assert value(box, "oddy") == pytest.approx(squares / (a * b * c) ** (4 / 3))
    gradients = 8 * ((b * c / 4) ** 2 + (a * c / 4) ** 2 + (a * b / 4) ** 2)
    assert value(box, "dimension") == pytest.approx(a * b * c / np.sqrt(2 * gradients))
    for metric in ("scaled_jacobian", "shear", "diagonal", "distortion", "nodal_jacobian_ratio"):
        assert value(box, metric) == pytest.approx(1)


def test_Q1_every_metric_has_a_truth_outside() -> None:
    """Verdict's, or a formula that follows on paper."""
    assert NAMES.keys() | OF_A_BOX.keys() == METRICS.keys()
    assert not NAMES.keys() & OF_A_BOX.keys()
    for metric, formula in OF_A_BOX.items():
        for sides in ((1.0, 2.0, 5.0), (3.0, 0.5, 0.5)):
            assert value(CUBE * sides, metric) == pytest.approx(formula(*sides))


@pytest.mark.parametrize("slant", [0.25, 1.0, 3.0])
def test_Q1_sheared_cube(slant: float) -> None:
    sheared = CUBE + CUBE[:, 2:] * [slant, 0, 0]
    length = np.sqrt(1 + slant * slant)
    angle = np.degrees(np.arctan(slant))
    assert value(sheared, "volume") == pytest.approx(1)
    assert value(sheared, "scaled_jacobian") == pytest.approx(1 / length)
    assert value(sheared, "skew") == pytest.approx(slant / length)
    assert value(sheared, "taper") == pytest.approx(0, abs=1e-12)
    assert value(sheared, "equiangle_skew") == pytest.approx(angle / 90)
    assert value(sheared, "shape") == pytest.approx(3 / (2 + length**2))


def test_Q1_frustum() -> None:
    top = 0.5
    frustum = CUBE - [0.5, 0.5, 0]
    frustum[4:, :2] *= top
    assert value(frustum, "volume") == pytest.approx((1 + top + top * top) / 3)
    assert value(frustum, "nodal_jacobian_ratio") == pytest.approx(top * top)
    assert value(frustum, "jacobian") == pytest.approx(top * top)
    assert value(frustum, "taper") == pytest.approx((2 - 2 * top) / (2 + 2 * top))


def test_Q1_edge_ratio_misses_the_edges_that_verdict_misses() -> None:
    seen, unseen = CUBE.copy(), CUBE.copy()
    seen[[1, 2, 5, 6], 0] = 4
    unseen[4:, 2] = 4
    assert value(seen, "edge_ratio") == pytest.approx(4)
    assert value(unseen, "edge_ratio") == pytest.approx(1)
