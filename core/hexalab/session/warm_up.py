"""Running through the work once, small, so that the browser's compiler has optimised it before a mesh comes.

WebAssembly starts in code that was compiled quickly and runs slowly; functions that run often are compiled again. A
grid of a few thousand cells, opened some times over, brings the first real mesh close to the speed of the second.
"""

from __future__ import annotations

import json

import numpy as np

from ..formats import write_bytes
from ..mesh import Mesh
from .door import Door

SIDE = 16
ROUNDS = 5


def grid(side: int) -> Mesh:
    """A cube of side**3 unit cubes."""
    line = np.arange(side + 1)
    points = np.stack(np.meshgrid(line, line, line, indexing="ij"), axis=-1).reshape(-1, 3)
    ids = np.arange(len(points)).reshape(side + 1, side + 1, side + 1)
    low, high = slice(None, -1), slice(1, None)
    ring = ((low, low), (high, low), (high, high), (low, high))
    corners = [ids[i, j, k].ravel() for k in (low, high) for i, j in ring]
    return Mesh.from_cells(points, np.stack(corners, axis=1))


def warm_up(door: Door) -> None:
    """Open, slice and measure a small grid through a door of its own, some times over."""
    data = write_bytes(grid(SIDE), "mesh")
    for turn in range(ROUNDS):
        door.answer("open", '["warm-up.mesh", {"$bytes": 0}]', [data])
        for offset in (0, 0.3 + 0.1 * turn):
            plane = {"enabled": True, "normal": [1, 0, 0], "offset": offset}
            door.answer("update", json.dumps([{"filters": {"planes": {"items": [plane]}}}]))
    door.answer("quality", '["scaled_jacobian"]')
