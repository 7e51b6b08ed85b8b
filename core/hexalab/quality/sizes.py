"""The metrics that compare a cell with the rest of the mesh: relative size squared and its products."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..arrays import Floats
from ..cells import HEXAHEDRON, TETRAHEDRON
from ..mesh import Mesh
from .block import TOLERANCE

NEEDS = {
    "relative_size_squared": ("volume", "corner_sum"),
    "shape_and_size": ("volume", "corner_sum", "shape"),
    "shear_and_size": ("volume", "corner_sum", "shear"),
}
"""What each of these metrics is made from."""


def volumes_of_kinds(mesh: Mesh, values: dict[str, Floats]) -> dict[int, Floats]:
    """Return the volumes whose mean a cell's size is compared with, by kind, from `values` of volume and corner sum."""
    of = {
        HEXAHEDRON: lambda cells: values["volume"][cells],
        TETRAHEDRON: lambda cells: values["corner_sum"][cells] / 6,
    }
    present = {kind: mesh.kinds == kind for kind in of}
    return {kind: of[kind](cells) for kind, cells in present.items() if cells.any()}


def with_sizes(
    mesh: Mesh, values: dict[str, Floats], wanted: list[str], means: Mapping[int, float] | None = None
) -> None:
    """Add the wanted size metrics to `values`, from what `NEEDS` names.

    Relative size squared is min(D, 1/D)^2, D the cell's size over the mean volume of the mesh's cells of its kind:
    `means`, by kind, where the mesh is a part of another. Verdict's size of a hexahedron is the mean of its corners'
    determinants, not the volume; of a tetrahedron it is the volume.
    """
    if not any(metric in NEEDS for metric in wanted):
        return
    if means is None:
        means = {kind: float(found.mean()) for kind, found in volumes_of_kinds(mesh, values).items()}
    size = np.full(mesh.cell_count, np.nan)
    for kind, share in ((HEXAHEDRON, 8), (TETRAHEDRON, 6)):
        cells = mesh.kinds == kind
        if cells.any():
            size[cells] = _relative_to(means[kind], values["corner_sum"][cells] / share)
    hexahedra = mesh.kinds == HEXAHEDRON
    for metric in wanted:
        if metric == "relative_size_squared":
            values[metric] = size
        elif metric in NEEDS:
            factor = values[NEEDS[metric][-1]]
            with np.errstate(invalid="ignore"):
                values[metric] = np.where((factor == 0) & hexahedra, 0.0, factor * size)


def _relative_to(mean: float, size: Floats) -> Floats:
    """Square of the ratio of sizes, or of its inverse if that is smaller; 0 where one of them is not positive.

    So says the manual. VTK 9.6 takes the root of a negative mean, and gives 0 to cells of edges below 1e-5 as well, by
    a threshold in the file's unit: not taken over.
    """
    if mean <= 0:
        return np.where(np.isnan(size), size, 0.0)
    ratio = size / mean
    with np.errstate(divide="ignore"):
        smaller = np.minimum(ratio, 1 / ratio)
    return np.where(ratio <= TOLERANCE, 0.0, smaller * smaller)
