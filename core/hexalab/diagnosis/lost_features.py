"""Features that the mesh does not hold: edges and faces of the file that are those of no cell (SPEC R13)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..groups import Features
from ..mesh import Mesh
from ..topology.lookup import edges_there, sides_of


class Held(NamedTuple):
    """Which features of one dimension the mesh holds, (n,) bool."""

    features: Features
    there: NDArray[np.bool_]


def held_features(mesh: Mesh) -> list[Held]:
    """Tell of each feature whether it is a vertex, an edge, or a face of a cell."""
    held = []
    for part in mesh.features:
        if part.dimension == 0:
            there = mesh.referenced[part.corners[0]]
        elif part.dimension == 1:
            there = edges_there(mesh.corners, mesh.vertex_count, part.corners)
        else:
            cells, _ = sides_of(mesh.corners, mesh.vertex_count, part.corners)
            there = cells >= 0
        held.append(Held(part, there))
    return held
