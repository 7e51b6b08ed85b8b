"""From a mesh to values: blocks of cells of one kind go through the kernels of the metrics asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from ..mesh import HEXAHEDRON, Floats, Mesh
from . import hexahedron
from .block import BLOCK, HexahedronBlock
from .metrics import METRICS

HEXAHEDRON_KERNELS: dict[str, Callable[[HexahedronBlock, Floats], None]] = {
    "scaled_jacobian": hexahedron.scaled_jacobian,
}


def quality(mesh: Mesh, metric: str) -> Floats:
    """Compute one metric of every cell.

    Parameters
    ----------
    mesh : Mesh
    metric : str
        Id, a key of `METRICS`.

    Returns
    -------
    (C,) float64
        Native values. Where Verdict returns its sentinel (1e30), the infinity at the metric's worst end, or of the
        value's sign where a volume passes 1e30; NaN for a kind of cell without the metric.

    Raises
    ------
    KeyError
        If there is no such metric.
    """
    return quality_many(mesh, [metric])[metric]


def quality_many(mesh: Mesh, metrics: Iterable[str] = METRICS) -> dict[str, Floats]:
    """Compute several metrics of every cell at once: they share corners, edges, lengths and determinants.

    Parameters
    ----------
    mesh : Mesh
    metrics : iterable of str
        Ids; all by default.

    Returns
    -------
    dict of str to (C,) float64
        As `quality` returns them, by id.
    """
    wanted = list(dict.fromkeys(metrics))
    for metric in wanted:
        if metric not in METRICS:
            raise KeyError(f"no metric {metric!r}; there are {', '.join(METRICS)}")
    out = {metric: np.full(mesh.cell_count, np.nan) for metric in wanted}
    kernels = {metric: HEXAHEDRON_KERNELS[metric] for metric in wanted}
    _run(mesh, np.flatnonzero(mesh.kinds == HEXAHEDRON), HexahedronBlock(), kernels, out)
    return out


def _run(mesh: Mesh, cells: Any, block: HexahedronBlock, kernels: Any, out: dict[str, Floats]) -> None:
    every = cells.size == mesh.cell_count
    with np.errstate(all="ignore"):
        for start in range(0, cells.size, BLOCK):
            part: Any = slice(start, start + BLOCK)
            if not every:
                part = cells[part]
            corners = mesh.corners[:, part]
            block.load(mesh.coordinates, corners)
            values = block.array("values")
            for metric, kernel in kernels.items():
                kernel(block, values)
                out[metric][part] = values
