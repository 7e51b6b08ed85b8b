"""The structure of a mesh as its page tells it: a row of figures, and tables that count.

The words are those of `hexalab structure`; what is not known is left out.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from ..model.facts import Counts, Facts
from .words import count, share, structure_word

FIRST = 12
"""So many rows of a table are seen; the others are folded behind their number."""

PER_MILLION = 1_000_000

Row = tuple[str, list[int | None]]
"""What is counted, and the number in each column; None where there is nothing to count."""

CHAINS = (("arcs_by_valence", "Arcs"), ("loops_by_valence", "Loops"))
"""What irregular edges form, by the facts' names."""

SHEETS_AND_CHORDS = (
    ("count", "in all"),
    ("closed", "closed"),
    ("self_intersecting", "self-intersecting"),
    ("self_touching", "self-touching"),
    ("one_sided", "one-sided"),
)
"""What sheets and chords are, by the facts' names."""

BASE_COMPLEX = (
    ("vertices", "vertices"),
    ("edges", "edges"),
    ("edge_loops", "closed edges"),
    ("faces", "faces"),
    ("blocks", "blocks"),
    ("separation_faces", "separation faces"),
    ("base_sheets", "base sheets"),
    ("base_chords", "base chords"),
)
"""What a base complex consists of, by the facts' names."""

KINDS = {"twisted": "twisted ring"}
"""Kinds of blocks whose word alone says too little."""


@dataclass(frozen=True)
class Tally:
    """A table that counts things by what they are.

    Parameters
    ----------
    caption : str
    heads : tuple of str
        Of the column that says what is counted, and of each column of numbers.
    rows : list of (str, list)
    usual : str
        The row that is as it should be, and can be overlooked.
    none : str
        What stands there if there is no row.
    """

    caption: str
    heads: tuple[str, ...]
    rows: list[Row]
    usual: str = ""
    none: str = ""

    @property
    def parts(self) -> tuple[list[Row], list[Row]]:
        """The rows that are seen, and those that are folded."""
        return self.rows[:FIRST], self.rows[FIRST:]


def figures(facts: Facts) -> list[tuple[str, str]]:
    """The figures that tell most, each with what it counts before it; none if nothing was traced."""
    structure = facts.structure
    if structure is None or facts.blocks is None:
        return []
    graph, part = structure["irregular"], structure["irregular_vertex_share"]
    rows = [
        ("Arcs", count(graph["arcs"])),
        ("Loops", count(graph["loops"])),
        ("Nodes", count(graph["nodes"])),
        ("Sheets", count(facts.sheets)),
        ("Chords", count(structure["chords"]["count"])),
        ("Blocks", count(facts.blocks)),
        ("Cells per block", f"{structure['base_complex']['cells_per_block']:,.2f}"),
    ]
    if part is not None:
        rows.append(("Irregular vertices inside", share(round(part * PER_MILLION), PER_MILLION)))
    word = structure_word(facts)
    return [*rows, ("Class", word)] if word else rows


def tallies(facts: Facts) -> list[list[Tally]]:
    """All tables of which something is known, in columns: of edges and nodes, of what goes through, of cells."""
    traced = facts.structure if facts.blocks is not None else None
    columns = [
        [*_edges(facts, traced), *_nodes(traced)],
        [*_layouts(traced)],
        [*_blocks(traced), *_layers(facts.cells_per_depth)],
    ]
    return [column for column in columns if column]


def _edges(facts: Facts, traced: dict[str, Any] | None) -> Iterator[Tally]:
    inside, boundary = facts.interior_edge_valence, facts.boundary_edge_valence
    if inside is not None:
        graph = traced["irregular"] if traced else {}
        chains = {head: graph[name] for name, head in CHAINS if graph.get(name)}
        yield Tally(
            "Interior edges by the cells around them",
            ("Valence", "Edges", *chains),
            [
                (str(v), [edges, *(None if v == 4 else by.get(str(v), 0) for by in chains.values())])
                for v, edges in sorted(inside.items())
            ],
            usual="4",
            none="none: no edge lies inside",
        )
    if boundary is not None:
        yield Tally(
            "Boundary edges by the cells around them", ("Valence", "Edges"), _sorted(boundary), usual="2"
        )


def _nodes(traced: dict[str, Any] | None) -> Iterator[Tally]:
    types = traced["irregular"]["node_types"] if traced else {}
    if types:
        rows = _most_first({_node(name): number for name, number in types.items()})
        yield Tally("Nodes by the valences that meet there", ("Valences", "Nodes"), rows)


def _layouts(traced: dict[str, Any] | None) -> Iterator[Tally]:
    if traced is None:
        return
    sheets, chords, base = traced["sheets"], traced["chords"], traced["base_complex"]
    through: list[Row] = [(words, [sheets[name], chords.get(name)]) for name, words in SHEETS_AND_CHORDS]
    yield Tally("Sheets and chords", ("Kind", "Sheets", "Chords"), through)
    parts: list[Row] = [(words, [base[name]]) for name, words in BASE_COMPLEX]
    inside = traced["interior_base_complex"]["blocks"]
    yield Tally("Base complex", ("Part", "Number"), [*parts, ("blocks by the inside alone", [inside])])


def _blocks(traced: dict[str, Any] | None) -> Iterator[Tally]:
    if traced is None:
        return
    base = traced["base_complex"]
    kinds = {KINDS.get(kind, kind): number for kind, number in base["kinds"].items()}
    yield Tally("Blocks by kind", ("Kind", "Blocks"), _most_first(kinds))
    sizes = {_size(size): number for size, number in base["dims"].items()}
    yield Tally("Blocks by size", ("Cells", "Blocks"), _most_first(sizes))


def _layers(cells: list[int] | None) -> Iterator[Tally]:
    if cells is not None:
        rows: list[Row] = [(str(hops), [number]) for hops, number in enumerate(cells)]
        yield Tally("Cells by hop distance from the boundary", ("Distance", "Cells"), rows)


def _sorted(numbers: Counts) -> list[Row]:
    return [(str(key), [number]) for key, number in sorted(numbers.items())]


def _most_first(numbers: dict[str, int]) -> list[Row]:
    return [(key, [number]) for key, number in sorted(numbers.items(), key=lambda item: -item[1])]


def _node(name: str) -> str:
    """Valences before the place: "i 3 3 5 5" as "3 3 5 5, inside", "b 3" as "3, on the boundary"."""
    place, _, valences = name.partition(" ")
    return f"{valences}, {'inside' if place == 'i' else 'on the boundary'}"


def _size(name: str) -> str:
    """Sizes to be read: "2x4x9" as "2 × 4 × 9", "twisted 768" as "twisted ring of 768"."""
    kind, _, cells = name.partition(" ")
    if cells.isdigit():
        return f"{KINDS.get(kind, kind)} of {count(int(cells))}"
    return f"{kind} {cells}".strip().replace("x", " × ")
