"""The table of metrics: the paper's ranges, and its normalisations there and back."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hexalab.quality import METRICS

INF = float("inf")

PAPER = """
DIA 0 1 0.65 1 1 | DIS -inf inf 0.5 1 1 | ER 1 inf - - 1 | J -inf inf 0 inf 1 | MER 1 inf 1 1.3 1
MAAF 1 inf 1 3 1 | MEAF 1 inf 1 3 1 | ODD 0 inf 0 0.5 0 | RSS 0 1 0.5 1 - | SJ -1 1 0.5 1 1 | SHA 0 1 0.3 1 1
SHAS 0 1 0.2 1 - | SHE 0 1 0.3 1 1 | SHES 0 1 0.2 1 - | SKE 0 inf 0 0.5 0 | STR 0 inf 0.25 1 1
TAP 0 inf 0 0.5 0 | VOL -inf inf 0 inf 1
"""
"""The paper's table: id, full range, acceptable range, value for the unit cube."""

BY_SYMBOL = {metric.symbol: metric for metric in METRICS.values()}
ROWS = [row.split() for row in PAPER.replace("\n", "|").split("|") if row.strip()]

PHI = {
    "q": ["DIA", "RSS", "SHA", "SHAS", "SHE", "SHES"],
    "max(q, 0)": ["SJ"],
    "(q - low) / (high - low)": ["DIS", "J", "VOL"],
    "(high - q) / (high - 1)": ["ER", "MER", "MAAF", "MEAF"],
    "(high - q) / high": ["ODD", "SKE", "TAP"],
    "q / high": ["STR"],
}


@pytest.mark.parametrize("row", ROWS, ids=[row[0] for row in ROWS])
def test_Q2_ranges_are_the_papers(row: list[str]) -> None:
    metric = BY_SYMBOL[row[0]]
    numbers = [None if text == "-" else float(text) for text in row[1:]]
    assert list(metric.full_range) == numbers[:2]
    assert metric.acceptable_range == (None if numbers[2] is None else tuple(numbers[2:4]))
    assert metric.unit_cube == numbers[4]


def test_Q2_the_table_is_complete() -> None:
    assert {metric.id for metric in METRICS.values()} == METRICS.keys()
    assert len(BY_SYMBOL) == len(METRICS)
    assert {row[0] for row in ROWS} < BY_SYMBOL.keys()
    assert len(ROWS) == 18
    assert {"dimension", "equiangle_skew", "nodal_jacobian_ratio"} < METRICS.keys()
    for metric in METRICS.values():
        low, high = metric.full_range
        assert low < high
        assert metric.name
        assert metric.formula
        assert metric.worst == (-INF if metric.better == "high" else INF)
        if metric.unit_cube is not None:
            assert low <= metric.unit_cube <= high


@pytest.mark.parametrize(("formula", "symbols"), PHI.items(), ids=PHI)
def test_Q2_phi_is_the_papers(formula: str, symbols: list[str]) -> None:
    for symbol in symbols:
        metric = BY_SYMBOL[symbol]
        low, high = (1.5, 4.0) if metric.full_range[1] == INF else (0.1, 0.9)
        for q in np.linspace(low, high, 7):
            expected = eval(formula, {"q": q, "low": low, "high": high, "max": max})
            assert metric.normalise(np.array([q]), low, high)[0] == pytest.approx(expected)


@given(
    metric=st.sampled_from(list(METRICS.values())),
    ends=st.tuples(st.floats(1.001, 50), st.floats(1.001, 50)).filter(
        lambda ends: abs(ends[0] - ends[1]) > 1e-3
    ),
    place=st.floats(0, 1),
)
def test_Q2_phi_and_its_inverse_are_inverse(metric: object, ends: tuple[float, float], place: float) -> None:
    low, high = sorted(ends)
    if metric.full_range[1] in (1, 3):
        low, high = low / 100, high / 100
    native = low + place * (high - low)
    normal = metric.normalise(np.array([native]), low, high)
    assert 0 <= normal[0] <= 1
    assert metric.denormalise(normal, low, high)[0] == pytest.approx(native, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("metric", METRICS.values(), ids=METRICS)
def test_Q2_one_is_best_and_zero_worst(metric: object) -> None:
    low, high = (0.2, 0.9) if metric.full_range[1] in (1, 3) else (1.2, 7.0)
    best, worst = (high, low) if metric.better == "high" else (low, high)
    good, bad = metric.normalise(np.array([best, worst]), low, high)
    assert good > bad


def test_Q2_scaled_jacobian_clamps() -> None:
    values = METRICS["scaled_jacobian"].normalise(np.array([-0.5, 0.0, 0.25, 1.0 + 2e-16]), -0.5, 1.0)
    np.testing.assert_array_equal(values, [0, 0, 0.25, 1])


@pytest.mark.parametrize("metric", METRICS.values(), ids=METRICS)
def test_Q2_empty_ranges_normalise_to_one(metric: object) -> None:
    if metric.normalisation.span is None:
        return
    for value in (1.0, 0.0, 2.5):
        values = np.full(3, value)
        np.testing.assert_array_equal(metric.normalise(values, value, value), 1)
        np.testing.assert_array_equal(metric.denormalise(np.array([0.0, 1.0]), value, value), value)
    rounding = 3.0 + np.array([0, 1, 2]) * 4e-16
    np.testing.assert_array_equal(metric.normalise(rounding, rounding.min(), rounding.max()), 1)


@pytest.mark.parametrize("metric", METRICS.values(), ids=METRICS)
def test_Q1_what_is_not_finite_has_no_place_on_the_scale(metric: object) -> None:
    values = np.array([0.5, INF, -INF, np.nan, 0.75])
    normal = metric.normalise(values, 0.25, 0.75)
    np.testing.assert_array_equal(np.isnan(normal), [False, True, True, True, False])
