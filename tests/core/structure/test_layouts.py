"""What the layouts that lie here are said to show, and closed bars of every turn: known otherwise (SPEC T1-T3)."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest

import hexalab
from hexalab.structure import Structure, facts_of
from hexalab.structure.blocks import KINDS
from tests.core.structure.brute_force import Slow
from tests.core.topology.grids import grid_cells

LAYOUTS = Path(__file__).resolve().parents[3] / "repository" / "layouts"
NAMES = sorted(path.stem for path in LAYOUTS.glob("*.mesh"))


def traced(name: str) -> Structure:
    return hexalab.structure(hexalab.read(LAYOUTS / f"{name}.mesh"))


@pytest.mark.parametrize("name", NAMES)
def test_T1_T2_T3_layouts_by_dictionaries(name: str) -> None:
    structure = traced(name)
    slow = Slow(structure.mesh.cells.tolist())
    block = slow.blocks()
    assert structure.block_of_cells.tolist() == [block[cell] for cell in range(len(slow.cells))]
    facts = facts_of(structure, labels=False)
    assert facts["sheets"]["count"] == len(set(slow.sheets().values()))
    assert facts["chords"]["count"] == len(set(slow.chords().values()))
    base = facts["base_complex"]
    assert (base["vertices"], base["edges"], base["edge_loops"], base["faces"]) == slow.skeleton()
    nodes, chains = slow.graph(whole=False)
    assert facts["irregular"]["nodes"] == len(nodes)
    assert facts["irregular"]["arcs"] + facts["irregular"]["loops"] == len(chains)


def test_T1_ten_ways_in_which_edges_of_three_four_and_five_cells_meet() -> None:
    structure = traced("nodes")
    slow = Slow(structure.mesh.cells.tolist())
    inner = slow.irregular - slow.boundary_edges
    outer = {vertex for edge in slow.boundary_edges for vertex in edge}
    at: dict[int, list[int]] = {}
    for edge, around in slow.edge_cells.items():
        for vertex in edge:
            at.setdefault(vertex, []).append(len(around))
    found = {
        tuple(at[vertex].count(valence) for valence in (3, 4, 5))
        for vertex in {vertex for edge in inner for vertex in edge} - outer
    }
    # Around a vertex inside lies a sphere of triangles, one for each cell: 3 a + 2 b + c = 12 by Euler's formula.
    assert len(found) == 10 and all(3 * a + 2 * b + c == 12 for a, b, c in found)
    assert {(4, 0, 0), (0, 0, 12)} <= found
    straight = {(2, 3, 0), (0, 5, 2)}
    assert straight <= found, "there an arc goes on"
    types = facts_of(structure, labels=False)["irregular"]["node_types"]
    inside = {name for name in types if name.startswith("i")}
    assert inside == {" ".join(["i", *("3" * a), *("5" * c)]) for a, _, c in found - straight}


@pytest.mark.parametrize("name", NAMES)
def test_T1_node_types_keep_to_eulers_formula(name: str) -> None:
    structure = traced(name)
    for type in structure.graph.types:
        if type.startswith("i"):
            left = 12 - sum(6 - int(valence) for valence in type.split()[1:])
            assert left >= 0 and left % 2 == 0, "what is left are edges of four cells"


def test_T1_T2_T3_what_is_said_of_the_others() -> None:
    facts = {name: facts_of(traced(name), labels=False) for name in NAMES}
    hoops = facts["hoops"]["irregular"]
    assert (hoops["nodes"], hoops["arcs"], hoops["loops_by_valence"]) == (0, 0, {"3": 4})
    six = facts["nodes-of-six"]["irregular"]["node_types"]
    assert any("6" in name for name in six if name.startswith("i"))
    assert facts["one-sided"]["sheets"]["one_sided"] > 0
    touching = facts["self-touching"]["sheets"]
    assert (touching["self_touching"], touching["self_intersecting"]) == (1, 0)
    assert (
        facts["straight-walls"]["base_complex"]["blocks"],
        facts["winding-walls"]["base_complex"]["blocks"],
    ) == (
        7,
        57,
    )


def closed_bar(i: int, j: int, length: int, turn: int, mirrored: bool = False) -> np.ndarray:
    """Cells of a bar whose two ends are joined, one of them turned by so many quarters, or mirrored."""
    section = (i + 1) * (j + 1)
    ends = np.rot90(np.arange(section).reshape(j + 1, i + 1), turn)
    ends = (ends[::-1] if mirrored else ends).reshape(-1)
    cells = grid_cells(i, j, length)
    top = cells >= length * section
    cells[top] = ends[cells[top] - length * section]
    return cells


def test_T3_twisted_blocks_are_counted_by_their_cells() -> None:
    one, other = closed_bar(2, 2, 6, 2), closed_bar(1, 4, 6, 2)
    cells = np.concatenate([one, other + one.max() + 1])
    structure = hexalab.structure(hexalab.Mesh.from_cells(np.zeros((int(cells.max()) + 1, 3)), cells))
    assert facts_of(structure, labels=False)["base_complex"]["dims"] == {"twisted 24": 2}


@pytest.mark.parametrize(("n", "length"), [(1, 3), (2, 4), (3, 5)])
def test_T3_a_closed_bar_is_a_ring_unless_it_comes_back_turned(n: int, length: int) -> None:
    section = (n + 1) ** 2
    for turn, mirrored in product(range(4), (False, True)):
        cells = closed_bar(n, n, length, turn, mirrored)
        structure = hexalab.structure(hexalab.Mesh.from_cells(np.zeros((length * section, 3)), cells))
        blocks = structure.base_complex.blocks
        straight = not (turn or mirrored)
        assert [KINDS[kind] for kind in blocks.kinds] == ["ring" if straight else "twisted"]
        assert blocks.dimensions.tolist() == ([[n, n, length]] if straight else [[0, 0, 0]])
        chords = structure.chords
        # Columns along the bar close after as many rounds as their place takes to come back to itself.
        places = (np.rot90(np.arange(n * n).reshape(n, n), turn)[:: -1 if mirrored else 1]).reshape(-1)
        assert sorted(chords.length[chords.closed].tolist()) == sorted(
            length * size for size in cycles(places)
        )


def cycles(places: np.ndarray) -> list[int]:
    """Lengths of a permutation's cycles."""
    found, seen = [], set()
    for start in range(len(places)):
        at, size = start, 0
        while at not in seen:
            seen.add(at)
            at, size = int(places[at]), size + 1
        if size:
            found.append(size)
    return found
