"""Statistics and histograms of a metric's values over a mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats
from .metrics import METRICS, Metric

PERCENTILES = (1, 5, 25, 75, 95, 99)
LARGEST = float(np.finfo(np.float64).max)

ROUNDING = 1e-12
"""What is outside of the acceptable range by no more than this part of its end is inside, but for rounding."""

WORST = 10
"""Number of worst cells listed."""


def statistics(
    values: Array, metric: Metric | str | None = None, kinds: Array | None = None
) -> dict[str, Any]:
    """Summarise one value per cell.

    Parameters
    ----------
    values : (C,) float
        Native values; those that are not finite are counted and left out of all else.
    metric : Metric, its id, or None
        Says what is acceptable and which end is worst; without it the lowest values are the worst.
    kinds : (C,) uint8, optional
        Cell kinds: cells of a kind that has not got the metric are then not counted at all.

    Returns
    -------
    dict
        `count`, `min`, `max`, `mean`, `median`, `variance` (of the population), `percentiles` ("1", "5", "25", "75",
        "95", "99", interpolated linearly), `not_finite`, `outside_acceptable` (finite values outside the acceptable
        range; 0 where there is none), `worst` (ids of at most ten cells of finite value, worst first).
        Numbers are None where no value is finite, the variance also where it passes float64.
    """
    if isinstance(metric, str):
        metric = METRICS[metric]
    values = np.asarray(values, dtype=np.float64)
    considered: NDArray[np.int64] | None = None
    if kinds is not None and metric is not None:
        has = np.isin(kinds, metric.kinds)
        if not has.all():
            considered = np.flatnonzero(has)
            values = values[considered]
    finite = np.isfinite(values)
    sound = values if finite.all() else values[finite]
    low_is_worst = metric is None or metric.better == "high"
    worst = worst_first(values, low_is_worst)
    if considered is not None:
        worst = considered[worst]
    out: dict[str, Any] = {
        "count": int(sound.size),
        "min": None,
        "max": None,
        "mean": None,
        "median": None,
        "variance": None,
        "percentiles": {str(p): None for p in PERCENTILES},
        "not_finite": int(values.size - sound.size),
        "outside_acceptable": 0,
        "worst": [int(cell) for cell in worst],
    }
    if not sound.size:
        return out
    quantiles = _percentiles(sound, (*PERCENTILES, 50))
    mean, variance = _moments(sound)
    out.update(
        min=float(sound.min()),
        max=float(sound.max()),
        mean=mean,
        median=quantiles[-1],
        variance=variance,
        percentiles={str(p): q for p, q in zip(PERCENTILES, quantiles, strict=False)},
    )
    if metric is not None and metric.acceptable_range is not None:
        low, high = (
            end + side * ROUNDING * abs(end)
            for end, side in zip(metric.acceptable_range, (-1, 1), strict=True)
        )
        out["outside_acceptable"] = int(np.count_nonzero((sound < low) | (sound > high)))
    return out


def _moments(values: Floats) -> tuple[float, float | None]:
    """Mean and variance of finite values, without overflow on the way; None for a variance that float64 can't hold."""
    largest = float(np.abs(values).max())
    exponent = int(np.frexp(largest)[1]) if not 1e-100 < largest < 1e100 else 0
    deviation = np.ldexp(values, -exponent) if exponent else values.copy()
    mean = float(deviation.mean())
    deviation -= mean
    deviation *= deviation
    with np.errstate(over="ignore"):
        variance = float(np.ldexp(deviation.mean(), 2 * exponent))
    return float(np.ldexp(mean, exponent)), variance if np.isfinite(variance) else None


def _percentiles(values: Floats, percents: tuple[int, ...]) -> list[float]:
    """Percentiles with linear interpolation, by one partition."""
    places = np.array(percents) / 100 * (values.size - 1)
    below = np.floor(places).astype(np.int64)
    above = np.minimum(below + 1, values.size - 1)
    ordered = np.partition(values, np.unique(np.concatenate([below, above])))
    left, right = ordered[below], ordered[above]
    share = places - below
    with np.errstate(over="ignore"):
        step = right - left
    between = np.where(np.isfinite(step), left + step * share, left * (1 - share) + right * share)
    return [float(x) for x in between]


def worst_first(values: Array, low_is_worst: bool, count: int = WORST) -> NDArray[np.int64]:
    """Find the worst of some values.

    Parameters
    ----------
    values : (C,) float64
        Those that are not finite are left out: they have no order.
    low_is_worst : bool
    count : int
        At most so many.

    Returns
    -------
    (n,) int64
        Their indices, worst first, of equal ones in order.
    """
    key = values if low_is_worst else -values
    finite = np.isfinite(key)
    known = None if finite.all() else np.flatnonzero(finite)
    if known is not None:
        key = key[known]
    if key.size > count:
        limit = np.partition(key, count - 1)[count - 1]
        candidates = np.flatnonzero(key < limit)
        ties = np.flatnonzero(key == limit)[: count - candidates.size]
        candidates = np.concatenate([candidates, ties])
    else:
        candidates = np.arange(key.size)
    candidates = candidates[np.lexsort((candidates, key[candidates]))]
    return np.asarray(candidates if known is None else known[candidates])


def histogram(values: Array, low: float, high: float, bins: int = 100) -> tuple[Floats, NDArray[np.int64]]:
    """Count values in bins of equal width.

    Parameters
    ----------
    values : (C,) float
        What is not finite or outside [low, high] is not counted.
    low, high : float
        Ends of the range, both included (with a tolerance of 1e-12 of its width, for rounding). An empty
        range is widened by half its value, or by a half at zero, so that its values stand in the middle.
    bins : int
        Number of bins, at least 1.

    Returns
    -------
    edges : (bins + 1,) float64
    counts : (bins,) int64
    """
    if bins < 1:
        raise ValueError(f"a histogram has at least one bin, not {bins}")
    if not (np.isfinite(low) and np.isfinite(high) and low <= high):
        raise ValueError(f"a histogram's range must be finite and in order, not {low} to {high}")
    values = np.asarray(values, dtype=np.float64)
    if low == high:
        half = abs(low) / 2 or 0.5
        low, high = max(low - half, -LARGEST), min(high + half, LARGEST)
    half = high / 2 - low / 2
    if not 1e-290 < half < 1e300:  # the same, of numbers that float64 can divide
        exponent = int(np.frexp(half)[1])
        with np.errstate(over="ignore"):
            values, ends = np.ldexp(values, -exponent), np.ldexp([low, high], -exponent)
        edges, counts = histogram(values, float(ends[0]), float(ends[1]), bins)
        return np.ldexp(edges, exponent), counts
    edges = low + (high - low) * (np.arange(bins + 1) / bins)
    edges[-1] = high
    place = values - low
    place *= bins / (high - low)
    slack = 1e-12 * bins
    with np.errstate(invalid="ignore"):
        inside = (place >= -slack) & (place <= bins + slack)
    if not inside.all():
        place = place[inside]
    index = place.astype(np.int32)
    np.clip(index, 0, bins - 1, out=index)
    return edges, np.bincount(index, minlength=bins)
