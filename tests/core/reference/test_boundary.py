"""The boundary of a mesh against VTK's filters, dictionaries and closed formulas."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from hexalab import read
from hexalab.cells import COLLAPSE
from hexalab.formats.vtk_grid import grid_of
from hexalab.mesh import Mesh
from hexalab.reference import boundary_of
from tests import published
from tests.core.conftest import grid_points
from tests.core.formats.samples import mixed
from tests.core.reference.surfaces import assert_same, cut_by_vtk, numpy_support, vtk
from tests.core.topology.brute_force import BruteForce

FOLDED = ("at-most-hexa",)
"""Meshes whose cells have collapsed: VTK does not find their faces to be shared."""


def grid(*shape: int, shaken: float = 0.2, seed: int = 4) -> Mesh:
    points, cells = grid_points(shape)  # type: ignore[arg-type]
    points = points + np.random.default_rng(seed).uniform(-shaken, shaken, points.shape)
    return Mesh.from_cells(points, cells)


def vtk_grid(mesh: Mesh) -> Any:
    rows = grid_of(mesh)
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_support.numpy_to_vtk(np.ascontiguousarray(mesh.points), deep=True))
    grid.SetPoints(points)
    cells = vtk.vtkCellArray()
    cells.SetData(
        numpy_support.numpy_to_vtkIdTypeArray(rows.offsets, deep=True),
        numpy_support.numpy_to_vtkIdTypeArray(rows.ids.astype(np.int64), deep=True),
    )
    grid.SetCells(numpy_support.numpy_to_vtk(rows.types, deep=True), cells)
    return grid


def boundary_by_vtk(mesh: Mesh, filter_name: str = "vtkDataSetSurfaceFilter") -> Any:
    """(n, 3, 3) triangles."""
    surface = getattr(vtk, filter_name)()
    surface.SetInputData(vtk_grid(mesh))
    return cut_by_vtk(surface.GetOutputPort())


def area_of(triangles: Any) -> float:
    u, v = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    return float(np.linalg.norm(np.cross(u, v), axis=1).sum() / 2)


def test_a_cube_is_seen_from_outside() -> None:
    found = boundary_of(grid(1, 1, 1, shaken=0))
    assert (found.count, found.closed, found.volume) == (12, True, pytest.approx(1, rel=1e-14))
    assert found.area == pytest.approx(6, rel=1e-14)


@pytest.mark.parametrize("filter_name", ["vtkDataSetSurfaceFilter", "vtkGeometryFilter"])
def test_a_shaken_grid_against_vtk(filter_name: str) -> None:
    mesh = grid(6, 5, 4)
    found = boundary_of(mesh)
    triangles = boundary_by_vtk(mesh, filter_name)
    assert_same(found, triangles)
    assert found.area == pytest.approx(area_of(triangles), rel=1e-12)
    assert found.closed and found.points.shape[1] == 6 * 7 * 5 - 5 * 4 * 3
    assert found.rows is not None and (mesh.coordinates[:, found.rows] == found.points).all()


def test_a_grid_of_boxes_has_the_volume_of_its_box() -> None:
    points, cells = grid_points((3, 4, 2))
    mesh = Mesh.from_cells(points**2 * [1, 0.5, 3] + 100, cells)
    found = boundary_of(mesh)
    assert found.volume == pytest.approx(9 * 8 * 12, rel=1e-12) and found.closed


def test_cells_of_all_kinds_against_vtk() -> None:
    sample = mixed()
    cells = sample.cells[:4]  # the fifth one repeats the second
    corners = np.array([np.array(ids)[list(COLLAPSE[kind])] for kind, ids in cells]).T
    points = sample.points + np.random.default_rng(2).uniform(-0.1, 0.1, sample.points.shape)
    mesh = Mesh(points.T, corners, np.array([kind for kind, _ in cells]))
    found = boundary_of(mesh)
    assert_same(found, boundary_by_vtk(mesh))
    assert found.rows is not None and 12 not in found.rows, "the loose vertex is gone"


def test_a_collapsed_hexahedron_is_one_of_its_kind() -> None:
    points, cells = grid_points((1, 1, 1))
    wedge = Mesh.from_cells(points, cells[:, [0, 1, 2, 2, 4, 5, 6, 6]])
    found = boundary_of(wedge)
    assert (found.count, found.closed, found.volume) == (8, True, pytest.approx(0.5, rel=1e-14))
    assert found.points.shape[1] == 6


def test_a_cell_that_is_there_twice_counts_once() -> None:
    points, cells = grid_points((2, 1, 1))
    points = points + np.random.default_rng(1).uniform(-0.1, 0.1, points.shape)
    once = boundary_of(Mesh.from_cells(points, cells))
    twice = boundary_of(Mesh.from_cells(points, cells[[0, 1, 1]]))
    assert_same(twice, once.points.T[once.triangles.T])
    assert twice.closed


def test_it_does_not_depend_on_how_cells_are_numbered() -> None:
    """With all its diagonals of one length: the smallest vertex decides."""
    mesh = grid(3, 3, 3, shaken=0)
    other = Mesh.from_cells(mesh.points, mesh.cells[::-1, [4, 5, 1, 0, 7, 6, 2, 3]])
    one, two = boundary_of(mesh), boundary_of(other)
    assert one.volume == pytest.approx(two.volume, rel=1e-14) and one.volume == pytest.approx(27, rel=1e-14)
    assert_same(two, one.points.T[one.triangles.T])


@pytest.mark.parametrize("name", published.CELLS)
def test_published_meshes_against_vtk(name: str) -> None:
    """Faces whose diagonals have one length may be cut either way: VTK goes by the corner that they begin with."""
    mesh = replace(read(published.file_of(name)), features=())
    found = boundary_of(mesh)
    triangles = boundary_by_vtk(mesh)
    ours, theirs = triangle_keys(found.points.T[found.triangles.T]), triangle_keys(triangles)
    ties = tied(mesh)
    assert len(ties) < 4 * 0.7 * found.count / 2, "there is something to compare"
    if any(word in name for word in FOLDED):
        assert ours - theirs <= ties
        return
    assert ours ^ theirs <= ties
    assert len(ours) == len(theirs) == found.count
    if not ours ^ theirs:
        assert found.area == pytest.approx(area_of(triangles), rel=1e-12)


@pytest.mark.parametrize("name", [name for name in published.CELLS if published.CELLS[name] < 11_000])
def test_published_meshes_against_dictionaries(name: str) -> None:
    mesh = read(published.file_of(name))
    truth = BruteForce(mesh.cells.tolist()).boundary
    found = boundary_of(mesh)
    assert found.rows is not None and set(found.rows.tolist()) == set().union(*truth)
    assert found.count == sum(len(face) - 2 for face in truth)


Key = tuple[tuple[float, ...], ...]


def triangle_keys(triangles: Any) -> set[Key]:
    """Triangles by their corners, whichever comes first, but in their order."""
    rows = [tuple(map(tuple, row)) for row in triangles.tolist()]
    return {min(row, row[1:] + row[:1], row[2:] + row[:2]) for row in rows}


def tied(mesh: Mesh) -> set[Key]:
    """The triangles, cut both ways, of boundary quadrilaterals whose diagonals have one length."""
    topology, rows = mesh.topology, mesh.topology.faces.boundary
    a, b, c, d = mesh.points[topology.corners_of(topology.face_cells[0, rows], topology.face_locals[0, rows])]
    equal = np.isclose(((a - c) ** 2).sum(axis=1), ((b - d) ** 2).sum(axis=1), rtol=1e-15, atol=0)
    quads = [corner[equal] for corner in (a, b, c, d)]
    cuts = [(0, 1, 2), (0, 2, 3), (0, 1, 3), (1, 2, 3)]
    return triangle_keys(np.concatenate([np.stack([quads[i] for i in cut], axis=1) for cut in cuts]))
