"""OBJ against what VTK and meshio write and read, and with the traps of real files."""

from __future__ import annotations

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

POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
V = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
TRIANGLES = [[0, 2, 1], [0, 1, 3]]


def obj(text: str, name: str = "x.obj") -> object:
    return read_reference_bytes(text.encode(), name)


def test_what_vtk_writes() -> None:
    points, triangles = ball()
    data = written(vtk.vtkOBJWriter(), poly_data(points, *triangles))
    found = read_reference_bytes(data, "x.obj")
    assert_same(found, found_by_vtk(vtk.vtkOBJReader(), data))
    assert found.count == len(triangles) and found.closed and found.format == "obj"
    assert np.allclose(found.points.T, points, rtol=0, atol=1e-6)


def test_what_meshio_writes() -> None:
    points, triangles = ball(1)
    found = read_reference_bytes(by_meshio(points, [("triangle", triangles)], "obj"), "x.obj")
    assert_same(found, points[triangles])
    quads = read_reference_bytes(by_meshio(CUBE, [("quad", CUBE_QUADS)], "obj"), "x.obj")
    assert quads.count == 12 and quads.closed and quads.volume == pytest.approx(1, rel=1e-14)


@pytest.mark.parametrize(
    "faces",
    [
        "f 1 3 2\nf 1 2 4\n",
        "f 1/1 3/2 2/3\nf 1/1 2/2 4/3\n",
        "f 1//1 3//2 2//3\nf 1//1 2//2 4//3\n",
        "f 1/1/1 3/2/9 2/3/9\nf 1/5/5 2/99/9 4/3/-1\n",
        "f 1/1/1 3//9 2\nf 1/ 2/99 4/3/\n",
        "f -4 -2 -3\nf -4 -3 -1\n",
        "f -4/-1 -2/-2 -3/-1\nf 1 -3 4\n",
        "f 1 3 \\\n2\nf 1 \\ \r\n 2 \\\n 4\n",
        "f 1 3 2 # the bottom \\\nf 1 2 4#x\n",
        "g a\ns off\nusemtl f 1 2 3\nf 1 3 2\no v 1 2 3\nl 1 2\np 1\nfo 1 2 3\nf 1 2 4\nvp 1 2\n",
        "\tf\t1  3   2  \n\n   f 1 2 4",
        "F 1 3 2\nf 1 2 4\n",
    ],
)
@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
def test_faces_in_all_forms(faces: str, newline: str) -> None:
    if newline == "\r" and "\r" in faces:
        faces = faces.replace("\r", "")
    text = (V + faces).replace("\r\n", "\n").replace("\n", newline)
    assert_same(obj(text), POINTS[TRIANGLES])  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "vertices",
    [
        V.replace("\n", " 1.0\n"),
        V.replace("\n", " 0.5 0.25 1\n"),
        "mtllib a.mtl\n# made by a test\n\n" + V.replace("\n", "\nvn 0 0 1\nvt 0.5 0.5\n"),
        V.replace("v 1 0 0\n", "v +1.e0 -0. .0 0.5 0.5 0.5\n"),
        "\ufeff" + V,
        V.replace("1", "1d0"),
        "  " + V.replace("v ", "\tv\t "),
    ],
)
def test_vertices_in_all_forms(vertices: str) -> None:
    for name in ("x.obj", "without an ending"):
        if vertices[0] == " " and name != "x.obj":
            continue
        assert_same(obj(vertices + "f 1 3 2\nf 1 2 4\n", "x.obj"), POINTS[TRIANGLES])  # type: ignore[arg-type]


def test_faces_before_their_vertices_and_counted_back_among_them() -> None:
    found = obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -1 -2 -3\nf -4 -1 -2\n")
    rows = [[0, 1, 2], [0, 1, 2], [3, 2, 1], [0, 3, 2]]
    assert_same(found, POINTS[rows])  # type: ignore[arg-type]


def test_polygons_of_any_number_of_corners() -> None:
    angles = 2 * np.pi * np.arange(12) / 12
    ring = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)
    faces = [range(12), range(0, 12, 3), range(0, 12, 4), range(5), (0, 6), (3,), range(0, 12, 2)]
    text = "".join("v {!r} {!r} {!r}\n".format(*point) for point in ring.tolist())
    text += "".join("f " + " ".join(str(one + 1) for one in face) + "\n" for face in faces)
    found = obj(text)
    ids = np.concatenate([np.array(face) for face in faces if len(face) > 2])
    sizes = np.array([len(face) for face in faces if len(face) > 2])
    expected = triangles_of(ring.T, ids, np.cumsum(sizes) - sizes, sizes)
    assert_same(found, ring[expected.T])  # type: ignore[arg-type]
    assert found.notes == (  # type: ignore[attr-defined]
        "Left out, as they have less than three corners: faces (2).",
        "Faces of more than four corners (3) were cut into triangles as fans from their first corners: of one that is "
        "not convex, triangles may lie outside of it.",
    )


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("v 0 1 0", "v 0 one 0", "line 3: ‘one’ stands where a number was expected, in a vertex"),
        ("v 0 1 0", "v 0 1", "line 3: a vertex has 2 numbers, expected x, y and z"),
        ("v 0 1 0", "v 0 nan 0", "line 3: in the vertices, the y coordinate of vertex 3 is nan"),
        ("f 1 2 4", "f 1 2 5", "line 6: a face refers to vertex 5, which is not there: expected 1 to 4"),
        ("f 1 2 4", "f 1 2 0", "line 6: a face refers to vertex 0, expected a number from 1 on or -1 to -4"),
        (
            "f 1 2 4",
            "f 1 2 -5",
            "line 6: a face refers to vertex -5, expected a number from 1 on or -1 to -4",
        ),
        (
            "f 1 2 4",
            "f 1 2 99999999999999999999",
            "line 6: a face refers to a number that is none, which is not",
        ),
        ("f 1 2 4", "f 1 2/x 4.5/2", "line 6: ‘4.5/2’ stands where a whole number was expected, in a face"),
        ("f 1 2 4", "f 1 /2 4", "line 6: ‘/2’ stands where a whole number was expected"),
        ("f 1 2 4", "f 1-2 4", "line 6: ‘1-2’ stands where a whole number was expected"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(old: str, new: str, words: str) -> None:
    text = (V + "f 1 3 2\nf 1 2 4\n").replace(old, new)
    with pytest.raises(MeshReadError, match=rf"^x\.obj, {words}"):
        obj(text)


def test_a_face_counted_back_before_there_is_a_vertex() -> None:
    with pytest.raises(
        MeshReadError, match=r"line 1: a face refers to vertex -1, expected a number from 1 on$"
    ):
        obj("f -1 -2 -3\n" + V)


def test_no_faces() -> None:
    for text in (V, V + "l 1 2\n", V + "f 1 1 2\n"):
        with pytest.raises(MeshReadError, match="the file has no faces, expected a surface"):
            obj(text)


def test_many_lines_in_blocks_without_walking_them() -> None:
    """Vertices and faces in turn, with normals between them, in several blocks."""
    points, triangles = ball(5)
    text = []
    for number, triangle in enumerate(triangles.tolist()):
        if number < len(points):
            text.append("v {!r} {!r} {!r}\nvn 0 0 1".format(*points[number].tolist()))
        first = min(number + 1, len(points))
        a, b, c = triangle
        text.append(f"f {a + 1}/1 {b - first}//2 {c + 1}" if b < first else f"f {a + 1} {b + 1} {c + 1}/7/7")
    data = "\n".join(text).encode()
    assert len(data) > 1 << 18
    lines, found = lines_of_core(lambda: read_reference_bytes(data, "x.obj"))
    assert_same(found, points[triangles])
    assert lines < 5_000
