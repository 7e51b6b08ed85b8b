"""Rows that begin with their own length, one after the other, of differing length."""

from __future__ import annotations

import numpy as np

from ..mesh import Array
from .vtk_values import ErrorAt


def row_starts(values: Array, count: int, error_at: ErrorAt) -> Array:
    """Index of each row's length in `values`.

    Where a row begins is known only from the row before; instead of walking, each value is taken as a
    length, and the set of starts is doubled until it holds all rows (pointer jumping): log2(count) passes
    over arrays.

    Parameters
    ----------
    values : (n,) integers
        Length, that many numbers, length, and so on.
    count : int
        Rows there should be.
    error_at : callable
        Makes the error for the value at an index.

    Raises
    ------
    MeshReadError
        A length is negative or runs past the end, or there are values left over.
    """
    size = len(values)
    here = np.arange(size, dtype=np.int64)
    lengths = values.astype(np.int64)
    after = here + lengths + 1
    after[(lengths < 0) | (after > size)] = size + 1
    jump = np.concatenate([after, [size, size + 1]])
    starts: Array = np.zeros(min(count, 1), dtype=np.int64)
    while len(starts) < count:
        following = jump[starts]
        if following[0] >= size:
            break
        starts = np.concatenate([starts, following[following < size]])
        if len(starts) < count:
            jump = jump[jump]
    starts = starts[:count]
    ends = after[starts]
    bad = ends > size
    if bad.any():
        index = int(starts[np.argmax(bad)])
        raise error_at(
            f"a row of CELLS says it has {int(values[index])} corners, more than are left in the section",
            index,
        )
    if len(starts) < count or (count and ends[-1] != size):
        raise error_at(
            f"CELLS announces {count} cells in {size} values, but {len(starts)} of them take "
            f"{int(ends[-1]) if len(ends) else 0}",
            min(int(ends[-1]) if len(ends) else 0, size - 1),
        )
    return starts
