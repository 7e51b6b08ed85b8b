"""SPEC A1, R1, R7, R8: any mesh survives being written and read, in bounded memory."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hexalab.cells import COLLAPSE, CORNERS_OF_KIND
from hexalab.formats import read_bytes, write_bytes
from hexalab.mesh import Mesh
from tests.core.formats.samples import grid
from tests.core.formats.test_medit import text_of

coordinate = st.floats(allow_nan=False, allow_infinity=False, width=64)
TYPES = ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64")


@st.composite
def meshes(draw: st.DrawFn) -> Mesh:
    """Cells of any kinds in any order on any vertices, corners repeated or not, with attributes."""
    count = draw(st.integers(1, 12))
    points = np.array(draw(st.lists(st.tuples(*[coordinate] * 3), min_size=count, max_size=count)))
    kinds = draw(st.lists(st.integers(0, 3), min_size=1, max_size=9))
    corners = []
    for kind in kinds:
        size = len(CORNERS_OF_KIND[kind])
        own = draw(st.lists(st.integers(0, count - 1), min_size=size, max_size=size))
        corners.append([own[place] for place in COLLAPSE[kind]])
    cell_data, point_data = {}, {}
    for target, rows in ((cell_data, len(kinds)), (point_data, count)):
        for name in draw(st.lists(st.text(min_size=1, max_size=6), unique=True, max_size=3)):
            width, code = draw(st.integers(1, 4)), draw(st.sampled_from(TYPES))
            values = np.array(
                draw(st.lists(st.integers(0, 100), min_size=rows * width, max_size=rows * width))
            )
            target[name] = values.astype(code).reshape(rows, width) if width > 1 else values.astype(code)
    return Mesh(
        points.T, np.array(corners).T, np.array(kinds), point_data, cell_data, name=draw(st.text(max_size=9))
    )


@settings(max_examples=150, deadline=None)
@given(meshes(), st.sampled_from(["vtk", "vtu"]))
def test_A1_R8_any_mesh_survives_the_formats_of_vtk(mesh: Mesh, format_id: str) -> None:
    back = read_bytes(write_bytes(mesh, format_id), f"x.{format_id}")
    np.testing.assert_array_equal(back.coordinates, mesh.coordinates)
    np.testing.assert_array_equal(back.corners, mesh.corners)
    np.testing.assert_array_equal(back.kinds, mesh.kinds)
    for found, wanted in ((back.cell_data, mesh.cell_data), (back.point_data, mesh.point_data)):
        assert len(found) == len(wanted)
        for (_, values), (_, original) in zip(found.items(), wanted.items(), strict=True):
            assert values.dtype == original.dtype
            np.testing.assert_array_equal(values, original)


@settings(max_examples=150, deadline=None)
@given(meshes())
def test_A1_R1_any_mesh_survives_medit(mesh: Mesh) -> None:
    back = read_bytes(write_bytes(mesh, "mesh"), "x.mesh")
    order = np.argsort(mesh.kinds, kind="stable")
    np.testing.assert_array_equal(back.coordinates, mesh.coordinates)
    np.testing.assert_array_equal(back.corners, mesh.corners[:, order])
    np.testing.assert_array_equal(back.kinds, mesh.kinds[order])


@pytest.mark.parametrize("format_id", ["mesh", "vtk", "vtu"])
def test_P7_reading_takes_little_more_memory_than_the_mesh(format_id: str) -> None:
    sample = grid(40, 40, 40)
    data = text_of(sample).encode() if format_id == "mesh" else b""
    mesh = Mesh.from_cells(sample.points, sample.rows_of(0))
    data = data or write_bytes(mesh, format_id)
    size = mesh.coordinates.nbytes + mesh.corners.nbytes + mesh.kinds.nbytes
    tracemalloc.start()
    try:
        read_bytes(data, f"x.{format_id}")
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    blocks = 4 * size if format_id == "vtu" else 0  # the inflated arrays
    assert peak < 2.5 * size + blocks + 4 * 2**20
