"""PLY in its three forms, against what VTK and meshio write and read, and with the traps of real files."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.reference import read_reference_bytes
from hexalab.reference.cutting import triangles_of
from tests.core.reference.surfaces import (
    CUBE,
    CUBE_QUADS,
    assert_same,
    ball,
    by_meshio,
    found_by_vtk,
    poly_data,
    vtk,
    written,
)
from tests.counting import lines_of_core

FORMS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
CODES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4",
    "double": "f8",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4", "float32": "f4",
    "float64": "f8",
}  # fmt: skip

Rows = list[list[Any]]
"""Rows of an element: numbers, and lists of numbers where the property is a list."""


def ply(form: str, *elements: tuple[str, list[str], Rows], newline: str = "\n") -> bytes:
    """The bytes of a file; properties are what stands behind the word `property`."""
    order = FORMS[form]
    lines = ["ply", f"format {form} 1.0", "comment made by a test"]
    body = b""
    for name, properties, rows in elements:
        lines += [f"element {name} {len(rows)}", *(f"property {one}" for one in properties)]
        for row in rows:
            words: list[Any] = []
            for one, value in zip(properties, row, strict=True):
                types = one.split()
                if types[0] == "list":
                    words += [(types[1], len(value)), *((types[2], entry) for entry in value)]
                else:
                    words.append((types[0], value))
            if order:
                body += b"".join(np.array(value, order + CODES[kind]).tobytes() for kind, value in words)
            else:
                body += (" ".join(str(value) for _, value in words) + newline).encode()
    return (newline.join([*lines, "end_header", ""])).encode() + body


XYZ = ["float x", "float y", "float z"]
LIST = ["list uchar int vertex_indices"]


def simple(form: str, points: Any, faces: Any, **options: str) -> bytes:
    return ply(
        form,
        ("vertex", XYZ, np.asarray(points).tolist()),
        ("face", LIST, [[list(map(int, face))] for face in faces]),
        **options,
    )


@pytest.mark.parametrize("calls", [
    {"SetFileTypeToASCII": None},
    {"SetFileTypeToBinary": None, "SetDataByteOrderToLittleEndian": None},
    {"SetFileTypeToBinary": None, "SetDataByteOrderToBigEndian": None},
])  # fmt: skip
def test_what_vtk_writes(calls: dict[str, None]) -> None:
    points, triangles = ball()
    data = written(vtk.vtkPLYWriter(), poly_data(points, *triangles), **calls)
    found = read_reference_bytes(data, "x.ply")
    assert_same(found, found_by_vtk(vtk.vtkPLYReader(), data))
    if "SetFileTypeToBinary" in calls:
        assert_same(found, points[triangles])
    assert found.count == len(triangles) and found.closed and found.format == "ply" and found.notes == ()


@pytest.mark.parametrize("binary", [False, True])
def test_what_meshio_writes(binary: bool) -> None:
    points, triangles = ball(1)
    blocks = [("triangle", triangles), ("quad", triangles[:3, [0, 1, 2, 2]])]
    found = read_reference_bytes(by_meshio(points, blocks[:1], "ply", binary=binary), "x.ply")
    assert_same(found, points[triangles])
    quads = read_reference_bytes(by_meshio(CUBE, [("quad", CUBE_QUADS)], "ply", binary=binary), "x.ply")
    assert quads.count == 12 and quads.closed and quads.volume == pytest.approx(1, rel=1e-14)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("counted_by", ["char", "uchar", "short", "uint16", "int32", "uint"])
@pytest.mark.parametrize("kind", ["uchar", "int16", "ushort", "int", "uint32"])
def test_numbers_of_all_types(form: str, counted_by: str, kind: str) -> None:
    points, triangles = ball(1)
    faces = [[triangle] for triangle in triangles.tolist()]
    data = ply(
        form,
        ("vertex", ["double z", "uchar red", "double x", "int q", "double y"],
         [[z, 200, x, -7, y] for x, y, z in points.tolist()]),
        ("face", [f"list {counted_by} {kind} vertex_index"], faces),
    )  # fmt: skip
    assert_same(read_reference_bytes(data, "x.ply"), points[triangles])


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("varied", [False, True])
def test_elements_in_any_order_with_any_properties(form: str, varied: bool) -> None:
    points, triangles = ball(1)
    texture = [[0.5] * (6 if not varied else number % 7) for number in range(len(triangles))]
    faces = ("face", ["uchar flags", "list uchar float texcoord", "list uchar int vertex_indices", "short q",
                      "list int double more"],
             [[1, texture[row], face, -2, texture[row]] for row, face in enumerate(triangles.tolist())])  # fmt: skip
    cameras = (
        "camera",
        ["float fov", "list uchar short some"],
        [[1.5, [1, 2, 3]], [2.5, [7] * (4 if varied else 3)]],
    )
    vertices = ("vertex", [*XYZ, "list uchar int around"],
                [[*point, [5] * (1 + varied * (row % 3))] for row, point in enumerate(points.tolist())])  # fmt: skip
    for elements in (
        [cameras, vertices, faces],
        [faces, vertices, cameras],
        [vertices, cameras, faces, cameras],
    ):
        assert_same(read_reference_bytes(ply(form, *elements), "x.ply"), points[triangles])


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("order", ["mixed", "sorted", "mostly one"])
def test_polygons_of_differing_length(form: str, order: str) -> None:
    random = np.random.default_rng(5)
    points = np.float32(random.random((200, 3)))
    sizes = random.integers(1, 9, 3000)
    sizes = {"mixed": sizes, "sorted": np.sort(sizes), "mostly one": np.where(sizes == 7, 5, 3)}[order]
    faces = [random.choice(200, size, replace=False) for size in sizes]
    found = read_reference_bytes(simple(form, points, faces), "x.ply")
    some = [face for face in faces if len(face) > 2]
    own = np.array([len(face) for face in some])
    expected = triangles_of(points.T.astype(float), np.concatenate(some), np.cumsum(own) - own, own)
    assert found.triangles.tolist() == expected.tolist()
    assert np.array_equal(found.points.T, points)
    few, many = int((sizes < 3).sum()), int((sizes > 4).sum())
    assert found.notes[-1].startswith(f"Faces of more than four corners ({many:,}) were cut")
    assert len(found.notes) == 1 + (few > 0)


@pytest.mark.parametrize("form", ["binary_little_endian", "binary_big_endian"])
def test_rows_larger_than_a_stretch(form: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rows are found in stretches of 64 bytes, some longer than that."""
    monkeypatch.setattr("hexalab.reference.ply_rows.STRETCH", 64)
    test_polygons_of_differing_length(form, "mixed")
    random = np.random.default_rng(6)
    sizes = random.choice([3, 3, 4, 40, 5], 300)
    points = np.float32(random.random((50, 3)))
    faces = [random.choice(50, size, replace=False) for size in sizes]
    found = read_reference_bytes(simple(form, points, faces), "x.ply")
    assert found.count == int((sizes - 2).sum())
    assert found.triangles[:, -1].tolist() == [faces[-1][0], *faces[-1][-2:]] or len(faces[-1]) == 4


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("form", FORMS)
def test_line_ends(form: str, newline: str) -> None:
    points, triangles = ball(0)
    points[0, 0] = np.frombuffer(b"\n\n\n\n", "<f4" if form != "binary_big_endian" else ">f4")[0]
    assert_same(
        read_reference_bytes(simple(form, points, triangles, newline=newline), "x"),
        np.float32(points).astype(float)[triangles],
    )


def test_text_with_blank_lines_and_more_on_lines_than_there_should_be() -> None:
    points, triangles = ball(0)
    data = simple("ascii", points, triangles).replace(b"end_header\n", b"end_header\n\n \n")
    data = data.replace(b"\n3 ", b"  255 0.5\n\n3\t").rstrip() + b" 1"
    found = read_reference_bytes(data, "x.ply")
    assert_same(found, points[triangles])


def test_degenerate_triangles_are_left_out() -> None:
    points, triangles = ball(0)
    data = simple("binary_little_endian", points, [[0, 1, 1], *triangles, [2, 2, 2]])
    found = read_reference_bytes(data, "x.ply")
    assert_same(found, points[triangles])
    assert found.notes == ("Left out, as they have a vertex twice: triangles (2).",)


HEAD = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
BODY = "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("ascii 1.0", "ascii_2 1.0", "line 2: ‘format ascii_2 1.0’ stands in the header, expected format, element"),
        ("format ascii 1.0\n", "", "line 1: the header has no line format, expected one of ascii, binary_l"),
        ("end_header", "end_head", "line 13: the file has no line end_header: it is cut short"),
        ("float y", "real y", "line 5: ‘property real y’ stands in the header"),
        ("float y", "float q", "line 1: the element vertex has no number y in front of its lists, only x, q, z"),
        ("uchar int", "float int", "line 8: ‘property list float int vertex_indices’ stands in the header"),
        ("uchar int", "uchar float", "line 1: the list vertex_indices is of type float32, expected integers"),
        ("vertex_indices", "corners", "line 1: the element face has no list vertex_indices or vertex_index, only corn"),
        ("element face", "element tristrips", "line 1: the file has no element ‘face’, only vertex .3., tristrips .1.: "
         "expected a surface; triangle strips are not read"),
        ("element vertex", "element point", "line 1: the file has no element ‘vertex’, only point .3., face .1.: exp"),
        ("vertex 3", "vertex -3", "line 3: the element ‘vertex’ has -3 rows"),
        ("vertex 3", "vertex three", "line 3: ‘element vertex three’ stands in the header"),
        ("vertex 3", "vertex 4", "line 13: the file ends in the faces: 0 of 1 lines are there"),
        ("vertex 3", "vertex 999999999999", "line 13: the file ends in the vertices: 4 of 999999999999 lines"),
        ("face 1", "face 2", "line 13: the file ends in the faces: 1 of 2 lines are there"),
        ("1 0 0\n", "1 0\n", "line 11: a vertex has 2 numbers, expected x, y and z"),
        ("1 0 0\n", "1 0 o\n", "line 11: ‘o’ stands where a number was expected, in the vertices"),
        ("1 0 0\n", "1 0 nan\n", "line 11: in the vertices, the z coordinate of vertex 2 is nan"),
        ("3 0 1 2", "4 0 1 2", "line 13: a list of 4 numbers is announced, which are not there"),
        ("3 0 1 2", "-3 0 1 2", "line 13: a list of -3 numbers is announced"),
        ("3 0 1 2", "3 0 1 3", "line 13: a face refers to vertex 3, which is not there: expected 0 to 2"),
        ("3 0 1 2", "3 0 -1 2", "line 13: a face refers to vertex -1, which is not there"),
        ("3 0 1 2", "3 0 x 2", "line 13: ‘x’ stands where a number was expected, in the faces"),
        ("face 1", "face 0", "^the file has no faces, expected a surface"),
        ("3 0 1 2", "0", "^the file has no faces, expected a surface .Left out, as they have less than three corners"),
    ],
)  # fmt: skip
def test_what_is_wrong_in_text_is_named_with_its_line(old: str, new: str, words: str) -> None:
    data = (HEAD + BODY).replace(old, new, 1)
    where = rf"^x\.ply, {words}" if words[0] != "^" else rf"^x\.ply: {words[1:]}"
    with pytest.raises(MeshReadError, match=where):
        read_reference_bytes(data.encode(), "x.ply")


@pytest.mark.parametrize("form", ["binary_little_endian", "binary_big_endian"])
def test_what_is_wrong_in_binary_is_named_with_its_byte(form: str) -> None:
    points, triangles = ball(0)
    data = simple(form, points, triangles)
    head = data.index(b"end_header\n") + len(b"end_header\n")
    first = head + 12 * 6
    cases = [
        (data[:-1], f"byte {first + 7 * 13}: the file ends in the element face: 7 of 8 rows are there"),
        (
            data[: first - 1],
            f"byte {head + 5 * 12}: the file ends in the element vertex: 5 of 6 rows are there",
        ),
        (
            data[:first] + b"\xff" + data[first + 1 :],
            f"byte {first}: the file ends in the element face: 0 of 8 rows",
        ),
        (data[:head], f"byte {head}: the file ends in the element vertex: 0 of 6"),
    ]
    order = FORMS[form]
    wrong = np.array(6, order + "i4").tobytes()
    cases.append(
        (data[: first + 18] + wrong + data[first + 22 :], f"byte {first + 18}: a face refers to vertex 6")
    )
    bad = np.array(np.inf, order + "f4").tobytes()
    cases.append(
        (data[: head + 28] + bad + data[head + 32 :], f"byte {head + 24}: in the vertices, the y coord")
    )
    for broken, words in cases:
        with pytest.raises(MeshReadError, match=rf"^x\.ply, {words}"):
            read_reference_bytes(broken, "x.ply")
    with pytest.raises(MeshReadError, match="element vertex: 14 of 999999999999 rows are there"):
        read_reference_bytes(data.replace(b"vertex 6", b"vertex 999999999999"), "x.ply")


@pytest.mark.parametrize("form", FORMS)
def test_many_rows_without_walking_them(form: str) -> None:
    points, triangles = ball(5)
    faces = [face[: 3 + number % 2] for number, face in enumerate(triangles[:, [0, 1, 2, 2]].tolist())]
    data = simple(form, points, faces)
    lines, found = lines_of_core(lambda: read_reference_bytes(data, "x.ply"))
    assert found.count == len(triangles) and found.closed
    assert lines < 5_000
