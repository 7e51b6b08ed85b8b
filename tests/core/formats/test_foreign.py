"""SPEC R6: formats that are not read are named as what they are, with what to do."""

from __future__ import annotations

from pathlib import Path

import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from hexalab.formats.foreign import FOREIGN, foreign
from tests.core.formats.mutants import seeds
from tests.tools import tool

gmsh = tool("gmsh")
meshio = tool("meshio")

SAMPLES = {
    "a Fluent mesh": ("x.msh", b'(0 "GAMBIT to Fluent File")\n\n(0 "Dimension:")\n(2 3)\n'),
    "a GiD mesh": (
        "x.msh",
        b'# made by GiD\nMESH "solid" dimension 3 ElemType Hexahedra Nnode 8\nCoordinates\n',
    ),
    "a FreeFem mesh": ("x.msh", b"8 6 12\n0 0 0 1\n1 0 0 1\n"),
    "a Netgen mesh": ("x.vol", b"mesh3d\ndimension\n3\n"),
    "a Nastran bulk data file": ("x.bdf", b"$ a comment\nBEGIN BULK\nGRID,1,,0.,0.,0.\n"),
    "an I-deas universal file": ("x.unv", b"    -1\n  2411\n         1         1\n"),
    "an LS-DYNA deck": ("x.inp", b"$ a comment\n*KEYWORD\n*NODE\n"),
    "an OpenFOAM file": ("points", b"/*---- OpenFOAM ----*/\nFoamFile\n{\n version 2.0;\n"),
    "an STL surface": ("x.stl", b"solid cube\n facet normal 0 0 1\n"),
    "a PLY file": ("x.ply", b"ply\nformat ascii 1.0\n"),
    "an OFF surface": ("x.off", b"OFF\n8 6 0\n"),
    "a binary STL surface": ("x.stl", b"solid, says the header".ljust(80) + b"\1\0\0\0" + b"\1" * 50),
    "an OBJ surface": ("x.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
}


def test_each_has_a_sample() -> None:
    assert [row.name for row in FOREIGN] == list(SAMPLES)


@pytest.mark.parametrize("name", SAMPLES)
def test_R6_it_is_named(name: str) -> None:
    file, data = SAMPLES[name]
    with pytest.raises(MeshReadError) as error:
        read_bytes(data, file)
    assert f"this is {name}, which is not read: " in str(error.value)
    assert ".vtu" in str(error.value)


@pytest.mark.parametrize("name", [name for name in SAMPLES if "surface" in name or "PLY" in name])
def test_R6_a_surface_can_be_opened_as_a_reference(name: str) -> None:
    file, data = SAMPLES[name]
    with pytest.raises(
        MeshReadError, match=r"as a reference to measure a mesh against; expected a volumetric mesh"
    ):
        read_bytes(data, file)


def test_R6_a_binary_surface_is_known_by_its_size() -> None:
    file, data = SAMPLES["a binary STL surface"]
    with pytest.raises(MeshReadError, match="neither the content nor the name tells"):
        read_bytes(data[:-1], file)


@pytest.mark.parametrize(
    ("ending", "name"),
    [
        (".unv", "an I-deas universal file"),
        (".bdf", "a Nastran bulk data file"),
        (".stl", "an STL surface"),
        (".ply2", None),
        (".key", "an LS-DYNA deck"),
    ],
)
def test_R6_what_gmsh_writes(tmp_path: Path, ending: str, name: str | None) -> None:
    path = tmp_path / f"x{ending}"
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
        gmsh.model.occ.synchronize()
        gmsh.model.mesh.generate(3)
        gmsh.write(str(path))
    finally:
        gmsh.finalize()
    found = foreign(path.read_bytes()[:8192], path.name)
    assert (found.name if found else None) == name


def test_no_file_that_is_read_is_taken_for_another() -> None:
    assert not [name for name, data in seeds() if foreign(data[:8192], name)]
