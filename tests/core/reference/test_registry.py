"""What a file is: told by its content, else by its name, at once."""

from __future__ import annotations

import gzip

import pytest

from hexalab.formats.foreign import foreign
from hexalab.formats.registry import HEAD
from hexalab.reference import REFERENCE_FORMATS, is_surface
from hexalab.reference.registry import format_of
from tests.core.formats.mutants import seeds
from tests.core.reference.test_stl import TETRAHEDRON, binary, in_text

SAMPLES = {
    "stl": [in_text(TETRAHEDRON[:3]).encode(), binary(TETRAHEDRON[:3]), binary(TETRAHEDRON[:3], header=b"solid"),
            b"solid", b" \nSolid facet"],
    "obj": [b"v 0 0 0\n", b"# x\nmtllib a.mtl\no b\n\ng c\nusemtl d\ns off\nvn 0 0 1\nvt 0 0\nv 1.0 -.5 +2 1 1 1\n",
            b"\xef\xbb\xbfv\t1 2\t3"],
    "off": [b"OFF\n8 6 0\n", b"# x\nCOFF 8 6 0", b"OFF BINARY\n", b"STCNOFF\n", b"off\n", b"4OFF\n", b"OFF8 6 0\n"],
    "ply": [b"ply\nformat ascii 1.0\n", b"ply\r\nformat", b"ply\rformat"],
    "polydata": [b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n",
                 b"# vtk DataFile Version 5.1\r\nASCII\r\nBINARY\r\nDATASET POLYDATA\r\n"],
    "vtp": [b'<?xml version="1.0"?>\n<!-- x -->\n<VTKFile type="PolyData" version="1.0">',
            b"<VTKFile version='0.1' type='PolyData'>"],
}  # fmt: skip


def test_each_format_has_samples() -> None:
    assert list(SAMPLES) == [row.id for row in REFERENCE_FORMATS]


@pytest.mark.parametrize("row", SAMPLES)
@pytest.mark.parametrize("name", ["", "x.vtk", "x.mesh", "x.xyz"])
def test_told_by_content(row: str, name: str) -> None:
    for data in SAMPLES[row]:
        found = format_of(data, name)
        assert found is not None and found.id == row, data
        assert is_surface(data, name)
        assert is_surface(gzip.compress(data), f"{name}.gz") or row == "stl"


@pytest.mark.parametrize("row", [row for row in REFERENCE_FORMATS if row.extensions])
def test_told_by_name_where_the_content_does_not_tell(row: object) -> None:
    for name in (f"x{row.extensions[0]}", f"X{row.extensions[0].upper()}.gz"):  # type: ignore[attr-defined]
        found = format_of(b"\1\2\3", name)
        assert found is row and is_surface(b"\1\2\3", name)
        assert is_surface(gzip.compress(b"\1\2\3"), name)


@pytest.mark.parametrize("name", ["", "x.stl", "x.obj", "x.off", "x.ply", "x.vtp"])
def test_meshes_are_no_surfaces_whatever_their_names(name: str) -> None:
    for _, data in seeds():
        assert not is_surface(data, name)
        assert not is_surface(data[:HEAD], name)


def test_from_the_first_bytes_alone() -> None:
    many = binary(*[TETRAHEDRON[:3]] * 500)
    assert is_surface(many, "x") and not is_surface(many[:HEAD], "x") and is_surface(many[:HEAD], "x.stl")
    whole = gzip.compress(in_text(*[TETRAHEDRON[:3]] * 5000).encode())
    assert is_surface(whole[:100], "x")
    assert not is_surface(b"\x1f\x8b nothing", "x")


def test_nothing_that_is_no_surface() -> None:
    for data in (
        b"",
        b"hello",
        b"*NODE\n1, 2, 3, 4\n",
        b"vertices 1 2 3",
        b"v 1 2\n",
        b"solidarity",
        b"OFFICE",
        b"plywood",
    ):
        assert not is_surface(data, "x.txt")


def test_all_that_are_surfaces_are_named_as_such_by_formats() -> None:
    for row, samples in SAMPLES.items():
        endings = next(one.extensions for one in REFERENCE_FORMATS if one.id == row)
        if row not in ("polydata", "vtp"):
            data = samples[0]
            found = foreign(data[:HEAD], f"x{endings[0]}", len(data))
            assert found is not None and "as a reference" in found.advice
