"""SPEC R13: elements of lower dimension, as Gmsh, meshio and the formats' manuals say."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes, write_bytes
from hexalab.mesh import Mesh
from tests.core.formats.gmsh_files import File, make
from tests.core.formats.samples import grid, mixed
from tests.core.formats.test_groups import CELLS, HEADING, NODES, members, of_features
from tests.core.formats.vtk_files import insert, legacy, unstructured_grid
from tests.tools import tool

meshio = tool("meshio")
vtk = tool("vtk")


def test_R13_surfaces_of_elements() -> None:
    """Abaqus Elements Guide: face 1 of a hexahedron is 1-2-3-4, face 2 is 5-8-7-6, face 4 is 2-3-7-6."""
    text = (
        f"{NODES}{CELLS}*SURFACE, NAME=ends\n10, S1\n30, S2\n*SURFACE, NAME=side, TYPE=ELEMENT\nEALL, S4\n"
        "*SURFACE, NAME=skin\nEALL,\n*SURFACE, NAME=few, TYPE=NODE\n1,\n2,\n"
    )
    mesh = read_bytes((HEADING + text).encode(), "x.inp")
    found = of_features(mesh, 2)
    assert found["surface:ends"] == {frozenset((0, 1, 2, 3)), frozenset((12, 13, 14, 15))}
    assert found["surface:side"] == {
        frozenset((4 * n + 1, 4 * n + 3, 4 * n + 5, 4 * n + 7)) for n in range(3)
    }
    topology = mesh.topology
    rows = topology.faces.boundary
    skin = topology.corners_of(topology.face_cells[0, rows], topology.face_locals[0, rows])
    assert found["surface:skin"] == {frozenset(column) for column in skin.T.tolist()}
    assert members(mesh)["surface:few"] == [0, 1]


@pytest.mark.parametrize("kind", ["C3D6", "C3D4", "C3D5"])
def test_R13_faces_of_other_kinds_by_their_numbers(kind: str) -> None:
    """Abaqus Elements Guide, "Three-dimensional solid element library": element faces."""
    faces = {
        "C3D6": ("123", "456", "1254", "2365", "3146"),
        "C3D4": ("123", "142", "243", "341"),
        "C3D5": ("1234", "152", "253", "354", "451"),
    }[kind]
    rows = "".join(f"*SURFACE, NAME=s{n + 1}\n1, S{n + 1}\n" for n in range(len(faces)))
    nodes = ", ".join(str(n + 1) for n in range(int(kind[-1])))
    text = f"{NODES}*ELEMENT, TYPE={kind}\n1, {nodes}\n{rows}*SURFACE, NAME=none\n1, S6\n"
    mesh = read_bytes((HEADING + text).encode(), "x.inp")
    found = of_features(mesh, 2)
    for number, face in enumerate(faces):
        assert found[f"surface:s{number + 1}"] == {frozenset(int(node) - 1 for node in face)}
    assert "surface:none" not in found or not found["surface:none"]
    assert any("1 rows of surfaces" in note for note in mesh.notes)


def test_R13_shells_and_beams_are_features_with_their_sets() -> None:
    text = (
        f"{NODES}{CELLS}*ELEMENT, TYPE=S4R, ELSET=floor\n101, 1, 2, 4, 3\n*ELEMENT, TYPE=STRI3, ELSET=tip\n"
        "102, 13, 14, 16\n*ELEMENT, TYPE=B32, ELSET=beam\n201, 1, 5, 3\n*ELSET, ELSET=mixed\n10, 101, 201, tip\n"
    )
    mesh = read_bytes((HEADING + text).encode(), "x.inp")
    assert of_features(mesh, 2) == {
        "elset:floor": {frozenset((0, 1, 2, 3))},
        "elset:tip": {frozenset((12, 13, 15))},
        "elset:mixed": {frozenset((0, 1, 2, 3)), frozenset((12, 13, 15))},
    }
    assert of_features(mesh, 1) == {"elset:beam": {frozenset((0, 4))}, "elset:mixed": {frozenset((0, 4))}}
    assert members(mesh) == {"elset:EALL": [0, 1, 2], "elset:mixed": [0]} and mesh.notes == []


def test_R13_a_deck_of_gmsh_keeps_its_lines_and_surfaces(tmp_path: Path) -> None:
    make(File(tmp_path / "x.inp"), wedges=False)
    make(File(tmp_path / "x.msh"), wedges=False)
    deck, mesh = read(tmp_path / "x.inp"), read(tmp_path / "x.msh")
    assert {part.called: part.count for part in deck.features} == {
        part.called: part.count for part in mesh.features if part.dimension
    }
    assert set(of_features(deck, 2)) == {
        f"elset:Surface{tag}" for tag in np.unique(mesh.features[2].data["entity"])
    }


MEDIT = """MeshVersionFormatted 2
Dimension 3
Vertices
8
0 0 0 1
1 0 0 1
1 1 0 1
0 1 0 1
0 0 1 2
1 0 1 2
1 1 1 2
0 1 1 2
Corners
2
1
7
Edges
3
1 2 5
2 3 5
3 4 6
Ridges
2
1
3
RequiredEdges
1
2
RequiredVertices
1
2
Triangles
1
1 2 3 9
Quadrilaterals
2
1 2 3 4 4
5 6 7 8
 8
Hexahedra
1
1 2 3 4 5 6 7 8 3
End
"""


def check_medit(mesh: Mesh) -> None:
    assert members(mesh) == {"reference:3": [0]}
    assert of_features(mesh, 0) == {
        "mark:corners": {frozenset((0,)), frozenset((6,))},
        "mark:required": {frozenset((1,))},
    }
    assert of_features(mesh, 1) == {
        "mark:ridges": {frozenset((0, 1)), frozenset((2, 3))},
        "mark:required": {frozenset((1, 2))},
        "reference:5": {frozenset((0, 1)), frozenset((1, 2))},
        "reference:6": {frozenset((2, 3))},
    }
    assert of_features(mesh, 2) == {
        "reference:9": {frozenset((0, 1, 2))},
        "reference:4": {frozenset((0, 1, 2, 3))},
        "reference:8": {frozenset((4, 5, 6, 7))},
    }
    assert mesh.notes == []


def test_R13_elements_of_a_medit_file_with_their_references() -> None:
    mesh = read_bytes(MEDIT.encode(), "x.mesh")
    check_medit(mesh)
    assert mesh.first_number == 1


@pytest.mark.parametrize("format_id", ["mesh", "meshb"])
def test_R13_they_survive_in_both_forms_of_medit(format_id: str) -> None:
    mesh = read_bytes(MEDIT.encode(), "x.mesh")
    check_medit(read_bytes(write_bytes(mesh, format_id), f"x.{format_id}"))


def test_R13_meshio_reads_the_same_elements_of_a_written_medit_file(tmp_path: Path) -> None:
    text = MEDIT.replace("RequiredEdges\n1\n2\n", "")  # which meshio does not know, and gives up
    mesh = read_bytes(text.encode(), "x.mesh")
    (tmp_path / "x.mesh").write_bytes(write_bytes(mesh, "mesh"))
    found = meshio.read(tmp_path / "x.mesh")
    rows = {block.type: block.data.tolist() for block in found.cells}
    references = dict(zip((block.type for block in found.cells), found.cell_data["medit:ref"], strict=True))
    assert rows["line"] == [[0, 1], [1, 2], [2, 3]] and references["line"].tolist() == [5, 5, 6]
    assert rows["triangle"] == [[0, 1, 2]] and references["triangle"].tolist() == [9]
    assert rows["quad"] == [[0, 1, 2, 3], [4, 5, 6, 7]] and references["quad"].tolist() == [4, 8]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("1 2 3 9\n", "1 2 x 9\n", "Triangles were left out"),
        ("1 2 3 9\n", "1 2 3 9 7\n", "5 numbers for 1 rows"),
        ("1 2 3 9\n", "1 2 30 9\n", "1 triangle refers to vertices that are not there"),
        ("Triangles\n1\n", "Triangles\n-1\n", "the number of triangles is -1"),
        ("3 4 6\n", "3 4.5 6\n", "Edges"),
    ],
)
def test_R10_features_that_cannot_be_read_do_not_cost_the_mesh(old: str, new: str, words: str) -> None:
    assert old in MEDIT
    mesh = read_bytes(MEDIT.replace(old, new, 1).encode(), "x.mesh")
    assert mesh.cell_count == 1 and mesh.cell_data["reference"].tolist() == [3]
    assert any(words in note for note in mesh.notes), mesh.notes


def test_R13_polylines_and_polygons_of_vtk_with_their_arrays(tmp_path: Path) -> None:
    data = unstructured_grid(grid(2, 1, 1))
    for kind, ids in ((4, [0, 1, 2]), (7, [0, 1, 3]), (7, [0, 1, 4, 3]), (7, [0, 1, 4, 3, 5]), (4, [3, 4])):
        insert(data, kind, ids)
    tags = vtk.vtkIntArray()
    tags.SetName("tag")
    for value in (0, 0, 7, 8, 8, 8, 9):
        tags.InsertNextValue(value)
    data.GetCellData().AddArray(tags)
    for version in (42, 51):
        mesh = read_bytes(legacy(data, version, True), "x.vtk")
        assert of_features(mesh, 1) == {
            "tag:7": {frozenset((0, 1)), frozenset((1, 2))},
            "tag:9": {frozenset((3, 4))},
        }
        assert of_features(mesh, 2) == {"tag:8": {frozenset((0, 1, 3)), frozenset((0, 1, 3, 4))}}
        assert "tag" not in mesh.cell_data and "polygons (1)" in " ".join(mesh.notes)


def test_R13_mixed_cells_beside_features(tmp_path: Path) -> None:
    sample = mixed()
    blocks = [
        ("hexahedron", sample.rows_of(0)),
        ("wedge", sample.rows_of(1)),
        ("line", np.array([[0, 1], [1, 2]])),
    ]
    meshio.write(tmp_path / "x.vtu", meshio.Mesh(sample.points, blocks))
    mesh = read(tmp_path / "x.vtu")
    assert mesh.kind_counts["wedge"] == len(sample.rows_of(1))
    assert mesh.features[0].corners.T.tolist() == [[0, 1], [1, 2]]


def test_R12_elements_of_a_file_without_cells_are_named_in_its_refusal() -> None:
    text = MEDIT.split("Hexahedra")[0] + "End\n"
    with pytest.raises(
        MeshReadError, match=r"only lines \(3\), points \(3\), quadrilaterals \(2\), triangles \(1\)"
    ):
        read_bytes(text.encode(), "x.mesh")
