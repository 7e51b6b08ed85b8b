"""SPEC R1, R3 on whole meshes: the repository's own, and the published ones where they are here."""

from __future__ import annotations

import gzip

import numpy as np
import pytest

from hexalab.cells import KINDS
from hexalab.formats import read, read_bytes, write_bytes
from tests.whole_meshes import OWN, WHOLE_MESHES, WholeMesh, plain

TO_AND_FRO = (
    "structures/collapsed.mesh", "structures/heated-plate.vtk", "shapes/knot.mesh", "faults/unreferenced-vertices.mesh",
    "2021-at-most-hexa--cylinder-n-slivers.mesh", "2019-symmetric-moving-frames--hex-fanpart.vtk",
)  # fmt: skip


@pytest.mark.parametrize("whole", WHOLE_MESHES, ids=str)
def test_R1_R3_whole_meshes_have_the_expected_counts(whole: WholeMesh) -> None:
    mesh, facts = read(whole.file()), whole.facts()
    assert (mesh.vertex_count, mesh.cell_count) == (facts["vertices"], facts["cells"])
    assert mesh.cell_count == whole.cells
    if whole.own:
        assert mesh.kind_counts == {KINDS[kind]: len(rows) for kind, rows in plain(whole.name)[1].items()}
    else:
        assert mesh.kind_counts == {"hexahedron": facts["cells"]}
    assert int((~mesh.referenced).sum()) == facts["unreferenced_vertices"]
    ordered = np.sort(mesh.corners, axis=0)
    repeating = (ordered[1:] == ordered[:-1]).any(axis=0)
    assert int(repeating.sum()) == facts["cells_repeating_a_vertex"]


@pytest.mark.parametrize("whole", OWN, ids=str)
def test_R1_R3_our_own_meshes_are_read_number_by_number(whole: WholeMesh) -> None:
    mesh = read(whole.file())
    points, cells = plain(whole.name)
    np.testing.assert_array_equal(mesh.points, points)
    np.testing.assert_array_equal(mesh.cells[mesh.kinds == 0], cells[0])


@pytest.mark.parametrize("whole", [one for one in WHOLE_MESHES if one.name in TO_AND_FRO], ids=str)
def test_A1_whole_meshes_survive_every_format(whole: WholeMesh) -> None:
    mesh = read(whole.file())
    for format_id in ("mesh", "vtk", "vtu"):
        back = read_bytes(gzip.compress(write_bytes(mesh, format_id), 1), f"x.{format_id}.gz")
        np.testing.assert_array_equal(back.coordinates, mesh.coordinates)
        np.testing.assert_array_equal(back.corners, mesh.corners)
