"""Which cells belong to arcs, sheets, chords and blocks, by their numbers."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from .base_complex import BaseComplex, Skeleton
from .graph import Graph
from .structure import Structure

Cells = NDArray[np.bool_]


def base_of(structure: Structure, variant: str) -> BaseComplex:
    """The base complex of all irregular edges ("whole"), or of those inside alone ("interior")."""
    return structure.interior_base_complex if variant == "interior" else structure.base_complex


def skeleton_of(structure: Structure, variant: str) -> Skeleton:
    """Vertices, edges and faces of that base complex."""
    return structure.interior_skeleton if variant == "interior" else structure.skeleton


def graph_of(structure: Structure, variant: str) -> Graph:
    """The graph of all irregular edges ("whole"), or of those inside alone ("interior")."""
    return structure.whole_graph if variant == "whole" else structure.graph


def count_of(structure: Structure, kind: str, variant: str = "whole") -> int:
    """How many arcs (with loops), sheets, chords or blocks there are."""
    if kind == "arcs":
        return graph_of(structure, variant).count
    if kind == "sheets":
        return structure.sheets.count
    return structure.chords.count if kind == "chords" else base_of(structure, variant).count


def known(numbers: Iterable[int], count: int) -> Ids:
    """Those of some numbers that are below a count, in their order, each once."""
    return np.array([one for one in dict.fromkeys(numbers) if 0 <= one < count], np.int32)


def cells_of(structure: Structure, kind: str, numbers: Iterable[int], variant: str = "whole") -> Cells:
    """(C,) bool: which cells of the mesh are in any of some sheets, chords or blocks, or around some arcs.

    Parameters
    ----------
    structure : Structure
    kind : "arcs", "sheets", "chords" or "blocks"
    numbers : iterable of int
        Numbers that there aren't are left out.
    variant : "whole" or "interior"
        Which arcs and blocks are meant: of all irregular edges, or of those inside alone.
    """
    return _in_mesh(structure, _cells_of_frame(structure, kind, numbers, variant))


def _cells_of_frame(structure: Structure, kind: str, numbers: Iterable[int], variant: str) -> Cells:
    frame = structure.frame
    wanted = np.zeros(count_of(structure, kind, variant), dtype=bool)
    wanted[known(numbers, len(wanted))] = True
    if kind == "arcs":
        edges = np.zeros(frame.edge_count, dtype=bool)
        graph = graph_of(structure, variant)
        edges[graph.edges[np.repeat(wanted, graph.lengths)]] = True
        rows: Array = frame.cell_edges
        return _any(edges, rows)
    return _any(wanted, labels_of(structure, kind, variant))


def labels_of(structure: Structure, kind: str, variant: str = "whole") -> Ids:
    """(k, N) int32: sheets, chords (k is 3) or block (1) of each cell of the frame."""
    if kind == "blocks":
        return base_of(structure, variant).of_cells[None]
    return structure.sheets.of_cells if kind == "sheets" else structure.chords.of_cells


def _any(flags: Cells, rows: Array) -> Cells:
    """Whether any of each cell's entries is flagged, of (k, N) rows."""
    out: Cells = flags[rows[0]]
    for row in rows[1:]:
        out |= flags[row]
    return out


def _in_mesh(structure: Structure, of_frame: Cells) -> Cells:
    frame = structure.frame
    if frame.cells is None:
        return of_frame
    out = np.zeros(structure.mesh.cell_count, dtype=bool)
    out[frame.cells] = of_frame
    return out
