"""Random small meshes of hexahedra for hypothesis: bits of grids, closed ones, tetrahedra in four cells each."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.core.topology.grids import grid_cells

TURNS = ([0, 1, 2, 3, 4, 5, 6, 7], [1, 2, 3, 0, 5, 6, 7, 4], [4, 0, 3, 7, 5, 1, 2, 6])
"""A cell, the same turned about one axis, and about another: together they make all 24."""


@st.composite
def grids(draw: st.DrawFn) -> NDArray[np.int32]:
    """Bits of grids."""
    cells = grid_cells(*(draw(st.integers(1, 4)) for _ in range(3)))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    kept = random.random(len(cells)) < draw(st.sampled_from([0.5, 0.8, 0.95, 1.0]))
    return cells[kept] if kept.any() else cells


@st.composite
def rings(draw: st.DrawFn) -> NDArray[np.int32]:
    """Bars n x n x length whose two ends are joined, turned by so many quarters, some mirrored."""
    n, length = draw(st.integers(1, 3)), draw(st.integers(3, 6))
    cells = grid_cells(n, n, length)
    section = (n + 1) ** 2
    ends = np.arange(section).reshape(n + 1, n + 1)
    ends = np.rot90(ends, draw(st.integers(0, 3)))
    if draw(st.booleans()):
        ends = ends[::-1]
    first = length * section
    top = cells >= first
    cells[top] = ends.reshape(-1)[cells[top] - first]
    return cells


@st.composite
def tetrahedra(draw: st.DrawFn) -> NDArray[np.int32]:
    """Tetrahedra, each parted into four cells at its middle, those of its faces and of its edges.

    They grow from one, each new one at a free face or closing between two of one edge.
    """
    tets = [(0, 1, 2, 3)]
    used = 4
    for _ in range(draw(st.integers(0, 7))):
        faces: dict[frozenset[int], int] = {}
        for tet in tets:
            for face in combinations(tet, 3):
                faces[frozenset(face)] = faces.get(frozenset(face), 0) + 1
        free = sorted(sorted(face) for face, number in faces.items() if number == 1)
        if not free:
            break
        face = draw(st.sampled_from(free))
        apexes = [used]
        for other in free:
            if len(set(face) & set(other)) == 2 and draw(st.booleans()):
                apexes.insert(0, next(iter(set(other) - set(face))))
        apex = apexes[0]
        tet = (*face, apex)
        sides = [frozenset(side) for side in combinations(tet, 3)]
        if any(faces.get(side, 0) > 1 for side in sides) or frozenset(tet) in {frozenset(t) for t in tets}:
            continue
        tets.append(tet)
        used = max(used, apex + 1)
    number: dict[frozenset[int], int] = {}

    def middle(*vertices: int) -> int:
        return number.setdefault(frozenset(vertices), len(number))

    cells = []
    for tet in tets:
        for v in tet:
            a, b, c = (w for w in tet if w != v)
            cells.append(
                [
                    middle(v), middle(v, a), middle(v, a, b), middle(v, b),
                    middle(v, c), middle(v, a, c), middle(*tet), middle(v, b, c),
                ]
            )  # fmt: skip
    return np.array(cells, np.int32)


@st.composite
def turned(draw: st.DrawFn, cells: NDArray[np.int32]) -> tuple[NDArray[np.int32], NDArray[np.intp]]:
    """The same mesh with vertices and cells renumbered and cells turned; and where each cell of it stood."""
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    cells = random.permutation(int(cells.max()) + 1)[cells]
    order = random.permutation(len(cells))
    cells = cells[order]
    for _ in range(4):
        for turn in TURNS[1:]:
            some = random.random(len(cells)) < 0.5
            cells[some] = cells[some][:, turn]
    return cells.astype(np.int32), order


meshes = st.one_of(grids(), rings(), tetrahedra())
