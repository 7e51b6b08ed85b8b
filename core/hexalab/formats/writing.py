"""What writers share: rows of text, cells in runs of one kind, the file's own numbers."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array
from ..cells import CORNERS_OF_KIND, WEDGE
from ..mesh import Mesh
from .assembly import WEDGE_OF_OTHERS


def formatted(row: str, columns: list[Array]) -> list[bytes]:
    """The columns as text, chunk by chunk, each row formatted alike."""
    out = []
    for start in range(0, len(columns[0]), CHUNK):
        lists = [column[start : start + CHUNK].tolist() for column in columns]
        numbers = [number for entry in zip(*lists, strict=True) for number in entry]
        out.append((row * len(lists[0]) % tuple(numbers)).encode())
    return out


def runs(*columns: Array) -> Iterator[slice]:
    """Slices of rows, from the first to the last, in each of which all columns stay the same.

    >>> list(runs(np.array([0, 0, 1, 0])))
    [slice(0, 2, None), slice(2, 3, None), slice(3, 4, None)]
    """
    if not len(columns[0]):
        return
    changes = np.zeros(len(columns[0]) - 1, dtype=bool)
    for column in columns:
        changes |= column[1:] != column[:-1]
    ends = [0, *(np.flatnonzero(changes) + 1).tolist(), len(columns[0])]
    yield from (slice(start, end) for start, end in pairwise(ends))


def own_corners(mesh: Mesh, kind: int, which: slice | Array) -> list[Array]:
    """Zero-based vertices of cells of one kind, an array for each corner, numbered as Medit, Gmsh and Abaqus do."""
    own = CORNERS_OF_KIND[kind]
    order = WEDGE_OF_OTHERS if kind == WEDGE else range(len(own))
    return [mesh.corners[own[place]][which].astype(np.int64) for place in order]


def numbers_kept(numbers: NDArray[np.int64] | None, largest: int) -> bool:
    """Whether a format whose numbers are 1 to `largest`, each once, can hold the file's own numbers."""
    if numbers is None or not len(numbers):
        return True
    return bool(numbers.min() >= 1 and numbers.max() <= largest and len(np.unique(numbers)) == len(numbers))


def numbers_written(numbers: NDArray[np.int64] | None, count: int, largest: int) -> NDArray[np.int64]:
    """(count,) the file's own numbers where the format can hold them, else 1, 2, 3, ..."""
    if numbers is not None and numbers_kept(numbers, largest):
        return numbers
    return np.arange(1, count + 1, dtype=np.int64)
