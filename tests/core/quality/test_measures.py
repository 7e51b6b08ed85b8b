"""Statistics and histograms against numpy's and against counting by hand."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hexalab.cells import HEXAHEDRON, TETRAHEDRON
from hexalab.quality import histogram, statistics

INF = float("inf")


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=60))
def test_Q3_statistics_equal_numpys(numbers: list[float]) -> None:
    values = np.array(numbers)
    found = statistics(values)
    assert found["count"] == values.size
    assert found["min"] == values.min()
    assert found["max"] == values.max()
    assert found["mean"] == pytest.approx(values.mean(), abs=1e-9)
    assert found["median"] == pytest.approx(np.median(values), abs=1e-9)
    assert found["variance"] == pytest.approx(values.var(), rel=1e-9, abs=1e-9)
    for name, value in found["percentiles"].items():
        assert value == pytest.approx(np.percentile(values, int(name)), rel=1e-12, abs=1e-9)


def test_Q3_what_is_not_finite_is_counted_apart() -> None:
    values = np.array([1.0, -INF, 3.0, np.nan, INF, 2.0])
    found = statistics(values)
    assert (found["not_finite"], found["count"]) == (3, 3)
    assert (found["min"], found["max"], found["mean"]) == (1, 3, 2)
    assert json.loads(json.dumps(found)) == found


def test_Q3_nothing_finite_has_no_numbers() -> None:
    for values in (np.array([]), np.array([np.nan, INF])):
        found = statistics(values, "shape")
        assert found["min"] is found["mean"] is found["median"] is None
        assert found["percentiles"]["5"] is None
        assert found["not_finite"] == values.size


def test_Q3_outside_the_acceptable_range() -> None:
    values = np.array([0.1, 0.5, 0.9, 1.0, -0.2, -INF])
    assert statistics(values, "scaled_jacobian")["outside_acceptable"] == 2
    assert statistics(values, "edge_ratio")["outside_acceptable"] == 0
    assert statistics(values)["outside_acceptable"] == 0


def test_Q3_worst_cells_by_id() -> None:
    values = np.array([0.5, 0.1, np.nan, 0.1, -INF, 0.9] + [0.8] * 20)
    assert statistics(values, "scaled_jacobian")["worst"][:5] == [1, 3, 0, 6, 7]  # finite ones alone
    assert statistics(values, "scaled_jacobian")["worst"][-1] == 12
    assert len(statistics(values, "scaled_jacobian")["worst"]) == 10
    assert statistics(values, "skew")["worst"][:2] == [5, 6]


@given(st.lists(st.integers(0, 5), min_size=1, max_size=80))
def test_Q3_worst_cells_equal_a_stable_sort(numbers: list[int]) -> None:
    values = np.array(numbers, dtype=float)
    assert statistics(values, "shape")["worst"] == np.argsort(values, kind="stable")[:10].tolist()
    assert statistics(values, "oddy")["worst"] == np.argsort(-values, kind="stable")[:10].tolist()


def test_Q3_kinds_without_the_metric_are_not_counted() -> None:
    values = np.array([0.5, np.nan, INF, 0.7])
    kinds = np.array([HEXAHEDRON, TETRAHEDRON, HEXAHEDRON, HEXAHEDRON], np.uint8)
    found = statistics(values, "skew", kinds)
    assert (found["count"], found["not_finite"]) == (2, 1)
    assert found["worst"] == [3, 0]
    assert statistics(values, "skew")["not_finite"] == 2


@given(st.lists(st.integers(-50, 150), max_size=80), st.integers(1, 12))
def test_Q4_bins_equal_counting_by_hand(numbers: list[int], bins: int) -> None:
    values = np.array(numbers, dtype=float) + 0.5
    edges, counts = histogram(values, 0, bins * 8, bins)
    assert counts.dtype == np.int64
    np.testing.assert_allclose(edges, np.arange(bins + 1) * 8)
    for place in range(bins):
        assert counts[place] == sum(8 * place <= value < 8 * place + 8 for value in values)


def test_Q4_both_ends_belong_and_what_is_not_finite_does_not() -> None:
    values = np.array([0.0, 1.0, 1.0 + 2e-16, -0.1, 1.1, np.nan, INF, -INF, 0.5])
    edges, counts = histogram(values, 0.0, 1.0, 4)
    assert counts.tolist() == [1, 0, 1, 2]
    assert (edges[0], edges[-1]) == (0, 1)


@pytest.mark.parametrize("value", [0.0, 3.0, -2.0, 1e-9, 1e29])
def test_Q4_an_empty_range_is_widened(value: float) -> None:
    edges, counts = histogram(np.full(7, value), value, value, 5)
    assert counts.tolist() == [0, 0, 7, 0, 0]
    assert edges[0] < value < edges[-1]


def test_Q4_senseless_ranges_are_refused() -> None:
    for low, high, bins in ((0, INF, 3), (2, 1, 3), (0, 1, 0), (np.nan, 1, 3)):
        with pytest.raises(ValueError, match="histogram"):
            histogram(np.zeros(3), low, high, bins)
