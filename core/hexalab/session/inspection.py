"""One cell at a time: what the inspector shows, and where a cell lies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..attributes import average_corners
from ..cells import CORNERS_OF_KIND, KINDS
from ..diagnosis import Finding
from ..mesh import Mesh
from ..quality import METRICS, certify, quality_many
from ..quality.validity import STATES
from .opened import Opened

RELATIVE = {"shape_and_size": "shape", "shear_and_size": "shear"}
"""Metrics that are the product of another and `relative_size_squared`, which depends on the whole mesh."""


def inspect(opened: Opened, cell: int) -> dict[str, Any]:
    """Tell everything about a cell.

    Returns
    -------
    dict
        `cell`, `kind`, `corners` (vertex ids of its own corners), `coordinates` (one [x, y, z] for each),
        `metrics` (id to value, None where it is not finite; only those that the kind has), `attributes` (name
        to value or list), `neighbours` (six cells, -1 outside), `validity` ("valid", "invalid" or
        "undecided").
    """
    mesh = opened.mesh
    kind = int(mesh.kinds[cell])
    corners = mesh.corners[np.array(CORNERS_OF_KIND[kind]), cell]
    return {
        "cell": cell,
        "kind": KINDS[kind],
        "corners": corners.tolist(),
        "coordinates": mesh.coordinates[:, corners].T.tolist(),
        "metrics": cell_metrics(opened, cell),
        "attributes": cell_attributes(mesh, cell),
        "neighbours": mesh.topology.neighbours_of(np.array([cell]))[:, 0].tolist(),
        "validity": STATES[int(certify(alone(mesh, cell)).state[0])],
    }


def alone(mesh: Mesh, cell: int) -> Mesh:
    """Return a mesh of one cell of another."""
    corners = mesh.corners[:, cell]
    own, places = np.unique(corners, return_inverse=True)
    return Mesh(mesh.coordinates[:, own], places.astype(np.int32).reshape(8, 1), mesh.kinds[cell : cell + 1])


def cell_metrics(opened: Opened, cell: int) -> dict[str, float | None]:
    """Measure one cell by every metric that its kind has."""
    kind = int(opened.mesh.kinds[cell])
    own = [metric.id for metric in METRICS.values() if kind in metric.kinds]
    values = {id: float(array[0]) for id, array in quality_many(alone(opened.mesh, cell), own).items()}
    if "relative_size_squared" in values:
        size = float(opened.values("relative_size_squared")[cell])
        values["relative_size_squared"] = size
        for product, factor in RELATIVE.items():
            if product in values:
                values[product] = size * values[factor] if factor in values else opened.values(product)[cell]
    return {id: value if np.isfinite(value) else None for id, value in values.items()}


def cell_attributes(mesh: Mesh, cell: int) -> dict[str, Any]:
    """Return the file's values for one cell; those of points as the mean of its corners."""
    found = {name: _plain(np.asarray(array)[cell]) for name, array in mesh.cell_data.items()}
    corners = mesh.corners[:, cell]
    for name, array in mesh.point_data.items():
        own = np.asarray(array)[corners]
        if own.dtype.kind in "biuf" and own.ndim <= 2:
            columns = own.reshape(8, -1).T.astype(np.float64)
            eight, kind = np.arange(8, dtype=np.int32).reshape(8, 1), mesh.kinds[cell : cell + 1]
            means = [float(average_corners(column, eight, kind)[0]) for column in columns]
            found[f"{name} (mean of corners)"] = means[0] if len(means) == 1 else means
    return found


def where(mesh: Mesh, cell: int) -> dict[str, Any]:
    """Return a cell's centre and size in drawing coordinates: diagonals of the mesh from its centre."""
    own = mesh.coordinates[:, mesh.corners[:, cell]]
    low, high = own.min(axis=1), own.max(axis=1)
    centre = (low + (high - low) / 2 - mesh.centre) / mesh.diagonal
    return {"centre": centre.tolist(), "size": float(np.sqrt(((high - low) ** 2).sum())) / mesh.diagonal}


def cells_of(mesh: Mesh, finding: Finding) -> NDArray[np.uint32]:
    """Return the cells that a finding concerns; those around its vertices where it names no cells."""
    if len(finding.cells):
        return np.asarray(finding.cells).astype(np.uint32)
    named = np.zeros(mesh.vertex_count, dtype=bool)
    named[np.asarray(finding.vertices, dtype=np.int64)] = True
    around = np.zeros(mesh.cell_count, dtype=bool)
    for corner in mesh.corners:
        around |= named[corner]
    return np.flatnonzero(around).astype(np.uint32)


def _plain(value: Array | Any) -> Any:
    return value.tolist() if isinstance(value, np.ndarray | np.generic) else value
