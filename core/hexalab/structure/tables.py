"""What a structure consists of as tables: a column of values for each property, a row for each thing."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..arrays import Array
from ..numbering import vertex_numbers
from .blocks import KINDS, Blocks
from .graph import Graph
from .structure import Structure

SHEET_KINDS = ("plain", "self-touching", "self-intersecting")
CHORD_KINDS = ("plain", "self-intersecting")


class Column(NamedTuple):
    """Values of one property.

    Attributes
    ----------
    values : (n,) array
        Numbers; whether something holds; or places in `words`.
    words : tuple of str
        What the numbers stand for, if they stand for words.
    """

    values: Array
    words: tuple[str, ...] = ()

    def told(self) -> list[str]:
        """Each value as CSV has it."""
        values = self.values.tolist()
        if self.words:
            return [self.words[value] for value in values]
        return [YES_NO[not value] if isinstance(value, bool) else str(value) for value in values]


YES_NO = ("yes", "no")

Columns = dict[str, Column]
"""Columns by name."""


def arcs_table(structure: Structure, graph: Graph | None = None) -> Columns:
    """Arcs and loops of a graph, the interior one by default: valence, edges, whether closed, vertices at the ends."""
    graph = structure.graph if graph is None else graph
    ends = (
        graph.vertices[np.stack([graph.starts[:-1], graph.starts[1:] - 1])]
        if graph.count
        else np.empty((2, 0), int)
    )
    return {
        "number": Column(np.arange(graph.count)),
        "valence": Column(graph.valence),
        "edges": Column(graph.lengths),
        "closed": Column(np.arange(graph.count) >= graph.arcs),
        "boundary": Column(graph.on_boundary),
        "from": Column(vertex_numbers(structure.mesh, ends[0])),
        "to": Column(vertex_numbers(structure.mesh, ends[1])),
    }


def nodes_table(structure: Structure) -> Columns:
    """Nodes of the interior graph: vertex and type."""
    graph = structure.graph
    return {
        "number": Column(np.arange(len(graph.nodes))),
        "vertex": Column(vertex_numbers(structure.mesh, graph.nodes)),
        "type": Column(graph.node_types, graph.types),
    }


def sheets_table(structure: Structure) -> Columns:
    """Sheets: cells, kind, whether closed and one-sided, crossings, edges, base sheet."""
    sheets = structure.sheets
    kinds = np.where(sheets.self_intersecting, 2, sheets.self_touching)
    return {
        "number": Column(np.arange(sheets.count)),
        "cells": Column(sheets.cells),
        "kind": Column(kinds, SHEET_KINDS),
        "closed": Column(sheets.closed),
        "one_sided": Column(sheets.one_sided),
        "crossings": Column(sheets.crossings),
        "edges": Column(sheets.edges),
        "base_sheet": Column(structure.base_sheets[0]),
    }


def chords_table(structure: Structure) -> Columns:
    """Chords: length, kind, whether closed, base chord."""
    chords = structure.chords
    return {
        "number": Column(np.arange(chords.count)),
        "length": Column(chords.length),
        "kind": Column(chords.self_intersecting.astype(np.uint8), CHORD_KINDS),
        "closed": Column(chords.closed),
        "base_chord": Column(structure.base_chords[0]),
    }


def blocks_table(structure: Structure, blocks: Blocks | None = None) -> Columns:
    """Blocks, of the whole base complex by default: cells, kind, dimensions (see `Blocks`)."""
    blocks = structure.base_complex.blocks if blocks is None else blocks
    return {
        "number": Column(np.arange(blocks.count)),
        "cells": Column(blocks.cells),
        "kind": Column(blocks.kinds, KINDS),
        **{name: Column(blocks.dimensions[:, axis]) for axis, name in enumerate("ijk")},
    }


TABLES: dict[str, Callable[[Structure], Columns]] = {
    "arcs": arcs_table,
    "nodes": nodes_table,
    "sheets": sheets_table,
    "chords": chords_table,
    "blocks": blocks_table,
}
"""Every table by its name."""


def csv_of(columns: Columns) -> str:
    """A table as CSV: names, then the values; what holds is "yes", what does not is "no". Nothing needs quotes."""
    told = [column.told() for column in columns.values()]
    return "".join(",".join(row) + "\n" for row in [columns, *zip(*told, strict=True)])
