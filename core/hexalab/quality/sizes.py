"""The metrics that compare a cell with the rest of the mesh: relative size squared and its products."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf

import numpy as np

from ..arrays import Floats
from ..cells import HEXAHEDRON, TETRAHEDRON
from ..mesh import Mesh
from .block import TOLERANCE
from .hexahedron import HUGE

NEEDS = {
    "relative_size_squared": ("volume", "corner_sum"),
    "shape_and_size": ("volume", "corner_sum", "shape"),
    "shear_and_size": ("volume", "corner_sum", "shear"),
}
"""What each of these metrics is made from."""


def volumes_of_kinds(mesh: Mesh, values: dict[str, Floats]) -> dict[int, Floats]:
    """Return the volumes whose mean a cell's size is compared with, by kind, from `values` of volume and corner sum."""
    of = {
        HEXAHEDRON: lambda cells: np.clip(values["volume"][cells], -HUGE, HUGE),
        TETRAHEDRON: lambda cells: values["corner_sum"][cells] / 6,
    }
    present = {kind: mesh.kinds == kind for kind in of}
    return {kind: of[kind](cells) for kind, cells in present.items() if cells.any()}


def with_sizes(
    mesh: Mesh, values: dict[str, Floats], wanted: list[str], means: Mapping[int, float] | None = None
) -> None:
    """Add the wanted size metrics to `values`, from what `NEEDS` names.

    Relative size squared is min(D, 1/D)^2, D the cell's size over the mean volume of the mesh's cells of its kind:
    `means`, by kind, where the mesh is a part of another.
    """
    if not any(metric in NEEDS for metric in wanted):
        return
    if means is None:
        means = {kind: float(found.mean()) for kind, found in volumes_of_kinds(mesh, values).items()}
    size = np.full(mesh.cell_count, np.nan)
    for kind, of_kind in ((HEXAHEDRON, _of_hexahedra), (TETRAHEDRON, _of_tetrahedra)):
        cells = mesh.kinds == kind
        if cells.any():
            size[cells] = of_kind(values["corner_sum"][cells], means[kind])
    hexahedra = mesh.kinds == HEXAHEDRON
    for metric in wanted:
        if metric == "relative_size_squared":
            values[metric] = size
        elif metric in NEEDS:
            factor = values[NEEDS[metric][-1]]
            with np.errstate(invalid="ignore"):
                values[metric] = np.where((factor == 0) & hexahedra, 0.0, factor * size)


def _of_hexahedra(total: Floats, mean: float) -> Floats:
    """Relative size squared from the sum of the corners' determinants: Verdict's size is their mean, not the volume.

    0 where that sum, or the mean volume, is not above 2.2e-15 (with a unit!). A negative mean volume makes Verdict take
    the root of a negative number: -inf then, where the sum is positive.
    """
    if mean < 0:
        out = np.full(total.shape, -inf)
    elif mean > TOLERANCE:
        out = _squared_ratio(total / (8 * mean))
    else:
        out = np.zeros(total.shape)
    out[~(total > TOLERANCE)] = 0
    return out


def _of_tetrahedra(total: Floats, mean: float) -> Floats:
    """Relative size squared from six times the volume; 0 where D, or the mean volume (with a unit!), is below 2.2e-15.

    A negative mean volume makes Verdict take the root of a negative number: -inf for every cell then.
    """
    if not mean > TOLERANCE:
        return np.full(total.shape, -inf if mean < 0 else 0.0)
    ratio = total / (6 * mean)
    out = _squared_ratio(ratio)
    out[~(ratio > TOLERANCE)] = 0
    return out


def _squared_ratio(ratio: Floats) -> Floats:
    with np.errstate(divide="ignore"):
        smaller = np.minimum(ratio, 1 / ratio)
    return np.asarray(smaller * smaller)
