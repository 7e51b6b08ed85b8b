"""SPEC R11, R12, R13: numbers, groups and features survive conversion, as other programs read it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from hexalab.cell_lists import cell_list
from hexalab.formats import WRITERS, left_behind, read, read_bytes, write, write_bytes, writer_of
from hexalab.groups import Features, Group
from hexalab.mesh import Mesh
from hexalab.numbering import cell_numbers, cells_numbered
from hexalab.quality import quality
from hexalab.selection import select_cells
from tests.core.formats.gmsh_files import opened
from tests.core.formats.samples import grid, mixed
from tests.core.formats.test_groups import members, of_features
from tests.core.formats.test_write import sample_mesh
from tests.tools import tool

meshio = tool("meshio")
vtk = tool("vtk")


def grouped() -> Mesh:
    """Twelve cubes with numbers of their own, sets that overlap, edges and faces with names."""
    sample = grid(3, 2, 2)
    cells = sample.rows_of(0)
    mesh = Mesh.from_cells(sample.points, cells)
    topology = mesh.topology
    rows = topology.faces.boundary
    skin = topology.corners_of(topology.face_cells[0, rows], topology.face_locals[0, rows])[:, :10]
    edges = cells[:3, :2].T.astype(np.int32)
    return Mesh(
        mesh.coordinates,
        mesh.corners,
        mesh.kinds,
        cell_numbers=np.arange(12)[::-1] * 10 + 7,
        vertex_numbers=np.arange(36) * 3 + 1000,
        first_number=1,
        groups=(
            Group("STEEL", "elset", [0, 1, 2, 5]),
            Group("left, part", "elset", [2, 5, 7]),
            Group("fixed", "nset", [0, 3, 35], "vertex"),
        ),
        features=(
            Features(0, np.array([[0, 35]]), {}, (Group("origin", "physical", [0], number=4),)),
            Features(1, edges, {"reference": np.array([5, 5, 6])}),
            Features(2, skin, {"reference": np.arange(10) // 5 + 1}, (Group("wall", "surface", [1, 2, 9]),)),
        ),
    )


SIDES = {0: ("physical:origin",), 2: ("surface:wall",)}


@pytest.mark.parametrize("format_id", ["vtk", "vtu"])
def test_R12_vtk_holds_all_of_it(format_id: str) -> None:
    mesh = grouped()
    data = write_bytes(mesh, format_id)
    back = read_bytes(data, f"x.{format_id}")
    assert members(back) == members(mesh)
    for dimension in range(3):
        assert of_features(back, dimension) == of_features(mesh, dimension)
    assert back.cell_numbers.tolist() == mesh.cell_numbers.tolist()
    assert back.vertex_numbers.tolist() == mesh.vertex_numbers.tolist()
    assert set(back.cell_data) == set(mesh.cell_data) and back.notes == []
    assert left_behind(mesh, writer_of(Path(f"x.{format_id}"))) == []


@pytest.mark.parametrize("format_id", ["vtk", "vtu"])
def test_R12_vtk_finds_them_too(tmp_path: Path, format_id: str) -> None:
    mesh = grouped()
    file = tmp_path / f"x.{format_id}"
    file.write_bytes(write_bytes(mesh, format_id))
    reader = vtk.vtkUnstructuredGridReader() if format_id == "vtk" else vtk.vtkXMLUnstructuredGridReader()
    if format_id == "vtk":
        reader.ReadAllFieldsOn()
    reader.SetFileName(str(file))
    reader.Update()
    found = reader.GetOutput()
    kinds = [found.GetCellType(row) for row in range(found.GetNumberOfCells())]
    assert [kinds.count(kind) for kind in (12, 1, 3, 9)] == [12, 2, 3, 10]
    ids = found.GetCellData().GetGlobalIds()
    assert ids.GetName() == "GlobalElementId"
    assert [int(ids.GetValue(row)) for row in range(12)] == mesh.cell_numbers.tolist()
    mask = found.GetCellData().GetArray("group:elset:STEEL")
    assert [row for row in range(len(kinds)) if mask.GetValue(row)] == [0, 1, 2, 5]
    nodes = found.GetPointData().GetArray("group:nset:fixed")
    assert [row for row in range(36) if nodes.GetValue(row)] == [0, 3, 35]


@pytest.mark.parametrize("format_id", ["msh", "msh2"])
def test_R12_gmsh_finds_them(tmp_path: Path, format_id: str) -> None:
    mesh = grouped()
    file = tmp_path / "x.msh"
    file.write_bytes(write_bytes(mesh, format_id))
    found = opened(file)
    by_name = {(dimension, name): tags for (dimension, _), (name, tags) in found.groups.items()}
    steel = mesh.cell_numbers[[0, 1, 2, 5] if format_id == "msh" else [0, 1]]
    assert by_name[3, "STEEL"] == sorted(steel.tolist())
    assert by_name[3, "left, part"] == sorted(mesh.cell_numbers[[2, 5, 7]].tolist())
    wall = {frozenset(found.lower[tag]) for tag in by_name[2, "wall"]}
    numbers = mesh.vertex_numbers
    assert wall == {
        frozenset(numbers[column].tolist()) for column in mesh.features[2].corners[:, [1, 2, 9]].T
    }
    assert len(by_name[0, "origin"]) == 1 and found.groups[0, 4][0] == "origin"
    back = read(file)
    assert back.cell_numbers.tolist() == mesh.cell_numbers.tolist()
    assert {len(part.corners): part.count for part in back.features} == {1: 2, 2: 3, 4: 10}
    assert set(members(back)) >= {"physical:STEEL", "physical:left, part"}
    notes = " ".join(left_behind(mesh, writer_of(Path("x.msh"), format_id)))
    assert ("2 that are in several" in notes) == (format_id == "msh2")
    assert "sets of nodes: fixed" in notes


def test_R12_abaqus_holds_sets_and_surfaces(tmp_path: Path) -> None:
    mesh = grouped()
    file = tmp_path / "x.inp"
    file.write_bytes(write_bytes(mesh, "inp"))
    back = read(file)
    assert members(back) == {
        "elset:STEEL": [0, 1, 2, 5],
        "elset:left_ part": [2, 5, 7],
        "nset:fixed": [0, 3, 35],
    }
    assert of_features(back, 2)["surface:wall"] == of_features(mesh, 2)["surface:wall"]
    assert of_features(back, 2)["surface:reference_1"] == of_features(mesh, 2)["reference:1"]
    assert back.cell_numbers.tolist() == mesh.cell_numbers.tolist()
    there = meshio.read(file)
    assert sorted(there.cell_sets["STEEL"][0].tolist()) == [0, 1, 2, 5]
    assert sorted(there.point_sets["fixed"].tolist()) == [0, 3, 35]
    notes = " ".join(left_behind(mesh, writer_of(file)))
    assert "2 corners, 3 edges left out" in notes and "left out." not in notes.replace("edges left out.", "")
    inner = np.array([[0, 1, 2, 35]], dtype=np.int32).T
    lost = replace(mesh, features=(Features(2, inner),))
    assert "1 other is left out" in " ".join(left_behind(lost, writer_of(file)))


@pytest.mark.parametrize("format_id", ["mesh", "meshb"])
def test_R12_medit_has_one_number_for_each_cell_and_says_so(format_id: str) -> None:
    mesh = grouped()
    notes = " ".join(left_behind(mesh, writer_of(Path(f"x.{format_id}"))))
    assert "no place for the groups STEEL, left, part" in notes and "numbers of elements" in notes
    apart = select_cells(mesh, [0, 1, 7])
    notes = " ".join(left_behind(apart, writer_of(Path(f"x.{format_id}"))))
    assert "1 is STEEL, 2 is left, part" in notes
    back = read_bytes(write_bytes(apart, format_id), f"x.{format_id}")
    assert members(back) == {"reference:1": [0, 1], "reference:2": [2]}


@pytest.mark.parametrize("source", ["mesh", "vtk", "msh", "inp"])
def test_R12_references_and_materials_become_sets_of_every_format(source: str) -> None:
    sample = mixed().grouped()
    mesh = Mesh.from_cells(sample.points[:8], [[0, 1, 2, 3, 4, 5, 6, 7]] * 4)
    mesh.cell_data["reference"] = np.array([3, 3, 9, 9], dtype=np.int32)
    back = read_bytes(write_bytes(mesh, source), f"x.{source}")
    wanted = {"reference:3": [0, 1], "reference:9": [2, 3]}
    if source == "inp":
        wanted = {"elset:reference_3": [0, 1], "elset:reference_9": [2, 3]}
    assert {key: rows for key, rows in members(back).items() if "entity" not in key} == wanted


def test_R12_two_groups_of_one_name_are_written_apart() -> None:
    sample = grid(2, 1, 1)
    groups = (Group("A", "elset", [0]), Group("a", "material", [1]), Group("1", "physical", [0, 1], number=1))
    mesh = Mesh.from_cells(sample.points, sample.rows_of(0), groups=groups)
    for format_id in ("inp", "msh"):
        found = members(read_bytes(write_bytes(mesh, format_id), f"x.{format_id}"))
        rows = sorted(rows for key, rows in found.items() if "entity" not in key)
        assert rows == [[0], [0, 1], [1]], found


def test_R13_faces_of_all_kinds_get_their_numbers_in_abaqus() -> None:
    mesh = sample_mesh(mixed())
    topology = mesh.topology
    rows = topology.faces.boundary
    skin = topology.corners_of(topology.face_cells[0, rows], topology.face_locals[0, rows])
    every = Group("skin", "surface", np.arange(skin.shape[1]))
    whole = replace(mesh, features=(Features(2, skin, {}, (every,)),))
    back = read_bytes(write_bytes(whole, "inp"), "x.inp")
    assert of_features(back, 2)["surface:skin"] == of_features(whole, 2)["surface:skin"]


def test_R11_every_writer_that_has_numbers_keeps_them() -> None:
    mesh = grouped()
    for row in WRITERS:
        back = read_bytes(write_bytes(mesh, row.id), f"x{row.extension}")
        kept = back.cell_numbers is not None and back.cell_numbers.tolist() == mesh.cell_numbers.tolist()
        assert kept == (row.id not in ("mesh", "meshb")), row.id


def test_R11_rows_that_are_counted_from_1_keep_their_numbers_in_vtk() -> None:
    sample = grid(2, 1, 1)
    mesh = Mesh.from_cells(sample.points, sample.rows_of(0), first_number=1)
    assert read_bytes(write_bytes(mesh, "vtu"), "x.vtu").cell_numbers.tolist() == [1, 2]
    plain = Mesh.from_cells(sample.points, sample.rows_of(0))
    assert read_bytes(write_bytes(plain, "vtu"), "x.vtu").cell_numbers is None


def test_R12_a_part_of_a_mesh_takes_its_groups_and_features_along() -> None:
    mesh = grouped()
    part = select_cells(mesh, [2, 5, 11])
    assert members(part) == {
        "elset:STEEL": [0, 1],
        "elset:left, part": [0, 1],
        "nset:fixed": members(part)["nset:fixed"],
    }
    whole = {tuple(map(tuple, mesh.points[column].tolist())) for column in mesh.features[2].corners.T}
    some = {tuple(map(tuple, part.points[column].tolist())) for column in part.features[-1].corners.T}
    assert some and some < whole


def test_R11_the_worst_element_is_found_under_its_number_by_gmsh(tmp_path: Path) -> None:
    sample = mixed()
    mesh = sample_mesh(sample)
    numbers = np.random.default_rng(2).permutation(mesh.cell_count) * 11 + 50
    numbered = replace(mesh, cell_numbers=numbers, vertex_numbers=np.arange(mesh.vertex_count)[::-1] * 3 + 9)
    write(numbered, tmp_path / "x.msh")
    found = opened(tmp_path / "x.msh")
    back = read(tmp_path / "x.msh")
    volume = quality(back, "volume")
    worst = int(np.argmin(volume))
    tag = int(cell_numbers(back, [worst])[0])
    _, nodes, _ = found.cells[tag]
    place = np.mean([found.points[node] for node in nodes], axis=0)
    np.testing.assert_allclose(place, back.barycentres[:, worst])
    assert {int(number) for number in cell_numbers(back)} == set(found.cells)
    assert cells_numbered(back, tag).tolist() == [worst]


def test_R11_a_worst_element_listed_for_gmsh_becomes_a_group_there(tmp_path: Path) -> None:
    mesh = grouped()
    write(mesh, tmp_path / "x.msh")
    script = cell_list(mesh, [4, 7], "gmsh", "WORST")
    after = opened(tmp_path / "x.msh", script, tmp_path / "y.msh")
    (name, tags) = next(
        row for (dimension, _), row in after.groups.items() if row[0] == "WORST" and dimension == 3
    )
    assert name == "WORST" and tags == sorted(mesh.cell_numbers[[4, 7]].tolist())
    again = read(tmp_path / "y.msh")
    worst = next(group for group in again.groups if group.name == "WORST")
    assert sorted(again.cell_numbers[worst.members].tolist()) == tags


def test_R12_a_list_of_cells_is_an_element_set_for_meshio(tmp_path: Path) -> None:
    mesh = replace(grouped(), groups=())
    text = write_bytes(mesh, "inp") + cell_list(mesh, [1, 10], "elset", "WORST").encode()
    (tmp_path / "x.inp").write_bytes(text)
    assert sorted(meshio.read(tmp_path / "x.inp").cell_sets["WORST"][0].tolist()) == [1, 10]
    assert members(read(tmp_path / "x.inp"))["elset:WORST"] == [1, 10]
