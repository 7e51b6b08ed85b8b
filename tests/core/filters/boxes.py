"""Small boxes of unit cubes."""

from __future__ import annotations

import numpy as np

from hexalab.mesh import Mesh
from tests.core.topology.grids import grid_cells


def box(nx: int, ny: int, nz: int) -> Mesh:
    """A box of nx x ny x nz unit cubes with one corner at the origin; cells x fastest."""
    k, j, i = (a.ravel() for a in np.meshgrid(range(nz + 1), range(ny + 1), range(nx + 1), indexing="ij"))
    return Mesh.from_cells(np.stack([i, j, k], axis=1).astype(float), grid_cells(nx, ny, nz))
