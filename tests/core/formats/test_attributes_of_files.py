"""SPEC R8: arrays of legacy `.vtk` files by name, in every section that holds them."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from tests.core.formats.samples import grid
from tests.core.formats.test_vtk_legacy import cube
from tests.core.formats.vtk_files import insert, legacy, numpy_to_vtk, unstructured_grid
from tests.tools import tool

vtk = tool("vtk")

TYPES = ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64")


@pytest.mark.parametrize("version", [42, 51])
@pytest.mark.parametrize("binary", [False, True])
def test_R8_every_section_and_type_that_vtk_writes(version: int, binary: bool) -> None:
    sample = grid(2, 3, 2)
    random = np.random.default_rng(3)
    data = unstructured_grid(sample)
    wanted = {}
    roles = ["Scalars", "Vectors", "Normals", "TCoords", "Tensors", "GlobalIds", "PedigreeIds"]
    widths = {"Vectors": 3, "Normals": 3, "TCoords": 2, "Tensors": 9, "Scalars": 2}
    for where, count in ((data.GetPointData(), 36), (data.GetCellData(), 12)):
        for role in roles:
            width = widths.get(role, 1)
            values = (
                np.round(random.uniform(-1, 1, (count, width)), 3) if width > 1 else np.arange(count)[:, None]
            )
            array = numpy_to_vtk(values if width > 1 else values.astype(np.int64), deep=True)
            if role in ("GlobalIds", "PedigreeIds"):
                array = vtk.vtkIdTypeArray()
                for value in values.ravel():
                    array.InsertNextValue(int(value))
            array.SetName(f"{role} of {count}")
            getattr(where, f"Set{role}")(array)
            wanted[f"{role} of {count}"] = values
        for code in TYPES:
            values = (random.integers(0, 100, (count, 2))).astype(code)
            array = numpy_to_vtk(values, deep=True)
            array.SetName(f"{code}%{count}")
            where.AddArray(array)
            wanted[f"{code}%{count}"] = values
        bits = vtk.vtkBitArray()
        for index in range(count):
            bits.InsertNextValue(index % 3 == 0)
        bits.SetName(f"bits {count}")
        where.AddArray(bits)
        wanted[f"bits {count}"] = (np.arange(count) % 3 == 0)[:, None]
        names = vtk.vtkStringArray()
        for index in range(count):
            names.InsertNextValue("x" * (index * 9) + " y")
        names.SetName(f"names {count}")
        where.AddArray(names)
    mesh = read_bytes(legacy(data, version, binary), "x.vtk")
    found = mesh.point_data | mesh.cell_data
    wanted = {name: values for name, values in wanted.items() if not name.startswith("GlobalIds")}
    assert mesh.vertex_numbers is None and mesh.cell_numbers is None  # ids that count the rows
    assert set(found) == set(wanted)
    for name, values in wanted.items():
        np.testing.assert_allclose(found[name].reshape(len(values), -1), values, atol=1e-5)
        if name.split("%")[0] in TYPES:
            assert found[name].dtype == np.dtype(name.split("%")[0])


def test_R8_cells_left_out_take_their_values_along() -> None:
    sample = grid(2, 1, 1)
    data = unstructured_grid(sample)
    insert(data, 9, [0, 1, 2, 3])
    insert(data, 12, sample.cells[0][1])
    array = numpy_to_vtk(np.array([1.0, 2.0, 3.0, 4.0]), deep=True)
    array.SetName("q")
    data.GetCellData().AddArray(array)
    for binary in (False, True):
        mesh = read_bytes(legacy(data, 51, binary), "x.vtk")
        assert mesh.cell_data["q"].tolist() == [1, 2, 4]


def read_rest(rest: str):
    return read_bytes(cube(rest=rest), "x.vtk")


def test_R8_sections_by_hand() -> None:
    mesh = read_rest(
        "POINT_DATA 8\nSCALARS fixed int\n0 1 2 3 4 5 6 7\n"
        "SCALARS pair float 2\nLOOKUP_TABLE default\n"
        + "1 2 "
        * 8
        + "\nLOOKUP_TABLE mine 2\n0 0 0 1 1 1 1 1\n"
        "CELL_DATA 1\nscalars fixed double 1\nlookup_table default\n7.5\nCOLOR_SCALARS rgb 3\n0 .5 1\n"
        "TENSORS6 six float\n1 2 3 4 5 6\nFIELD FieldData 2\na%20b 1 1 float\nnan\nfixed 2 1 int\n1 2\n"
    )
    assert mesh.point_data["fixed"].tolist() == list(range(8))
    assert mesh.point_data["pair"].tolist() == [[1, 2]] * 8
    assert mesh.cell_data["fixed"].tolist() == [7.5] and mesh.cell_data["fixed_2"].tolist() == [[1, 2]]
    assert mesh.cell_data["rgb"].tolist() == [[0, 0.5, 1]] and mesh.cell_data["six"].shape == (1, 6)
    assert np.isnan(mesh.cell_data["a b"]).all()


def test_R8_arrays_of_another_length_are_left_out_with_a_note() -> None:
    mesh = read_rest(
        "CELL_DATA 2\nSCALARS q float\nLOOKUP_TABLE default\n1 2\nPOINT_DATA 8\nSCALARS p int\n" + "1 " * 8
    )
    assert mesh.cell_data == {} and list(mesh.point_data) == ["p"]
    assert "‘q’ has 2 entries for 1 cells" in mesh.notes[0]


@pytest.mark.parametrize(
    ("rest", "words"),
    [
        ("CELL_DATA 1\nSCALARS q float\nLOOKUP_TABLE default\n", ["the array ‘q’ should be 1 numbers"]),
        ("CELL_DATA 1\nSCALARS q float\nLOOKUP_TABLE default\nx", ["line 15", "‘x’"]),
        ("CELL_DATA 1\nSCALARS q word\n1", ["‘word’", "type of numbers"]),
        ("CELL_DATA 1\nSCALARS q float 0\n1", ["0 components"]),
        ("CELL_DATA 1\nSCALARS q float 99999999999\n1", ["components"]),
        ("CELL_DATA 1\nSCALARS\n1", ["SCALARS should be followed"]),
        ("CELL_DATA 900000000\nSCALARS q float\n1", ["should be 900000000 numbers"]),
        ("CELL_DATA -1\nSCALARS q float\n1", ["-1"]),
        ("CELL_DATA 1\nFIELD f 1\nq 1 -3 float\n1", ["-3"]),
        ("CELL_DATA 1\nFIELD f 9999999\nq 1 1 float\n1", ["9999999"]),
    ],
)
def test_R10_bad_attributes(rest: str, words: list[str]) -> None:
    with pytest.raises(MeshReadError) as caught:
        read_rest(rest)
    for word in words:
        assert word in str(caught.value)
