"""The scales of the plots' axes: where values go, which of them are labelled, and how."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

SQUEEZE = 5
"""How much smaller the Scaled Jacobian is drawn below 0: few meshes go there, and how far tells little."""

SMALLEST_SHARE = 1e-3
"""From which on shares are drawn by their logarithm; from 0 to there they are not."""

Ticks = list[tuple[float, str]]
"""Values and their labels."""


@dataclass(frozen=True)
class Scale:
    """A scale.

    Parameters
    ----------
    name, options : str, dict
        As Matplotlib's `set_xscale` takes them.
    limits : callable
        From the values that are drawn to the ends of the axis.
    ticks : callable
        From the ends of the axis to what is labelled.
    """

    name: str
    options: dict[str, Any]
    limits: Callable[[Sequence[float]], tuple[float, float]]
    ticks: Callable[[float, float], Ticks]


def _squeezed(values: Any) -> Any:
    values = np.asarray(values, float)
    return np.where(values < 0, values / SQUEEZE, values)


def _stretched(values: Any) -> Any:
    values = np.asarray(values, float)
    return np.where(values < 0, values * SQUEEZE, values)


def _wide(values: Sequence[float]) -> tuple[float, float]:
    return min(values) / 1.4, max(values) * 1.4


def _decades(low: float, high: float) -> Ticks:
    powers = range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)
    return [(10.0**power, f"{10**power:,}") for power in powers if power >= 0]


def _jacobian_limits(values: Sequence[float]) -> tuple[float, float]:
    return (-1.12 if min(values) <= 0 else -0.02), 1.02


def _jacobian_ticks(low: float, high: float) -> Ticks:
    ticks = [(-1, "−1"), (0, "0"), (0.25, "0.25"), (0.5, "0.5"), (0.75, "0.75"), (1, "1")]
    return [(value, label) for value, label in ticks if low <= value <= high]


def _mean_limits(values: Sequence[float]) -> tuple[float, float]:
    return min(0.9, math.floor(min(values) * 10) / 10) - 0.01, 1.01


def _tenths(low: float, high: float) -> Ticks:
    return [(tenth / 10, f"{tenth / 10:g}") for tenth in range(11) if low <= tenth / 10 <= high]


def _shares(low: float, high: float) -> Ticks:
    ticks = [(0, "0"), (0.001, "0.1 %"), (0.01, "1 %"), (0.1, "10 %"), (1, "100 %")]
    return [(value, label) for value, label in ticks if low <= value <= high]


SCALES = {
    "count": Scale("log", {}, _wide, _decades),
    "jacobian": Scale("function", {"functions": (_squeezed, _stretched)}, _jacobian_limits, _jacobian_ticks),
    "mean": Scale("linear", {}, _mean_limits, _tenths),
    "share": Scale(
        "symlog",
        {"linthresh": SMALLEST_SHARE, "linscale": 0.6},
        lambda values: (-SMALLEST_SHARE / 6, min(1.0, max(values) * 1.3)),
        _shares,
    ),
    "year": Scale(
        "linear",
        {},
        lambda values: (min(values) - 0.6, max(values) + 0.6),
        lambda low, high: [(year, str(year)) for year in range(math.ceil(low), math.floor(high) + 1)],
    ),
}
"""Scales by what they are of."""
