"""SPEC A1: what is written comes back, through us, VTK and meshio."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshWriteError
from hexalab.formats import read, read_bytes, write, write_bytes
from hexalab.mesh import Mesh
from tests.core.formats.samples import VTK_TYPES, Sample, check, check_data, grid, mixed
from tests.core.formats.vtk_files import legacy, unstructured_grid, vtk_to_numpy
from tests.tools import tool

meshio, vtk = tool("meshio"), tool("vtk")

ODD = [1 / 3, 1e-300, -1.7976931348623157e308, 123456789.123456789, -0.0, 5e-324]


def sample_mesh(sample: Sample) -> Mesh:
    mesh = read_bytes(legacy(unstructured_grid(sample), 51, True), "a mesh.vtk")
    return replace(mesh, coordinates=sample.points.T)


@pytest.mark.parametrize("format_id", ["vtk", "vtu"])
@pytest.mark.parametrize("make", [mixed, lambda: grid(9, 8, 7)])
def test_A1_vtk_formats_keep_everything(format_id: str, make) -> None:
    sample = make()
    sample.points[0, :] = ODD[:3]
    sample.points[1, :] = ODD[3:]
    mesh = read_bytes(write_bytes(sample_mesh(sample), format_id), f"x.{format_id}")
    check(mesh, sample)
    check_data(mesh, sample)


def test_A1_medit_keeps_cells_by_kind_and_references(tmp_path: Path) -> None:
    sample = mixed()
    sample.points[0, :] = ODD[:3]
    sample.points[1, :] = ODD[3:]
    sample.cell_data["reference"] = sample.cell_data.pop("part")
    sample.point_data["reference"] = np.arange(13)
    write(sample_mesh(sample), tmp_path / "x.mesh")
    mesh = read(tmp_path / "x.mesh")
    check(mesh, sample.grouped())
    np.testing.assert_array_equal(mesh.cell_data["reference"], sample.grouped().cell_data["reference"])
    np.testing.assert_array_equal(mesh.point_data["reference"], np.arange(13))


@pytest.mark.parametrize("format_id", ["vtk", "vtu"])
def test_A1_vtk_reads_what_is_written(tmp_path: Path, format_id: str) -> None:
    sample = mixed()
    sample.cell_data |= {
        "a b%c": np.arange(5, dtype=np.int64) << 40,
        "small": np.arange(5, dtype=np.uint8),
        "flag": np.array([True, False, True, True, False]),
        "half": np.arange(5, dtype=np.float16),
    }
    mesh = sample_mesh(mixed())
    mesh.cell_data = dict(sample.cell_data)
    write(mesh, tmp_path / f"x.{format_id}")
    if format_id == "vtk":
        reader = vtk.vtkUnstructuredGridReader()
        reader.ReadAllFieldsOn()
    else:
        reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(tmp_path / f"x.{format_id}"))
    reader.Update()
    found = reader.GetOutput()
    np.testing.assert_array_equal(vtk_to_numpy(found.GetPoints().GetData()), sample.points)
    for cell, (kind, ids) in enumerate(sample.cells):
        assert found.GetCellType(cell) == VTK_TYPES[kind]
        assert [found.GetCell(cell).GetPointId(i) for i in range(len(ids))] == ids
    for data, arrays in ((found.GetPointData(), sample.point_data), (found.GetCellData(), sample.cell_data)):
        assert data.GetNumberOfArrays() == len(arrays)
        for name, values in arrays.items():
            np.testing.assert_array_equal(vtk_to_numpy(data.GetArray(name)), values.astype(float))


@pytest.mark.parametrize("format_id", ["mesh", "vtk", "vtu"])
def test_A1_meshio_reads_what_is_written(tmp_path: Path, format_id: str) -> None:
    sample = grid(3, 4, 2)
    write(sample_mesh(sample), tmp_path / f"x.{format_id}")
    found = meshio.read(tmp_path / f"x.{format_id}")
    np.testing.assert_array_equal(found.points, sample.points)
    np.testing.assert_array_equal(found.cells_dict["hexahedron"], sample.rows_of(0))


def test_A1_a_mesh_without_cells_in_a_kind_and_odd_names() -> None:
    mesh = Mesh.from_cells(
        np.random.default_rng(1).random((8, 3)), np.arange(8), name="line\nbreak é" + "x" * 300
    )
    mesh.cell_data = {"": np.zeros(1), 'quote " <&>': np.ones(1), "wide é": np.zeros((1, 0))}
    for format_id in ("vtk", "vtu"):
        back = read_bytes(write_bytes(mesh, format_id), "x." + format_id)
        assert 'quote " <&>' in back.cell_data


@pytest.mark.parametrize("name", ["", "\t", "a\tb", "bell\x07", "nul\0", "é <&>"])
def test_A1_vtk_reads_vtu_files_whatever_their_arrays_are_called(tmp_path: Path, name: str) -> None:
    mesh = sample_mesh(mixed())
    mesh.cell_data = {name: np.arange(5.0)}
    write(mesh, tmp_path / "x.vtu")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(tmp_path / "x.vtu"))
    reader.Update()
    assert reader.GetOutput().GetNumberOfCells() == 5
    assert vtk_to_numpy(reader.GetOutput().GetCellData().GetArray(0)).tolist() == [0, 1, 2, 3, 4]


def test_A1_unknown_format_is_refused() -> None:
    with pytest.raises(MeshWriteError, match="mesh, vtk, vtu, meshb, msh, msh2, inp"):
        write_bytes(sample_mesh(grid(1, 1, 1)), "stl")
