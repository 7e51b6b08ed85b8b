"""Whole meshes with facts about each that do not come from the core: what every room's tests hold on real files.

Our own are the repository's, always here: read by the few lines below, their topology found by dictionaries and their
quality by VTK's Verdict. The published ones are added where they are here.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from hexalab.cells import COLLAPSE, HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from tests import published
from tests.core.quality import verdict
from tests.core.topology.brute_force import BruteForce

REPOSITORY = Path(__file__).resolve().parents[1] / "repository"
KEYWORDS = {"Hexahedra": HEXAHEDRON, "Prisms": WEDGE, "Pyramids": PYRAMID, "Tetrahedra": TETRAHEDRON}


@dataclass(frozen=True)
class WholeMesh:
    """A mesh file; `name` is the file's, or for our own `source/file`.

    `cells` is known before the file is there, so that tests can be chosen by it.
    """

    name: str
    cells: int

    def __str__(self) -> str:
        return self.name

    @property
    def own(self) -> bool:
        """Whether it is the repository's."""
        return "/" in self.name

    def file(self) -> Path:
        """Where it lies; the test is left out where it is not here."""
        return REPOSITORY / self.name if self.own else published.file_of(self.name)

    def facts(self) -> dict[str, Any]:
        """Counts, valences, depths and components, as dictionaries find them."""
        return own_facts(self.name) if self.own else published.facts()[self.name]

    def verdict(self) -> dict[str, dict[str, Any]]:
        """Least, greatest and mean value of each of Verdict's metrics, and those of the first cells or of all."""
        return own_verdict(self.name) if self.own else published.facts()[self.name]["verdict"]


def own_meshes() -> list[WholeMesh]:
    """All mesh files of the repository, smallest first."""
    files = [file for ending in ("mesh", "vtk") for file in sorted(REPOSITORY.glob(f"*/*.{ending}"))]
    names = [f"{file.parent.name}/{file.name}" for file in files]
    rows = [WholeMesh(name, sum(map(len, plain(name)[1].values()))) for name in names]
    return sorted(rows, key=lambda row: (row.cells, row.name))


@cache
def plain(name: str) -> tuple[np.ndarray, dict[int, np.ndarray]]:
    """Points (V, 3) and cells (n, k) by kind of a file of ours, Medit or VTK's legacy text as `making` writes them."""
    words = (REPOSITORY / name).read_text("utf-8").split()

    def table(start: int, width: int, dtype: type) -> np.ndarray:
        count = int(words[start])
        return np.array(words[start + 1 : start + 1 + count * width], dtype).reshape(count, width)

    if name.endswith(".vtk"):
        start = words.index("POINTS")
        count = int(words[start + 1])
        points = np.array(words[start + 3 : start + 3 + 3 * count], float).reshape(count, 3)
        start = words.index("CELLS")
        rows = np.array(words[start + 3 : start + 3 + int(words[start + 2])], int).reshape(-1, 9)
        return points, {HEXAHEDRON: rows[:, 1:]}
    points = table(words.index("Vertices") + 1, 4, float)[:, :3]
    corners = {HEXAHEDRON: 8, WEDGE: 6, PYRAMID: 5, TETRAHEDRON: 4}
    cells = {
        kind: table(words.index(keyword) + 1, corners[kind] + 1, int)[:, :-1] - 1
        for keyword, kind in KEYWORDS.items()
        if keyword in words
    }
    return points, cells


@cache
def own_facts(name: str) -> dict[str, Any]:
    """What `expected.json` says of a published mesh, Verdict's part apart."""
    points, by_kind = plain(name)
    cells = np.concatenate([rows[:, list(COLLAPSE[kind])] for kind, rows in sorted(by_kind.items())]).tolist()
    truth = BruteForce(cells)
    depth = truth.depth
    return {
        "vertices": len(points),
        "cells": len(cells),
        "unreferenced_vertices": len(points) - len({vertex for cell in cells for vertex in cell}),
        "cells_repeating_a_vertex": sum(len(set(cell)) < 8 for cell in cells),
        "faces": len(truth.face_cells),
        "boundary_faces": len(truth.boundary),
        "nonmanifold_faces": sum(len(around) > 2 for around in truth.face_cells.values()),
        "edges": len(truth.edge_cells),
        "interior_edge_valence": {str(n): count for n, count in truth.valence(on_boundary=False).items()},
        "boundary_edge_valence": {str(n): count for n, count in truth.valence(on_boundary=True).items()},
        "cells_per_depth": [depth.count(level) for level in range(max(depth) + 1)],
        "face_connected_components": len(set(truth.components)),
    }


@cache
def own_verdict(name: str) -> dict[str, dict[str, Any]]:
    """Verdict's values of all cells of a mesh of hexahedra; the test is left out where VTK is missing."""
    points, cells = plain(name)
    out = {}
    for metric in verdict.NAMES:
        values = verdict.quality(points, cells[HEXAHEDRON], metric)
        ends = {"min": float(values.min()), "max": float(values.max()), "mean": float(values.mean())}
        out[metric] = {**ends, "first8": values.tolist()}
    return out


OWN = own_meshes()
WHOLE_MESHES = OWN + [WholeMesh(name, count) for name, count in published.CELLS.items()]
HEXAHEDRAL = [mesh for mesh in WHOLE_MESHES if mesh.name != "structures/mixed.mesh"]
"""Those whose every cell Verdict measures as a hexahedron."""
