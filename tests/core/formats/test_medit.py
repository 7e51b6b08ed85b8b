"""SPEC R1: `.mesh`, after Medit's and libMeshb's documentation, and against files of Gmsh and meshio."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from hexalab.formats.medit_keywords import SKIPPED
from hexalab.formats.text import PIECE
from tests.core.formats.samples import HEXAHEDRON, Sample, check, grid, mixed

CUBE = """MeshVersionFormatted 2
Dimension 3
Vertices
8
0 0 0 0
1 0 0 0
1 1 0 0
0 1 0 0
0 0 1 0
1 0 1 0
1 1 1 0
0 1 1 0
Hexahedra
1
1 2 3 4 5 6 7 8 0
End
"""
UNIT_CUBE = Sample(
    np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=float),
    [(HEXAHEDRON, list(range(8)))],
)
FROM_VTK = ((0, 1, 2, 3, 4, 5, 6, 7), (0, 2, 1, 3, 5, 4), (0, 1, 2, 3, 4), (0, 1, 2, 3))
SECTIONS = ("Hexahedra", "Prisms", "Pyramids", "Tetrahedra")


def text_of(sample: Sample, references: bool = True, newline: str = "\n") -> str:
    """The sample as a `.mesh` file; its own way to write, apart from the project's."""
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(sample.points))]
    lines += [" ".join(map(repr, map(float, p))) + (" 0" if references else "") for p in sample.points]
    for kind, keyword in enumerate(SECTIONS):
        rows = sample.rows_of(kind)[:, list(FROM_VTK[kind])]
        lines += [keyword, str(len(rows))]
        lines += [" ".join(str(i + 1) for i in row) + (" 0" if references else "") for row in rows]
    return newline.join([*lines, "End", ""])


@pytest.mark.parametrize("references", [True, False])
def test_R1_all_kinds_with_and_without_references(references: bool) -> None:
    check(read_bytes(text_of(mixed(), references).encode(), "x.mesh"), mixed().grouped())


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s.upper(),
        lambda s: s.lower(),
        lambda s: s.replace("\n", "\r\n"),
        lambda s: s.replace("\n", "\r"),
        lambda s: s.replace("\n", " "),
        lambda s: s.replace(" ", "\n"),
        lambda s: s.replace(" ", "\t \t"),
        lambda s: "\ufeff" + s,
        lambda s: "\n \n" + s,
        lambda s: s.replace("Dimension 3", "Dimension\n3"),
        lambda s: s.replace("Dimension 3\n", ""),
        lambda s: s.replace("Version", "VERSION").replace("2\nD", "4\nD"),
        lambda s: s.replace("End\n", "END"),
        lambda s: s + "anything at all after the end",
        lambda s: "# a comment with Vertices 9\n" + s,
        lambda s: s.replace("Vertices\n", "Vertices # how many: 7\n#0 0 0\n"),
        lambda s: s.replace("1 1 0 0\n", "1 1 0 0 # corner 3\n"),
        lambda s: s.replace("1 1 0 0\n", "1 1 0 0#\n"),
        lambda s: s.replace("1 0 0 0", "1.0 -0 0.0 0").replace("1 1 1 0", "+1 1e0 .1E+1 0"),
        lambda s: s.replace("1 0 0 0", "1D0 0.d+0 0.0D-3 0"),
        lambda s: s.replace("Hexahedra", "Hexaedra"),
        lambda s: s.replace("Hexahedra", "Triangles\n2\n1 2 3 0\n1 2 4 0\nHexahedra"),
        lambda s: s.replace("Hexahedra", "Tetrahedra\n0\nHexahedra"),
        lambda s: s.replace("Vertices", "Normals 2 0 0 1 1e-3 0 0\nTangents\n1\n1 0 0\nVertices"),
        lambda s: s.replace("Vertices", "BoundingBox 0 1 0 1 0 1\nVertices"),
        lambda s: s.replace("Hexahedra", "Ridges\n0\nCorners 1 4\nRequiredVertices\n2\n1\n2\nHexahedra"),
        lambda s: s.replace("Hexahedra", "VertexOnGeometricEdge\n1\n1 2 0.5\nHexahedra"),
    ],
)
def test_R1_spellings_of_the_same_file(change) -> None:
    check(read_bytes(change(CUBE).encode(), "x.mesh"), UNIT_CUBE)


def test_R1_every_keyword_of_the_format_is_known() -> None:
    for keyword in sorted(SKIPPED):
        mesh = read_bytes(CUBE.replace("Hexahedra", f"{keyword}\n1\n1 2 3\nHexahedra").encode(), "x.mesh")
        check(mesh, UNIT_CUBE)
        assert mesh.notes == []


def test_R1_sections_in_any_order() -> None:
    head, rest = CUBE.split("Vertices")
    vertices, cells = rest.split("Hexahedra")
    text = f"{head}Hexahedra{cells.replace('End', '')}Vertices{vertices}End"
    check(read_bytes(text.encode(), "x.mesh"), UNIT_CUBE)


def test_R1_unknown_section_and_missing_end_are_noted() -> None:
    text = CUBE.replace("Hexahedra", "Flavours\n2\n1 2\nHexahedra").replace("End\n", "")
    mesh = read_bytes(text.encode(), "x.mesh")
    check(mesh, UNIT_CUBE)
    assert "Flavours" in mesh.notes[0] and "End" in mesh.notes[1]


def test_R1_references_become_an_attribute() -> None:
    text = CUBE.replace("1 2 3 4 5 6 7 8 0", "1 2 3 4 5 6 7 8 42").replace("1 1 1 0", "1 1 1 -3")
    mesh = read_bytes(text.encode(), "x.mesh")
    assert mesh.cell_data["reference"].tolist() == [42]
    assert mesh.point_data["reference"].tolist() == [0, 0, 0, 0, 0, 0, -3, 0]


def test_R1_one_number_on_a_line_with_and_without_references() -> None:
    sample = grid(2, 3, 1)
    for references in (True, False):
        check(read_bytes(text_of(sample, references).replace(" ", "\n").encode(), "x.mesh"), sample)


def test_R1_longer_than_one_piece() -> None:
    sample = grid(21, 20, 19)
    data = text_of(sample).encode()
    assert len(data) > 3 * PIECE
    check(read_bytes(data, "x.mesh"), sample)
    check(read_bytes(data.replace(b"\n", b" "), "x.mesh"), sample)


def test_R1_higher_order_cells_keep_their_corners() -> None:
    row = "1 2 3 4 5 6 7 8" + " 1" * 19
    text = CUBE.replace("Hexahedra\n1\n1 2 3 4 5 6 7 8 0", f"HexahedraQ2\n1\n{row} 0")
    mesh = read_bytes(text.encode(), "x.mesh")
    check(mesh, UNIT_CUBE)
    assert "higher order" in mesh.notes[0]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("1 2 3 4 5 6 7 8 0", "1 2 3 4 5 6 7 9 0", ["line 15", "vertex 9", "expected 1 to 8"]),
        ("1 2 3 4 5 6 7 8 0", "0 2 3 4 5 6 7 8 0", ["line 15", "vertex 0"]),
        ("1 2 3 4 5 6 7 8 0", "1 2 3 4 5 6 7 99999999999999999999 0", ["line 15", "vertex"]),
        ("1 2 3 4 5 6 7 8 0", "1 2 3 4 5 6 7 0x8 0", ["line 15", "‘0x8’", "Hexahedra, which should be 9"]),
        ("1 2 3 4 5 6 7 8 0", "1 2 3 4 5 6 7", ["line 16", "‘End’", "number 8"]),
        ("1 2 3 4 5 6 7 8 0", "1 2 3 4 5 6 7 8 0 1", ["line 15", "‘1’", "keyword"]),
        ("1 2 3 4 5 6 7 8 0", "1 2 3 4 5 6 7 8 0\n1 2 3 4 5 6 7 8 0", ["line 16", "more numbers"]),
        ("1 1 0 0", "1 1 zero 0", ["line 7", "‘zero’", "Vertices"]),
        ("1 1 0 0", "1 1 inf 0", ["line 7", "z coordinate of vertex 3 is inf"]),
        ("1 1 0 0", "1 1 NaN 0", ["line 7", "nan"]),
        ("1 1 0 0", "1 1 1e999 0", ["line 7", "inf"]),
        ("1 1 0 0", "1 1,0 0", ["line 7", "‘1,0’"]),
        ("Vertices\n8", "Vertices\n9", ["line 13", "‘Hexahedra’", "should be 36 numbers"]),
        ("Vertices\n8", "Vertices\n-8", ["line 4", "-8"]),
        ("Vertices\n8", "Vertices\n8000000000", ["line 4", "8000000000 vertices", "bytes"]),
        ("Vertices\n8", "Vertices\n8.5", ["line 4", "‘8.5’"]),
        ("Vertices\n8", "Vertices\n" + "8" * 5000, ["line 4", "whole number"]),
        ("Dimension 3", "Dimension 2", ["line 2", "expected 3"]),
        ("Hexahedra\n1\n1 2 3 4 5 6 7 8 0\n", "", ["no cells"]),
        ("Hexahedra\n1\n1 2 3 4 5 6 7 8 0\n", "Quads\n1\n1 2 3 4 0\n", ["no volumetric cells", "quadrilaterals (1)"]),
        ("Hexahedra", "Vertices\n1\n0 0 0 0\nHexahedra", ["second section Vertices"]),
    ],
)  # fmt: skip
def test_R10_bad_files(old: str, new: str, words: list[str]) -> None:
    assert old in CUBE
    with pytest.raises(MeshReadError) as caught:
        read_bytes(CUBE.replace(old, new, 1).encode(), "bad.mesh")
    assert str(caught.value).startswith("bad.mesh") and "\n" not in str(caught.value)
    for word in words:
        assert word in str(caught.value)


def test_R10_every_prefix_is_an_error_or_the_whole_mesh() -> None:
    for length in range(len(CUBE)):
        try:
            mesh = read_bytes(CUBE[:length].encode(), "x.mesh")
        except MeshReadError as error:
            assert error.file == "x.mesh"
        else:
            check(mesh, UNIT_CUBE)
            assert length >= CUBE.index(" 8 0") + 2


def test_R10_the_guilty_line_deep_in_a_file() -> None:
    data = text_of(grid(21, 20, 19))
    lines = data.split("\n")
    for number in (5000, 9000, len(lines) - 10):
        broken = [*lines[:number], "1 2 spam", *lines[number + 1 :]]
        with pytest.raises(MeshReadError, match="spam") as caught:
            read_bytes("\n".join(broken).encode(), "x.mesh")
        assert caught.value.line == number + 1
        broken[number] = " ".join([*lines[number].split()[:-2], "777777", "0"])
        if number > 9300:
            with pytest.raises(MeshReadError, match="vertex 777777") as caught:
                read_bytes("\n".join(broken).encode(), "x.mesh")
            assert caught.value.line == number + 1
