"""A mesh of cells that have all collapsed to an edge has no face to look across."""

from __future__ import annotations

import numpy as np

from hexalab.topology import Topology


def test_R7_a_cell_without_faces_has_no_neighbours() -> None:
    """Found by hypothesis: the first of no faces was asked for."""
    topology = Topology(np.array([[1], [3], [1], [1], [1], [1], [1], [1]], np.int32), 4)
    assert topology.face_count == 0
    assert topology.neighbours_of(np.arange(1)).tolist() == [[-1]] * 6
