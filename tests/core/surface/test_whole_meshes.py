"""Whole meshes drawn: closed, and of as many faces and edges as dictionaries count."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from hexalab.cells import EDGES
from hexalab.formats import read
from hexalab.surface import MODES, DrawnMesh, extract_irregular, extract_silhouette, extract_surface
from tests.core.surface.checks import check_closed, check_form
from tests.whole_meshes import WHOLE_MESHES, WholeMesh

DRAWN = [whole for whole in WHOLE_MESHES if whole.cells < 20_000]

UNORIENTED = "faults/opposite-orientation.mesh"
"""Its faces cannot agree on which way to go round."""

COINCIDENT = ("faults/coincident-vertices.mesh", "faults/zero-volume.mesh")
"""Their edges cannot be told apart by where they are."""

APART = [whole for whole in DRAWN if whole.cells < 9_000 and whole.name not in COINCIDENT]


@cache
def drawing_of(whole: WholeMesh) -> DrawnMesh:
    return DrawnMesh(read(whole.file()))


def cut(drawing: DrawnMesh) -> np.ndarray:
    """Half of the mesh, by an oblique plane, without every ninth cell."""
    height = np.array([0.3, 0.5, 0.8]) @ drawing.mesh.barycentres
    return (height < np.median(height)) & (np.arange(len(height)) % 9 != 0)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("whole", DRAWN, ids=str)
def test_V1_whole_meshes_are_drawn_closed(whole: WholeMesh, mode: str) -> None:
    drawing = drawing_of(whole)
    surface = extract_surface(drawing, cut(drawing), mode)
    check_form(surface)
    if whole.name != UNORIENTED:
        check_closed(surface)
    if mode == "darkness_coded_edges":
        lines = extract_surface(drawing, cut(drawing), "lines")
        assert (lines.edges == surface.edges).all() and (surface.edge_cells >= 1).all()


@pytest.mark.parametrize("whole", DRAWN, ids=str)
def test_V4_whole_meshes_have_the_expected_valences(whole: WholeMesh) -> None:
    counts = extract_irregular(drawing_of(whole)).counts
    for kind, usual in (("interior", "4"), ("boundary", "2")):
        expected = {n: count for n, count in whole.facts()[f"{kind}_edge_valence"].items() if n != usual}
        assert counts[kind] == expected


@pytest.mark.parametrize("whole", DRAWN, ids=str)
def test_V3_whole_meshes_have_a_silhouette(whole: WholeMesh) -> None:
    drawing = drawing_of(whole)
    silhouette = extract_silhouette(drawing, np.zeros(drawing.mesh.cell_count, bool))
    assert (
        len(silhouette.positions) == 12 * drawing.topology.face_cells[0, drawing.topology.faces.boundary].size
    )


@pytest.mark.parametrize("whole", APART, ids=str)
def test_V1_whole_meshes_count_the_cells_around_edges(whole: WholeMesh) -> None:
    """Against a list of all pairs of shown cell and edge."""
    drawing = drawing_of(whole)
    mesh, shown = drawing.mesh, cut(drawing)
    ends = np.concatenate([np.sort(mesh.cells[:, list(pair)], axis=1) for pair in EDGES])
    cells = np.tile(np.arange(mesh.cell_count), 12)
    real = (ends[:, 0] != ends[:, 1]) & shown[cells]
    pairs = np.unique(np.column_stack([ends, cells])[real], axis=0)
    edges, around = np.unique(pairs[:, :2], axis=0, return_counts=True)
    expected = {tuple(edge): int(count) for edge, count in zip(edges.tolist(), around, strict=True)}
    place = {tuple(point): i for i, point in enumerate(drawing.coordinates.T.tolist())}
    surface = extract_surface(drawing, shown, "darkness_coded_edges")
    drawn = [
        tuple(sorted((place[tuple(a)], place[tuple(b)]))) for a, b in surface.edges.reshape(-1, 2, 3).tolist()
    ]
    assert len(set(drawn)) == len(drawn)
    assert [expected[edge] for edge in drawn] == surface.edge_cells.tolist()
