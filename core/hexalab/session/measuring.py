"""Numbers for the panels: statistics and histograms of metrics and attributes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..mesh import cell_barycentres
from ..packing import jsonable
from ..quality import METRICS, histogram
from ..quality.measures import worst_first
from .mapping import Reach, map_ends, map_positions
from .opened import Opened


def statistics_of(opened: Opened, quantity: str) -> dict[str, Any]:
    """Return the statistics of a quantity, a metric or an attribute, and what the table knows of the metric.

    Returns
    -------
    dict
        As `hexalab.statistics`, and `id`, `name`, `symbol`, `low`, `high` (finite range over the mesh),
        `acceptable_range`, `full_range` (an infinite end is None), `worst_value`, `best_value` (native values
        where the normalised quality is 0 and 1; None for an attribute).
    """
    numbers = opened.statistics_of(quantity)
    reach = opened.range_of(quantity)
    low, high = reach or (None, None)
    told: dict[str, Any] = {
        "id": quantity,
        "name": opened.label_of(quantity),
        "symbol": "",
        "low": low,
        "high": high,
    }
    told.update(acceptable_range=None, full_range=None, worst_value=None, best_value=None)
    metric = METRICS.get(quantity)
    if metric is not None:
        told.update(
            symbol=metric.symbol, acceptable_range=metric.acceptable_range, full_range=metric.full_range
        )
        if reach is not None:
            worst, best = metric.denormalise(np.array([0.0, 1.0]), *reach)
            told.update(worst_value=worst, best_value=best)
    answer: dict[str, Any] = jsonable({**numbers, **told})
    return answer


def worst_of(opened: Opened, quantity: str, count: int) -> dict[str, Any]:
    """Return the worst cells by a metric or by a change of one, or those of the highest values of an attribute.

    Returns
    -------
    dict
        `cells` (ids of at most `count` cells of finite value, worst first), their `values` and `places` (barycentres,
        [x, y, z] each), and `not_finite`, ids of at most `count` cells that have no finite value though their kind
        has the metric.
    """
    mesh, metric, values = opened.mesh, METRICS.get(quantity), opened.values(quantity)
    cells = worst_first(values, opened.better_of(quantity) == "high", count)
    bad = ~np.isfinite(values)
    if metric is not None:
        bad &= np.isin(mesh.kinds, metric.kinds)
    some = mesh.corners[:, cells]
    places = cell_barycentres(mesh.coordinates, some, mesh.kinds[cells])
    answer: dict[str, Any] = jsonable(
        {
            "cells": cells.tolist(),
            "values": values[cells].tolist(),
            "places": places.T.tolist(),
            "not_finite": np.flatnonzero(bad)[:count].tolist(),
        }
    )
    return answer


def histogram_of(
    opened: Opened,
    quantity: str,
    bins: int,
    shown: NDArray[np.bool_] | None,
    limits: Reach = None,
    reach: Reach = None,
) -> dict[str, Any]:
    """Count the values of a quantity in bins.

    Parameters
    ----------
    opened : Opened
    quantity : str
    bins : int
    shown : (C,) bool or None
        Cells to count; None for all.
    limits : (low, high) or None
        Values at the ends of the colour map, if the status fixes them.
    reach : (low, high) or None
        Smallest and largest value that axis and colours are made for, if they are those of more than this mesh.

    Returns
    -------
    dict
        `quantity`, `label`, `edges` (bins + 1,), `counts` (bins,), `map_position` (bins,) of the bins' middles,
        `low`, `high` (ends of the axis), `not_finite`.
    """
    values = opened.values(quantity)
    if shown is not None:
        values = values[shown]
    low, high = axis_of(opened, quantity, reach)
    edges, counts = histogram(values, low, high, bins)
    middles = (edges[1:] + edges[:-1]) / 2
    return {
        "quantity": quantity,
        "label": opened.label_of(quantity),
        "edges": edges,
        "counts": counts.astype(np.uint32),
        "map_position": map_positions(opened, quantity, middles, limits, reach).astype(np.float32),
        "low": low,
        "high": high,
        "not_finite": int(np.count_nonzero(~np.isfinite(values))),
    }


def axis_of(opened: Opened, quantity: str, reach: Reach = None) -> tuple[float, float]:
    """Return the ends of a histogram's axis: the finite values, and a metric's worst and best ones."""
    found = map_ends(opened, quantity, reach)
    if found is None:
        return 0.0, 1.0
    ends = list(found)
    if quantity in METRICS:
        ends += METRICS[quantity].denormalise(np.array([0.0, 1.0]), *found).tolist()
    ends = [end for end in ends if np.isfinite(end)]
    return min(ends), max(ends)
