"""Topology of whole meshes against the facts that dictionaries found."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.cells import HEXAHEDRON
from hexalab.diagnosis import diagnose
from hexalab.formats import read
from tests.whole_meshes import HEXAHEDRAL, WHOLE_MESHES, WholeMesh, plain


@pytest.mark.parametrize("whole", WHOLE_MESHES, ids=str)
def test_R7_topology_of_whole_meshes(whole: WholeMesh) -> None:
    mesh, facts = read(whole.file()), whole.facts()
    t = mesh.topology
    found = {
        "vertices": mesh.vertex_count,
        "cells": mesh.cell_count,
        "faces": t.face_count,
        "boundary_faces": t.boundary_face_count,
        "nonmanifold_faces": t.nonmanifold_face_count,
        "edges": t.edge_count,
        "interior_edge_valence": {str(valence): n for valence, n in t.interior_edge_valence.items()},
        "boundary_edge_valence": {str(valence): n for valence, n in t.boundary_edge_valence.items()},
        "cells_per_depth": t.cells_per_depth,
        "face_connected_components": t.component_count,
        "cells_repeating_a_vertex": int(t.repeating_cells.sum()),
        "unreferenced_vertices": int((~mesh.referenced).sum()),
    }
    assert found == {key: facts[key] for key in found}


@pytest.mark.parametrize("whole", HEXAHEDRAL, ids=str)
def test_R9_findings_in_whole_meshes(whole: WholeMesh) -> None:
    """What Verdict's smallest volume and Jacobian tell is among the findings, and nothing against it."""
    found = {finding.id: finding for finding in diagnose(read(whole.file()))}
    facts, verdict = whole.facts(), whole.verdict()
    least = verdict["jacobian"]["min"]
    if (
        whole.own
    ):  # where Verdict's values of all cells are known: a corner that is collapsed is no invalid one
        cells = plain(whole.name)[1][HEXAHEDRON]
        distinct = [len(set(cell)) == 8 for cell in cells.tolist()]
        least = np.array(verdict["jacobian"]["first8"])[distinct].min()
    assert ("inverted_cells" in found) == (verdict["volume"]["min"] < 0)
    assert ("invalid_corner_cells" in found) == (least <= 0)
    repeated = found["repeated_vertices"].count if "repeated_vertices" in found else 0
    assert repeated == facts["cells_repeating_a_vertex"]
    assert ("unreferenced_vertices" in found) == bool(facts["unreferenced_vertices"])
    for finding in found.values():
        assert len(np.unique(finding.cells)) == len(finding.cells)
