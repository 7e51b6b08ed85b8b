"""Structures of random small meshes are what the definitions say, whatever the numbers (SPEC T1-T3)."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise
from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import hexalab
from hexalab.structure import Structure
from tests.core.structure.brute_force import Slow
from tests.core.structure.strategies import meshes, turned


def both(cells: NDArray[np.int32]) -> tuple[Slow, Structure]:
    """The structure by definition, and by arrays."""
    points = np.zeros((int(cells.max()) + 1, 3))
    return Slow(cells.tolist()), hexalab.structure(hexalab.Mesh.from_cells(points, cells))


def parts(labels: Any) -> set[frozenset[int]]:
    """What belongs together, whatever it is called."""
    found: dict[int, set[int]] = {}
    for thing, label in enumerate(np.asarray(labels).reshape(-1).tolist()):
        found.setdefault(label, set()).add(thing)
    return {frozenset(part) for part in found.values()}


def edge(structure: Structure, row: int) -> frozenset[int]:
    """The vertices of an edge."""
    return frozenset(structure.frame.edge_vertices[:, row].tolist())


@given(meshes)
def test_T2_sheets_and_chords(cells: NDArray[np.int32]) -> None:
    slow, structure = both(cells)
    sheets, chords = structure.sheets, structure.chords
    crossings = np.array(slow.crossings())
    assert parts(sheets.of_cells.T) == parts(crossings)
    assert np.array_equal(sheets.of_cells.T.reshape(-1), by_appearance(crossings))
    flat = crossings.reshape(-1).tolist(), sheets.of_cells.T.reshape(-1).tolist()
    name = dict(zip(*flat, strict=True))
    again = {name[label] for row in crossings.tolist() for label, times in Counter(row).items() if times > 1}
    assert set(np.flatnonzero(sheets.self_intersecting).tolist()) == again
    touching = {name[label] for label in slow.self_touching()} - again
    assert set(np.flatnonzero(sheets.self_touching).tolist()) == touching
    assert set(np.flatnonzero(sheets.one_sided).tolist()) == {name[label] for label in slow.one_sided()}
    sheet = slow.sheets()
    open_ = {name[sheet[edge]] for edge in slow.boundary_edges}
    assert set(np.flatnonzero(~sheets.closed).tolist()) == open_
    passed = np.array(
        [[slow.chords()[slow._face(cell, local)] for local in (5, 2, 0)] for cell in slow.cells]
    )
    assert np.array_equal(chords.of_cells.T.reshape(-1), by_appearance(passed))
    assert chords.length.sum() == 3 * len(cells)


@given(meshes)
def test_T3_base_complex(cells: NDArray[np.int32]) -> None:
    slow, structure = both(cells)
    count = range(len(cells))
    assert structure.base_complex.of_cells.tolist() == [slow.blocks()[cell] for cell in count]
    inner = structure.interior_base_complex.of_cells
    assert inner.tolist() == [slow.blocks(inside_only=True)[cell] for cell in count]
    skeleton = structure.skeleton
    chains = skeleton.edges
    found = len(skeleton.vertices), chains.open, chains.count - chains.open, skeleton.faces
    assert found == slow.skeleton()


@given(meshes)
def test_T3_every_block_is_a_box_or_closes_on_itself(cells: NDArray[np.int32]) -> None:
    _, structure = both(cells)
    blocks = structure.base_complex.blocks
    kinds = set(blocks.kinds.tolist())
    assert kinds <= {0, 1, 2, 3, 4}
    boxes = blocks.kinds == 0
    assert np.array_equal(blocks.dimensions[boxes].prod(axis=1), blocks.cells[boxes])


@given(meshes)
def test_T1_graphs(cells: NDArray[np.int32]) -> None:
    slow, structure = both(cells)
    for graph, whole in ((structure.graph, False), (structure.whole_graph, True)):
        nodes, chains = slow.graph(whole)
        assert set(graph.nodes.tolist()) == nodes
        bounds = graph.starts - np.arange(len(graph.starts))
        found = [
            frozenset(edge(structure, row) for row in graph.edges[bounds[k] : bounds[k + 1]].tolist())
            for k in range(graph.count)
        ]
        assert Counter(found) == Counter(frozenset(chain) for chain in chains)
        for k in range(graph.count):
            walk = graph.vertices[graph.starts[k] : graph.starts[k + 1]].tolist()
            rows = graph.edges[bounds[k] : bounds[k + 1]].tolist()
            assert [frozenset(pair) for pair in pairwise(walk)] == [edge(structure, row) for row in rows]


@given(st.data())
def test_T2_T3_numbers_change_nothing(data: st.DataObject) -> None:
    cells = data.draw(meshes)
    other, order = data.draw(turned(cells))
    _, one = both(cells)
    _, two = both(other)
    first, second = one.base_complex, two.base_complex
    assert parts(first.of_cells[order]) == parts(second.of_cells)
    assert sorted(first.blocks.dimensions.tolist()) == sorted(second.blocks.dimensions.tolist())
    for a, b in ((one.sheets, two.sheets), (one.chords, two.chords)):
        assert a.count == b.count
        through = np.sort(a.of_cells[:, order], axis=0).T.tolist(), np.sort(b.of_cells, axis=0).T.tolist()
        assert [len(set(row)) for row in through[0]] == [len(set(row)) for row in through[1]]
    for a, b in ((one.graph, two.graph), (one.whole_graph, two.whole_graph)):
        assert Counter(a.lengths.tolist()) == Counter(b.lengths.tolist())
        assert Counter(a.types[kind] for kind in a.node_types) == Counter(
            b.types[kind] for kind in b.node_types
        )


def by_appearance(labels: NDArray[np.int_]) -> NDArray[np.int_]:
    """Labels renumbered in the order in which they come first."""
    number: dict[int, int] = {}
    return np.array([number.setdefault(label, len(number)) for label in labels.reshape(-1).tolist()])
