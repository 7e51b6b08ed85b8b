"""The facts of a comparison, as `hexalab compare --json` prints them (SPEC S7)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ..arrays import Floats
from ..mesh import Mesh
from ..numbering import cell_numbers
from ..packing import jsonable
from ..quality import METRICS, quality_many
from ..quality.measures import worst_first
from ..reference import TriangleSurface, boundary_of
from ..summary import summarise
from .connectivity import difference_in_cells
from .counterpart import change_of, counterpart_of
from .distances import Measuring, both_ways
from .quantities import lengths
from .triangle_index import TriangleIndex
from .volumes import volume_of, volume_ratio

COMPARED = ("min", "mean", "max")
"""The statistics whose differences are told."""

MOST_NAMED = 20
"""So many of the cells that a metric got worse at are told by their numbers."""


def compare(a: Mesh, b: Mesh | TriangleSurface, metrics: Iterable[str] = METRICS) -> dict[str, Any]:
    """Compare two meshes, or a mesh with a reference surface.

    Parameters
    ----------
    a : Mesh
        The first: before, or what is to be judged.
    b : Mesh or TriangleSurface
        The second: after, or the surface that was meant (`hexalab.read_reference`).
    metrics : iterable of str
        Ids of the metrics to compare; all by default.

    Returns
    -------
    dict
        Ready for JSON. `a` and `b`: as `summarise` gives them, a surface's by `surface_facts`. `difference`: metric id
        to what `min`, `mean` and `max` have more in the second (None where one has none); empty for a surface.
        `same_connectivity`, and `connectivity`: what tells the cells apart, in words. `changes` and `displacement` (see
        `cell_changes`, `displacement_facts`), None where the cells are others. `distance`: see `surface_distances`.
        `volume_ratio`: volume of the second over that of the first (None where one is not closed, or has none).
    """
    metrics = list(metrics)
    told: dict[str, Any] = {"a": summarise(a, metrics)}
    if isinstance(b, TriangleSurface):
        told.update(b=surface_facts(b), difference={}, same_connectivity=False, connectivity="", changes=None)
        told["displacement"] = None
    else:
        told["b"] = summarise(b, metrics)
        difference = difference_in_cells(a, b)
        told["difference"] = differences(told["a"]["quality"], told["b"]["quality"])
        told.update(
            same_connectivity=not difference, connectivity=difference, changes=None, displacement=None
        )
        if not difference:
            told["changes"] = cell_changes(a, b, metrics)
            told["displacement"] = displacement_facts(counterpart_of(a, b).displacement(a), a.diagonal)
    told["distance"] = surface_distances(a, b)
    told["volume_ratio"] = volume_ratio(volume_of(a), volume_of(b))
    facts: dict[str, Any] = jsonable(told)
    return facts


def surface_facts(surface: TriangleSurface) -> dict[str, Any]:
    """Collect the facts of a reference surface.

    They are `file`, `format`, `vertices`, `triangles`, `extent`, `area`, `volume`
    (that it encloses; None if it is not closed), `closed`, `notes`.
    """
    return {
        "file": surface.name,
        "format": surface.format,
        "vertices": len(surface.vertices_used),
        "triangles": surface.count,
        "extent": surface.extent.tolist(),
        "area": surface.area,
        "volume": volume_of(surface),
        "closed": surface.closed,
        "notes": list(surface.notes),
    }


def differences(
    first: Mapping[str, Mapping[str, Any]], second: Mapping[str, Mapping[str, Any]]
) -> dict[str, dict[str, float | None]]:
    """Subtract statistics, those of `COMPARED`: metric id to what the second has more."""
    return {
        metric: {name: _more(numbers[name], second[metric][name]) for name in COMPARED}
        for metric, numbers in first.items()
    }


def _more(first: float | None, second: float | None) -> float | None:
    return None if first is None or second is None else second - first


def cell_changes(a: Mesh, b: Mesh, metrics: Iterable[str] = METRICS) -> dict[str, dict[str, Any]]:
    """Tell at how many cells each metric got worse and better; for meshes of the same cells.

    Returns
    -------
    dict
        Metric id to its `change_counts`.
    """
    wanted = list(metrics)
    first, second = quality_many(a, wanted), quality_many(b, wanted)
    return {metric: change_counts(a, metric, change_of(first[metric], second[metric])) for metric in wanted}


def change_counts(mesh: Mesh, metric: str, change: Floats) -> dict[str, Any]:
    """Count the cells at which a metric got worse and better.

    Parameters
    ----------
    mesh : Mesh
    metric : str
    change : (C,) float64
        See `change_of`.

    Returns
    -------
    dict
        `worse`, `better`, `same` (cells; those of a kind that has not got the metric are not counted), `largest_loss`
        (how much worse the worst change made a cell; 0 where none got worse, infinite where a value is finite no more),
        `cells` (numbers of those that got worse the most, at most `MOST_NAMED`).
    """
    gain = change if METRICS[metric].better == "high" else -change
    worse = gain < 0
    loss = float(-gain[worse].min()) if worse.any() else 0.0
    gone = np.flatnonzero(np.isneginf(gain))
    named = np.concatenate([gone, worst_first(np.where(worse, gain, np.nan), True, MOST_NAMED)])
    return {
        "worse": int(np.count_nonzero(worse)),
        "better": int(np.count_nonzero(gain > 0)),
        "same": int(np.count_nonzero(gain == 0)),
        "largest_loss": loss,
        "cells": cell_numbers(mesh, named[:MOST_NAMED]),
    }


def displacement_facts(way: Floats, diagonal: float) -> dict[str, Any]:
    """Tell how far vertices moved: `moved` (how many), `max`, `mean`, and the same with `_percent` of a diagonal.

    Parameters
    ----------
    way : (V, 3) float64
    diagonal : float
    """
    moved = lengths(way)
    told = {"max": float(moved.max(initial=0.0)), "mean": float(moved.mean()) if len(moved) else 0.0}
    return {
        "moved": int(np.count_nonzero(moved)),
        **told,
        **{f"{name}_percent": 100 * value / diagonal for name, value in told.items()},
    }


def surface_distances(a: Mesh, b: Mesh | TriangleSurface) -> dict[str, Any]:
    """Measure how far two surfaces are apart: boundaries of meshes, or a reference surface.

    Distances are those of vertices to the nearest point of the other surface, whose quadrilaterals are cut as
    `hexalab.reference.boundary_of` says; percents are of the first one's diagonal.

    Returns
    -------
    dict
        `a_to_b`, `b_to_a`: see `Measuring.facts`; `hausdorff`, `hausdorff_percent`: the larger of both largest.
    """
    ours, theirs = (boundary_of(one) if isinstance(one, Mesh) else one for one in (a, b))
    there = Measuring(ours, TriangleIndex(theirs.points, theirs.triangles)).finish()
    back = there.turned(theirs).finish()
    return both_ways(there.facts(a.diagonal), back.facts(a.diagonal))
