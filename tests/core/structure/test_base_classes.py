"""Base sheets and chords of random small meshes, and the skeleton of the inside alone, by dictionaries (SPEC T3)."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from numpy.typing import NDArray

import hexalab
from hexalab.structure.members import cells_of
from tests.core.structure.brute_force import EDGES, FACES, OPPOSITE, Slow, classes
from tests.core.structure.strategies import meshes

THROUGH = {side: d for d, pair in enumerate(OPPOSITE) for side in pair}
ALONG = {
    frozenset(edge): d
    for d, (a, b) in enumerate(OPPOSITE)
    for edge in EDGES
    if set(edge) & set(FACES[a]) and set(edge) & set(FACES[b])
}
"""The direction of each edge of a cell."""


def both(cells: NDArray[np.int32]) -> tuple[Slow, hexalab.Structure]:
    points = np.zeros((int(cells.max()) + 1, 3))
    return Slow(cells.tolist()), hexalab.structure(hexalab.Mesh.from_cells(points, cells))


def joined(slow: Slow) -> list[tuple[frozenset[int], list[int]]]:
    """Faces within blocks, with their two cells."""
    walls = slow.walls()
    return [
        (face, around) for face, around in slow.face_cells.items() if len(around) == 2 and face not in walls
    ]


def side_of(cell: list[int], face: frozenset[int]) -> int:
    return next(k for k, places in enumerate(FACES) if {cell[p] for p in places} == face)


def direction_of(cell: list[int], edge: frozenset[int]) -> int:
    return next(d for places, d in ALONG.items() if {cell[p] for p in places} == edge)


@given(meshes)
def test_T3_base_sheets_follow_each_other_within_a_block(cells: NDArray[np.int32]) -> None:
    slow, structure = both(cells)
    sheet = structure.sheets.of_cells
    links = []
    for face, (one, other) in joined(slow):
        a, b = (THROUGH[side_of(slow.cells[cell], face)] for cell in (one, other))
        links.append((int(sheet[a, one]), int(sheet[b, other])))
    expected = classes(range(structure.sheets.count), links)
    labels, count = structure.base_sheets
    assert labels.tolist() == [expected[number] for number in range(structure.sheets.count)]
    assert count == len(set(expected.values()))


@given(meshes)
def test_T3_base_chords_lie_side_by_side_within_a_block(cells: NDArray[np.int32]) -> None:
    slow, structure = both(cells)
    chord = structure.chords.of_cells
    links = []
    for face, (one, other) in joined(slow):
        ring = slow.rings[face]
        for edge in (frozenset(ring[:2]), frozenset(ring[1:3])):
            a, b = (direction_of(slow.cells[cell], edge) for cell in (one, other))
            links.append((int(chord[a, one]), int(chord[b, other])))
    expected = classes(range(structure.chords.count), links)
    labels, count = structure.base_chords
    assert labels.tolist() == [expected[number] for number in range(structure.chords.count)]
    assert count == len(set(expected.values()))


@given(meshes)
def test_T3_the_skeleton_of_the_inside_alone(cells: NDArray[np.int32]) -> None:
    slow, structure = both(cells)
    skeleton = structure.interior_skeleton
    chains = skeleton.edges
    found = len(skeleton.vertices), chains.open, chains.count - chains.open, skeleton.faces
    assert found == slow.skeleton(inside_only=True)


@given(meshes)
def test_T1_T4_cells_at_arcs_are_those_around_their_edges(cells: NDArray[np.int32]) -> None:
    slow, structure = both(cells)
    for graph, variant in ((structure.graph, "interior"), (structure.whole_graph, "whole")):
        chains = graph.chains
        for number in {0, len(chains) // 2, len(chains)}:
            expected = set()
            for a, b in zip(chains[number], chains[number][1:], strict=False) if number < len(chains) else ():
                expected |= slow.edge_cells[frozenset((int(a), int(b)))]
            found = np.flatnonzero(cells_of(structure, "arcs", [number], variant))
            assert set(found.tolist()) == expected
