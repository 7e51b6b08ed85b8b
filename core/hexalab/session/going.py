"""From the file's numbers to cells, and what lies around them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..errors import HexaLabError
from ..numbering import cells_numbered, vertices_numbered
from .opened import Opened

SMALLEST_STEP = 1e-9
"""Part of the diagonal by which a neighbour has to stand before a cell to be left out."""


def numbers_of(opened: Opened) -> dict[str, Any]:
    """Tell how the file numbers cells and vertices.

    Returns
    -------
    dict
        `first` (what rows are counted from), `cells` ((C,) float64 or int32, None where they are the rows counted on).
    """
    numbers = opened.mesh.cell_numbers
    if numbers is not None:
        small = numbers.size == 0 or (int(numbers.max()) < 2**31 and int(numbers.min()) >= -(2**31))
        numbers = numbers.astype(np.int32 if small else np.float64)
    return {"first": opened.mesh.first_number, "cells": numbers}


def find(opened: Opened, kind: str, number: int, direction: list[float] | None) -> dict[str, Any]:
    """Find a cell or a vertex by the number that the file gives it.

    Parameters
    ----------
    opened : Opened
    kind : "cell" or "vertex"
    number : int
    direction : (3,) float or None
        From the eye; of the cells around a cell those that stand before it are left out then.

    Returns
    -------
    dict
        `rows` (of all that have the number, rising), `cell` (the one to look at: the first of these, or the first
        around the vertex; -1 without any), `around` ((n,) uint32: that cell and those that share a vertex with it, or
        all around the vertex), `place` ([x, y, z] in the file's unit).

    Raises
    ------
    HexaLabError
        Neither cells nor vertices are asked for, or none has that number: which there are.
    """
    mesh = opened.mesh
    ways = {"cell": (cells_numbered, mesh.cell_numbers, mesh.cell_count, "element"),
            "vertex": (vertices_numbered, mesh.vertex_numbers, mesh.vertex_count, "node")}  # fmt: skip
    if kind not in ways:
        raise HexaLabError(f"there is no {kind!r} to go to, expected cell or vertex")
    look_up, own, count, called = ways[kind]
    rows = look_up(mesh, number)
    if not len(rows):
        low, high = mesh.first_number, mesh.first_number + count - 1
        if own is not None and len(own):
            low, high = int(own.min()), int(own.max())
        raise HexaLabError(f"the mesh has no {called} {number}: its numbers are from {low:,} to {high:,}")
    if kind == "cell":
        cell = int(rows[0])
        around = cells_around(opened, cell, direction)
        place = mesh.coordinates[:, np.unique(mesh.corners[:, cell])].mean(axis=1)
    else:
        around = cells_of_vertices(opened, rows[:1])
        cell = int(around[0]) if len(around) else -1
        place = mesh.coordinates[:, rows[0]]
    return {
        "rows": rows.tolist(),
        "cell": cell,
        "around": around.astype(np.uint32),
        "place": place.tolist(),
    }


def cells_of_vertices(opened: Opened, vertices: Array) -> NDArray[np.intp]:
    """Rows of the cells that have one of the vertices, rising."""
    wanted = np.zeros(opened.mesh.vertex_count, dtype=bool)
    wanted[vertices] = True
    has = np.zeros(opened.mesh.cell_count, dtype=bool)
    for corner in opened.mesh.corners:
        has |= wanted[corner]
    return np.flatnonzero(has)


def cells_around(opened: Opened, cell: int, direction: list[float] | None) -> NDArray[np.intp]:
    """Rows of a cell and of those that share a vertex with it, but for those that hide it from the eye."""
    mesh = opened.mesh
    around = cells_of_vertices(opened, mesh.corners[:, cell])
    if direction is None or not np.any(direction):
        return around
    along = np.asarray(direction, dtype=np.float64)
    along = along / np.sqrt((along * along).sum())
    places = opened.drawn_mesh.barycentres(np.append(around, cell))
    depth = (places * along[:, None]).sum(axis=0)
    before = depth[:-1] < depth[-1] - SMALLEST_STEP
    kept: NDArray[np.intp] = around[~before | (around == cell)]
    return kept
