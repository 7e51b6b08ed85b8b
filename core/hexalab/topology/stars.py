"""Stars: the cells around each vertex, for walks that start from few vertices."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Ids
from .slots import last_writers

LAYERS = 16
"""In a grid eight layers hold all; after so many the rest is sorted: vertices of very many cells."""


class Stars:
    """The cells around each vertex.

    In each layer every vertex has room for one cell. All that want to stand there write their number, the
    last stays, and the others go to the next layer.

    Parameters
    ----------
    corners : (8, C) int32
    vertex_count : int
    """

    def __init__(self, corners: Ids, vertex_count: int) -> None:
        self._cell_count = corners.shape[1]
        cells = np.arange(self._cell_count, dtype=np.int32)
        self._layers: list[Ids] = []
        vertex: Array = np.empty(0, np.int32)
        cell: Array = np.empty(0, np.int32)
        for place in range(LAYERS):
            if place < len(corners):
                vertex = np.concatenate([vertex, corners[place]]) if len(vertex) else corners[place]
                cell = np.concatenate([cell, cells]) if len(cell) else cells
            elif not len(vertex):
                break
            layer = np.full(vertex_count, -1, np.int32)
            lost = np.flatnonzero(last_writers(layer, vertex, cell) != cell)
            self._layers.append(layer)
            vertex, cell = vertex[lost], cell[lost]
        order = np.argsort(vertex, kind="stable")
        self._rest_vertex, self._rest_cell = vertex[order], cell[order]

    def cells_of(self, vertices: Array) -> Ids:
        """Cells that have one of the vertices at a corner, (n,) int32, in no order, some of them repeated."""
        found = [layer[vertices] for layer in self._layers]
        if len(self._rest_vertex):
            first = np.searchsorted(self._rest_vertex, vertices, "left")
            count = np.searchsorted(self._rest_vertex, vertices, "right") - first
            skipped = np.repeat(np.cumsum(count) - count, count)
            found.append(self._rest_cell[np.repeat(first, count) + np.arange(count.sum()) - skipped])
        cells: Ids = np.concatenate(found)
        return cells[cells >= 0]
