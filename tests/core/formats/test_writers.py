"""SPEC A1, R8: `.msh`, `.inp` and `.meshb` come back whole, through us, Gmsh, meshio and libMeshb's rules."""

from __future__ import annotations

import gzip
import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from hexalab.formats import read, read_bytes, write, write_bytes
from hexalab.formats.writers import WRITERS, left_behind, writer_of
from hexalab.mesh import Mesh
from tests.core.formats.gmsh_files import opened
from tests.core.formats.samples import MESHIO_NAMES, Sample, check, grid, mixed
from tests.core.formats.test_gmsh_versions import check_as_gmsh
from tests.core.formats.test_write import ODD, sample_mesh
from tests.tools import tool

gmsh, meshio = tool("gmsh"), tool("meshio")


def numbered(sample: Sample | None = None) -> Mesh:
    """The mixed mesh with numbers of its own, in no order."""
    mesh = sample_mesh(sample or mixed())
    random = np.random.default_rng(7)
    return replace(
        mesh,
        vertex_numbers=random.permutation(mesh.vertex_count) * 3 + 11,
        cell_numbers=random.permutation(mesh.cell_count) * 5 + 1_000_000,
    )


def check_numbers(mesh: Mesh, wanted: Mesh) -> None:
    assert mesh.vertex_numbers is not None and mesh.cell_numbers is not None
    np.testing.assert_array_equal(mesh.vertex_numbers, wanted.vertex_numbers)
    np.testing.assert_array_equal(mesh.cell_numbers, wanted.cell_numbers)


@pytest.mark.parametrize("format_id", ["msh", "msh2"])
def test_A1_gmsh_files_keep_everything(tmp_path: Path, format_id: str) -> None:
    sample = mixed()
    sample.points[0, :] = ODD[:3]
    mesh = numbered(sample)
    mesh.cell_data |= {
        "physical": np.array([4, 4, 0, 2, 2]), "entity": np.array([1, 1, 3, 2, 2]),
        "nothing": np.array([np.nan, 1, 2, 3, np.inf]),
    }  # fmt: skip
    assert write(mesh, tmp_path / "x.msh", format_id) == []
    back = read(tmp_path / "x.msh")
    check(back, sample)
    check_numbers(back, mesh)
    for found, wanted in ((back.point_data, mesh.point_data), (back.cell_data, mesh.cell_data)):
        assert set(found) == set(wanted)
        for name, values in wanted.items():
            np.testing.assert_array_equal(found[name], values)


@pytest.mark.parametrize("format_id", ["msh", "msh2"])
def test_A1_gmsh_reads_what_is_written(tmp_path: Path, format_id: str) -> None:
    mesh = numbered()
    mesh.cell_data |= {"physical": np.array([4, 4, 9, 2, 2])}
    write(mesh, tmp_path / "x.msh", format_id)
    check_as_gmsh(mesh, opened(tmp_path / "x.msh"))
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(tmp_path / "x.msh"))
        fields = {}
        for tag in gmsh.view.getTags():
            name = gmsh.view.option.getString(tag, "Name")
            _, tags, values, _, _ = gmsh.view.getModelData(tag, 0)
            fields[name] = dict(zip(tags.tolist(), (row.tolist() for row in values), strict=True))
    finally:
        gmsh.finalize()
    for name, data, numbers in (
        ("height", mesh.point_data, mesh.vertex_numbers),
        ("shift", mesh.point_data, mesh.vertex_numbers),
        ("flow", mesh.cell_data, mesh.cell_numbers),
    ):
        assert numbers is not None
        rows = data[name].reshape(len(numbers), -1).tolist()
        assert fields[name] == dict(zip(numbers.tolist(), rows, strict=True))


@pytest.mark.parametrize("ending", ["msh", "inp", "meshb"])
def test_A1_meshio_reads_what_is_written(tmp_path: Path, ending: str) -> None:
    sample = grid(3, 4, 2)
    write(sample_mesh(sample), tmp_path / f"x.{ending}")
    found = meshio.read(tmp_path / f"x.{ending}")
    np.testing.assert_allclose(found.points, sample.points, rtol=1e-13 if ending == "inp" else 0, atol=0)
    np.testing.assert_array_equal(found.cells_dict["hexahedron"], sample.rows_of(0))


def test_A1_meshio_reads_decks_of_all_kinds_it_knows(tmp_path: Path) -> None:
    """It has no C3D5. Its wedge is VTK's; Abaqus's triangle 1 2 3 is seen from the other side."""
    sample = mixed().grouped()
    kept = [at for at, (kind, _) in enumerate(sample.cells) if MESHIO_NAMES[kind] != "pyramid"]
    mesh = sample_mesh(Sample(sample.points, [sample.cells[at] for at in kept]))
    write(mesh, tmp_path / "x.inp")
    found = meshio.read(tmp_path / "x.inp")
    for kind, order in ((0, range(8)), (1, (0, 2, 1, 3, 5, 4)), (3, range(4))):
        wanted = sample.rows_of(kind)[:, list(order)]
        np.testing.assert_array_equal(found.cells_dict[MESHIO_NAMES[kind]], wanted)


def test_A1_decks_keep_cells_and_numbers_in_order(tmp_path: Path) -> None:
    mesh = numbered()
    lost = write(mesh, tmp_path / "x.inp")
    assert len(lost) == 1 and "height (of vertices), shift (of vertices), flow (of cells)" in lost[0]
    back = read(tmp_path / "x.inp")
    check(back, mixed())
    check_numbers(back, mesh)
    assert not back.cell_data


def test_A1_numbers_of_decks_fit_twenty_characters() -> None:
    """Abaqus reads no more of a field, nor does CalculiX: the rest of an exponent would be cut off."""
    random = np.random.default_rng(5)
    points = random.normal(size=(3000, 3)) * 10.0 ** random.integers(-200, 200, (3000, 1))
    points[:6, 0] = ODD
    mesh = Mesh.from_cells(points, np.arange(8))
    data = write_bytes(mesh, "inp")
    rows = data.split(b"*NODE\n")[1].split(b"*ELEMENT")[0].split()
    assert max(len(word.rstrip(b",")) for word in rows) <= 20
    np.testing.assert_allclose(read_bytes(data, "x.inp").points, points, rtol=1e-12, atol=0)


def sections(data: bytes) -> dict[int, np.ndarray]:
    """Rows of each section of a `.meshb`, by libMeshb's rules: code, version, then keyword, next position, count."""
    code, version = struct.unpack_from("<ii", data)
    assert code == 1
    whole, place = ("q" if version == 4 else "i"), ("q" if version >= 3 else "i")
    widths = {4: f"<ddd{whole}", 8: f"<5{whole}", 9: f"<7{whole}", 10: f"<9{whole}", 49: f"<6{whole}"}
    found, at = {}, 8
    while True:
        keyword, after = struct.unpack_from(f"<i{place}", data, at)
        at += struct.calcsize(f"<i{place}")
        if keyword == 54:
            assert at == len(data)
            return found
        if keyword == 3:
            assert struct.unpack_from("<i", data, at) == (3,)
        else:
            (count,) = struct.unpack_from(f"<{whole}", data, at)
            start = at + struct.calcsize(whole)
            size = struct.calcsize(widths[keyword])
            assert start + count * size == after
            found[keyword] = np.array(
                [struct.unpack_from(widths[keyword], data, start + i * size) for i in range(count)]
            )
        at = after


@pytest.mark.parametrize("largest", [2**31 - 1, 2**40])
def test_A1_meshb_by_libmeshbs_rules(largest: int) -> None:
    """Wedges are numbered as Medit does, the triangle 1 2 3 seen from the other side than VTK's."""
    sample = mixed()
    mesh = sample_mesh(sample)
    mesh.cell_data["reference"] = np.array([1, 2, 3, 4, largest])
    data = write_bytes(mesh, "meshb")
    assert data[4] == (4 if largest >= 2**31 else 2)
    found = sections(data)
    np.testing.assert_array_equal(found[4][:, :3], sample.points)
    for keyword, kind, order in (
        (10, 0, range(8)),
        (9, 1, (0, 2, 1, 3, 5, 4)),
        (49, 2, range(5)),
        (8, 3, range(4)),
    ):
        np.testing.assert_array_equal(found[keyword][:, :-1], sample.rows_of(kind)[:, list(order)] + 1)
    assert found[10][:, -1].tolist() == [2, largest]
    back = read_bytes(data, "x.meshb")
    check(back, sample.grouped())
    assert back.cell_data["reference"].tolist() == [2, largest, 3, 4, 1]


def test_R8_what_has_no_place_is_told() -> None:
    mesh = numbered()
    mesh.cell_data["reference"] = np.arange(5) / 2
    mesh.cell_data["pair"] = np.zeros((5, 2))
    mesh.cell_data["long"] = np.array([0, 1, 2, 3, 2**60])
    told = {row.id: " ".join(left_behind(mesh, row)) for row in WRITERS}
    assert (
        "reference (of cells)" in told["mesh"]
        and "numbers of nodes" in told["mesh"]
        and "order" in told["meshb"]
    )
    assert "attributes pair (of cells), long (of cells):" in told["msh"]
    assert "height" not in told["msh"] and "numbers" not in told["msh2"]
    assert told["vtk"] == told["vtu"] == ""
    twice = replace(mesh, cell_numbers=np.array([1, 1, 2, 3, 4]))
    assert "occur twice" in " ".join(left_behind(twice, writer_of(Path("x.inp"))))
    back = read_bytes(write_bytes(twice, "inp"), "x.inp")
    assert back.cell_numbers is None


def test_A1_gzipped_by_its_name_and_the_same_each_time(tmp_path: Path) -> None:
    mesh = numbered()
    write(mesh, tmp_path / "x.msh.gz")
    data = (tmp_path / "x.msh.gz").read_bytes()
    assert gzip.decompress(data) == write_bytes(mesh, "msh")
    write(mesh, tmp_path / "x.msh.gz")
    assert (tmp_path / "x.msh.gz").read_bytes() == data


def test_A1_one_entity_for_each_group_of_a_volume() -> None:
    """A volume of the file whose cells belong to two groups can't be one volume in `.msh` 4.1."""
    mesh = sample_mesh(grid(4, 1, 1))
    mesh.cell_data = {"entity": np.array([7, 7, 7, 8]), "physical": np.array([1, 2, 1, 1])}
    back = read_bytes(write_bytes(mesh, "msh"), "x.msh")
    assert back.cell_data["physical"].tolist() == [1, 2, 1, 1]
    assert len(set(back.cell_data["entity"].tolist())) == 3
