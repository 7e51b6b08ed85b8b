"""Topology of the published meshes against the facts that dictionaries found."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from hexalab.diagnosis import diagnose
from hexalab.formats import read


def test_R7_topology_of_published_meshes(meshes: Path, expected: dict[str, Any]) -> None:
    for name, facts in expected.items():
        mesh = read(meshes / name)
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
        assert found == {key: facts[key] for key in found}, name


def test_R9_findings_in_published_meshes(meshes: Path, expected: dict[str, Any]) -> None:
    """What Verdict's smallest volume and Jacobian tell is among the findings, and nothing against it."""
    for name, facts in expected.items():
        found = {finding.id: finding for finding in diagnose(read(meshes / name))}
        verdict = facts["verdict"]
        assert ("inverted_cells" in found) == (verdict["volume"]["min"] < 0), name
        assert ("invalid_corner_cells" in found) == (verdict["jacobian"]["min"] <= 0), name
        repeated = found["repeated_vertices"].count if "repeated_vertices" in found else 0
        assert repeated == facts["cells_repeating_a_vertex"], name
        assert ("unreferenced_vertices" in found) == bool(facts["unreferenced_vertices"]), name
        for finding in found.values():
            assert len(np.unique(finding.cells)) == len(finding.cells)
