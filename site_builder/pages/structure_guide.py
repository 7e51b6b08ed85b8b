"""What the guide's page on structure is filled with."""

from __future__ import annotations

from pathlib import Path
from typing import Any, TypedDict

from hexalab.cli.structure import described
from hexalab.structure import CELL_DATA, TABLES
from hexalab.structure.quantities import QUANTITIES

from ..model.catalogue import Catalogue, MeshEntry
from ..pictures.collection import Collection
from .words import count, share, structure_word

EXAMPLES = Path(__file__).resolve().parents[2] / "docs" / "examples"
EXAMPLE, PRINTED = EXAMPLES / "structure.py", EXAMPLES / "structure.txt"
"""The script that the page shows, and what it prints for `DESCRIBED`."""

DESCRIBED = "shapes/sphere"
"""The mesh that is described in a shell and asked about in Python."""

COMPARED = (
    "shapes/twisted-bar",
    "layouts/straight-walls",
    "layouts/winding-walls",
    "shapes/sphere",
    "shapes/bracket",
    "structures/octree",
)
"""Meshes whose figures stand side by side, from regular to scattered."""

CHAPTERS = (
    ("irregular", "Irregular edges and valence"), ("graph", "Arcs and loops"), ("nodes", "Types of nodes"),
    ("sheets", "Sheets"), ("kinds-of-sheets", "Kinds of sheets"), ("crossing", "Sheets that meet"),
    ("chords", "Chords"), ("base-complex", "Base complex and blocks"), ("kinds-of-blocks", "Boxes and rings"),
    ("variants", "Whole and interior"), ("base-sheets", "Base sheets and base chords"),
    ("misaligned", "Seven blocks or 57"), ("classes", "Regular, polycube, and no other word"),
    ("context", "Focus and context"), ("filters", "Filters and colours"), ("octree", "Octree-like meshes"),
    ("shell", "In a shell"), ("python", "In Python"), ("limits", "Where it ends"), ("sources", "Sources"),
)  # fmt: skip
"""The page's sections by their anchors."""

PER_MILLION = 1_000_000


class Compared(TypedDict):
    """A mesh in the table of figures, all in words."""

    mesh: MeshEntry
    word: str
    blocks: str
    cells_per_block: str
    irregular: str


def structure_guide_values(catalogue: Catalogue, collection: Collection) -> dict[str, Any]:
    """Values of the template."""
    traced = {mesh.id: mesh for mesh in catalogue.meshes if mesh.facts.blocks is not None}
    return {
        "heading": "Structure",
        "description": "Irregular edges, sheets, chords, base complex: what the words mean, with pictures.",
        "chapters": CHAPTERS,
        "figures": collection.lessons,
        "compared": [_compared(traced[id]) for id in COMPARED if id in traced],
        "quantities": [(id, quantity.name) for id, quantity in QUANTITIES.items()],
        "tables": list(TABLES),
        "arrays": list(CELL_DATA),
        "described": _described(traced.get(DESCRIBED)),
        "code": EXAMPLE.read_text("utf-8").strip(),
        "printed": PRINTED.read_text("utf-8").strip(),
    }


def _compared(mesh: MeshEntry) -> Compared:
    structure = mesh.facts.structure or {}
    part = structure["irregular_vertex_share"]
    return {
        "mesh": mesh,
        "word": structure_word(mesh.facts),
        "blocks": count(mesh.facts.blocks),
        "cells_per_block": f"{structure['base_complex']['cells_per_block']:,.2f}",
        "irregular": "" if part is None else share(round(part * PER_MILLION), PER_MILLION),
    }


def _described(mesh: MeshEntry | None) -> str:
    """The command for a mesh and what it prints; empty where the mesh is not here."""
    if mesh is None or mesh.facts.structure is None:
        return ""
    return f"{mesh.file_name}\n{described(mesh.file_name, mesh.facts.structure)}"
