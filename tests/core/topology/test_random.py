"""Random meshes against dictionaries without hypothesis, so that browsers' Python runs them too."""

from __future__ import annotations

import numpy as np
import pytest

from tests.core.topology.checks import check_edges, check_faces, check_walks, topology
from tests.core.topology.grids import grid_cells


@pytest.mark.parametrize("seed", range(12))
def test_R7_topology_of_random_meshes_equals_dictionaries(seed: int) -> None:
    """Grids, shuffled, with vertices merged, cells repeated, torn out and collapsed."""
    random = np.random.default_rng(seed)
    cells = grid_cells(*random.integers(1, 7, size=3))
    count = int(cells.max()) + 1
    if seed % 2:
        cells = random.permutation(count).astype(np.int32)[cells]
    for _ in range(seed % 4):
        cells[cells == random.integers(count)] = random.integers(count)
    if seed % 3:
        cells = cells[random.random(len(cells)) < 0.9]
        cells = np.concatenate([cells, cells[: seed // 4]])
    some = random.random(len(cells)) < 0.1
    cells[some] = cells[some][:, [0, 1, 2, 2, 4, 5, 6, 6]]
    t = topology(random.permutation(cells))
    cells = t.corners.T
    check_faces(cells, t)
    check_edges(cells, t)
    check_walks(cells, t)
