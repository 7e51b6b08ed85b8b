"""Colours of blocks, pairs of sheets, distances: against the plain definitions (SPEC T4, T5)."""

from __future__ import annotations

from collections import Counter, deque

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import hexalab
from hexalab.structure.colouring import block_colours, coloured
from hexalab.structure.distance import irregular_distance
from hexalab.structure.matrix import sheet_pairs
from tests.core.structure.brute_force import FACES, OPPOSITE, Slow
from tests.core.structure.strategies import meshes

COLOURS = 12


@given(st.integers(2, 40), st.integers(0, 2**32 - 1))
def test_T4_neighbours_differ_where_colours_suffice(count: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    pairs = {tuple(sorted(random.choice(count, 2, replace=False).tolist())) for _ in range(3 * count)}
    one, other = np.array(sorted(pairs), np.int32).T
    found = coloured(count, one, other, 32)
    most = int(np.bincount(np.concatenate([one, other])).max())
    if most < 32:
        assert (found[one] != found[other]).all()
    assert found.max() < 32


def test_T4_all_colours_are_used() -> None:
    found = coloured(1000, np.empty(0, np.int32), np.empty(0, np.int32), COLOURS)
    assert set(found.tolist()) == set(range(COLOURS))


@given(meshes)
def test_T4_blocks_that_share_a_face_differ(cells: NDArray[np.int32]) -> None:
    structure = hexalab.structure(hexalab.Mesh.from_cells(np.zeros((int(cells.max()) + 1, 3)), cells))
    found = block_colours(structure.frame, structure.base_complex, COLOURS)
    block = structure.base_complex.of_cells
    beside: dict[int, set[int]] = {}
    for around in Slow(cells.tolist()).face_cells.values():
        if len(around) == 2 and block[around[0]] != block[around[1]]:
            beside.setdefault(block[around[0]], set()).add(block[around[1]])
            beside.setdefault(block[around[1]], set()).add(block[around[0]])
    for one, others in beside.items():
        if all(len(beside[other]) < COLOURS for other in (one, *others)):
            assert found[one] not in {found[other] for other in others}


@given(meshes)
def test_T4_sheets_that_cross_and_that_run_side_by_side(cells: NDArray[np.int32]) -> None:
    structure = hexalab.structure(hexalab.Mesh.from_cells(np.zeros((int(cells.max()) + 1, 3)), cells))
    pairs = sheet_pairs(structure.frame, structure.sheets)
    slow = Slow(cells.tolist())
    sheet = structure.sheets.of_cells.T.tolist()
    crossings: Counter[tuple[int, int]] = Counter()
    for a, b, c in sheet:
        for pair in ((a, b), (b, c), (a, c)):
            crossings[min(pair), max(pair)] += 1
    beside: Counter[tuple[int, int]] = Counter()
    through = {local: direction for direction, ends in enumerate(OPPOSITE) for local in ends}
    for face, around in slow.face_cells.items():
        if len(around) == 2:
            ends = []
            for cell in around:
                local = next(
                    k for k, places in enumerate(FACES) if {slow.cells[cell][p] for p in places} == face
                )
                ends.append(sheet[cell][through[local]])
            beside[min(ends), max(ends)] += 1
    found = list(zip(pairs.one.tolist(), pairs.other.tolist(), strict=True))
    assert {
        pair: number for pair, number in zip(found, pairs.crossings.tolist(), strict=True) if number
    } == crossings
    assert {
        pair: number for pair, number in zip(found, pairs.beside.tolist(), strict=True) if number
    } == beside


@given(meshes)
def test_T5_distance_from_irregular_edges(cells: NDArray[np.int32]) -> None:
    structure = hexalab.structure(hexalab.Mesh.from_cells(np.zeros((int(cells.max()) + 1, 3)), cells))
    slow = Slow(cells.tolist())
    distance = [-1] * len(cells)
    inner = slow.irregular - slow.boundary_edges
    queue = deque(sorted({cell for edge in inner for cell in slow.edge_cells[edge]}))
    for cell in queue:
        distance[cell] = 0
    while queue:
        cell = queue.popleft()
        for around in slow.face_cells.values():
            if cell in around:
                for other in around:
                    if distance[other] < 0:
                        distance[other] = distance[cell] + 1
                        queue.append(other)
    assert irregular_distance(structure.frame).tolist() == distance
