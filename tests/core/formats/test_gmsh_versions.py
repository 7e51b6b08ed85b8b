"""SPEC R5, R12: `.msh` 1, 3 and 4.0, partitioned meshes, sections shorter or longer than announced, beside Gmsh."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

from hexalab.cells import CORNERS_OF_KIND
from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes
from hexalab.mesh import Mesh
from tests.core.formats.gmsh_files import File, Opened, make, opened
from tests.core.formats.samples import HEX_22, WEDGE, mixed, signed_volumes
from tests.tools import tool

meshio = tool("meshio")

CASES = Path(__file__).parent / "cases"
TYPES = {5: 0, 6: 1, 7: 2, 4: 3}
FROM_VTK = ([0, 1, 2, 3, 4, 5, 6, 7], [0, 2, 1, 3, 5, 4], [0, 1, 2, 3, 4], [0, 1, 2, 3])


def check_as_gmsh(mesh: Mesh, truth: Opened) -> None:
    """Assert that every cell stands where Gmsh has it, of the same kind, orientation, group and number."""
    numbers = mesh.cell_numbers if mesh.cell_numbers is not None else np.arange(1, mesh.cell_count + 1)
    assert sorted(numbers.tolist()) == sorted(truth.cells)
    volumes = signed_volumes(mesh)
    for cell, number in enumerate(numbers.tolist()):
        kind, nodes, jacobian = truth.cells[number]
        assert mesh.kinds[cell] == TYPES[kind]
        wanted = np.array([truth.points[node] for node in nodes])
        found = mesh.points[np.unique(mesh.cells[cell])]
        np.testing.assert_array_equal(np.unique(found, axis=0), np.unique(wanted, axis=0))
        assert np.sign(volumes[cell]) == np.sign(jacobian)
        for name, values in (("physical", truth.physicals), ("partition", truth.partitions)):
            own = int(mesh.cell_data[name][cell]) if name in mesh.cell_data else 0
            assert own == (values[number] or [0])[0], (name, number)


@pytest.mark.parametrize("name", ["gmsh-1", "gmsh-4.0", "gmsh-partitioned", "gmsh-physical-names"])
def test_R5_the_cases_are_read_as_by_gmsh(name: str) -> None:
    mesh = read(CASES / f"{name}.msh")
    check_as_gmsh(mesh, opened(CASES / f"{name}.msh"))
    assert set(mesh.cell_data["physical"]) == {1 if name == "gmsh-1" else 7}


@pytest.mark.parametrize(("version", "binary"), [(1, 0), (2.2, 1), (3, 0), (3, 1), (4.0, 0), (4.1, 1)])
def test_R5_physical_groups_of_each_version(tmp_path: Path, version: float, binary: int) -> None:
    path = tmp_path / "x.msh"
    make(File(path, [("Mesh.SaveAll", 0), ("Mesh.MshFileVersion", version), ("Mesh.Binary", binary)]))
    check_as_gmsh(read(path), opened(path))


@pytest.mark.parametrize(("version", "binary"), [(2.2, 0), (2.2, 1), (4.0, 0), (4.1, 0), (4.1, 1)])
def test_R12_physical_groups_of_partitioned_meshes(tmp_path: Path, version: float, binary: int) -> None:
    path = tmp_path / "x.msh"
    form = [("Mesh.SaveAll", 0.0), ("Mesh.MshFileVersion", version), ("Mesh.Binary", binary)]
    make(File(path, form), partitions=3)
    mesh, truth = read(path), opened(path)
    check_as_gmsh(mesh, truth)
    assert set(mesh.cell_data["partition"]) == {1, 2, 3} and set(mesh.cell_data["physical"]) == {7, 9}
    assert len(set(mesh.cell_data["entity"])) == 2


def test_R12_the_entity_of_a_partitioned_cell_is_that_of_the_geometry() -> None:
    mesh = read(CASES / "gmsh-partitioned.msh")
    assert mesh.cell_data["partition"].tolist() == [1, 2]
    assert mesh.cell_data["entity"].tolist() == [1, 1]


def test_R12_what_is_not_kept_of_a_file_is_told() -> None:
    assert any("‘stress’" in note for note in read(CASES / "gmsh-element-node-data.msh").notes)
    several = "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 2 5 7 0\n$EndEntities\n"
    text = (CASES / "gmsh-partitioned.msh").read_text()
    start, end = text.index("$Entities"), text.index("$Nodes")
    mesh = read_bytes((text[:start] + several + text[end:].replace("3 2 5 1", "3 1 5 1")).encode(), "x.msh")
    assert mesh.cell_data["physical"].tolist() == [5, 0]
    assert [(group.number, group.members.tolist()) for group in mesh.groups] == [(5, [0]), (7, [0])]
    assert any("several physical groups" in note for note in mesh.notes)


def binary_40() -> bytes:
    """A 4.0 file in binary by the format's description: Gmsh has given it up, meshio reads it."""
    sample = mixed()
    out = b"$MeshFormat\n4.0 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n$Entities\n"
    out += struct.pack("<4Q", 1, 0, 0, 1)
    out += struct.pack("<i6dQ", 4, *[0.0] * 6, 0)
    out += struct.pack("<i6dQiQ", 3, 0, 0, 0, 2, 2, 2, 1, 8, 0) + b"\n$EndEntities\n$Nodes\n"
    out += struct.pack("<2Q", 2, 13)
    for first, last in ((0, 5), (5, 13)):
        out += struct.pack("<3iQ", 3, 3, 0, last - first)
        for number in range(first, last):
            out += struct.pack("<i3d", 10 * number + 7, *sample.points[number])
    out += b"\n$EndNodes\n$Elements\n" + struct.pack("<2Q", 4, 5)
    tag = 0
    for kind, gmsh_type in enumerate((5, 6, 7, 4)):
        rows = sample.rows_of(kind)[:, FROM_VTK[kind]]
        out += struct.pack("<3iQ", 3, 3, gmsh_type, len(rows))
        for row in rows:
            tag += 1
            out += struct.pack(f"<i{len(row)}i", tag, *(10 * row + 7))
    return out + b"\n$EndElements\n"


def test_R5_version_40_in_binary(tmp_path: Path) -> None:
    (tmp_path / "x.msh").write_bytes(binary_40())
    mesh, truth = read(tmp_path / "x.msh"), meshio.read(tmp_path / "x.msh")
    np.testing.assert_array_equal(mesh.points, truth.points)
    for kind, block in enumerate(truth.cells):
        own = [mesh.cells[cell][list(CORNERS_OF_KIND[kind])] for cell in np.flatnonzero(mesh.kinds == kind)]
        np.testing.assert_array_equal(np.array(own)[:, FROM_VTK[kind]], block.data)
    assert mesh.cell_data["physical"].tolist() == [8] * 5
    assert mesh.kind_counts == {"hexahedron": 2, "wedge": 1, "pyramid": 1, "tetrahedron": 1}
    assert (signed_volumes(mesh)[mesh.kinds == WEDGE] > 0).all()


def test_R5_a_row_more_than_announced_is_passed_over_as_by_gmsh() -> None:
    path = CASES / "gmsh-one-node-too-many.msh"
    mesh = read(path)
    check_as_gmsh(mesh, opened(path))
    assert mesh.vertex_count == 8 and mesh.points[:, 2].max() == 1
    assert any("$Nodes holds more than it announces" in note for note in mesh.notes)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("$Nodes\n8", "$Nodes\n9", "$Nodes announces 9 nodes and has 8, which are read."),
        ("$Elements\n3", "$Elements\n4", "$Elements announces 4 elements and has 3, which are read."),
        ("$Elements\n3", "$Elements\n2", "$Elements announces 2 elements and has 3, of which 2 are read."),
    ],
)
def test_R5_sections_whose_end_is_marked_are_read(old: str, new: str, words: str) -> None:
    mesh = read_bytes(HEX_22.replace(old, new, 1).encode(), "x.msh")
    assert mesh.vertex_count == 8 and mesh.kind_counts["hexahedron"] == 1
    assert words in mesh.notes
    assert mesh.cell_count == (1 if new.endswith("2") else 2)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("$NOD\n8", "$NOD\n7", "refers to node 8"),
        ("1 5 1 1 8 1", "1 5 1 1 7 1", "does not fit"),
        ("1 5 1 1 8 1", "1 4 1 1 8 1", "does not fit"),
        ("$ENDELM", "", r"before \$ENDELM"),
        ("$ELM", "$ELEM", r"before \$EndELEM"),
    ],
)  # fmt: skip
def test_R10_bad_files_of_version_1(old: str, new: str, words: str) -> None:
    text = (CASES / "gmsh-1.msh").read_text()
    assert old in text
    with pytest.raises(MeshReadError, match=words):
        read_bytes(text.replace(old, new, 1).encode(), "x.msh")


def test_R10_parametric_nodes_of_version_3_are_refused_in_words(tmp_path: Path) -> None:
    make(File(tmp_path / "x.msh", [("Mesh.MshFileVersion", 3)]))
    text = (tmp_path / "x.msh").read_text()
    at = text.index("$Nodes")
    first = text.index("\n", text.index("\n", at) + 1)
    line = text[first + 1 : text.index("\n", first + 1)]
    assert line.endswith(" 0")
    with pytest.raises(MeshReadError, match="parametric nodes"):
        read_bytes(text.replace(line, line[:-1] + "1", 1).encode(), "x.msh")
