"""From a mesh to values: blocks of cells of one kind go through the kernels of the metrics asked for."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from typing import Any

import numpy as np

from ..arrays import Floats
from ..cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from ..mesh import Mesh
from . import condition, face_angles, faces, hexahedron, hexahedron_shape, nodal, other_kinds
from .arena import BLOCK
from .block import HexahedronBlock
from .metrics import METRICS
from .sizes import NEEDS, volumes_of_kinds, with_sizes

VOLUME = 3
"""Power of a length that a volume is."""

Kernels = dict[str, Callable[[Any, Floats], None]]

OF_FACES: Kernels = {
    "equiangle_skew": face_angles.equiangle_skew,
    "sicn": condition.sicn,
    "smallest_face_angle": face_angles.smallest_angle,
    "largest_face_angle": face_angles.largest_angle,
    "characteristic_length": faces.characteristic_length,
}
"""Kernels that tetrahedra, pyramids and wedges share, over the faces and corners of their kind."""

KERNELS: dict[int, tuple[Callable[[], Any], Kernels]] = {
    HEXAHEDRON: (
        HexahedronBlock,
        {
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
            "equiangle_skew": face_angles.hexahedron_equiangle_skew,
            "nodal_jacobian_ratio": nodal.nodal_jacobian_ratio,
            "sicn": condition.hexahedron_sicn,
            "gauss_jacobian_ratio": nodal.gauss_jacobian_ratio,
            "warpage": faces.hexahedron_warpage,
            "smallest_face_angle": face_angles.hexahedron_smallest_angle,
            "largest_face_angle": face_angles.hexahedron_largest_angle,
            "characteristic_length": faces.hexahedron_characteristic_length,
            "corner_sum": hexahedron_shape.corner_sum,
        },
    ),
    TETRAHEDRON: (
        other_kinds.tetrahedra,
        {
            "distortion": other_kinds.tetrahedron_distortion,
            "edge_ratio": other_kinds.tetrahedron_edge_ratio,
            **OF_FACES,
            "jacobian": other_kinds.tetrahedron_jacobian,
            "scaled_jacobian": other_kinds.tetrahedron_scaled_jacobian,
            "shape": other_kinds.tetrahedron_shape,
            "volume": other_kinds.tetrahedron_volume,
            "corner_sum": other_kinds.tetrahedron_corner_sum,
        },
    ),
    PYRAMID: (
        other_kinds.pyramids,
        {
            **OF_FACES,
            "jacobian": other_kinds.jacobian,
            "scaled_jacobian": other_kinds.pyramid_scaled_jacobian,
            "shape": other_kinds.pyramid_shape,
            "volume": other_kinds.pyramid_volume,
            "warpage": faces.warpage,
        },
    ),
    WEDGE: (
        other_kinds.wedges,
        {
            "distortion": other_kinds.wedge_distortion,
            "edge_ratio": other_kinds.edge_ratio,
            **OF_FACES,
            "jacobian": other_kinds.jacobian,
            "max_aspect_frobenius": other_kinds.wedge_max_aspect_frobenius,
            "mean_aspect_frobenius": other_kinds.wedge_mean_aspect_frobenius,
            "scaled_jacobian": other_kinds.wedge_scaled_jacobian,
            "shape": other_kinds.wedge_shape,
            "volume": other_kinds.wedge_volume,
            "warpage": faces.warpage,
        },
    ),
}
"""For each kind of cell: what gathers a block of them, and the kernel of each metric."""


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
        Native values. Where the metric is not defined: the infinity at its worst end. NaN for a kind of cell
        without the metric, and for coordinates that are NaN.

    Raises
    ------
    KeyError
        If there is no such metric.
    """
    return quality_many(mesh, [metric])[metric]


def quality_many(
    mesh: Mesh, metrics: Iterable[str] = METRICS, means: Mapping[int, float] | None = None
) -> dict[str, Floats]:
    """Compute several metrics of every cell at once: they share corners, edges, lengths and determinants.

    Parameters
    ----------
    mesh : Mesh
    metrics : iterable of str
        Ids; all by default.
    means : mapping of int to float, optional
        Mean volume of the cells of each kind, if the mesh is a part of another: what its cells' sizes are relative to.

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
    near, exponent = mesh.within_reach
    out = _kernel_values(near, needed)
    if means is not None:
        means = {kind: float(np.ldexp(mean, -VOLUME * exponent)) for kind, mean in means.items()}
    with_sizes(near, out, wanted, means)
    return {metric: _in_unit(out[metric], METRICS[metric].length_power * exponent) for metric in wanted}


def compared_volumes(mesh: Mesh) -> dict[int, Floats]:
    """Return the volumes of the cells of each kind, by kind, whose mean the size metrics compare with."""
    near, exponent = mesh.within_reach
    volumes = volumes_of_kinds(near, _kernel_values(near, ("volume", "corner_sum")))
    return {kind: _in_unit(values, VOLUME * exponent) for kind, values in volumes.items()}


def _in_unit(values: Floats, exponent: int) -> Floats:
    """Multiply with a power of two; what passes the range of float64 becomes infinite."""
    if not exponent:
        return values
    with np.errstate(over="ignore"):
        return np.ldexp(values, exponent)


def _kernel_values(mesh: Mesh, needed: Collection[str]) -> dict[str, Floats]:
    """Values of every cell by the kernels of these names; NaN where its kind has none."""
    out: dict[str, Floats] = {metric: np.full(mesh.cell_count, np.nan) for metric in needed}
    for kind, (make_block, of_kind) in KERNELS.items():
        cells = np.flatnonzero(mesh.kinds == kind)
        kernels = {metric: kernel for metric, kernel in of_kind.items() if metric in needed}
        if cells.size and kernels:
            _run(mesh, cells, make_block(), kernels, out)
    return out


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
