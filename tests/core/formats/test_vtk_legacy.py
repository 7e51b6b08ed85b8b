"""SPEC R3: `.vtk` legacy, against files that VTK writes and against hand-written ones."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from tests.core.formats.samples import HEXAHEDRON, Sample, check, check_data, grid, mixed, signed_volumes
from tests.core.formats.vtk_files import insert, legacy, unstructured_grid
from tests.tools import tool

vtk = tool("vtk")

CUBE = """# vtk DataFile Version {version}
a cube
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 double
0 0 0 1 0 0 1 1 0 0 1 0
0 0 1 1 0 1 1 1 1 0 1 1
{cells}
CELL_TYPES 1
{type}
{rest}"""
COUNTED = "CELLS 1 9\n8 0 1 2 3 4 5 6 7"
SPLIT = "CELLS 2 8\nOFFSETS vtktypeint64\n0 8\nCONNECTIVITY vtktypeint64\n0 1 2 3 4 5 6 7"
HEAD = b"# vtk DataFile Version 3.0\nx\n"
UNIT_CUBE = Sample(
    np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=float),
    [(HEXAHEDRON, list(range(8)))],
)


def cube(cells: str = COUNTED, version: str = "3.0", type: object = 12, rest: str = "") -> bytes:
    return CUBE.format(version=version, cells=cells, type=type, rest=rest).encode()


@pytest.mark.parametrize("version", [42, 51])
@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("make", [mixed, lambda: grid(3, 2, 4)])
def test_R3_files_of_vtk(version: int, binary: bool, make) -> None:
    sample = make()
    mesh = read_bytes(legacy(unstructured_grid(sample), version, binary), "x.vtk")
    check(mesh, sample, 0 if binary else 1e-5)
    if binary:
        check_data(mesh, sample)


@pytest.mark.parametrize("header", ["1.0", "2.0", "3.0", "3.98", "4.0", "4.1", "4.2", "5.0", "5.1", "9.9"])
@pytest.mark.parametrize("cells", [COUNTED, SPLIT])
def test_R3_the_word_offsets_decides_not_the_version_line(header: str, cells: str) -> None:
    check(read_bytes(cube(cells, header), "x.vtk"), UNIT_CUBE)


@pytest.mark.parametrize("version", [42, 51])
def test_R3_binary_version_line_is_not_trusted(version: int) -> None:
    data = legacy(unstructured_grid(mixed()), version, True)
    line = data.split(b"\n", 1)[0]
    for claimed in (b"1.0", b"3.0", b"4.2", b"5.1"):
        check(read_bytes(data.replace(line, b"# vtk DataFile Version " + claimed, 1), "x.vtk"), mixed())


def test_R3_any_layout_of_numbers() -> None:
    data = cube().decode()
    head, numbers = data.split("POINTS 8 double\n")
    points, rest = numbers.split("CELLS")
    one_each = points.replace(" ", "\n")
    one_line = points.replace("\n", " ") + "\n"
    for text in (one_each, one_line, "\n\n" + points.replace(" ", "  \t "), points.replace("\n", "\r\n")):
        check(read_bytes((head + "POINTS 8 double\n" + text + "CELLS" + rest).encode(), "x.vtk"), UNIT_CUBE)
    spread = data.replace(COUNTED, "CELLS\n1\n9\n\n8 0 1\n2 3 4\n5 6\n 7\n")
    check(read_bytes(spread.encode(), "x.vtk"), UNIT_CUBE)


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s.replace("\n", "\r\n"),
        lambda s: "\ufeff" + s,
        lambda s: "\n\n" + s,
        lambda s: s.replace("a cube", ""),
        lambda s: s.replace("a cube\n", ""),
        lambda s: s.replace("a cube", "ASCII"),
        lambda s: s.replace("ASCII\n", "ASCII\n\n\n"),
        lambda s: s.lower().replace("a cube", "# vtk"),
        lambda s: s.rstrip(),
        lambda s: s.replace("0 0 0 1", "0.0E+00 -0.0 0d0 1.D0"),
        lambda s: s.replace("\n0 0 1", "\n\v\f0 0 1"),
    ],
)
def test_R3_spellings_of_the_same_file(change) -> None:
    check(read_bytes(change(cube().decode()).encode(), "x.vtk"), UNIT_CUBE)


def test_R3_line_end_behind_a_binary_block_is_optional() -> None:
    data = legacy(unstructured_grid(grid(2, 2, 2)), 42, True)
    for word in (b"CELLS", b"CELL_TYPES"):
        data = data.replace(b"\n" + word, word)
    check(read_bytes(data, "x.vtk"), grid(2, 2, 2))


def test_R3_binary_with_windows_line_ends_in_its_header() -> None:
    data = legacy(unstructured_grid(grid(1, 1, 2)), 42, True)
    start = data.index(b"double\n")
    data = data[:start].replace(b"\n", b"\r\n") + b"double\r\n" + data[start + 7 :]
    check(read_bytes(data, "x.vtk"), grid(1, 1, 2))


def test_R3_voxels_have_another_corner_order() -> None:
    voxel = cube(COUNTED.replace("0 1 2 3 4 5 6 7", "0 1 3 2 4 5 7 6"), type=11)
    mesh = read_bytes(voxel, "x.vtk")
    check(mesh, UNIT_CUBE)
    assert mesh.notes == []


def test_R3_voxels_of_vtk() -> None:
    image = vtk.vtkImageData()
    image.SetDimensions(3, 4, 2)
    filter = vtk.vtkAppendFilter()
    filter.AddInputData(image)
    filter.Update()
    mesh = read_bytes(legacy(filter.GetOutput(), 51, True), "x.vtk")
    assert mesh.kind_counts == {"hexahedron": 6}
    np.testing.assert_allclose(signed_volumes(mesh), 1)


def test_R3_voxels_written_in_hexahedral_order_are_found_out_by_volume() -> None:
    mesh = read_bytes(cube(type=11), "x.vtk")
    check(mesh, UNIT_CUBE)
    assert any("voxels" in note for note in mesh.notes)


@pytest.mark.parametrize("type", [10, 9, 0, 255, -3, 28, 71])
def test_R3_eight_corners_called_something_else_are_a_hexahedron(type: int) -> None:
    mesh = read_bytes(cube(type=type), "x.vtk")
    check(mesh, UNIT_CUBE)
    assert len(mesh.notes) == 1 and f"type {type}" in mesh.notes[0]


def test_R3_quadratic_faces_beside_hexahedra_are_no_hexahedra() -> None:
    sample = grid(1, 1, 1)
    data = unstructured_grid(sample)
    insert(data, 23, [0, 1, 2, 3, 4, 5, 6, 7])
    insert(data, 7, [0, 1, 2, 3, 4, 5, 6, 7])
    mesh = read_bytes(legacy(data, 51, True), "x.vtk")
    check(mesh, sample)
    assert any("polygons (1)" in note for note in mesh.notes)
    assert any("quadratic quadrilaterals" in note for note in mesh.notes)
    assert [part.corners.T.tolist() for part in mesh.features] == [[[0, 1, 2, 3]]]


def test_R3_no_cell_types() -> None:
    mesh = read_bytes(cube().split(b"CELL_TYPES")[0], "x.vtk")
    check(mesh, UNIT_CUBE)
    assert len(mesh.notes) == 1


def test_R3_text_after_the_mesh_ends_the_reading_with_a_note() -> None:
    mesh = read_bytes(cube(rest="\n*** The MPI_Finalize() function was called\n1 2 3\n"), "x.vtk")
    check(mesh, UNIT_CUBE)
    assert "line 13" in mesh.notes[0]


def test_R3_metadata_is_skipped() -> None:
    sample = grid(2, 1, 1)
    sample.point_data["named"] = np.arange(36.0).reshape(12, 3)
    data = unstructured_grid(sample)
    array = data.GetPointData().GetArray("named")
    for number, name in enumerate(("first one", "second", "third")):
        array.SetComponentName(number, name)
    key = vtk.vtkDataArray.UNITS_LABEL()
    array.GetInformation().Set(key, "a b c")
    data.GetPoints().GetData().GetInformation().Set(key, "POINTS 3 float")
    for version in (42, 51):
        for binary in (False, True):
            text = legacy(data, version, binary)
            assert text.count(b"METADATA") == 2
            mesh = read_bytes(text, "x.vtk")
            check(mesh, sample, 1e-5)
            np.testing.assert_allclose(mesh.point_data["named"], sample.point_data["named"], atol=1e-4)


def test_R3_metadata_by_hand() -> None:
    rest = "METADATA\nINFORMATION 1\nNAME L2_NORM LOCATION vtkDataArray\nDATA 2 0 1.7\n\n"
    rest += "CELL_DATA 1\nSCALARS q float\n5"
    mesh = read_bytes(cube(rest=rest), "x.vtk")
    assert mesh.cell_data["q"].tolist() == [5]


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (HEAD + b"ASCII\nDATASET POLYDATA\nPOINTS 0 float\n", ["line 4", "POLYDATA", "surface"]),
        (HEAD + b"ASCII\nDATASET STRUCTURED_POINTS\n", ["STRUCTURED_POINTS", "UNSTRUCTURED_GRID", "Append"]),
        (HEAD + b"ASCII\nDATASET STRUCTURED_GRID\n", ["a structured grid", "ParaView", "save it as .vtu"]),
        (HEAD + b"ASCII\nDATASET RECTILINEAR_GRID\n", ["a rectilinear grid", "ParaView", "save it as .vtu"]),
        (b"# vtk DataFile Version 3.0\nx\nTEXT\nDATASET POLYDATA\n", ["ASCII or BINARY"]),
        (b"# vtk DataFile Version 3.0\n", ["ASCII or BINARY"]),
        (cube(type="x"), ["line 11", "‘x’", "CELL_TYPES"]),
        (cube("CELLS 1 8\n8 0 1 2 3 4 5 6"), ["does not fit"]),
        (cube("CELLS 2 9\n8 0 1 2 3 4 5 6 7"), ["2 rows", "1 rows take 9"]),
        (cube("CELLS 1 10\n8 0 1 2 3 4 5 6 7 0"), ["1 rows take 9"]),
        (cube("CELLS 1 9\n-8 0 1 2 3 4 5 6 7"), ["does not fit"]),
        (cube("CELLS -1 9\n8 0 1 2 3 4 5 6 7"), ["CELLS announces -1"]),
        (cube("CELLS 1 9\n8 0 1 2 3 4 5 6 8"), ["line 9", "vertex 8", "0 to 7"]),
        (cube("CELLS 1 9\n8 0 1 2 3 4 5 6 -1"), ["line 9", "vertex -1"]),
        (cube("CELLS 1 9\n8 0 1 2 3 4 5 6 4294967296"), ["line 9", "vertex"]),
        (cube("CELLS 1 9\n8 0 1 2 3 4 5 6 7x"), ["line 9", "‘7x’"]),
        (cube("CELLS 1 9\n8 0 1 2 3 4 5 6 7.5"), ["line 9", "‘7.5’", "whole"]),
        (cube("CELLS 1 9\n8 0 1 2 3 4 5 6-7"), ["line 9", "‘6-7’"]),
        (cube(SPLIT.replace("0 8", "0 9")), ["offset 1 is 9"]),
        (cube(SPLIT.replace("0 8", "1 8")), ["offset 0 is 1"]),
        (cube("CELLS 2 8\nOFFSETS vtktypeint64\n0 8\n0 1 2 3 4 5 6 7"), ["CONNECTIVITY was expected"]),
        (cube("CELLS 2 8\nOFFSETS word\n0 8\n0 1 2 3 4 5 6 7"), ["‘word’", "type of numbers"]),
        (cube().replace(b"CELL_TYPES 1", b"CELL_TYPES 2"), ["CELL_TYPES", "2"]),
        (cube().replace(b"POINTS 8", b"POINTS 9"), ["line 8", "‘CELLS’", "27 numbers", "number 25"]),
        (cube().replace(b"POINTS 8", b"POINTS 7"), ["line 7", "‘0’", "section"]),
        (cube().replace(b"POINTS 8", b"POINTS 800000000000"), ["line 5", "800000000000 points"]),
        (cube().replace(b"POINTS 8", b"POINTS -8"), ["line 5", "-8"]),
        (cube().replace(b"POINTS 8", b"POINTS eight"), ["line 5", "‘eight’"]),
        (cube().replace(b"1 0 1 1 1", b"1 0 nan 1 1"), ["line 7", "z coordinate of vertex 6 is nan"]),
        (cube().replace(b"1 0 1 1 1", b"1 0 1e400 1 1"), ["line 7", "inf"]),
        (cube().replace(b"double", b"string"), ["string"]),
        (cube("CELLS 1 4\n3 0 1 2", type=10), ["tetrahedra", "has 3 corners", "expected 4"]),
        (cube("CELLS 1 4\n3 0 1 2", type=5), ["no volumetric cells", "triangles (1)"]),
        (cube() + b"POINTS 1 float\n0 0 0\n", ["second section POINTS"]),
        (cube() + COUNTED.encode(), ["second section CELLS"]),
        (cube().split(b"CELLS")[0], ["before its section CELLS"]),
        (cube().replace(b"CELL_TYPES", b"CELL_TIPES"), ["note"]),
    ],
)  # fmt: skip
def test_R10_bad_legacy_files(data: bytes, words: list[str]) -> None:
    if words == ["note"]:
        assert "CELL_TIPES" in " ".join(read_bytes(data, "bad.vtk").notes)
        return
    with pytest.raises(MeshReadError) as caught:
        read_bytes(data, "bad.vtk")
    assert str(caught.value).startswith("bad.vtk")
    for word in words:
        assert word in str(caught.value)


def test_R10_truncated_binary_names_the_byte() -> None:
    data = legacy(unstructured_grid(grid(2, 2, 2)), 42, True)
    cut = data.index(b"CELLS") + 40
    with pytest.raises(MeshReadError, match=r"byte \d+.*CELLS should be 288 bytes"):
        read_bytes(data[:cut], "x.vtk")


def test_R3_rows_of_all_lengths_without_walking_them() -> None:
    random = np.random.default_rng(5)
    sizes = random.choice([3, 4, 8], 5000)
    rows = [random.integers(0, 8, size) for size in sizes]
    text = "\n".join(" ".join(map(str, [len(row), *row])) for row in rows)
    types = "\n".join({3: "5", 4: "10", 8: "12"}[int(size)] for size in sizes)
    data = cube().decode().replace(COUNTED, f"CELLS {len(rows)} {sum(sizes) + len(rows)}\n{text}")
    data = data.replace("CELL_TYPES 1\n12", f"CELL_TYPES {len(rows)}\n{types}")
    mesh = read_bytes(data.encode(), "x.vtk")
    kept = [row for row in rows if len(row) > 3]
    assert mesh.cell_count == len(kept)
    wanted = [row.tolist() if len(row) == 8 else [row[i] for i in (0, 1, 2, 2, 3, 3, 3, 3)] for row in kept]
    np.testing.assert_array_equal(mesh.cells, wanted)
