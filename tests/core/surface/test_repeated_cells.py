"""Cells that are there twice: a finding, and each place is drawn once, as without the second."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.diagnosis import diagnose
from hexalab.formats import write_bytes
from hexalab.mesh import Mesh
from hexalab.session import Session
from hexalab.surface import DrawnMesh, extract_silhouette, extract_surface
from tests.core.surface.shapes import grid, split_grid, unit_cube

TURNED = [1, 2, 3, 0, 5, 6, 7, 4]
"""The cell numbered from another corner."""


def with_repeats(mesh: Mesh, *cells: int) -> Mesh:
    """The mesh with some cells there once more, at the end."""
    again = mesh.corners[:, list(cells)][TURNED] if not mesh.kinds.any() else mesh.corners[:, list(cells)]
    kinds = np.concatenate([mesh.kinds, mesh.kinds[list(cells)]])
    return Mesh(mesh.coordinates, np.concatenate([mesh.corners, again], axis=1), kinds)


CASES = {
    "a lone cube": (unit_cube(), (0,)),
    "a lone cube, three times": (unit_cube(), (0, 0)),
    "one in the middle and one at the corner": (grid(3, 3, 3), (13, 0)),
    "all of a grid": (grid(2, 2, 1), (0, 1, 2, 3)),
    "wedges": (split_grid("wedge", 2), (0, 3)),
    "tetrahedra": (split_grid("tetrahedron", 1), (0, 1, 2)),
}


@pytest.mark.parametrize("name", CASES)
def test_R9_a_finding_names_the_second_ones(name: str) -> None:
    mesh, cells = CASES[name]
    found = {one.id: one for one in diagnose(with_repeats(mesh, *cells))}["repeated_cells"]
    assert found.cells.tolist() == list(range(mesh.cell_count, mesh.cell_count + len(cells)))
    assert "repeated_cells" not in {one.id for one in diagnose(mesh)}


def test_R9_cells_that_share_all_vertices_but_one_are_no_repeats() -> None:
    cube = np.arange(8)
    other = np.array([0, 1, 2, 3, 4, 5, 6, 8])
    mesh = Mesh.from_cells(np.random.default_rng(1).random((9, 3)), [cube, other])
    assert not len(mesh.topology.repeated_cells)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("mode", ["lines", "darkness_coded_edges", "fissure", "rounded"])
def test_V1_the_picture_is_that_without_them(name: str, mode: str) -> None:
    mesh, cells = CASES[name]
    alone, twice = DrawnMesh(mesh), DrawnMesh(with_repeats(mesh, *cells))
    for hidden in (None, 0):
        shown = np.ones(mesh.cell_count, dtype=bool)
        if hidden is not None and mesh.cell_count > 1:
            shown[hidden] = False
        also = np.concatenate([shown, shown[list(cells)]])
        expected, found = extract_surface(alone, shown, mode), extract_surface(twice, also, mode)
        for key, values in vars(expected).items():
            if isinstance(values, np.ndarray):
                np.testing.assert_array_equal(vars(found)[key], values, err_msg=key)
        assert len(found.positions) > 0
        np.testing.assert_array_equal(
            extract_silhouette(twice, also).positions, extract_silhouette(alone, shown).positions
        )


def test_R9_a_session_draws_peels_and_tells_them() -> None:
    session = Session()
    session.open("x.vtk", write_bytes(with_repeats(grid(3, 3, 3), 13, 0), "vtk"))
    assert session.update({})["shown_faces"] == 54
    assert session.update({"filters": {"peel": {"depth": 1}}})["shown_faces"] == 6
    found = {one["id"]: one for one in session.describe("findings")["findings"]}
    assert found["repeated_cells"]["count"] == 2
    assert session.finding_cells("repeated_cells").tolist() == [27, 28]
