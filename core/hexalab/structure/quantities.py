"""Numbers per cell out of the structure, to be coloured by, filtered by and plotted like an attribute."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..arrays import Array, Floats, tally
from .structure import Structure


class Quantity(NamedTuple):
    """A number for each cell.

    Attributes
    ----------
    name : str
        On the screen.
    values : callable
        (N,) numbers of the frame's cells, -1 where there is none.
    """

    name: str
    values: Callable[[Structure], Array]


def _different_sheets(structure: Structure) -> Array:
    a, b, c = structure.sheets.of_cells
    out: Array = 1 + (b != a).astype(np.int32) + ((c != a) & (c != b))
    return out


def _smallest_sheet(structure: Structure) -> Array:
    sheets = structure.sheets
    out: Array = sheets.cells[sheets.of_cells].min(axis=0)
    return out


def _block_cells(structure: Structure) -> Array:
    base = structure.base_complex
    out: Array = tally(base.of_cells, base.count)[base.of_cells]
    return out


QUANTITIES = {
    "structure:distance": Quantity(
        "Cells to the nearest irregular edge", lambda structure: structure.irregular_distance
    ),
    "structure:sheets": Quantity("Sheets through the cell", _different_sheets),
    "structure:smallest_sheet": Quantity("Cells of its smallest sheet", _smallest_sheet),
    "structure:block_cells": Quantity("Cells of its block", _block_cells),
}
"""Quantities by id: how many faces lie between the cell and the nearest one at an interior irregular edge; how many
different sheets cross it, 1 to 3; sizes of the smallest of these and of its block, in cells."""


def quantity_values(structure: Structure, id: str) -> Floats:
    """(C,) float64: a quantity of `QUANTITIES` for each cell of the mesh; NaN where there is none."""
    found = structure.frame.in_mesh(
        QUANTITIES[id].values(structure).astype(np.int32), structure.mesh.cell_count
    )
    return np.where(found < 0, np.nan, found)
