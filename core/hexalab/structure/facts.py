"""The facts of a structure, as `hexalab structure --json` prints them and the catalogue keeps them."""

from __future__ import annotations

import hashlib
from typing import Any

import numpy as np

from ..arrays import Array
from .blocks import BOX, KINDS, RING, Blocks
from .graph import Graph
from .structure import Structure

REGULAR, POLYCUBE = "regular", "polycube"
"""The classes that are exact: no irregular interior edge, and one block for each component, or more."""


def facts_of(structure: Structure, labels: bool = True) -> dict[str, Any]:
    """Collect the facts.

    Parameters
    ----------
    structure : Structure
    labels : bool
        Whether hashes of all labels are wanted, which take longer than the rest on large meshes.

    Returns
    -------
    dict
        Ready for JSON, with the keys `irregular`, `sheets`, `chords`, `base_complex`, `interior_base_complex`,
        `class`, `irregular_vertex_share`, `labels`, and `skipped`, what is not traced, if there is any.
    """
    sheets, chords = structure.sheets, structure.chords
    facts: dict[str, Any] = {
        "irregular": graph_facts(structure.graph),
        "sheets": {
            "count": sheets.count,
            "closed": _sum(sheets.closed),
            "self_intersecting": _sum(sheets.self_intersecting),
            "self_touching": _sum(sheets.self_touching),
            "one_sided": _sum(sheets.one_sided),
        },
        "chords": {
            "count": chords.count,
            "closed": _sum(chords.closed),
            "self_intersecting": _sum(chords.self_intersecting),
        },
        "base_complex": complex_facts(structure),
        "interior_base_complex": {"blocks": structure.interior_base_complex.count},
        "class": class_of(structure),
        "irregular_vertex_share": irregular_vertex_share(structure),
    }
    if labels:
        facts["labels"] = {
            "sheets": hash_of(sheets.of_cells.T),
            "chords": hash_of(chords.of_cells.T),
            "blocks": hash_of(structure.base_complex.of_cells),
        }
    skipped = structure.frame.skipped
    return {"skipped": skipped, **facts} if skipped else facts


def graph_facts(graph: Graph) -> dict[str, Any]:
    """Counts of nodes, arcs and loops, by valence and by type."""
    types = dict(
        zip(graph.types, np.bincount(graph.node_types, minlength=len(graph.types)).tolist(), strict=True)
    )
    return {
        "nodes": len(graph.nodes),
        "nodes_inside": sum(number for name, number in types.items() if name.startswith("i")),
        "arcs": graph.arcs,
        "loops": graph.count - graph.arcs,
        "arcs_by_valence": _tally(graph.valence[: graph.arcs]),
        "loops_by_valence": _tally(graph.valence[graph.arcs :]),
        "node_types": types,
    }


def complex_facts(structure: Structure) -> dict[str, Any]:
    """Counts of blocks, vertices, edges and faces."""
    base, skeleton = structure.base_complex, structure.skeleton
    blocks = base.blocks
    return {
        "blocks": blocks.count,
        "vertices": len(skeleton.vertices),
        "edges": skeleton.edges.open,
        "edge_loops": skeleton.edges.count - skeleton.edges.open,
        "faces": skeleton.faces,
        "kinds": {
            KINDS[kind]: number for kind, number in enumerate(np.bincount(blocks.kinds).tolist()) if number
        },
        "dims": dimensions(blocks),
        "separation_faces": _sum(base.separating[: structure.frame.paired]),
        "cells_per_block": round(structure.frame.count / blocks.count, 4) if blocks.count else None,
        "base_sheets": structure.base_sheets[1],
        "base_chords": structure.base_chords[1],
    }


def class_of(structure: Structure) -> str | None:
    """The exact class of the mesh, `REGULAR` or `POLYCUBE`; None for all others, and where some is not traced.

    For the words that are used of other meshes there are no published thresholds.
    """
    frame = structure.frame
    if not frame.count or frame.skipped or (frame.irregular & ~frame.edge_on_boundary).any():
        return None
    return REGULAR if structure.base_complex.count == frame.topology.component_count else POLYCUBE


def irregular_vertex_share(structure: Structure) -> float | None:
    """The share of vertices at an interior irregular edge among the vertices inside; None if none is inside."""
    frame = structure.frame
    inside = frame.vertex_used & ~frame.vertex_on_boundary
    at = np.zeros(len(inside), dtype=bool)
    at[frame.edge_vertices[:, frame.irregular & ~frame.edge_on_boundary]] = True
    total = _sum(inside)
    return round(_sum(at & inside) / total, 6) if total else None


def dimensions(blocks: Blocks) -> dict[str, int]:
    """Blocks of each size: "2x4x9" for boxes, "ring 2x4x(36)", and the cells of others: "twisted 768"."""
    rows = np.column_stack([blocks.kinds.astype(np.int32), blocks.dimensions, blocks.cells])
    rows[blocks.kinds == BOX, 4] = 0
    found, numbers = np.unique(rows, axis=0, return_counts=True)
    return {_size(*row): number for row, number in zip(found.tolist(), numbers.tolist(), strict=True)}


def _size(kind: int, i: int, j: int, k: int, cells: int) -> str:
    if kind == BOX:
        return f"{i}x{j}x{k}"
    return f"{KINDS[kind]} {i}x{j}x({k})" if kind == RING else f"{KINDS[kind]} {cells}"


def hash_of(labels: Array) -> str:
    """The first 16 hexadecimal digits of the SHA-256 of labels in decimal, joined by commas: for exact comparison."""
    return hashlib.sha256(",".join(map(str, labels.reshape(-1).tolist())).encode()).hexdigest()[:16]


def _tally(values: Array) -> dict[str, int]:
    found, numbers = np.unique(values, return_counts=True)
    return {str(value): number for value, number in zip(found.tolist(), numbers.tolist(), strict=True)}


def _sum(flags: Array) -> int:
    return int(np.count_nonzero(flags))
