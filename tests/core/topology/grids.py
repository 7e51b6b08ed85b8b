"""Regular grids, without anything but numpy, so that tests inside Pyodide have them too."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def grid_cells(nx: int, ny: int, nz: int) -> NDArray[np.int32]:
    """Cells (C, 8) of a regular grid, x fastest."""
    k, j, i = (axis.ravel() for axis in np.meshgrid(range(nz), range(ny), range(nx), indexing="ij"))

    def vertex(a: int, b: int, c: int) -> NDArray[np.int64]:
        return ((k + c) * (ny + 1) + j + b) * (nx + 1) + i + a

    places = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    return np.stack([vertex(*place) for place in places], axis=1).astype(np.int32)
