"""The facts of a mesh, as `hexalab info --json` prints them and the catalogue keeps them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .arrays import Floats
from .cells import HEXAHEDRON
from .diagnosis import diagnose
from .group_facts import all_groups, listed_features
from .mesh import Mesh
from .numbering import cell_numbers, vertex_numbers
from .packing import jsonable
from .quality import METRICS, quality_many, statistics

MOST_NAMED = 20
"""So many cells and vertices of a finding are told by their numbers."""

STATISTICS = ("min", "max", "mean", "median", "variance", "not_finite", "outside_acceptable")
"""The statistics that the facts hold of each metric."""


def summarise(mesh: Mesh, metrics: Iterable[str] = METRICS) -> dict[str, Any]:
    """Collect the facts of a mesh.

    Parameters
    ----------
    mesh : Mesh
    metrics : iterable of str
        Ids of the metrics to measure; all by default.

    Returns
    -------
    dict
        Ready for JSON, with the keys `file`, `format`, `vertices`, `cells`, `kinds`, `faces`,
        `boundary_faces`, `nonmanifold_faces`, `edges`, `interior_edge_valence`, `boundary_edge_valence`,
        `cells_per_depth`, `components`, `unreferenced_vertices`, `cells_repeating_a_vertex`, `findings`,
        `quality`, `groups`, `features`. Numbers that are not finite are None.
    """
    facts: dict[str, Any] = {
        "file": mesh.name,
        "format": mesh.format,
        "vertices": mesh.vertex_count,
        "cells": mesh.cell_count,
        "kinds": mesh.kind_counts,
        **topology_facts(mesh),
        "findings": [
            {
                "id": finding.id,
                "count": finding.count,
                "message": finding.message,
                "cells": cell_numbers(mesh, finding.cells[:MOST_NAMED]),
                "vertices": vertex_numbers(mesh, finding.vertices[:MOST_NAMED]),
            }
            for finding in diagnose(mesh)
        ],
        "quality": measures(mesh, quality_many(mesh, metrics)),
        "groups": all_groups(mesh),
        "features": listed_features(mesh),
    }
    found: dict[str, Any] = jsonable(facts)
    return found


def topology_facts(mesh: Mesh) -> dict[str, Any]:
    """Collect the facts of a mesh's topology; see `summarise`."""
    return {name: fact for part in TOPOLOGY.values() for name, fact in part(mesh).items()}


def _faces(mesh: Mesh) -> dict[str, Any]:
    topology = mesh.topology
    return {
        "faces": topology.face_count,
        "boundary_faces": topology.boundary_face_count,
        "nonmanifold_faces": topology.nonmanifold_face_count,
    }


def _edges(mesh: Mesh) -> dict[str, Any]:
    topology = mesh.topology
    return {
        "edges": topology.edge_count,
        "interior_edge_valence": topology.interior_edge_valence,
        "boundary_edge_valence": topology.boundary_edge_valence,
    }


def _layers(mesh: Mesh) -> dict[str, Any]:
    topology = mesh.topology
    return {"cells_per_depth": topology.cells_per_depth, "components": topology.component_count}


def _vertices(mesh: Mesh) -> dict[str, Any]:
    repeating = mesh.topology.repeating_cells & (mesh.kinds == HEXAHEDRON)
    return {
        "unreferenced_vertices": int(np.count_nonzero(~mesh.referenced)),
        "cells_repeating_a_vertex": int(np.count_nonzero(repeating)),
    }


TOPOLOGY = {"faces": _faces, "edges": _edges, "layers": _layers, "vertices": _vertices}
"""Parts of the facts about topology, in the order in which they are told."""


def measures(
    mesh: Mesh, values: Mapping[str, Floats], kinds: NDArray[np.uint8] | None = None
) -> dict[str, dict[str, Any]]:
    """Summarise values per cell by metric id: metric to its statistics, those of `STATISTICS`.

    The values are those of all cells, or of some, whose kinds are told then.
    """
    kinds = mesh.kinds if kinds is None else kinds
    measured = {}
    for metric, array in values.items():
        numbers = statistics(array, METRICS[metric], kinds)
        measured[metric] = {name: numbers[name] for name in STATISTICS}
    return measured
