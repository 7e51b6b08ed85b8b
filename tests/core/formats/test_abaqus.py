"""SPEC R5: Abaqus and CalculiX `.inp`."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes
from tests.core.formats.gmsh_files import File, make
from tests.core.formats.samples import HEXAHEDRON, INP_CELLS, INP_NODES, Sample, check, grid, signed_volumes
from tests.tools import tool

meshio = tool("meshio")

UNIT_CUBE = Sample(
    np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=float),
    [(HEXAHEDRON, list(range(8)))],
)


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s,
        lambda s: s.lower(),
        lambda s: s.replace("\n", "\r\n"),
        lambda s: s.replace("*Node, NSET=all", "*NODE,\n NSET=all"),
        lambda s: s.replace("TYPE=C3D8R", " Type = C3D8R "),
        lambda s: s.replace("5 , 0. , 0. , 1.", "5, 0.E+0, 0.D0, 1.d+00"),
        lambda s: s.replace("*SOLID", "*NSET, NSET=few\n100, 20,\n3\n*SOLID"),
        *[
            lambda s, t=t: s.replace("C3D8R", t)
            for t in ("C3D8", "C3D8I", "C3D8H", "C3D8IH", "C3D8RT", "DC3D8", "SC8R")
        ],
    ],
)
def test_R5_spellings_of_the_same_file(change) -> None:
    mesh = read_bytes(change(INP_NODES + INP_CELLS).encode(), "x.inp")
    check(mesh, UNIT_CUBE)
    assert mesh.notes == []
    assert mesh.vertex_numbers.tolist() == [100, 20, 3, 4, 5, 6, 7, 8000]
    assert mesh.cell_numbers.tolist() == [11]


def test_R5_the_content_tells_the_format() -> None:
    assert read_bytes((INP_NODES + INP_CELLS).encode(), "noname").format == "inp"


def test_R5_mixed_elements_and_what_is_left_out() -> None:
    text = (
        INP_NODES
        + INP_CELLS
        + "*ELEMENT, TYPE=C3D4\n1, 100, 20, 3, 7\n*ELEMENT, TYPE=C3D6\n2, 100,20,3,5,6,7\n"
    )
    text += "*ELEMENT, TYPE=U4\n3, 100, 20, 3, 4\n4, 5, 6, 7, 8000\n*ELEMENT, TYPE=C3D10\n7" + ", 20" * 10
    mesh = read_bytes(text.encode(), "x.inp")
    assert mesh.kind_counts == {"hexahedron": 1, "tetrahedron": 2, "wedge": 1}
    assert (signed_volumes(mesh)[:3] > 0).all()
    assert "elements of type U4 (2)" in mesh.notes[1] and "higher order" in mesh.notes[0]


def test_R5_quadratic_hexahedra_over_two_lines() -> None:
    nodes = ", ".join(["100", "20", "3", "4", "5", "6", "7", "8000"] + ["3"] * 7)
    text = INP_NODES + f"*ELEMENT, TYPE=C3D20R\n1, {nodes},\n 4, 4, 4, 4, 4\n"
    mesh = read_bytes(text.encode(), "x.inp")
    check(mesh, UNIT_CUBE)
    assert "higher order" in mesh.notes[0]


def test_R5_parts_have_numbers_of_their_own() -> None:
    part = (INP_NODES + INP_CELLS).split("** a comment\n")[1].split("*SOLID")[0]
    text = f"*PART, NAME=a\n{part}*END PART\n*PART, NAME=b\n{part.replace('1.', '2.')}*END PART\n"
    mesh = read_bytes(text.encode(), "x.inp")
    assert mesh.vertex_count == 16
    assert mesh.cells.tolist() == [list(range(8)), list(range(8, 16))]
    assert mesh.notes[0] == "No part is instanced: parts are shown where they lie."


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("*NGEN\n1, 2, 1\n", "*NGEN makes nodes"),
        ("*ElGen, ELSET=all\n11, 2, 8, 1\n", "*ELGEN makes elements"),
        ("*SYSTEM\n1, 0, 0, 1, 0, 0\n", "*SYSTEM whose points span no system"),
    ],
)
def test_R5_what_is_not_followed_is_noted(line: str, words: str) -> None:
    mesh = read_bytes((INP_NODES + line + INP_CELLS).encode(), "x.inp")
    assert mesh.cell_count == 1
    assert [words in note for note in mesh.notes] == [True]


def test_R5_files_of_meshio_and_gmsh(tmp_path: Path) -> None:
    sample = grid(3, 2, 2)
    meshio.write(tmp_path / "m.inp", meshio.Mesh(sample.points, [("hexahedron", sample.rows_of(HEXAHEDRON))]))
    check(read(tmp_path / "m.inp"), sample, 1e-15)
    make(File(tmp_path / "g.inp"))
    mesh = read(tmp_path / "g.inp")
    assert set(mesh.kind_counts) == {"hexahedron", "wedge"}
    assert (signed_volumes(mesh) > 0).all()
    np.testing.assert_allclose(signed_volumes(mesh).sum(), 1.5, rtol=1e-9)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("11, 100, 20", "11, 100, 21", ["line 15", "element 11", "node 21"]),
        ("8000\n*SOLID", "\n*SOLID", ["line 15", "element 11 of type C3D8R has 7 nodes, expected 8"]),
        ("11, 100", "11, x", ["line 15", "‘x’"]),
        ("4,0,1,0", "4,0,one,0", ["line 8", "‘one’"]),
        ("4,0,1,0", "4,0,nan,0", ["line 8", "y coordinate", "nan"]),
        ("4,0,1,0", ",0,1,0", ["line 8", "begins with a comma"]),
        ("4,0,1,0", "4.5,0,1,0", ["line 8", "number 4.5", "not whole"]),
        ("*Node, NSET=all", "*Nodes", ["no *NODE"]),
        ("TYPE=C3D8R", "TYPE=U8", ["no volumetric cells", "U8"]),
        ("TYPE=C3D8R", "TYPE=S8R", ["no volumetric cells", "quadrilaterals (1)"]),
        ("TYPE=C3D8R", "KIND=C3D8R", ["no volumetric cells", "unknown"]),
    ],
)  # fmt: skip
def test_R10_bad_inp_files(old: str, new: str, words: list[str]) -> None:
    text = INP_NODES + INP_CELLS
    assert old in text
    with pytest.raises(MeshReadError) as caught:
        read_bytes(text.replace(old, new, 1).encode(), "bad.inp")
    for word in ["bad.inp", *words]:
        assert word in str(caught.value)
