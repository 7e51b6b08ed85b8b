"""OFF against what meshio and VTK write and read, and with the traps of real files."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.reference import read_reference_bytes
from tests.core.reference.surfaces import CUBE, CUBE_QUADS, assert_same, ball, by_meshio, meshio
from tests.counting import lines_of_core

POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
TRIANGLES = [[0, 2, 1], [0, 1, 3]]
V = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
F = "3 0 2 1\n3 0 1 3\n"


def off(text: str, name: str = "x.off") -> object:
    return read_reference_bytes(text.encode(), name)


def test_what_meshio_writes_and_reads(tmp_path: object) -> None:
    points, triangles = ball()
    data = by_meshio(points, [("triangle", triangles)], "off")
    found = read_reference_bytes(data, "x.off")
    assert_same(found, points[triangles])
    (tmp_path / "x.off").write_bytes(data)  # type: ignore[operator]
    other = meshio.read(tmp_path / "x.off")  # type: ignore[operator]
    assert np.array_equal(found.points.T, other.points) and found.closed and found.format == "off"
    assert np.array_equal(found.triangles.T, other.cells_dict["triangle"])


@pytest.mark.parametrize(
    "text",
    [
        "OFF\n4 2 0\n" + V + F,
        "OFF 4 2 0\n" + V + F,
        "OFF4 2 0\n" + V + F,
        "OFF\n4 2\n" + V + F,
        "# made by a test\n\nOFF # or so\n# more\n4 2 5 # V F E\n\n# vertices\n" + V + "#\n\n" + F,
        "4 2 0\n" + V + F,
        "\ufeffOFF\n4 2 0\n" + V + F,
        "off\n4 2 0\n" + V + F,
        "COFF\n4 2 0\n" + V.replace("\n", " 255 0 0 255\n") + F,
        "COFF\n4 2 0\n" + V.replace("\n", " 0.5 0.5 1\n") + F.replace("\n", " 0.25 0.5 1.0\n"),
        "NOFF\n4 2 0\n" + V.replace("\n", " 0 0 1\n") + F,
        "CNOFF\n4 2 0\n" + V.replace("\n", " 0 0 1 9 9 9 9\n") + F,
        "NCOFF\n4 2 0\n" + V.replace("\n", " 0 0 1 9 9 9 9\n") + F,
        "STCNOFF\n4 2 0\n" + V.replace("\n", " 0 0 1 9 9 9 9 1 1\n") + F,
        "OFF\n4 2 0\n" + V.replace("\n", " 1 2 3\n") + F.replace("\n", " 255 0 0\n"),
        "OFF\n4 2 0\n" + V + "3 0 2 1 7\n3 0 1 3 255 0 0.5 1\n",
        "OFF\r\n4 2 0\r\n" + (V + F).replace("\n", "\r\n"),
        "OFF\r4 2 0\r" + (V + F).replace("\n", "\r"),
        "OFF\n4 2 0\n" + V + F + "what follows is left out\n",
        "OFF\n4 2 0\n" + V + F.rstrip(),
        "OFF 4 2 0 " + (V + F).replace("\n", " "),
        "OFF\n4 2 0\n0 0 0 1 0 0\n0 1 0 0 0\n1\n3 0 2\n1 3 0 1 3",
        "COFF 4 2 0 " + (V.replace("\n", " 1 2 3 4 ") + F).replace("\n", " "),
    ],
)
def test_all_forms(text: str) -> None:
    assert_same(off(text), POINTS[TRIANGLES])  # type: ignore[arg-type]


def test_polygons_and_what_is_none() -> None:
    text = "OFF\n8 8 0\n" + "\n".join(" ".join(map(str, point)) for point in CUBE.tolist()) + "\n"
    rows = ["4 " + " ".join(map(str, quad)) for quad in CUBE_QUADS.tolist()]
    found = off("\n".join([text + rows[0], "2 0 1", *rows[1:], "1 5"]))
    assert found.closed and found.volume == pytest.approx(1, rel=1e-14)  # type: ignore[attr-defined]
    assert found.notes == ("Left out, as they have less than three corners: faces (2).",)  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("OFF BINARY\n\0\0\0", ", line 1: this OFF file is binary: only OFF in text can be read"),
        ("4OFF\n4 2 0\n", ", line 1: this is ‘4OFF’, whose points have not three coordinates"),
        ("nOFF\n3\n4 2 0\n", ", line 1: this is ‘nOFF’, whose points have not three coordinates"),
        ("OFT\n4 2 0\n", ", line 1: ‘OFT’ stands where OFF was expected"),
        ("OFF\n4 two 0\n" + V + F, ", line 2: ‘two’ stands where the number of faces was expected"),
        ("OFF\n4000 2 0\n" + V + F, ", line 2: 4000 vertices are announced, but the file has only"),
        ("OFF\n-4 2 0\n" + V + F, ", line 2: the number of vertices is -4"),
        ("OFF\n4 2 0\n" + V + "3 0 2 1\n", ", line 7: .*the faces.*"),
        ("OFF\n4 2 0\n" + V + "3 0 2 1\n3 0 1", ", line 8: a face announces 3 corners, which are not there"),
        ("OFF\n4 2 0\n" + V + F.replace("3 0 1", "-3 0 1"), ", line 8: a face announces -3 corners"),
        ("OFF\n4 2 0\n" + V + F.replace("1 3\n", "1 4\n"), ", line 8: a face refers to vertex 4, which is not there: "
         "expected 0 to 3"),
        ("OFF\n4 2 0\n" + V + F.replace("1 3\n", "1 -1\n"), ", line 8: a face refers to vertex -1"),
        ("OFF\n4 2 0\n" + V + F.replace("1 3\n", "1 2.5\n"), ", line 8: a face refers to a number that is none"),
        ("OFF\n4 2 0\n" + V + F.replace("1 3\n", "1 x\n"), ", line 8: ‘x’ stands where a number was expected"),
        ("OFF\n4 2 0\n" + V.replace("0 1 0", "0 1") + F, ", line 5: a vertex has 2 numbers, expected x, y and z"),
        ("OFF\n4 2 0\n" + V.replace("0 1 0", "0 y 0") + F, ", line 5: ‘y’ stands where a number was expected"),
        ("OFF\n4 2 0\n" + V.replace("0 1 0", "0 inf 0") + F, ", line 5: in the vertices, the y coordinate of vertex 3"),
        ("OFF\n4 0 0\n" + V, ": the file has no faces, expected a surface"),
        ("OFF 4 2 0 " + (V + F).replace("\n", " ").replace("3 0 1 3 ", "3 0 1 9 "), ", line 1: a face refers to ver"),
        ("OFF 4 2 0 " + V.replace("\n", " ").replace("1 ", "inf ", 1) + F.replace("\n", " "), ", line 1: in the vert"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named(text: str, words: str) -> None:
    with pytest.raises(MeshReadError, match=rf"^x\.off{words}"):
        off(text)


def test_many_lines_in_blocks_without_walking_them() -> None:
    points, triangles = ball(5)
    rows = ["{!r} {!r} {!r}".format(*point) for point in points.tolist()]
    faces = [
        f"3 {a} {b} {c}" + " 9 9.5 9" * (number % 2) for number, (a, b, c) in enumerate(triangles.tolist())
    ]
    text = "\n".join([f"OFF\n{len(rows)} {len(faces)} 0", *rows, *faces])
    assert len(text) > 1 << 18
    lines, found = lines_of_core(lambda: off(text))
    assert_same(found, points[triangles])
    assert lines < 5_000
    bad = text.replace(faces[-9], faces[-9].replace(" 9.5", " 9.5.5"))
    line = 2 + len(rows) + len(faces) - 8
    with (
        pytest.raises(MeshReadError, match=rf"line {line}: ‘9.5.5’")
        if bad != text
        else pytest.raises(MeshReadError)
    ):
        off(bad)
