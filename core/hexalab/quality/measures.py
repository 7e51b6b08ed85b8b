"""Statistics and histograms of a metric's values over a mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats
from .metrics import METRICS, Metric

PERCENTILES = (1, 5, 25, 75, 95, 99)
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
        range; 0 where there is none), `worst` (ids of at most ten cells, worst first, infinite values before all).
        Numbers are None where no value is finite.
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
    worst = _worst(values, low_is_worst)
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
    mean = float(sound.mean())
    deviation = sound - mean
    deviation *= deviation
    out.update(
        min=float(sound.min()),
        max=float(sound.max()),
        mean=mean,
        median=quantiles[-1],
        variance=float(deviation.mean()),
        percentiles={str(p): q for p, q in zip(PERCENTILES, quantiles, strict=False)},
    )
    if metric is not None and metric.acceptable_range is not None:
        low, high = metric.acceptable_range
        out["outside_acceptable"] = int(np.count_nonzero((sound < low) | (sound > high)))
    return out


def _percentiles(values: Floats, percents: tuple[int, ...]) -> list[float]:
    """Percentiles with linear interpolation, by one partition."""
    places = np.array(percents) / 100 * (values.size - 1)
    below = np.floor(places).astype(np.int64)
    above = np.minimum(below + 1, values.size - 1)
    ordered = np.partition(values, np.unique(np.concatenate([below, above])))
    left, right = ordered[below], ordered[above]
    with np.errstate(over="ignore"):
        return [float(x) for x in left + (right - left) * (places - below)]


def _worst(values: Floats, low_is_worst: bool) -> NDArray[np.int64]:
    """Indices of the worst values, worst first, ties by id; NaN is none."""
    key = values if low_is_worst else -values
    known = np.flatnonzero(~np.isnan(key)) if np.isnan(key).any() else None
    if known is not None:
        key = key[known]
    if key.size > WORST:
        limit = np.partition(key, WORST - 1)[WORST - 1]
        candidates = np.flatnonzero(key < limit)
        ties = np.flatnonzero(key == limit)[: WORST - candidates.size]
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
    if low == high:
        half = abs(low) / 2 or 0.5
        low, high = low - half, high + half
    values = np.asarray(values, dtype=np.float64)
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
