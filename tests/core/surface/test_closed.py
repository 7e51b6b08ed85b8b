"""Every mode, every kind of cell: closed, outward, well formed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from hexalab.mesh import Mesh
from hexalab.surface import MODES, DrawnMesh, extract_surface
from tests.core.surface.checks import (
    cell_volumes,
    check_closed,
    check_form,
    check_manifold,
    points_of,
    rings_of,
    volume,
)
from tests.core.surface.shapes import KINDS, grid, mesh_of, random_mask, split_grid, unit_cube

SHARES = (0.1, 0.5, 0.9, 0.97)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("jitter", [0.0, 0.12])
def test_V1_closed_whatever_is_hidden(kind: str, mode: str, jitter: float) -> None:
    mesh = split_grid(kind, 4, jitter)
    drawing = DrawnMesh(mesh)
    volumes = cell_volumes(mesh.points, mesh.cells)
    for seed, share in enumerate(SHARES):
        shown = random_mask(mesh.cell_count, seed, share)
        surface = extract_surface(drawing, shown, mode)
        check_form(surface)
        check_closed(surface)
        assert volume(surface) > 0
        if "edges" in mode or mode == "lines":
            assert volume(surface) * mesh.diagonal**3 == pytest.approx(volumes[shown].sum(), rel=1e-4)
        assert set(surface.cells.tolist()) <= set(np.flatnonzero(shown).tolist())


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("kind", KINDS)
def test_V1_everything_shown_is_a_manifold(kind: str, mode: str) -> None:
    """Lines draw the mesh's boundary; in the other modes cells inside touch nothing that is exposed."""
    mesh = split_grid(kind, 3)
    surface = extract_surface(DrawnMesh(mesh), np.ones(mesh.cell_count, bool), mode)
    if mode in ("lines", "darkness_coded_edges"):
        check_manifold(surface)
        assert (surface.inside == 0).all()
    check_closed(surface)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("kind", KINDS)
def test_V1_each_cell_alone_is_a_manifold(kind: str, mode: str) -> None:
    """All corners exposed: each cell is a closed body of its own."""
    mesh = split_grid(kind, 2)
    drawing = DrawnMesh(mesh)
    for cell in range(0, mesh.cell_count, 5):
        shown = np.zeros(mesh.cell_count, bool)
        shown[cell] = True
        surface = extract_surface(drawing, shown, mode)
        check_form(surface)
        check_manifold(surface)
        middle = drawing.barycentres(np.array([cell]))[:, 0]
        normals = surface.normals.reshape(-1, 4)[:, :3]
        assert ((points_of(surface) - middle) * normals).sum(axis=1).min() > 0


@pytest.mark.parametrize("mode", MODES)
def test_V1_normals_point_out_of_the_cell(mode: str) -> None:
    mesh = grid(4, 4, 4, jitter=0.1)
    drawing = DrawnMesh(mesh)
    shown = mesh.barycentres.sum(axis=0) < 7
    surface = extract_surface(drawing, shown, mode)
    middles = drawing.barycentres(surface.cells)
    outward = points_of(surface) - middles.T
    assert ((surface.normals.reshape(-1, 4)[:, :3] * outward).sum(axis=1) > 0).all()


@pytest.mark.parametrize("mode", MODES)
def test_V1_nothing_shown_and_no_mesh(mode: str) -> None:
    mesh = grid(2, 2, 2)
    empty = mesh_of(np.empty((0, 3)), np.empty((0, 8), np.int32))
    for some in (mesh, empty):
        surface = extract_surface(DrawnMesh(some), np.zeros(some.cell_count, bool), mode)
        check_form(surface)
        assert len(surface.faces) == len(surface.cells) == len(surface.edges) == 0


def test_V1_unknown_mode_is_refused() -> None:
    with pytest.raises(ValueError, match="crack"):
        extract_surface(DrawnMesh(unit_cube()), np.ones(1, bool), "crack")


@pytest.mark.parametrize("mode", MODES)
def test_V1_far_from_the_origin_and_of_any_size(mode: str) -> None:
    """DrawnMesh coordinates are found in float64: neither place nor size of the mesh shows."""
    mesh = grid(2, 2, 2, jitter=0.1)
    shown = np.array([1, 1, 0, 1, 1, 0, 1, 1], bool)
    here = extract_surface(DrawnMesh(mesh), shown, mode)
    for scale, shift in ((1e-9, 0.0), (1e9, 0.0), (1.0, 1e6)):
        there = DrawnMesh(Mesh(mesh.coordinates * scale + shift, mesh.corners, mesh.kinds))
        surface = extract_surface(there, shown, mode)
        assert np.allclose(surface.positions, here.positions, atol=1e-6)
        assert (np.abs(surface.positions) <= 0.5001).all()
        assert (np.abs(surface.normals.astype(int) - here.normals) < 60).all()


@pytest.mark.parametrize("mode", MODES)
def test_V1_flat_cells_get_normals(mode: str) -> None:
    """Cells and faces without area: the normal points from the cell's barycentre, and is always a number."""
    flat = replace(flat := grid(2, 2, 2), coordinates=flat.coordinates * [[1], [1], [0]])
    needle = replace(needle := grid(2, 1, 1), coordinates=needle.coordinates * [[1], [0], [0]])
    point = replace(point := grid(1, 1, 1), coordinates=np.full_like(point.coordinates, 3))
    one_face = unit_cube()
    apex = np.where(np.arange(8) < 4, one_face.coordinates, [[0.5], [0.5], [1]])
    one_face = replace(one_face, coordinates=apex)
    for mesh in (flat, needle, point, one_face):
        surface = extract_surface(DrawnMesh(mesh), np.ones(mesh.cell_count, bool), mode)
        check_form(surface)
    if mode != "rounded":
        up = surface.normals.reshape(-1, 4)[np.repeat(surface.faces % 8 == 1, 4)]
        assert (up[:, 2] > 30000).all()


@pytest.mark.parametrize("mode", MODES)
def test_V1_inside_tells_what_filters_expose(mode: str) -> None:
    mesh = grid(3, 3, 3, turned=False)
    shown = mesh.barycentres[2] < 2
    surface = extract_surface(DrawnMesh(mesh), shown, mode)
    height = (points_of(surface)[:, 2] * mesh.diagonal + mesh.centre[2])[rings_of(surface)]
    up = surface.normals.reshape(-1, 4)[:, 2][rings_of(surface)]
    ring_inside = surface.inside[rings_of(surface)]
    cut = (height > 1.8).all(axis=1) & (up > 32000).all(axis=1)
    bottom = (height < 0.2).all(axis=1) & (up < -32000).all(axis=1)
    assert cut.any() and (ring_inside[cut] == 255).any(axis=1).all()
    assert bottom.any() and (ring_inside[bottom] == 0).all()
    assert set(surface.inside.tolist()) == {0, 255}
    if mode == "rounded":
        outer = mesh.topology.cell_faces[surface.faces % 8, surface.faces // 8] >= mesh.topology.faces.paired
        assert (ring_inside[outer] == 0).all()
