"""Random small meshes for hypothesis: bits of grids, shuffled, mixed, torn, crowded, folded."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.core.topology.grids import grid_cells

COLLAPSE = (
    (0, 1, 2, 3, 4, 5, 6, 7),
    (0, 1, 2, 2, 3, 4, 5, 5),
    (0, 1, 2, 3, 4, 4, 4, 4),
    (0, 1, 2, 2, 3, 3, 3, 3),
)


@st.composite
def grids(draw: st.DrawFn) -> NDArray[np.int32]:
    """Grids with vertices and cells permuted, vertices merged, cells repeated and left out."""
    cells = grid_cells(*(draw(st.integers(1, 4)) for _ in range(3)))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    count = int(cells.max()) + 1
    if draw(st.booleans()):
        cells = random.permutation(count)[cells]
    for _ in range(draw(st.integers(0, 3))):
        cells[cells == random.integers(count)] = random.integers(count)
    if draw(st.booleans()):
        cells = cells[random.random(len(cells)) < 0.8]
    if draw(st.booleans()) and len(cells):
        cells = np.concatenate([cells, cells[random.integers(len(cells), size=draw(st.integers(1, 4)))]])
    return np.asarray(random.permutation(cells), dtype=np.int32)


@st.composite
def soups(draw: st.DrawFn) -> NDArray[np.int32]:
    """Cells of all kinds on few vertices: much is shared, repeated, folded."""
    vertices = draw(st.integers(4, 12))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    rows = []
    for _ in range(draw(st.integers(0, 8))):
        kind = COLLAPSE[random.integers(4)]
        ids = (
            random.integers(vertices, size=8)
            if random.random() < 0.3
            else random.permutation(12)[:8] % vertices
        )
        rows.append(ids[list(kind)])
    return np.array(rows, dtype=np.int32).reshape(-1, 8)


meshes = st.one_of(grids(), soups())
