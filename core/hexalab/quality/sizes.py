"""The metrics that compare a cell with the rest of the mesh: relative size squared and its products."""

from __future__ import annotations

from math import inf

import numpy as np

from ..mesh import HEXAHEDRON, TETRAHEDRON, Floats, Mesh
from .block import TOLERANCE

HUGE = 1e30

NEEDS = {
    "relative_size_squared": ("volume", "corner_sum"),
    "shape_and_size": ("volume", "corner_sum", "shape"),
    "shear_and_size": ("volume", "corner_sum", "shear"),
}
"""What each of these metrics is made from."""

DETERMINANTS = {HEXAHEDRON: 8, TETRAHEDRON: 6}
"""How many times the cell's size `corner_sum` holds, for the kinds that have these metrics."""


def with_sizes(mesh: Mesh, values: dict[str, Floats], wanted: list[str]) -> None:
    """Add the wanted size metrics to `values`, from what `NEEDS` names.

    Relative size squared is min(D, 1/D)^2, D the cell's size over the mean volume of the mesh's cells of its kind.
    For hexahedra Verdict takes as size the mean determinant of the corners, not the volume. 0 where the sum of
    determinants, or the mean volume, is not above 2.2e-15 (with a unit!). A negative mean volume makes Verdict take the
    root of a negative number: -inf then, where the cell's size is positive.
    """
    if not any(metric in NEEDS for metric in wanted):
        return
    size = np.full(mesh.cell_count, np.nan)
    for kind, times in DETERMINANTS.items():
        cells = mesh.kinds == kind
        if cells.any():
            size[cells] = _relative_size(values["corner_sum"][cells], times, values["volume"][cells])
    for metric in wanted:
        if metric == "relative_size_squared":
            values[metric] = size
        elif metric in NEEDS:
            factor = values[NEEDS[metric][-1]]
            with np.errstate(invalid="ignore"):
                values[metric] = np.where(factor == 0, np.where(np.isnan(size), np.nan, 0.0), factor * size)


def _relative_size(total: Floats, times: int, volumes: Floats) -> Floats:
    mean = float(np.clip(volumes, -HUGE, HUGE).mean())
    flat = ~(total > TOLERANCE)
    if mean < 0:
        out = np.full(total.shape, -inf)
    elif not mean > TOLERANCE:
        out = np.zeros(total.shape)
    else:
        out = total / (times * mean)
        with np.errstate(divide="ignore"):
            np.minimum(out, 1 / out, out=out)
        out *= out
    out[flat] = 0
    return out
