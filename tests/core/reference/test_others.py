"""Surfaces in formats of meshes: faces of files without cells, and the boundaries of volumetric meshes."""

from __future__ import annotations

import gzip
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hexalab.diagnosis import TURNED
from hexalab.errors import MeshReadError, NoCellsError
from hexalab.formats import WRITERS, read_bytes, write_bytes
from hexalab.mesh import Mesh
from hexalab.reference import boundary_of, read_reference, read_reference_bytes
from hexalab.reference.cutting import triangles_of
from tests.core.conftest import grid_points, legacy_vtk, medit
from tests.core.formats.samples import mixed
from tests.core.reference.surfaces import CUBE, CUBE_QUADS, assert_same, ball, by_meshio
from tests.tools import tool

gmsh = tool("gmsh")

POINTS, TRIANGLES = ball(1)
POINTS = np.round(POINTS * 256) / 256  # short in decimals, too
KITE = np.concatenate([POINTS, [[5, 0, 0], [7, 0, 0], [7, 1, 0], [5, 2, 0]]])
COUNT = len(POINTS)


def expected() -> Any:
    """The triangles, and the quadrilateral behind them, cut along the diagonal from its second to its fourth corner."""
    return np.concatenate(
        [KITE[TRIANGLES], KITE[[[COUNT, COUNT + 1, COUNT + 2], [COUNT, COUNT + 2, COUNT + 3]]]]
    )


@pytest.mark.parametrize(
    ("ending", "file_format", "options"),
    [
        (".mesh", "medit", {}),
        (".meshb", "medit", {}),
        (".vtk", "vtk42", {"binary": False}),
        (".vtk", "vtk42", {"binary": True}),
        (".vtk", "vtk51", {"binary": True}),
        (".vtu", "vtu", {"binary": False}),
        (".vtu", "vtu", {"binary": True, "compression": "zlib"}),
        (".msh", "gmsh22", {"binary": False}),
        (".msh", "gmsh22", {"binary": True}),
        (".inp", "abaqus", {}),
        (".inp", "avsucd", {}),
    ],
)
def test_surfaces_that_meshio_writes(ending: str, file_format: str, options: dict[str, Any]) -> None:
    blocks = [("triangle", TRIANGLES), ("quad", np.arange(4)[None] + COUNT)]
    data = by_meshio(KITE, blocks, file_format, ending=ending, **options)
    found = read_reference_bytes(data, f"x{ending}")
    assert_same(found, expected())
    assert found.name == f"x{ending}" and found.rows is None
    with pytest.raises(NoCellsError, match=r"no volumetric cells, only .*: expected hexahedra"):
        read_bytes(data, f"x{ending}")


def test_a_surface_that_gmsh_writes(tmp_path: Path) -> None:
    files = [
        tmp_path / name for name in ("x.msh", "y.msh", "x.stl", "x.off", "x.mesh", "x.vtk", "x.inp", "x.obj")
    ]
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.model.occ.addSphere(0, 0, 0, 1)
        gmsh.model.occ.synchronize()
        gmsh.model.mesh.generate(2)
        for file in files:
            gmsh.option.setNumber("Mesh.MshFileVersion", 4.1 if file.name == "x.msh" else 2.2)
            gmsh.write(str(file))
        _, places, _ = gmsh.model.mesh.getNodes()
    finally:
        gmsh.finalize()
    surfaces = [read_reference(file) for file in files if file.is_file() and file.stat().st_size]
    assert len(surfaces) == len(files)
    for found in surfaces:
        assert found.closed, found.name
        assert (
            found.volume == pytest.approx(surfaces[0].volume, rel=1e-5) and 3.9 < found.volume < 4 * np.pi / 3
        )
        assert found.count == surfaces[0].count and len(found.vertices_used) <= len(places) / 3


def test_what_the_error_carries() -> None:
    data = by_meshio(KITE, [("triangle", TRIANGLES), ("line", np.array([[0, 1]]))], "vtu")
    with pytest.raises(NoCellsError) as caught:
        read_bytes(data, "x.vtu")
    assert isinstance(caught.value, MeshReadError) and caught.value.format == "vtu"
    assert (caught.value.coordinates.T == KITE).all()
    assert [(part.dimension, part.count) for part in caught.value.features] == [(1, 1), (2, len(TRIANGLES))]


def test_a_file_with_neither_faces_nor_cells() -> None:
    data = by_meshio(KITE, [("line", np.array([[0, 1], [1, 2]]))], "vtu")
    with pytest.raises(
        MeshReadError, match=r"^x\.vtu: the file has neither faces nor volumetric cells, expected a surf"
    ):
        read_reference_bytes(data, "x.vtu")


def test_faces_that_refer_to_nothing_or_to_one_vertex_twice_are_left_out() -> None:
    text = (
        "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTriangles\n4\n"
    )
    found = read_reference_bytes((text + "1 2 3 0\n1 1 2 0\n1 2 5 0\n1 3 4 0\nEnd\n").encode(), "x.mesh")
    assert found.triangles.T.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert found.notes == (
        "1 triangle refers to vertices that are not there: left out.",
        "Left out, as they have a vertex twice: triangles (1).",
    )


def test_what_else_is_left_out_is_told() -> None:
    """Rigid facets of Abaqus are faces; springs are none."""
    text = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n*ELEMENT, TYPE=R3D3\n1, 1, 2, 3\n"
    found = read_reference_bytes((text + "*ELEMENT, TYPE=SPRINGA\n2, 1, 2\n3, 2, 3\n").encode(), "x.inp")
    assert found.triangles.T.tolist() == [[0, 1, 2]]
    assert found.notes == ("Left out, as they are no faces: elements of type SPRINGA (2).",)


@pytest.mark.parametrize("row", [row.id for row in WRITERS])
def test_the_boundary_of_a_volumetric_mesh_in_every_format(row: str) -> None:
    sample = mixed()
    cells = [ids for kind, ids in sample.cells if kind == 0][:1]
    mesh = Mesh.from_cells(sample.points, cells)
    found = read_reference_bytes(write_bytes(mesh, row), "x")
    assert_same(found, boundary_of(mesh).points.T[boundary_of(mesh).triangles.T])
    assert found.notes[-1] == "The surface is the boundary of a volumetric mesh of 1 cell."
    assert found.name == "x" and found.rows is not None and (found.rows == np.arange(8)).all()


def test_a_mesh_that_is_inside_out_is_turned_round() -> None:
    points, cells = grid_points((2, 3, 4))
    found = read_reference_bytes(medit(points, cells[:, [4, 5, 6, 7, 0, 1, 2, 3]]), "x.mesh")
    assert found.volume == pytest.approx(24, rel=1e-12) and found.closed
    assert found.notes == (TURNED, "The surface is the boundary of a volumetric mesh of 24 cells.")


def test_a_mesh_without_a_boundary() -> None:
    points, cells = grid_points((1, 1, 1))
    folded = np.concatenate([cells, cells[:, [0, 3, 2, 1, 4, 7, 6, 5]], cells[:, [4, 5, 6, 7, 0, 1, 2, 3]]])
    data = legacy_vtk(points, folded)
    assert read_reference_bytes(data, "x.vtk").closed, "cells that repeat another count once"


def test_gzipped_by_content_and_from_paths_and_streams(tmp_path: Path) -> None:
    ids = CUBE_QUADS.reshape(-1)
    cut = triangles_of(CUBE.T, ids, range(0, 24, 4), np.full(6, 4))
    text = "".join("v {} {} {}\n".format(*point) for point in CUBE.tolist())
    text += "".join("f {} {} {} {}\n".format(*quad) for quad in (CUBE_QUADS + 1).tolist())
    for name, data in (("x.obj", text.encode()), ("x.obj.gz", gzip.compress(text.encode()))):
        path = tmp_path / name
        path.write_bytes(data)
        for found in (
            read_reference(path),
            read_reference(str(path)),
            read_reference_bytes(bytearray(data), name),
        ):
            assert_same(found, CUBE[cut.T])
            assert found.name == name
        with path.open("rb") as stream:
            assert read_reference(stream).count == 12
    assert read_reference_bytes(gzip.compress(text.encode()), "x").count == 12
    with pytest.raises(MeshReadError, match=r"nothing\.stl: the file can't be read"):
        read_reference(tmp_path / "nothing.stl")


@pytest.mark.parametrize(
    ("data", "name", "words"),
    [
        (b"", "x.stl", "the file is empty"),
        (b"\x89PNG\r\n\x1a\n", "x.stl", "the file is a PNG picture"),
        (b"hello", "x.txt", r"neither the content nor the name tells of a known format, expected one of \.stl, \.obj, "
         r"\.off, \.ply, \.vtp, \.mesh, \.vtk"),
        (b'(0 "GAMBIT to Fluent File")\n', "x.msh", "this is a Fluent mesh, which is not read: convert it"),
        (b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_GRID\n", "x.vtk", "a structured grid"),
    ],
)  # fmt: skip
def test_what_is_no_surface(data: bytes, name: str, words: str) -> None:
    with pytest.raises(MeshReadError, match=rf"^{name}.*: .*{words}"):
        read_reference_bytes(data, name)
