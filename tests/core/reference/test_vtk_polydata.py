"""VTK's polygons, legacy and XML, against what VTK writes and reads."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.reference import TriangleSurface, read_reference_bytes
from tests.core.reference.surfaces import (
    CUBE,
    CUBE_QUADS,
    assert_same,
    ball,
    found_by_vtk,
    poly_data,
    vtk,
    written,
)

VERSIONS = [(42, "SetFileTypeToASCII"), (42, "SetFileTypeToBinary"), (51, "SetFileTypeToASCII"),
            (51, "SetFileTypeToBinary")]  # fmt: skip
XML = [
    {"SetDataModeToAscii": None},
    {"SetDataModeToBinary": None},
    {"SetDataModeToAppended": None, "EncodeAppendedDataOff": None},
    {"SetDataModeToAppended": None, "SetCompressorTypeToNone": None},
]


def legacy(data: Any, version: int, mode: str) -> bytes:
    return written(vtk.vtkPolyDataWriter(), data, SetFileVersion=version, **{mode: None})


def read(data: bytes) -> TriangleSurface:
    return read_reference_bytes(data, "x.vtk")


def with_everything() -> Any:
    """Triangles, quadrilaterals, strips and lines, with arrays of points and cells."""
    points, triangles = ball(2)
    strips = [[0, 7, 20, 9, 33, 5], [8, 1, 2], [40, 41, 42, 43]]
    kite = [[5, 0, 0], [7, 0, 0], [7, 1, 0], [5, 2, 0]]
    count = len(points)
    points = np.concatenate([points, kite])
    quad = range(count, count + 4)
    data = poly_data(points, *triangles, quad, strips=strips, lines=[[0, 1], [1, 2, 3]])
    for values, target in (("f", data.GetPointData()), ("g", data.GetCellData())):
        array = vtk.vtkDoubleArray()
        array.SetName(values)
        count = data.GetNumberOfPoints() if values == "f" else data.GetNumberOfCells()
        for number in range(count):
            array.InsertNextValue(number / 3)
        target.AddArray(array)
    return data


@pytest.mark.parametrize(("version", "mode"), VERSIONS)
def test_triangles(version: int, mode: str) -> None:
    points, triangles = ball()
    data = legacy(poly_data(points, *triangles), version, mode)
    assert (b"OFFSETS" in data) == (version == 51)
    found = read(data)
    assert_same(found, found_by_vtk(vtk.vtkPolyDataReader(), data))
    assert np.allclose(found.points.T, points, rtol=0, atol=1e-10)
    assert found.count == len(triangles) and found.closed and found.format == "polydata" and found.notes == ()


def test_version_3() -> None:
    points, triangles = ball()
    data = legacy(poly_data(points, *triangles), 42, "SetFileTypeToASCII")
    data = data.replace(b"DataFile Version 4.2", b"DataFile Version 3.0")
    found = read(data)
    assert_same(found, found_by_vtk(vtk.vtkPolyDataReader(), data))
    for same in (b"\n" + data.replace(b"POLYDATA", b"Polydata"), data.replace(b"\n", b"\r\n")):
        assert_same(read_reference_bytes(same, "no ending"), found.points.T[found.triangles.T])


@pytest.mark.parametrize(("version", "mode"), VERSIONS)
def test_all_that_there_can_be(version: int, mode: str) -> None:
    data = legacy(with_everything(), version, mode)
    found = read(data)
    assert_same(found, found_by_vtk(vtk.vtkPolyDataReader(), data))
    assert found.notes == ("Left out, as they are no faces: lines (2).",)


@pytest.mark.parametrize("calls", XML)
def test_xml(calls: dict[str, None]) -> None:
    data = written(vtk.vtkXMLPolyDataWriter(), with_everything(), **calls)
    for name in ("x.vtp", "x"):
        found = read_reference_bytes(data, name)
        assert_same(found, found_by_vtk(vtk.vtkXMLPolyDataReader(), data))
        assert found.notes == ("Left out, as they are no faces: lines (2).",) and found.format == "vtp"


def test_xml_in_pieces() -> None:
    points, triangles = ball(1)
    writer = vtk.vtkXMLPolyDataWriter()
    data = written(writer, poly_data(points, *triangles), SetDataModeToAscii=None).decode()
    start, end = data.index("<Piece"), data.index("</Piece>") + len("</Piece>")
    twice = data[:end] + data[start:end] + data[end:]
    found = read_reference_bytes(twice.encode(), "x.vtp")
    assert_same(found, np.concatenate([points[triangles]] * 2))
    assert found.points.shape[1] == 2 * len(points)
    for old, new, words in (
        ('NumberOfPolys="32"', 'NumberOfPolys="31"', "32 offsets for 31 cells of Polys"),
        ('"connectivity"', '"conn"', "Polys has no DataArray connectivity"),
        ("<Polys>", "<Poly>", "Polys"),
    ):
        assert old in data
        with pytest.raises(MeshReadError, match=words):
            read_reference_bytes(data.replace(old, new).encode(), "x.vtp")
    at = data.index("connectivity", data.index("<Polys"))
    number = data.index("0 ", data.index(">", at))
    for new in ("99", "-1"):
        with pytest.raises(
            MeshReadError, match=f"Polys refer to vertex {new}, which is not there: expected 0 to 17"
        ):
            read_reference_bytes((data[:number] + new + data[number + 1 :]).encode(), "x.vtp")


@pytest.mark.parametrize(("version", "mode"), VERSIONS)
def test_polygons_of_many_corners(version: int, mode: str) -> None:
    ring = np.stack([np.cos(np.arange(7)), np.sin(np.arange(7)), np.zeros(7)], axis=1)
    found = read(legacy(poly_data(ring, range(7), [0, 1, 2]), version, mode))
    assert found.triangles.T.tolist() == [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 6], [0, 1, 2]]
    assert len(found.notes) == 1 and "fans" in found.notes[0]


@pytest.mark.parametrize(("version", "mode"), VERSIONS)
def test_quadrilaterals_are_cut_as_vtk_cuts_them(version: int, mode: str) -> None:
    random = np.random.default_rng(3)
    points = np.concatenate(
        [CUBE + 3 * number + random.uniform(-0.3, 0.3, CUBE.shape) for number in range(20)]
    )
    quads = np.concatenate([CUBE_QUADS + 8 * number for number in range(20)])
    data = legacy(poly_data(points, *quads), version, mode)
    found = read(data)
    assert_same(found, found_by_vtk(vtk.vtkPolyDataReader(), data))
    assert found.count == 240 and found.closed


HEAD = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n"


@pytest.mark.parametrize(
    ("rest", "words"),
    [
        (
            "POLYGONS 1 4\n3 0 1 4\n",
            ", line 8: a face refers to vertex 4, which is not there: expected 0 to 3",
        ),
        ("TRIANGLE_STRIPS 1 5\n4 0 1 2 9\n", ", line 8: a face refers to vertex 9"),
        ("POLYGONS 1 4\n3 0 1\n", ", line 8: the file ends in POLYGONS: 3 of 4 numbers are there"),
        ("POLYGONS 1 4\n3 0 1 x\n", ", line 8: ‘x’ stands where a whole number was expected, in POLYGONS"),
        ("POLYGONS 1 5\n3 0 1 2 3\n", ", line 8: POLYGONS should be 1 rows in 5 values"),
        ("POLYGONS 9 4\n3 0 1 2\n", ", line 8: POLYGONS announces 9 polygons in 4 values"),
        ("POLYGONS -1 4\n3 0 1 2\n", ", line 7: POLYGONS announces -1 and 4"),
        (
            "POLYGONS 1 4\n3 0 1 2\nPOLYGONS 1 4\n3 0 1 2\n",
            ", line 9: a second section POLYGONS, expected one",
        ),
        (
            "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2\n",
            ", line 9: offset 1 is 4",
        ),
        (
            "LINES 1 3\n2 0 1\n",
            ": the file has no faces, expected a surface .Left out, as they are no faces: lines",
        ),
        ("POLIGONS 1 4\n3 0 1 2\n", ", line 7: ‘POLIGONS’ stands where a section was expected"),
        ("", ": the file has no faces, expected a surface"),
    ],
)
def test_what_is_wrong_is_named(rest: str, words: str) -> None:
    with pytest.raises(MeshReadError, match=rf"^x\.vtk{words}"):
        read((HEAD + rest).encode())


def test_a_log_behind_the_polygons_and_bad_points() -> None:
    found = read((HEAD + "POLYGONS 1 4\n3 0 1 2\nwritten in 3 s\n").encode())
    assert found.notes == ("Reading stopped at line 9, which is not of the format: ‘written’.",)
    with pytest.raises(MeshReadError, match="line 6: the z coordinate of vertex 4 is nan"):
        read((HEAD.replace("0 1\n", "0 nan\n") + "POLYGONS 1 4\n3 0 1 2\n").encode())


def test_a_binary_file_that_is_cut_short_names_the_byte() -> None:
    points, triangles = ball(1)
    data = legacy(poly_data(points, *triangles), 42, "SetFileTypeToBinary")
    at = data.index(b"\n", data.index(b"POLYGONS")) + 1
    with pytest.raises(
        MeshReadError, match=rf"^x\.vtk, byte {at}: POLYGONS should be 512 bytes, but the file has only 9"
    ):
        read(data[: at + 9])
