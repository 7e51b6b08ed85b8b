"""SPEC R12, R13: groups and elements of lower dimension, as Gmsh, meshio and the formats' manuals say."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hexalab.formats import read, read_bytes
from hexalab.grouping import feature_groups, groups_of
from hexalab.mesh import Mesh
from tests.core.formats.gmsh_files import File, make, opened
from tests.core.formats.samples import grid
from tests.tools import tool

meshio = tool("meshio")
vtk = tool("vtk")


def members(mesh: Mesh) -> dict[str, list[int]]:
    """Members of all groups of a mesh by their ids."""
    return {group.id: group.members.tolist() for group in groups_of(mesh)}


def of_features(mesh: Mesh, dimension: int) -> dict[str, set[frozenset[int]]]:
    """Vertices of the members of groups of features, by the groups' ids."""
    found = {}
    for part in mesh.features:
        if part.dimension == dimension:
            for group in feature_groups(part.data, part.groups):
                found[group.id] = {frozenset(column) for column in part.corners[:, group.members].T.tolist()}
    return found


VERSIONS = [(2.2, 0), (2.2, 1), (4.0, 0), (4.1, 0), (4.1, 1)]


@pytest.mark.parametrize(("version", "binary"), VERSIONS)
@pytest.mark.parametrize("gaps", [False, True])
def test_R12_physical_groups_are_those_that_gmsh_finds(
    tmp_path: Path, version: float, binary: int, gaps: bool
) -> None:
    file = tmp_path / "x.msh"
    options = [("Mesh.MshFileVersion", version), ("Mesh.Binary", binary), ("Mesh.SaveAll", 0.0)]
    make(File(file, options), gaps=gaps, named=version > 4)
    wanted, mesh = opened(file), read(file)
    numbers = np.arange(1, mesh.cell_count + 1) if mesh.cell_numbers is None else mesh.cell_numbers
    nodes = np.arange(1, mesh.vertex_count + 1) if mesh.vertex_numbers is None else mesh.vertex_numbers
    assert {dimension for dimension, _ in wanted.groups} == ({0, 1, 2, 3} if version > 4 else {3})
    solid = {group.number: group for group in mesh.groups if group.origin == "physical"}
    assert set(solid) == {tag for dimension, tag in wanted.groups if dimension == 3}
    for (dimension, tag), (name, tags) in wanted.groups.items():
        if dimension == 3:
            assert solid[tag].name == (name or str(tag))
            assert sorted(numbers[solid[tag].members].tolist()) == tags
        else:
            found = of_features(mesh, dimension)[f"physical:{name}"]
            rows = {frozenset(wanted.lower[tag]) for tag in tags}
            assert {frozenset(int(nodes[vertex]) for vertex in row) for row in found} == rows
    assert mesh.notes == (
        ["A volume belongs to several physical groups: the attribute “physical” names the first."]
        if version > 4
        else []
    )


def test_R12_partitions_are_groups(tmp_path: Path) -> None:
    make(File(tmp_path / "x.msh", [("Mesh.MshFileVersion", 4.1)]), partitions=3, wedges=False)
    wanted, mesh = opened(tmp_path / "x.msh"), read(tmp_path / "x.msh")
    numbers = np.arange(1, mesh.cell_count + 1) if mesh.cell_numbers is None else mesh.cell_numbers
    for number in (1, 2, 3):
        tags = sorted(tag for tag, parts in wanted.partitions.items() if parts == [number])
        assert tags == sorted(numbers[members(mesh)[f"partition:{number}"]].tolist())


def test_R12_sets_that_meshio_writes_and_reads(tmp_path: Path) -> None:
    sample = grid(3, 2, 2)
    mesh = meshio.Mesh(
        sample.points,
        [("hexahedron", sample.rows_of(0))],
        cell_sets={"LEFT": [np.array([0, 3, 5])], "ALL": [np.arange(12)]},
        point_sets={"FIXED": np.array([0, 7, 11])},
    )
    meshio.write(tmp_path / "x.inp", mesh)
    found = read(tmp_path / "x.inp")
    assert members(found) == {
        "elset:LEFT": [0, 3, 5],
        "elset:ALL": list(range(12)),
        "nset:FIXED": [0, 7, 11],
    }
    there = meshio.read(tmp_path / "x.inp")
    assert there.cell_sets["LEFT"][0].tolist() == members(found)["elset:LEFT"]


NODES = "*NODE\n" + "".join(
    f"{1 + i + 2 * j + 4 * k}, {i}, {j}, {k}\n" for k in range(4) for j in range(2) for i in range(2)
)
"""Two by two by four nodes."""

CELLS = "*ELEMENT, TYPE=C3D8, ELSET=EALL\n" + "".join(
    f"{10 * n + 10}, " + ", ".join(str(4 * n + c) for c in (1, 2, 4, 3, 5, 6, 8, 7)) + "\n" for n in range(3)
)
"""Three cubes on one another: elements 10, 20, 30."""


def test_R12_ranges_sets_of_sets_and_names_in_any_letter_case() -> None:
    text = (
        f"{NODES}{CELLS}*ELSET, ELSET=Ends\n10, 30\n*Elset, elset=run, GENERATE\n10, 30, 10\n"
        "*ELSET, ELSET=both\nENDS, 20\n*ELSET, ELSET=ends\n10,\n*NSET, NSET=low, GENERATE\n1, 4\n"
        "*NSET, NSET=of cells, ELSET=Ends\n*ELSET, ELSET=_picked, INTERNAL\n20,\n"
        "*SOLID SECTION, ELSET=_picked, MATERIAL=Steel\n1.,\n*SOLID SECTION, MATERIAL=steel, ELSET=ends\n,\n"
    )
    mesh = read_bytes((HEADING + text).encode(), "x.inp")
    assert members(mesh) == {
        "material:Steel": [0, 1, 2],
        "elset:EALL": [0, 1, 2],
        "elset:Ends": [0, 2],
        "elset:run": [0, 1, 2],
        "elset:both": [0, 1, 2],
        "nset:low": [0, 1, 2, 3],
        "nset:of cells": list(range(16)),
    }
    assert mesh.cell_numbers.tolist() == [10, 20, 30] and mesh.notes == []


HEADING = "*HEADING\nthree cubes\n"


def test_R12_a_set_defined_after_the_one_that_names_it_and_one_that_is_nowhere() -> None:
    text = f"{NODES}{CELLS}*ELSET, ELSET=a\nb, c\n*ELSET, ELSET=b\n20, 99\n"
    mesh = read_bytes((HEADING + text).encode(), "x.inp")
    assert members(mesh)["elset:a"] == [1]
    assert any("1 entries of sets" in note or "2 entries of sets" in note for note in mesh.notes)
    assert any("sets that are not there: c" in note for note in mesh.notes)


def test_R12_sets_that_name_each_other_come_to_an_end() -> None:
    text = f"{NODES}{CELLS}*ELSET, ELSET=a\nb, 10\n*ELSET, ELSET=b\na, 20\n"
    mesh = read_bytes((HEADING + text).encode(), "x.inp")
    assert members(mesh)["elset:a"] == [0, 1] == members(mesh)["elset:b"]


def test_R12_parts_instances_and_sets_of_the_assembly() -> None:
    """Abaqus Analysis User's Guide, "Defining an assembly": names in the assembly are prefixed by the instance's."""
    part = f"*PART, NAME=bar\n{NODES}{CELLS}*ELSET, ELSET=tip\n30,\n*NSET, NSET=foot\n1, 2\n*END PART\n"
    assembly = (
        "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=one, PART=bar\n*END INSTANCE\n"
        "*INSTANCE, NAME=two, PART=bar\n10., 0., 0.\n*END INSTANCE\n"
        "*ELSET, ELSET=tips\none.tip, TWO.TIP\n*ELSET, ELSET=middle, INSTANCE=two\n20,\n"
        "*ELSET, ELSET=middle, INSTANCE=one\n20,\n*NSET, NSET=feet\none.foot, two.4\n*END ASSEMBLY\n"
    )
    mesh = read_bytes((HEADING + part + assembly).encode(), "x.inp")
    assert mesh.cell_count == 6
    assert members(mesh) == {
        "instance:one": [0, 1, 2],
        "instance:two": [3, 4, 5],
        "elset:one.EALL": [0, 1, 2],
        "elset:two.EALL": [3, 4, 5],
        "elset:one.tip": [2],
        "elset:two.tip": [5],
        "elset:tips": [2, 5],
        "elset:middle": [1, 4],
        "nset:one.foot": [0, 1],
        "nset:two.foot": [16, 17],
        "nset:feet": [0, 1, 19],
    }
    assert mesh.notes == []


def test_R12_sets_that_name_many_sets_are_gone_through_once() -> None:
    rows = "".join(f"*ELSET, ELSET=s{n}\ns{n + 1}, s{n + 1}\n" for n in range(60))
    text = f"{NODES}{CELLS}{rows}*ELSET, ELSET=s60\n20,\n"
    mesh = read_bytes((HEADING + text).encode(), "x.inp")
    assert members(mesh)["elset:s0"] == [1]


@pytest.mark.parametrize("format_id", ["vtk", "vtu"])
def test_R12_material_arrays_of_vtk(tmp_path: Path, format_id: str) -> None:
    """What meshio writes of lines, faces and cells with one array over all."""
    sample = grid(3, 2, 1)
    material = [np.array([1, 1, 2, 2, 5, 5]), np.array([8, 9]), np.array([7])]
    cells = [
        ("hexahedron", sample.rows_of(0)),
        ("quad", sample.rows_of(0)[:2, :4]),
        ("line", sample.rows_of(0)[:1, :2]),
    ]
    meshio.write(
        tmp_path / f"x.{format_id}",
        meshio.Mesh(
            sample.points,
            cells,
            cell_data={"Material": material, "id": [np.arange(6) / 2, np.arange(2) / 2, [0.5]]},
        ),
    )
    mesh = read(tmp_path / f"x.{format_id}")
    assert members(mesh) == {"Material:1": [0, 1], "Material:2": [2, 3], "Material:5": [4, 5]}
    assert mesh.first_number == 0
    assert set(of_features(mesh, 2)) == {"Material:8", "Material:9"} and mesh.features[1].count == 2
    assert of_features(mesh, 1)["Material:7"] == {frozenset(sample.rows_of(0)[0, :2].tolist())}


def test_R12_arrays_of_many_or_no_whole_numbers_make_no_groups() -> None:
    sample = grid(4, 4, 4)
    mesh = Mesh.from_cells(
        sample.points,
        sample.rows_of(0),
        cell_data={
            "id": np.arange(64),
            "half": np.arange(64) // 2 / 2,
            "whole": np.repeat([3.0, 4.0], 32),
            "wide": np.repeat([[1, 2]], 64, axis=0),
            "lost": np.full(64, np.nan),
            "far": np.repeat([-(2**40), 2**40], 32),
            "tiny": np.repeat([-128, 127], 32).astype(np.int8),
            "flag": np.repeat([True, False], 32),
        },
    )
    found = members(mesh)
    assert set(found) == {
        "whole:3", "whole:4", f"far:{-(2**40)}", f"far:{2**40}", "tiny:-128", "tiny:127", "flag:0", "flag:1",
    }  # fmt: skip
    assert found["tiny:127"] == found["whole:4"] == found["flag:0"] == list(range(32, 64))
