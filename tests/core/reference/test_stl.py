"""STL in text and binary, against what VTK and meshio write and read, and with the traps of real files."""

from __future__ import annotations

import struct

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.reference import read_reference_bytes
from hexalab.reference.welding import slots_of, welded
from tests.core.reference.surfaces import (
    assert_same,
    ball,
    by_meshio,
    found_by_vtk,
    poly_data,
    vtk,
    written,
)

TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]


def in_text(*facets: object, name: str = "x", end: bool = True) -> str:
    lines = [f"solid {name}"]
    for facet in facets:
        lines += ["  facet normal 0 0 1", "    outer loop"]
        lines += ["      vertex " + " ".join(map(repr, map(float, corner))) for corner in facet]  # type: ignore[attr-defined]
        lines += ["    endloop", "  endfacet"]
    return "\n".join([*lines, *([f"endsolid {name}"] if end else []), ""])


def binary(*facets: object, header: bytes = b"") -> bytes:
    out = header.ljust(80) + struct.pack("<I", len(facets))
    for facet in facets:
        out += struct.pack("<12fH", 0, 0, 1, *np.ravel(facet), 7)  # type: ignore[arg-type]
    return out


@pytest.mark.parametrize("mode", ["SetFileTypeToASCII", "SetFileTypeToBinary"])
def test_what_vtk_writes(mode: str) -> None:
    points, triangles = ball()
    data = written(vtk.vtkSTLWriter(), poly_data(points, *triangles), **{mode: None})
    found = read_reference_bytes(data, "x.stl")
    assert_same(found, points[triangles])
    assert_same(found, found_by_vtk(vtk.vtkSTLReader(), data))
    assert found.points.shape[1] == len(points) and found.closed
    assert (found.format, found.name, found.notes) == ("stl", "x.stl", ())


@pytest.mark.parametrize("binary", [False, True])
def test_what_meshio_writes(binary: bool) -> None:
    points, triangles = ball(1)
    found = read_reference_bytes(by_meshio(points, [("triangle", triangles)], "stl", binary=binary), "x.stl")
    assert_same(found, points[triangles])
    assert found.closed


@pytest.mark.parametrize(
    "header", [b"solid", b"solid facet normal 0 0 1", b"SOLID \0\0", b"", b"COLOR=\xff\1\2\3"]
)
@pytest.mark.parametrize("name", ["x.stl", "X.STL", "x", "x.bin"])
def test_binary_is_told_by_its_size_and_not_by_its_first_word(header: bytes, name: str) -> None:
    found = read_reference_bytes(binary(*TETRAHEDRON[FACES], header=header), name)
    assert_same(found, TETRAHEDRON[FACES])
    assert found.closed and found.volume == pytest.approx(1 / 6, rel=1e-14)


def test_binary_with_bytes_after_the_last_triangle() -> None:
    found = read_reference_bytes(binary(*TETRAHEDRON[FACES]) + b"more", "x.stl")
    assert found.count == 4 and found.notes == ("What follows the last triangle was left out: 4 bytes.",)


@pytest.mark.parametrize("header", [b"", b"solid x"])
def test_binary_cut_short_names_bytes_found_and_expected(header: bytes) -> None:
    data = binary(*TETRAHEDRON[FACES], header=header)
    words = r"x\.stl, byte 80: 4 triangles are announced, which take 284 bytes .* the file has 283"
    with pytest.raises(MeshReadError, match=words):
        read_reference_bytes(data[:-1], "x.stl")


def test_binary_shorter_than_its_head() -> None:
    with pytest.raises(MeshReadError, match="the file has 50 bytes, expected the 84"):
        read_reference_bytes(b"\1" * 50, "x.stl")


def test_a_number_of_triangles_that_lies_allocates_nothing() -> None:
    data = b"\0" * 80 + b"\xff\xff\xff\xff" + b"\1" * 100
    with pytest.raises(MeshReadError, match="4294967295 triangles are announced"):
        read_reference_bytes(data, "x.stl")


def test_several_solids_in_one_file() -> None:
    text = in_text(*TETRAHEDRON[FACES[:2]], name="one") + in_text(
        *TETRAHEDRON[FACES[2:]], name="two vertex 1"
    )
    found = read_reference_bytes(text.encode(), "x.stl")
    assert_same(found, TETRAHEDRON[FACES])
    assert found.closed and found.points.shape[1] == 4


def spelled(text: str) -> list[bytes]:
    return [
        text.encode(),
        text.upper().encode(),
        text.replace("\n", "\r\n").encode(),
        text.replace("\n", "\r").encode(),
        text.replace("    ", "\t").replace("\n", " \n\n").encode(),
        b"\xef\xbb\xbf\n" + text.encode(),
        text.replace("1.0", "+1.0E+00").replace("0.0", "-0.e-3").encode(),
        text.replace("1.0", "1d0").replace("0.0", ".0").encode(),
        text.replace("normal 0 0 1", "normal nan nan -1.#IND").encode(),
        text.replace("  facet normal 0 0 1\n", "facet\n").encode(),
        text.replace("endsolid x", "end solid").encode(),
        text.replace("solid x", "solid").encode(),
        text.replace("solid x", "solid " + "é" * 3000).encode(),
    ]


@pytest.mark.parametrize("number", range(13))
def test_spellings(number: int) -> None:
    found = read_reference_bytes(spelled(in_text(*TETRAHEDRON[FACES]))[number], "x.stl")
    assert_same(found, TETRAHEDRON[FACES])
    assert found.points.shape[1] == 4 and found.notes == ()


def test_zero_is_zero_whatever_its_sign() -> None:
    facets = [[[0.0, 0, 0], [1, -0.0, 0], [0, 1, 0]], [[-0.0, -0.0, 0], [0, 1, 0], [-1, -0.0, 0]]]
    for data in (binary(*facets), in_text(*facets).encode()):
        found = read_reference_bytes(data, "x.stl")
        assert found.points.shape[1] == 4
        assert not np.signbit(found.points[found.points == 0]).any()


def test_triangles_whose_corners_are_one_are_left_out() -> None:
    facets = [TETRAHEDRON[[0, 1, 1]], *TETRAHEDRON[FACES], TETRAHEDRON[[2, 2, 2]]]
    for data in (binary(*facets), in_text(*facets).encode()):
        found = read_reference_bytes(data, "x.stl")
        assert_same(found, TETRAHEDRON[FACES])
        assert found.notes == ("Left out, as they have a vertex twice: triangles (2).",)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("1.0 0.0 0.0", "1.0 zero 0.0", "line 6: ‘zero’ stands where a number was expected, in a vertex"),
        ("1.0 0.0 0.0", "1.0 0.0-1.0 0", "line 6: ‘0.0-1.0’ stands"),
        ("1.0 0.0 0.0", "1.0 0.0", "line 6: a vertex has 2 numbers, expected 3"),
        ("1.0 0.0 0.0", "1.0 0.0 0 1", "line 6: a vertex has 4 numbers, expected 3"),
        ("1.0 0.0 0.0", "1.0 nan 0.0", "line 6: in the corners, the y coordinate of vertex 3 is nan"),
        ("1.0 0.0 0.0", "1e999 0 0.0", "line 6: in the corners, the x coordinate of vertex 3 is inf"),
        (
            "      vertex 1.0 0.0 0.0\n",
            "",
            "line 8: a facet begins here, and the one before it has 2 vertices",
        ),
        (
            "    endloop\n",
            "      vertex 0 0 1\n",
            "line 9: a facet begins here, and the one before it has 4 ",
        ),
    ],
)
def test_facets_that_are_wrong(old: str, new: str, words: str) -> None:
    text = in_text(*TETRAHEDRON[FACES]).replace(old, new, 1)
    with pytest.raises(MeshReadError, match=rf"x\.stl, {words}".replace("(", r"\(")):
        read_reference_bytes(text.encode(), "x.stl")


def test_a_file_that_ends_in_a_facet_or_without_endsolid() -> None:
    text = in_text(*TETRAHEDRON[FACES])
    for ending, have in (
        (".0\n    endloop", 3),
        ("\n    endloop", 3),
        ("\n      vertex 0.0 0.0 1.0\n    endloop", 2),
        ("\n    outer", 0),
    ):
        cut = text[: text.rindex(ending)]
        with pytest.raises(
            MeshReadError, match=rf"line 2\d: the file ends in facet 4, of which {have} vertices"
        ):
            read_reference_bytes(cut.encode(), "x.stl")
    with pytest.raises(MeshReadError, match=r"line 27: a vertex has 2 numbers, expected 3"):
        read_reference_bytes(text[: text.rindex("1.0\n    endloop")].encode(), "x.stl")
    found = read_reference_bytes(text[: text.rindex("endsolid")].encode(), "x.stl")
    assert found.notes == ("The file does not end with endsolid: it may be cut short.",)
    assert_same(found, TETRAHEDRON[FACES])


def test_no_triangles() -> None:
    for data in (in_text().encode(), binary(header=b"x")):
        with pytest.raises(MeshReadError, match="the file has no triangles, expected a surface"):
            read_reference_bytes(data, "x.stl")


def test_many_blocks_of_text() -> None:
    random = np.random.default_rng(1)
    points, triangles = (
        random.normal(size=(500, 3)),
        random.permuted(np.tile(np.arange(500), (4000, 1)), axis=1),
    )
    text = in_text(*points[triangles[:, :3]])
    assert len(text) > 3 * (1 << 18)
    found = read_reference_bytes(text.encode(), "x.stl")
    assert_same(found, points[triangles[:, :3]])
    assert found.points.shape[1] == 500
    bad = text.encode()
    at = bad.rindex(b"vertex", 0, -100_000)
    line = bad.count(b"\n", 0, at) + 1
    with pytest.raises(MeshReadError, match=rf"line {line}: ‘oops’"):
        read_reference_bytes(bad[:at] + b"vertex oops 1 2 \n#" + bad[at:], "x.stl")


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_welding_against_a_dictionary(dtype: type) -> None:
    random = np.random.default_rng(2)
    for places, count in ((1, 50), (7, 1000), (5000, 5000), (10**6, 3000)):
        points = (random.integers(0, places, (count, 3)) * 0.25).astype(dtype)
        first, ids = welded([points[:, axis].copy() for axis in range(3)])
        known: dict[tuple[float, ...], int] = {}
        expected = [known.setdefault(tuple(point), len(known)) for point in points.tolist()]
        assert ids.tolist() == expected
        assert points[first].tolist() == [list(point) for point in known]


def test_points_that_collide_in_all_rounds_are_sorted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "hexalab.reference.welding.slots_of", lambda keys, step, width: slots_of(keys, 0, width) * 0
    )
    axis = np.arange(40.0) % 20
    first, ids = welded([axis, axis * 0, axis])
    assert first.tolist() == list(range(20)) and ids.tolist() == [*range(20), *range(20)]
