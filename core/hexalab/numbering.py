"""The file's own numbers of cells and vertices (SPEC R11), and back from numbers to rows.

Where a mesh has none of its own, a number is the row, counted from `Mesh.first_number` on.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .arrays import Array
from .mesh import Mesh

Numbers = NDArray[np.int64]


def cell_numbers(mesh: Mesh, rows: ArrayLike | None = None) -> Numbers:
    """Tell the file's numbers of cells.

    Parameters
    ----------
    mesh : Mesh
    rows : (n,) int, optional
        Which cells; all by default.

    Returns
    -------
    (n,) int64

    >>> mesh = Mesh.from_cells(np.zeros((8, 3)), [[0, 1, 2, 3, 4, 5, 6, 7]], cell_numbers=np.array([1043]))
    >>> cell_numbers(mesh).tolist(), cells_numbered(mesh, 1043).tolist(), cells_numbered(mesh, 0).tolist()
    ([1043], [0], [])
    """
    return _numbers(mesh.cell_numbers, mesh.cell_count, mesh.first_number, rows)


def vertex_numbers(mesh: Mesh, rows: ArrayLike | None = None) -> Numbers:
    """Tell the file's numbers of vertices.

    Parameters
    ----------
    mesh : Mesh
    rows : (n,) int, optional
        Which vertices; all by default.

    Returns
    -------
    (n,) int64
    """
    return _numbers(mesh.vertex_numbers, mesh.vertex_count, mesh.first_number, rows)


def cells_numbered(mesh: Mesh, number: int) -> NDArray[np.intp]:
    """Find the cells that the file gives a number.

    Parameters
    ----------
    mesh : Mesh
    number : int

    Returns
    -------
    (n,) int
        Rows, rising: one, none, or in an assembly several.
    """
    return _rows(mesh.cell_numbers, mesh.cell_count, mesh.first_number, number)


def vertices_numbered(mesh: Mesh, number: int) -> NDArray[np.intp]:
    """Find the vertices that the file gives a number.

    Parameters
    ----------
    mesh : Mesh
    number : int

    Returns
    -------
    (n,) int
        Rows, rising.
    """
    return _rows(mesh.vertex_numbers, mesh.vertex_count, mesh.first_number, number)


def _numbers(own: Numbers | None, count: int, first: int, rows: ArrayLike | None) -> Numbers:
    if rows is None:
        return np.arange(first, first + count, dtype=np.int64) if own is None else own
    places: Array = np.asarray(rows, dtype=np.int64)
    return places + first if own is None else own[places]


def _rows(own: Numbers | None, count: int, first: int, number: int) -> NDArray[np.intp]:
    if own is not None:
        return np.flatnonzero(own == number)
    row = number - first
    return np.array([row] if 0 <= row < count else [], dtype=np.intp)
