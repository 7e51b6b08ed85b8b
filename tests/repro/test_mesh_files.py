"""Bugs that mutants of mesh files found (tests/core/formats/test_mutants.py)."""

from __future__ import annotations

import struct
import warnings

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes

CORNERS = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1"
MSH = (
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n{nodes}\n$EndNodes\n"
    "$Elements\n1\n1 5 0 1 2 3 4 5 6 7 8\n$EndElements\n"
)


@pytest.mark.parametrize("number", ["nan", "inf", "1e300", "1.5"])
def test_R10_a_node_number_that_is_no_whole_number(number: str) -> None:
    rows = [f"{i + 1} {row}" for i, row in enumerate(CORNERS.split("\n"))]
    rows[3] = number + rows[3][1:]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(MeshReadError, match="not whole"):
            read_bytes(MSH.format(nodes="\n".join(rows)).encode(), "x.msh")
        inp = "*NODE\n" + "\n".join(row.replace(" ", ",") for row in rows) + "\n*ELEMENT,TYPE=C3D4\n1,1,2,3,5"
        with pytest.raises(MeshReadError, match="not whole"):
            read_bytes(inp.encode(), "x.inp")


def test_R10_a_signalling_nan_among_binary_coordinates() -> None:
    points = np.array(CORNERS.split(), dtype=">f4").tobytes()
    points = points[:8] + struct.pack(">I", 0x7F800001) + points[12:]
    data = b"# vtk DataFile Version 3.0\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n" + points
    data += b"\nCELLS 1 9\n" + struct.pack(">9i", 8, *range(8)) + b"\nCELL_TYPES 1\n" + struct.pack(">i", 12)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(MeshReadError, match="byte 77: the z coordinate of vertex 1 is nan"):
            read_bytes(data, "x.vtk")


@pytest.mark.parametrize("name", ["DataArray" * 500, "Data\tArray"])
def test_R10_names_in_errors_are_short_and_on_one_line(name: str) -> None:
    data = f'<VTKFile type="UnstructuredGrid\n{name}"><{name.split()[0]}></VTKFile>'.encode()
    with pytest.raises(MeshReadError) as caught:
        read_bytes(data, "x.vtu")
    assert len(str(caught.value)) < 200 and "\n" not in str(caught.value)


def test_R10_hashes_before_a_mesh_do_not_take_for_ever() -> None:
    """The pattern that recognises the format tried every way to split a row of hashes."""
    with pytest.raises(MeshReadError):
        read_bytes(b"#" * 3000 + b" MeshVersion", "x.mesh")


def test_R1_numpy_returns_unwritten_memory_for_a_count_too_large() -> None:
    """`np.fromstring(text, count=n)` does not tell when the text has fewer numbers: a piece that ends early."""
    rows = "\n".join(["1.00000000000000000000000000000000000000000000000000000e+00 0 0 0"] * 6000)
    mesh = f"MeshVersionFormatted 2\nDimension 3\nVertices\n6000\n{rows}\nTetrahedra\n1\n1 2 3 4 0\nEnd\n"
    found = read_bytes(mesh.encode(), "x.mesh").points
    np.testing.assert_array_equal(found, np.tile([1.0, 0, 0], (6000, 1)))
