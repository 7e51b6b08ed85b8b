"""From a mesh to values: blocks of cells of one kind go through the kernels of the metrics asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from ..mesh import HEXAHEDRON, Floats, Mesh
from . import face_angles, hexahedron, hexahedron_shape, nodal
from .arena import BLOCK
from .block import HexahedronBlock
from .metrics import METRICS
from .sizes import NEEDS, with_sizes

Kernels = dict[str, Callable[[Any, Floats], None]]

HEXAHEDRON_KERNELS: Kernels = {
    "diagonal": hexahedron.diagonal,
    "distortion": hexahedron_shape.distortion,
    "edge_ratio": hexahedron.edge_ratio,
    "jacobian": hexahedron.jacobian,
    "max_edge_ratio": hexahedron.max_edge_ratio,
    "max_aspect_frobenius": hexahedron_shape.max_aspect_frobenius,
    "mean_aspect_frobenius": hexahedron_shape.mean_aspect_frobenius,
    "oddy": hexahedron_shape.oddy,
    "scaled_jacobian": hexahedron.scaled_jacobian,
    "shape": hexahedron_shape.shape,
    "shear": hexahedron.shear,
    "skew": hexahedron.skew,
    "stretch": hexahedron.stretch,
    "taper": hexahedron.taper,
    "volume": hexahedron_shape.volume,
    "dimension": hexahedron_shape.dimension,
    "equiangle_skew": face_angles.equiangle_skew,
    "nodal_jacobian_ratio": nodal.nodal_jacobian_ratio,
    "corner_sum": hexahedron_shape.corner_sum,
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
        Native values. Where Verdict returns its sentinel (1e30): the infinity at the metric's worst end, or
        for what carries a unit and passes 1e30 the infinity of its sign. NaN for a kind of cell without the
        metric, and for coordinates that are NaN.

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
    needed = dict.fromkeys(need for metric in wanted for need in NEEDS.get(metric, (metric,)))
    out = {metric: np.full(mesh.cell_count, np.nan) for metric in needed}
    kernels = {metric: kernel for metric, kernel in HEXAHEDRON_KERNELS.items() if metric in needed}
    cells = np.flatnonzero(mesh.kinds == HEXAHEDRON)
    _run(mesh, cells, HexahedronBlock(), kernels, out)
    with_sizes(mesh, out, wanted)
    return {metric: out[metric] for metric in wanted}


def _run(mesh: Mesh, cells: Any, block: Any, kernels: Kernels, out: dict[str, Floats]) -> None:
    """Fill `out` for the cells given by id, block by block."""
    every = cells.size == mesh.cell_count
    with np.errstate(all="ignore"):
        for start in range(0, cells.size, BLOCK):
            part: Any = slice(start, start + BLOCK)
            if not every:
                part = cells[part]
            block.load(mesh.coordinates, mesh.corners[:, part])
            values = block.array("values")
            for metric, kernel in kernels.items():
                kernel(block, values)
                out[metric][part] = values
