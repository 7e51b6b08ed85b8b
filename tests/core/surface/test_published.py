"""Published meshes, where they are present: closed, and of as many faces and edges as dictionaries count."""

from __future__ import annotations

import json
import os
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from hexalab.cells import EDGES
from hexalab.formats import read
from hexalab.surface import MODES, DrawnMesh, extract_irregular, extract_silhouette, extract_surface
from tests.core.surface.checks import check_closed, check_form

ROOT = Path(__file__).resolve().parents[3]
MESHES = Path(os.environ.get("HEXALAB_MESHES", ROOT.parent / "shared" / "meshes"))
EXPECTED = MESHES / "expected.json"
FACTS = json.loads(EXPECTED.read_text()) if EXPECTED.exists() else {}
NAMES = [name for name in FACTS if FACTS[name]["cells"] < 20_000]

pytestmark = pytest.mark.skipif(not FACTS, reason="the published meshes are not here")


@cache
def drawing_of(name: str) -> DrawnMesh:
    return DrawnMesh(read(MESHES / name))


def cut(drawing: DrawnMesh) -> np.ndarray:
    """Half of the mesh, by an oblique plane, without every ninth cell."""
    height = np.array([0.3, 0.5, 0.8]) @ drawing.mesh.barycentres
    return (height < np.median(height)) & (np.arange(len(height)) % 9 != 0)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("name", NAMES)
def test_V1_published_meshes_are_drawn_closed(name: str, mode: str) -> None:
    drawing = drawing_of(name)
    surface = extract_surface(drawing, cut(drawing), mode)
    check_form(surface)
    check_closed(surface)
    if mode == "darkness_coded_edges":
        lines = extract_surface(drawing, cut(drawing), "lines")
        assert (lines.edges == surface.edges).all() and (surface.edge_cells >= 1).all()


@pytest.mark.parametrize("name", NAMES)
def test_V4_published_meshes_have_the_expected_valences(name: str) -> None:
    counts = extract_irregular(drawing_of(name)).counts
    for kind, usual in (("interior", "4"), ("boundary", "2")):
        expected = {n: count for n, count in FACTS[name][f"{kind}_edge_valence"].items() if n != usual}
        assert counts[kind] == expected


@pytest.mark.parametrize("name", NAMES)
def test_V3_published_meshes_have_a_silhouette(name: str) -> None:
    drawing = drawing_of(name)
    silhouette = extract_silhouette(drawing, np.zeros(drawing.mesh.cell_count, bool))
    assert (
        len(silhouette.positions) == 12 * drawing.topology.face_cells[0, drawing.topology.faces.boundary].size
    )


@pytest.mark.parametrize("name", [name for name in NAMES if FACTS[name]["cells"] < 9_000])
def test_V1_published_meshes_count_the_cells_around_edges(name: str) -> None:
    """Against a list of all pairs of shown cell and edge."""
    drawing = drawing_of(name)
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
