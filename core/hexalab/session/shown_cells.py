"""The shown cells as a mesh of their own, with what was measured of them as attributes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..errors import HexaLabError
from ..formats import left_behind, writer_of
from ..mesh import Mesh
from ..quality import METRICS
from ..selection import select_cells
from ..structure.cell_data import cell_data
from .opened import Opened

CELL = "original_cell"
"""Attribute with the row that a cell has in the whole mesh, counted from 0."""


def shown_mesh(
    opened: Opened,
    shown: NDArray[np.bool_],
    metrics: Sequence[str] = (),
    attributes: Sequence[str] | None = None,
    structure: bool = False,
) -> Mesh:
    """Make a mesh of the shown cells.

    Parameters
    ----------
    opened : Opened
    shown : (C,) bool
    metrics : sequence of str
        Metrics whose values become attributes of the cells, by their ids, (n,) float64, NaN where a cell has none.
        They are those of the whole mesh: sizes compare with its mean volume. An attribute of the file that goes by
        the same name stays, and the metric is then called ``NAME (measured)``.
    attributes : sequence of str, optional
        Attributes of the file that come along, ``cell:NAME`` or ``point:NAME``; all by default.
    structure : bool
        Whether the structure comes along; see `hexalab.structure.cell_data`.

    Returns
    -------
    Mesh
        With the attribute `CELL` where some cells are hidden.

    Raises
    ------
    HexaLabError
        Nothing is shown, or there is no such metric or attribute.
    """
    if not shown.any():
        raise HexaLabError("no cell is shown: there is nothing to save")
    mesh = opened.mesh
    rows = np.flatnonzero(shown)
    kept = {f"{on}:{name}" for on, data in data_of(mesh) for name in data}
    if attributes is not None:
        for wanted in attributes:
            if wanted not in kept:
                has = ", ".join(sorted(kept)) or "none"
                raise HexaLabError(f"the mesh has no attribute {wanted!r}; it has {has}")
        kept = set(attributes)
    points, cells = (
        {name: values for name, values in data.items() if f"{on}:{name}" in kept}
        for on, data in data_of(mesh)
    )
    lean = replace(mesh, point_data=points, cell_data=cells)
    part = select_cells(lean, rows) if len(rows) < mesh.cell_count else lean
    measured: dict[str, Array] = {}
    if structure:
        measured = {name: of[rows] for name, of in cell_data(opened.traced.structure).items()}
    for metric in metrics:
        if metric not in METRICS:
            raise HexaLabError(f"there is no metric {metric!r}; there are {', '.join(METRICS)}")
        measured[free_name(metric, part.cell_data)] = opened.values(metric)[rows]
    if len(rows) < mesh.cell_count:
        measured[free_name(CELL, part.cell_data)] = rows
    return replace(part, cell_data={**part.cell_data, **measured})


def shown_file(part: Mesh, format: str) -> dict[str, Any]:
    """Write it; returns the file, `data`, and what it has no place for, `notes`.

    Where the format numbers its elements and the mesh has no numbers of its own, they are the rows in the whole mesh
    counted from 1: so it is known which cell is which where attributes have no place, either.

    Raises
    ------
    MeshWriteError
        Meshes can't be written in that format.
    """
    row = writer_of(Path(part.name), format)
    notes = left_behind(part, row)
    if row.largest_number and part.cell_numbers is None and CELL in part.cell_data:
        part = replace(part, cell_numbers=part.cell_data[CELL] + 1)
    return {"data": np.frombuffer(row.write(part), dtype=np.uint8), "notes": notes}


def data_of(mesh: Mesh) -> tuple[tuple[str, dict[str, Array]], ...]:
    """The attributes of vertices and of cells."""
    return ("point", mesh.point_data), ("cell", mesh.cell_data)


def free_name(name: str, taken: dict[str, Array]) -> str:
    """A name that is not taken."""
    return f"{name} (measured)" if name in taken else name
