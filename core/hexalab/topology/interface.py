"""The interface: the faces that part shown cells from hidden ones or from the outside.

It is what the picture is made of, and must follow a slider: a change of few cells looks at the faces of those
cells only, any other change passes once over all faces.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids
from .faces import Faces

SMALL_CHANGE = 24
"""A change is small if fewer than one cell in that many flips: six scattered faces each against one pass."""


class Interface(NamedTuple):
    """The faces with exactly one shown side.

    Attributes
    ----------
    rows : (N,) intp
        Rows of the faces: first those that hidden cells expose, then those of the mesh's own boundary.
    cells : (N,) int32
        The shown cells.
    locals : (N,) uint8
        Which of the shown cell's six faces it is.
    """

    rows: NDArray[np.intp]
    cells: Ids
    locals: NDArray[np.uint8]


class InterfaceFinder:
    """Finds interfaces one after the other, and remembers the last.

    Parameters
    ----------
    faces : Faces
    """

    def __init__(self, faces: Faces) -> None:
        self._faces = faces
        self._shown: NDArray[np.bool_] | None = None
        self._parted = np.zeros(faces.paired, dtype=bool)
        self._last: Interface | None = None

    def find(self, shown: NDArray[np.bool_]) -> Interface:
        """Faces with exactly one shown side, not to be changed: for the same cells it is the same arrays.

        Parameters
        ----------
        shown : (C,) bool
        """
        if self._follow(shown) or self._last is None:
            self._last = self._collect(shown)
        return self._last

    def inside(self, shown: NDArray[np.bool_]) -> NDArray[np.intp]:
        """Rows of two cells of which one is shown."""
        if self._follow(shown):
            self._last = None
        return np.flatnonzero(self._parted)

    def _collect(self, shown: NDArray[np.bool_]) -> Interface:
        faces = self._faces
        inside = np.flatnonzero(self._parted)
        outer = np.flatnonzero(shown[faces.cells[0, faces.paired :]]) + faces.paired
        second = ~shown[faces.cells[0][inside]]
        rows = np.concatenate([inside, outer])
        cells: Ids = faces.cells[0][rows]
        local: NDArray[np.uint8] = faces.locals[0][rows]
        turned = np.flatnonzero(second)
        cells[turned] = faces.cells[1][inside[turned]]
        local[turned] = faces.locals[1][inside[turned]]
        return Interface(rows, cells, local)

    def _follow(self, shown: NDArray[np.bool_]) -> bool:
        """Bring `_parted`, which interior faces part shown from hidden, up to date; tell whether anything changed."""
        left = self._faces.cells[0, : self._faces.paired]
        right = self._faces.cells[1, : self._faces.paired]
        if self._shown is None:
            self._shown = shown.copy()
        else:
            flipped = np.flatnonzero(shown != self._shown)
            self._shown[flipped] = shown[flipped]
            if not len(flipped):
                return False
            if len(flipped) * SMALL_CHANGE < len(shown):
                rows: Ids = self._faces.rows[:, flipped].reshape(-1)
                rows = rows[(rows >= 0) & (rows < self._faces.paired)]
                self._parted[rows] = shown[left[rows]] != shown[right[rows]]
                return True
        if shown.all() or not shown.any():
            self._parted[:] = False
        else:
            np.not_equal(shown[left], shown[right], out=self._parted)
        return True
