"""Strips of triangles as triangles, for both of VTK's formats."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..formats.byte_order import native
from ..formats.ids import as_int32
from ..formats.row_chain import ErrorAt
from .polygons import Polygons


def cut_strips(ids: Array, starts: Array | range, sizes: Array, error_at: ErrorAt) -> Polygons:
    """Triangles of strips: three vertices in a row each, every second one with its first two exchanged.

    >>> cut_strips(np.array([5, 6, 7, 8]), range(0, 4, 4), np.array([4]), None).ids.reshape(-1, 3).tolist()
    [[5, 6, 7], [7, 6, 8]]
    """
    counts = np.maximum(np.asarray(sizes).astype(np.intp) - 2, 0)
    within = np.arange(int(counts.sum())) - np.repeat(np.cumsum(counts) - counts, counts)
    first = np.repeat(np.asarray(starts), counts) + within
    odd = within % 2
    source = np.stack([first + odd, first + 1 - odd, first + 2], axis=1).reshape(-1)
    triangles = as_int32(native(ids))[source]
    return Polygons(
        triangles,
        range(0, len(source), 3),
        np.full(len(first), 3, np.int32),
        lambda message, index: error_at(message, int(source[index])),
    )
