"""Hand-picking (SPEC F4; the paper, Manual Selection): the cells that were dug, undug and isolated.

What was picked is two lists of cells, so that it can be undone, saved and typed; the viewer changes them.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

Indices = NDArray[np.intp]


def pick(hidden: NDArray[np.bool_], isolated: bool, dug: Indices, undug: Indices) -> NDArray[np.bool_]:
    """Change what the other filters hide, (C,) bool; a new array.

    Parameters
    ----------
    hidden : (C,) bool
    isolated : bool
    dug, undug : (n,) intp
        Cells that are hidden and shown whatever the other filters say. A cell in both is shown.
    """
    picked = np.ones(len(hidden), dtype=bool) if isolated else hidden.copy()
    picked[dug] = True
    picked[undug] = False
    return picked


class PickedCells:
    """A list of picked cells as an array, made once for each list.

    A slice leaves the lists as they are: with 100,000 picked cells it must not walk through them again.

    Parameters
    ----------
    count : int
        Number of cells of the mesh; numbers that no cell has are left out.
    """

    def __init__(self, count: int) -> None:
        self._count = count
        self._list: Iterable[int] | None = None
        self._cells: Indices = np.empty(0, dtype=np.intp)

    def of(self, cells: Iterable[int]) -> Indices:
        """Return the cells of a list, which is known again by its identity: a list is not changed, but replaced."""
        if cells is not self._list:
            ids = np.fromiter(cells, dtype=np.int64)
            self._cells = ids[(ids >= 0) & (ids < self._count)].astype(np.intp)
            self._list = cells
        return self._cells
