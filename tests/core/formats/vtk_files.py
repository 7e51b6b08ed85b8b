"""Files written by VTK itself."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from tests.core.formats.samples import VTK_TYPES, Sample
from tests.tools import tool

vtk = tool("vtk")
numpy_to_vtk = tool("vtk.util.numpy_support").numpy_to_vtk
vtk_to_numpy = tool("vtk.util.numpy_support").vtk_to_numpy


def unstructured_grid(sample: Sample) -> vtk.vtkUnstructuredGrid:
    """The sample as VTK's data set."""
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for point in sample.points:
        points.InsertNextPoint(*point)
    grid.SetPoints(points)
    for kind, ids in sample.cells:
        insert(grid, VTK_TYPES[kind], ids)
    for data, arrays in ((grid.GetPointData(), sample.point_data), (grid.GetCellData(), sample.cell_data)):
        for name, values in arrays.items():
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            data.AddArray(array)
    return grid


def insert(grid: vtk.vtkUnstructuredGrid, cell_type: int, ids: list[int]) -> None:
    """Add a cell."""
    id_list = vtk.vtkIdList()
    for number in ids:
        id_list.InsertNextId(number)
    grid.InsertNextCell(cell_type, id_list)


def legacy(grid: Any, version: int = 51, binary: bool = False) -> bytes:
    """The bytes of a `.vtk` file in the form of version 4.2 or 5.1."""
    writer = vtk.vtkUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileVersion(version)
    if binary:
        writer.SetFileTypeToBinary()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "mesh.vtk"
        writer.SetFileName(str(path))
        assert writer.Write()
        return path.read_bytes()


def xml(grid: Any, path: Any, **options: str) -> bytes:
    """The bytes of a `.vtu` file; options are calls of the writer, as `DataMode="Ascii"`."""
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(str(path))
    for name, value in options.items():
        if value in ("On", "Off"):
            getattr(writer, name + value)()
        else:
            getattr(writer, f"Set{name}To{value}")()
    assert writer.Write()
    return path.read_bytes()
