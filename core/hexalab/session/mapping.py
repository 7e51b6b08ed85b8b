"""Where values stand on a colour map."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats
from ..comparison import QUANTITIES as COMPARED
from ..quality import METRICS
from .opened import Opened

BEYOND = 0.5
"""Places on a colour map of values beyond its limits: so far at the most."""

Reach = Sequence[float] | None
"""Two values, in any order."""


def map_ends(opened: Opened, quantity: str, reach: Reach = None) -> tuple[float, float] | None:
    """Return the values at the ends of a colour map that is not a metric's normalisation; None if there is none.

    They are smallest and largest of the mesh, or of more than this one, `reach`; of changes, as far below 0 as
    above.
    """
    low, high = sorted(reach or opened.range_of(quantity) or (np.nan, np.nan))
    if np.isnan(low):
        return None
    if quantity in COMPARED and COMPARED[quantity].metric:
        most = max(abs(low), abs(high))
        return -most, most
    return low, high


def map_positions(
    opened: Opened, quantity: str, values: Floats, limits: Reach = None, reach: Reach = None
) -> NDArray[np.float64]:
    """Place values on a colour map, from 0, its first colour, to 1, its last.

    The first colour is that of the best value of a metric or of a change of one, or of the lowest of an attribute.

    Parameters
    ----------
    opened : Opened
    quantity : str
        Metric or attribute that the values are of.
    values : (n,) float64
    limits : (low, high), optional
        Values at the ends of the map; by default the metric's normalisation or the attribute's range.
    reach : (low, high), optional
        Smallest and largest value that these are made for; by default those of the mesh.

    Returns
    -------
    (n,) float64
        NaN where a value is not finite; below 0 and above 1 where it is beyond limits that were given.
    """
    metric = METRICS.get(quantity)
    ends = map_ends(opened, quantity, reach)
    if ends is None:
        return np.full(len(values), np.nan)
    if metric is not None and limits is None:
        return np.asarray(1 - metric.normalise(values, *ends))
    low, high = sorted(limits or ends)
    with np.errstate(invalid="ignore", over="ignore"):
        share: Floats = np.zeros(len(values))  # where all values are alike
        if high > low:
            share = (values / 2 - low / 2) / (high / 2 - low / 2)
        elif limits:
            share[values > low] = 1
        reach_beyond = BEYOND if limits else 0.0
        normal = np.clip(share, -reach_beyond, 1 + reach_beyond)
    normal = np.where(np.isfinite(values), normal, np.nan)
    turned = opened.better_of(quantity) == "high"
    return np.asarray(1 - normal if turned else normal, dtype=np.float64)
