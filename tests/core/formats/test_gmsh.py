"""SPEC R5: `.msh` 2.2 and 4.1, files of Gmsh and meshio, and the traps of the format by hand."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes
from tests.core.formats.gmsh_files import File, make
from tests.core.formats.samples import HEX_22, MESHIO_NAMES, Sample, check, grid, mixed, signed_volumes
from tests.tools import tool

meshio = tool("meshio")

FROM_VTK = ([0, 1, 2, 3, 4, 5, 6, 7], [0, 2, 1, 3, 5, 4], [0, 1, 2, 3, 4], [0, 1, 2, 3])


def hexahedra_only() -> Sample:
    return grid(2, 3, 2)


VERSIONS = [(1, 0), (2.2, 0), (2.2, 1), (3, 0), (3, 1), (4.0, 0), (4.1, 0), (4.1, 1)]


def _form(version: float, binary: int) -> list[tuple[str, float]]:
    return [("Mesh.MshFileVersion", version), ("Mesh.Binary", binary)]


@pytest.mark.parametrize("order", [1, 2, 3])
def test_R5_files_of_gmsh(tmp_path: Path, order: int) -> None:
    files = [
        File(tmp_path / f"{version}_{binary}.msh", _form(version, binary)) for version, binary in VERSIONS
    ]
    made = make(*files, order=order, wedges=order < 3)
    hexahedra, wedges = made.count({1: 5, 2: 12, 3: 92}[order]), made.count({1: 6, 2: 13, 3: 90}[order])
    assert hexahedra > 20
    for version, binary in VERSIONS:
        mesh = read(tmp_path / f"{version}_{binary}.msh")
        assert mesh.kind_counts == {"hexahedron": hexahedra} | ({"wedge": wedges} if wedges else {})
        volumes = signed_volumes(mesh)
        assert (volumes > 0).all()
        np.testing.assert_allclose(volumes.sum(), 1.5 if wedges else 1, rtol=1e-9)
        assert any("higher order" in note for note in mesh.notes) == (order > 1)
        assert mesh.features[-1].dimension == 2 and not any("Left out" in note for note in mesh.notes)
        if version == 4.1:
            expected = [7] * hexahedra + [9] * wedges
            assert sorted(mesh.cell_data["physical"].tolist()) == expected


@pytest.mark.parametrize(("version", "binary"), VERSIONS)
def test_R5_gaps_in_numbers_and_physical_groups(tmp_path: Path, version: float, binary: int) -> None:
    form = [("Mesh.SaveAll", 0.0), *_form(version, binary)]
    made = make(File(tmp_path / "x.msh", form), gaps=True)
    wanted, place = made.elements[5], made.points
    mesh = read(tmp_path / "x.msh")
    hexahedra = mesh.kinds == 0
    found = {tuple(row) for row in np.round(mesh.points[mesh.cells[hexahedra]].reshape(-1, 24), 9).tolist()}
    assert found == {
        tuple(np.round(np.concatenate([place[int(t)] for t in row]), 9).tolist()) for row in wanted
    }
    assert set(mesh.cell_data["physical"]) == {7, 9}
    assert (mesh.cell_data["physical"][hexahedra] == 7).all()
    np.testing.assert_allclose(signed_volumes(mesh).sum(), 1.5, rtol=1e-9)


@pytest.mark.parametrize(
    ("file_format", "binary", "make"),
    [
        ("gmsh22", True, mixed),
        ("gmsh22", False, mixed),
        ("gmsh", True, hexahedra_only),
        ("gmsh", False, hexahedra_only),
    ],
)
def test_R5_R8_files_of_meshio(tmp_path: Path, file_format: str, binary: bool, make) -> None:
    """meshio writes several kinds in 2.2 only, and data in binary only under numpy 2."""
    sample = make().grouped()
    kinds = sorted({kind for kind, _ in sample.cells})
    blocks = [(MESHIO_NAMES[kind], sample.rows_of(kind)[:, FROM_VTK[kind]]) for kind in kinds]
    data = {}
    if binary and "flow" in sample.cell_data:
        sizes = np.cumsum([len(rows) for _, rows in blocks])[:-1]
        flow = np.split(sample.cell_data["flow"], sizes)
        data = {"cell_data": {"flow": flow}, "point_data": {"shift": sample.point_data["shift"]}}
    mesh = meshio.Mesh(sample.points, blocks, **data)
    meshio.write(tmp_path / "x.msh", mesh, file_format=file_format, binary=binary)
    found = read(tmp_path / "x.msh")
    check(found, sample, 1e-15)
    if data:
        np.testing.assert_allclose(found.cell_data["flow"], sample.cell_data["flow"], rtol=1e-12)
        np.testing.assert_allclose(found.point_data["shift"], sample.point_data["shift"], rtol=1e-12)


@pytest.mark.parametrize("old", ["33 7.5", "3\n0\n1\n2\n33"])
def test_R8_values_that_cannot_be_read_do_not_cost_the_mesh(old: str) -> None:
    """As meshio 5.3 writes them with numpy 2: `1 np.float64(7.5)`."""
    data = '$NodeData\n1\n"a"\n1\n0.5\n3\n0\n1\n2\n33 7.5\n2 -1\n$EndNodeData\n'
    rest = '$ElementData\n1\n"flow"\n0\n3\n0\n1\n1\n4 5\n$EndElementData\n'
    bad = data.replace(old, "33 np.float64(7.5)")
    mesh = read_bytes((HEX_22 + bad + rest).encode(), "x.msh")
    assert mesh.kind_counts == {"hexahedron": 1, "tetrahedron": 1}
    assert set(mesh.point_data) == set()
    assert "flow" in mesh.cell_data
    assert any(note.startswith("Values were left out") for note in mesh.notes)
    with pytest.raises(MeshReadError):
        read_bytes((HEX_22 + bad.replace("$EndNodeData\n", "")).encode(), "x.msh")


def test_R8_data_by_hand() -> None:
    data = """$NodeData
1
"a name"
1
0.5
3
0
1
2
33 7.5
2 -1
$EndNodeData
$ElementData
1
"flow"
0
3
0
3
3
70 1 2 3
4 4 5 6
9 7 8 9
$EndElementData
"""
    mesh = read_bytes((HEX_22 + data).encode(), "x.msh")
    wanted = np.full(8, np.nan)
    wanted[[1, 2]] = -1, 7.5
    np.testing.assert_array_equal(mesh.point_data["a name"], wanted)
    assert mesh.cell_data["flow"].tolist() == [[4, 5, 6], [1, 2, 3]]


def test_R5_numbers_with_gaps_by_hand() -> None:
    mesh = read_bytes(HEX_22.encode(), "x.msh")
    assert mesh.kind_counts == {"hexahedron": 1, "tetrahedron": 1}
    assert mesh.cells[0].tolist() == list(range(8))
    assert mesh.cell_data["physical"].tolist() == [8, 0] and mesh.cell_data["entity"].tolist() == [9, 0]
    check_crlf = read_bytes(HEX_22.replace("\n", "\r\n").encode(), "x.msh")
    np.testing.assert_array_equal(check_crlf.cells, mesh.cells)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("2.2 0 8", "5.0 0 8", ["‘5.0’", "expected 1, 2, 3, 4.0 or 4.1"]),
        ("2.2 0 8", "2.2 7 8", ["file type 7"]),
        ("33 1 1 0\n", "33 1 1\n", ["line 18", "‘$EndNodes’", "32 numbers"]),
        ("$Nodes\n8", "$Nodes\n7", ["element 4 refers to node 1000000"]),
        ("$EndNodes", "x\n$EndNodes", ["line 18", "‘x’", "$EndNodes was expected"]),
        ("$Nodes\n8", "$Nodes\n80000000000", ["line 9", "80000000000 nodes"]),
        ("70 4 0 101 2 33 5", "70 4 0 101 2 33", ["does not fit"]),
        ("4 5 3 8 9 1 101", "4 5 3 8 9 1 102", ["element 4", "node 102"]),
        ("4 5 3 8 9 1 101", "4 999 3 8 9 1 101", ["does not fit"]),
        ("4 5 3 8 9 1 101", "4 5 x 8 9 1 101", ["line 22", "‘x’"]),
        ("101 0 0 0", "101 0 0 inf", ["$Nodes", "not a finite"]),
        ("$EndElements\n", "", ["$EndElements"]),
        ("$Nodes", "$Knots", ["$EndKnots"]),
    ],
)  # fmt: skip
def test_R10_bad_msh_files(old: str, new: str, words: list[str]) -> None:
    assert old in HEX_22
    with pytest.raises(MeshReadError) as caught:
        read_bytes(HEX_22.replace("\n" + old, "\n" + new, 1).encode(), "bad.msh")
    for word in ["bad.msh", *words]:
        assert word in str(caught.value)
