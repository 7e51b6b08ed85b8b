"""Regularisation (SPEC F5; the paper, Filter regularization): cleans the cut that plane and peel make.

The hidden set is dilated n times, then eroded n times. The interface is made of interior faces with exactly
one shown side. Where the cut meets the original surface, the vertices of its rim lie on such faces and
count; the surface's other vertices, and faces of the boundary, never do: a mesh does not wear away from
outside.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids
from ..topology import Topology
from ..topology.interface import InterfaceFinder

STRONGEST = 5
"""Largest strength (SPEC F5)."""


class Regulariser:
    """Regularises hidden sets of one mesh.

    The interface of the last set is remembered: sets that follow each other are alike.

    Parameters
    ----------
    topology : Topology
    """

    def __init__(self, topology: Topology) -> None:
        self._topology = topology
        self._finder = InterfaceFinder(topology.faces)

    def regularise(self, hidden: NDArray[np.bool_], strength: int) -> NDArray[np.bool_]:
        """Dilate a hidden set, (C,) bool, `strength` times, then erode it as often; a new array."""
        shown = ~hidden
        for change in [False] * strength + [True] * strength:
            shown[self._touching(shown)] = change
        return ~shown

    def _touching(self, shown: NDArray[np.bool_]) -> Ids:
        """Cells, shown or not, with a vertex on the interface."""
        topology = self._topology
        rows = self._finder.inside(shown)
        flagged = np.zeros(topology.vertex_count, dtype=bool)
        flagged[topology.corners_of(topology.face_cells[0][rows], topology.face_locals[0][rows])] = True
        return topology.stars.cells_of(np.flatnonzero(flagged))
