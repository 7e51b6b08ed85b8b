"""Numbers per cell out of a comparison, to be coloured by, filtered by and plotted like an attribute."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..arrays import Floats, Ids
from ..mesh import Mesh
from ..quality import METRICS
from .counterpart import Counterpart

DISTANCE = "compare:distance"
DISPLACEMENT = "compare:displacement"
CHANGE = "change:"


@dataclass(frozen=True)
class Quantity:
    """A number for each cell.

    Parameters
    ----------
    name : str
        On the screen.
    better : "low" or "high"
        Which of two values is better.
    length_power : int
        As of a metric.
    metric : str
        Whose change it is; "" for what is none. Changes have a sign: maps and axes have 0 in the middle.
    cellwise : bool
        Whether it needs the same cells in both meshes.
    """

    name: str
    better: Literal["low", "high"]
    length_power: int
    metric: str = ""
    cellwise: bool = True


QUANTITIES = {
    DISTANCE: Quantity("Distance to the other surface", "low", 1, cellwise=False),
    DISPLACEMENT: Quantity("Displacement", "low", 1),
    **{
        CHANGE + id: Quantity(f"Change of {metric.name}", metric.better, metric.length_power, metric=id)
        for id, metric in METRICS.items()
    },
}
"""Quantities by id: the largest distance of a cell's boundary vertices to the other surface (NaN for cells inside), the
largest displacement of its vertices, and what a metric has more in the second mesh than in the first."""


def largest_of_corners(values: Floats, corners: Ids) -> Floats:
    """Take the largest of a number over each cell's corners.

    Parameters
    ----------
    values : (V,) float64
        NaN where a vertex has none.
    corners : (8, C) int32

    Returns
    -------
    (C,) float64
        NaN where none of the corners has one.
    """
    largest: Floats = values[corners[0]]
    for corner in corners[1:]:
        np.fmax(largest, values[corner], out=largest)
    return largest


def lengths(vectors: Floats) -> Floats:
    """(n,) lengths of (n, 3) vectors, though squares pass what float64 holds."""
    return np.asarray(np.hypot(np.hypot(vectors[:, 0], vectors[:, 1]), vectors[:, 2]))


def cellwise_values(mesh: Mesh, counterpart: Counterpart, id: str) -> Floats:
    """(C,) float64: a quantity of `QUANTITIES` that needs the same cells; ValueError where they are others."""
    if id == DISPLACEMENT:
        return largest_of_corners(lengths(counterpart.displacement(mesh)), mesh.corners)
    return counterpart.change(mesh, QUANTITIES[id].metric)
