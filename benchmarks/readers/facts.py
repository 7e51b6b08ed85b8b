"""What a program found in a file, in numbers that can be laid beside those of another."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

from hexalab.arrays import Array, Floats

VTK_TYPES = {"hexahedron": 12, "wedge": 13, "pyramid": 14, "tetrahedron": 10}
MEASURES = {"hexahedron": "Hex", "wedge": "Wedge", "pyramid": "Pyramid", "tetrahedron": "Tet"}


@dataclass
class Reading:
    """A file as one program reads it.

    Parameters
    ----------
    points : (V, 3) float64
    corners : dict of str to (n, k) integers
        For each kind of cell its own corners, in VTK's order.
    cell_arrays, point_arrays : dict of str to arrays
        The file's attributes, one row for each cell kept or for each point.
    """

    points: Floats
    corners: dict[str, Array]
    cell_arrays: dict[str, Array] = field(default_factory=dict)
    point_arrays: dict[str, Array] = field(default_factory=dict)


def measured(reading: Reading) -> dict[str, Any]:
    """Cells per kind; and of all cells: the box, the sums of their corners' coordinates, volume and Scaled Jacobian.

    Volumes and Scaled Jacobians are VTK's, whoever read the file: what differs is what was read.
    """
    corners = {kind: rows for kind, rows in reading.corners.items() if len(rows)}
    places = np.concatenate(
        [reading.points[rows].reshape(-1, 3) for rows in corners.values()] or [np.zeros((0, 3))]
    )
    facts: dict[str, Any] = {"cells": {kind: len(rows) for kind, rows in sorted(corners.items())}}
    if len(places):
        facts["box"] = [*places.min(axis=0).tolist(), *places.max(axis=0).tolist()]
        facts["corner sum"] = places.sum(axis=0).tolist()
        volumes = np.concatenate(
            [_verdict(reading.points, rows, kind, "Volume") for kind, rows in corners.items()]
        )
        facts["volume"], facts["size"] = float(volumes.sum()), float(np.abs(volumes).sum())
        jacobians = np.concatenate(
            [_verdict(reading.points, rows, kind, "ScaledJacobian") for kind, rows in corners.items()]
        )
        finite = jacobians[np.abs(jacobians) < 1e29]
        facts["SJ"] = [float(finite.min()), float(finite.mean())] if len(finite) else []
    facts["cell arrays"] = {name: summary(rows) for name, rows in sorted(reading.cell_arrays.items())}
    facts["point arrays"] = {name: summary(rows) for name, rows in sorted(reading.point_arrays.items())}
    return facts


def summary(rows: Array) -> list[float]:
    """Numbers of an array, of those that are no numbers, and smallest, largest and mean of the rest."""
    rows = np.asarray(rows, dtype=np.float64).ravel()
    finite = rows[np.isfinite(rows)]
    known = [float(finite.min()), float(finite.max()), float(finite.mean())] if len(finite) else []
    return [len(rows), len(rows) - len(finite), *known]


def _verdict(points: Floats, rows: Array, kind: str, measure: str) -> Floats:
    count, size = rows.shape
    grid, places, cells = vtk.vtkUnstructuredGrid(), vtk.vtkPoints(), vtk.vtkCellArray()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=1))
    offsets = np.arange(0, count * size + 1, size, dtype=np.int64)
    ids = np.ascontiguousarray(rows, dtype=np.int64).ravel()
    cells.SetData(*(numpy_to_vtkIdTypeArray(part, deep=1) for part in (offsets, ids)))
    grid.SetPoints(places)
    grid.SetCells(VTK_TYPES[kind], cells)
    quality = vtk.vtkMeshQuality()
    quality.SetInputData(grid)
    getattr(quality, f"Set{MEASURES[kind]}QualityMeasureTo{measure}")()
    quality.Update()
    return np.asarray(vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality"))).copy()


def close(ours: Any, theirs: Any, scale: float = 0.0) -> bool:
    """Whether two facts are the same but for the last digits of single precision."""
    if isinstance(ours, dict) or isinstance(theirs, dict):
        return bool(ours == theirs)
    a, b = np.atleast_1d(np.asarray(ours, float)), np.atleast_1d(np.asarray(theirs, float))
    return a.shape == b.shape and bool(np.allclose(a, b, rtol=2e-6, atol=2e-6 * scale))
