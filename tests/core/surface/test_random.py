"""Surfaces of random masks and random meshes, by hypothesis."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from hexalab.surface import MODES, DrawnMesh, extract_irregular, extract_silhouette, extract_surface
from tests.core.surface.checks import check_closed, check_form
from tests.core.surface.shapes import grid, mesh_of, random_mask
from tests.core.surface.test_fissure import check as check_fissure
from tests.core.surface.test_irregular import check as check_irregular
from tests.core.surface.test_lines import check_against_dictionaries
from tests.core.surface.test_rounded import check_lattice
from tests.core.topology.strategies import meshes

SHARES = (0.1, 0.5, 0.9, 0.97)


@given(
    st.tuples(*[st.integers(1, 3)] * 3),
    st.integers(0, 2**31),
    st.sampled_from(SHARES),
    st.sampled_from(MODES),
)
@settings(max_examples=150, deadline=None)
def test_V1_closed_on_random_masks(shape: tuple[int, int, int], seed: int, share: float, mode: str) -> None:
    mesh = grid(*shape, jitter=0.1)
    surface = extract_surface(DrawnMesh(mesh), random_mask(mesh.cell_count, seed, share), mode)
    check_form(surface)
    check_closed(surface)


@given(meshes, st.integers(0, 2**31), st.sampled_from(MODES))
@settings(max_examples=300, deadline=None)
def test_V1_any_cells_are_drawn(cells: np.ndarray, seed: int, mode: str) -> None:
    """Cells that share faces by three, repeat corners across, are a single point: no error, a sound form."""
    random = np.random.default_rng(seed)
    mesh = mesh_of(random.random((int(cells.max(initial=0)) + 2, 3)), cells)
    drawing = DrawnMesh(mesh)
    shown = random_mask(mesh.cell_count, seed, 0.7)
    surface = extract_surface(drawing, shown, mode)
    check_form(surface)
    assert shown[np.unique(surface.cells)].all()
    extract_silhouette(drawing, shown)
    irregular = extract_irregular(drawing)
    assert len(irregular.barb_valence) == 2 * len(irregular.paper_valence)


@given(st.tuples(*[st.integers(1, 4)] * 3), st.integers(0, 2**31), st.floats(0, 1))
@settings(max_examples=100, deadline=None)
def test_V1_faces_edges_and_counts_on_random_masks(
    shape: tuple[int, int, int], seed: int, share: float
) -> None:
    mesh = grid(*shape)
    check_against_dictionaries(mesh, random_mask(mesh.cell_count, seed, share))


@given(st.tuples(*[st.integers(1, 4)] * 3), st.integers(0, 2**31), st.floats(0, 1), st.floats(0.04, 0.2))
@settings(max_examples=60, deadline=None)
def test_V1_fissure_on_random_masks(shape: tuple[int, int, int], seed: int, share: float, gap: float) -> None:
    mesh = grid(*shape, jitter=0.1)
    check_fissure(mesh, random_mask(mesh.cell_count, seed, share), gap)


@given(st.tuples(*[st.integers(1, 2)] * 3), st.integers(0, 2**31), st.floats(0.3, 1), st.floats(0.04, 0.2))
@settings(max_examples=40, deadline=None)
def test_V1_rounded_is_the_lattice(
    shape: tuple[int, int, int], seed: int, share: float, radius: float
) -> None:
    mesh = grid(*shape, jitter=0.1)
    check_lattice(mesh, random_mask(mesh.cell_count, seed, share), radius)


@given(st.tuples(*[st.integers(1, 3)] * 3), st.integers(0, 2**31), st.floats(0.3, 1))
@settings(max_examples=40, deadline=None)
def test_V4_irregular_edges_of_torn_grids(shape: tuple[int, int, int], seed: int, share: float) -> None:
    mesh = grid(*shape, jitter=0.1)
    kept = random_mask(mesh.cell_count, seed, share)
    check_irregular(mesh_of(mesh.points, mesh.cells[kept]))
