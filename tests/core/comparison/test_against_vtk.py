"""The nearest of many triangles beside VTK's cell locator, around real surfaces."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import hexalab
from hexalab.comparison import TriangleIndex
from tests import published
from tests.core.comparison.brute_force import least
from tests.core.comparison.surfaces import Surface


def vtk_surface(source: Any) -> Surface:
    """The triangles of what a source of VTK puts out."""
    vtk = pytest.importorskip("vtk")
    from vtk.util.numpy_support import vtk_to_numpy

    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    data = triangles.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return Surface(points.T, corners.T.astype(np.int32))


def vtk_nearest(surface: Surface, queries: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Distances (n,) and closest points (3, n) by VTK's cell locator."""
    vtk = pytest.importorskip("vtk")
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

    points, cells, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(surface.points.T), deep=True))
    corners = np.ascontiguousarray(surface.triangles.T, dtype=np.int64)
    starts = np.arange(0, 3 * len(corners) + 1, 3, dtype=np.int64)
    cells.SetData(*(numpy_to_vtkIdTypeArray(part, deep=True) for part in (starts, corners.reshape(-1))))
    data.SetPoints(points)
    data.SetPolys(cells)
    locator = vtk.vtkCellLocator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    closest, cell = np.zeros((3, queries.shape[1])), vtk.vtkGenericCell()
    far = np.zeros(queries.shape[1])
    for place, query in enumerate(queries.T):
        point, square = [0.0] * 3, vtk.reference(0.0)
        locator.FindClosestPoint(query, point, cell, vtk.reference(0), vtk.reference(0), square)
        closest[:, place], far[place] = point, np.sqrt(float(square))
    return far, closest


def agree(surface: Surface, queries: np.ndarray, wrong: float = 0) -> None:
    """Where the two differ, exact arithmetic decides: VTK goes wrong at slivers."""
    found = TriangleIndex(*surface).nearest(queries)
    far, closest = vtk_nearest(surface, queries)
    extent = np.ptp(surface.points, axis=1).max()
    differ = np.flatnonzero(np.abs(found.distance - far) > 1e-9 * extent)
    assert len(differ) <= wrong * len(far)
    for one in differ:
        assert found.distance[one] < far[one]
        truth = least(queries[:, one], surface.corners, found.distance[one])
        assert abs(found.distance[one] - truth) <= 1e-12 * extent
    assert np.abs(np.linalg.norm(found.closest - queries, axis=0) - found.distance).max() <= 1e-12 * extent
    apart = np.linalg.norm(found.closest - closest, axis=0) > 1e-6 * extent
    assert apart.sum() - len(differ) < 0.01 * len(far), "but for queries with several closest points"


def test_vtk_finds_the_same_around_a_sphere() -> None:
    source = pytest.importorskip("vtk").vtkSphereSource()
    source.SetThetaResolution(60)
    source.SetPhiResolution(50)
    surface = vtk_surface(source)
    rng = np.random.default_rng(7)
    agree(surface, rng.uniform(-1, 1, size=(3, 3000)))
    agree(surface, surface.points[:, ::2] * rng.uniform(0.9, 1.1, size=(1, surface.points[:, ::2].shape[1])))


MESHES = {
    "2015-practical-hex-mesh--armadillo-stresstest-in.mesh": 0,
    "2012-all-hex-meshing--rod-rod.vtk": 0,
    "2021-at-most-hexa--fandisk-slivers.mesh": 0.15,
}
"""The share of queries that VTK may answer wrongly."""


@pytest.mark.parametrize("name", MESHES)
def test_vtk_finds_the_same_around_the_boundary_of_a_mesh(name: str) -> None:
    vtk = pytest.importorskip("vtk")
    surface = vtk_surface(boundary(name, vtk))
    rng = np.random.default_rng(7)
    low, high = surface.points.min(axis=1)[:, None], surface.points.max(axis=1)[:, None]
    agree(
        surface, rng.uniform(low - (high - low) / 10, high + (high - low) / 10, size=(3, 2000)), MESHES[name]
    )
    some = rng.permutation(surface.points.shape[1])[:2000]
    beside = surface.points[:, some] + rng.normal(size=(3, len(some))) * (high - low).max() / 1000
    agree(surface, beside, MESHES[name])


def boundary(name: str, vtk: Any) -> Any:
    """VTK's filter that gives the boundary of a mesh."""
    mesh = hexalab.read(published.file_of(name))
    points, grid = vtk.vtkPoints(), vtk.vtkUnstructuredGrid()
    points.SetDataTypeToDouble()
    for point in mesh.points.tolist():
        points.InsertNextPoint(point)
    grid.SetPoints(points)
    for cell in mesh.cells.tolist():
        grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, cell)
    outside = vtk.vtkGeometryFilter()
    outside.SetInputData(grid)
    return outside
