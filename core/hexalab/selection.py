"""A mesh of some of another's cells: what is shown, saved; what is bad, looked at alone."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .arrays import Array, Ids
from .errors import HexaLabError
from .mesh import Mesh


def select_cells(mesh: Mesh, cells: ArrayLike) -> Mesh:
    """Make a mesh of some cells, in their order, and of the vertices that they use.

    Attributes come along, groups with those of their members that are there, features all of whose vertices are
    there, and the file's own numbers of nodes and elements where it has them.

    Parameters
    ----------
    mesh : Mesh
    cells : (C,) bool or (n,) int
        Which: a mask over all cells, or their rows, rising.

    Returns
    -------
    Mesh

    Raises
    ------
    HexaLabError
        A mask of another length, or a row that is no cell, or rows that do not rise.

    >>> mesh = Mesh.from_cells(np.zeros((12, 3)), [[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]])
    >>> part = select_cells(mesh, [1])
    >>> part.cells.tolist(), part.vertex_count
    ([[0, 1, 2, 3, 4, 5, 6, 7]], 8)
    """
    rows = rows_of(np.asarray(cells), mesh.cell_count)
    corners = mesh.corners[:, rows]
    used = np.zeros(mesh.vertex_count, dtype=bool)
    used[corners] = True
    vertices = np.flatnonzero(used)
    vertex_place, cell_place = places(vertices, mesh.vertex_count), places(rows, mesh.cell_count)
    return Mesh(
        mesh.coordinates[:, vertices],
        vertex_place[corners],
        mesh.kinds[rows],
        {name: values[vertices] for name, values in mesh.point_data.items()},
        {name: values[rows] for name, values in mesh.cell_data.items()},
        name=mesh.name,
        format=mesh.format,
        notes=list(mesh.notes),
        vertex_numbers=None if mesh.vertex_numbers is None else mesh.vertex_numbers[vertices],
        cell_numbers=None if mesh.cell_numbers is None else mesh.cell_numbers[rows],
        first_number=mesh.first_number,
        groups=tuple(
            group.among(cell_place if group.on == "cell" else vertex_place) for group in mesh.groups
        ),
        features=tuple(part.within(vertex_place) for part in mesh.features),
    )


def places(kept: Array, count: int) -> Ids:
    """(count,) the new row of each old one, -1 for those that are not kept."""
    place = np.full(count, -1, dtype=np.int32)
    place[kept] = np.arange(len(kept), dtype=np.int32)
    return place


def rows_of(cells: Array, count: int) -> Array:
    """Rows of the chosen cells, (n,) int64, rising."""
    if cells.dtype == bool:
        if cells.shape != (count,):
            raise HexaLabError(f"cells: found a mask of shape {cells.shape}, expected ({count},)")
        return np.flatnonzero(cells)
    rows = cells.astype(np.int64) if cells.size else np.zeros(0, dtype=np.int64)
    if cells.ndim != 1 or (cells.size and cells.dtype.kind not in "iu"):
        raise HexaLabError(
            f"cells: found an array of {cells.dtype} of shape {cells.shape}, expected rows or a mask"
        )
    if len(rows) and not (rows[0] >= 0 and rows[-1] < count and (np.diff(rows) > 0).all()):
        raise HexaLabError(f"cells: expected rows from 0 to {count - 1} that rise, each once")
    return rows
