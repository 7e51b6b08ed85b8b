"""What the structure of a mesh consists of, cell by cell, by dictionaries: for the tests of what is shown of it."""

from __future__ import annotations

from typing import Any

from hexalab.mesh import Mesh
from tests.core.structure.brute_force import FACES, FIRST, OPPOSITE, Slow


def traced_rows(mesh: Mesh) -> list[int]:
    """The cells that structure is traced in: hexahedra of eight vertices."""
    return [cell for cell in range(mesh.cell_count) if len(set(mesh.cells[cell].tolist())) == 8]


def slow_of(mesh: Mesh) -> Slow:
    """The structure of these, numbered by themselves."""
    return Slow(mesh.cells[traced_rows(mesh)].tolist())


def things(mesh: Mesh, inside_only: bool = False) -> dict[str, list[set[int]]]:
    """The cells of all blocks, sheets and chords, by dictionaries; each kind in the order of their first cells."""
    rows, slow = traced_rows(mesh), slow_of(mesh)
    sheet, chord, block = slow.sheets(), slow.chords(), slow.blocks(inside_only)
    found: dict[str, dict[Any, set[int]]] = {kind: {} for kind in ("blocks", "sheets", "chords")}
    for place, cell in enumerate(slow.cells):
        found["blocks"].setdefault(block[place], set()).add(rows[place])
        for edge in FIRST:
            found["sheets"].setdefault(sheet[frozenset(cell[p] for p in edge)], set()).add(rows[place])
        for begin, _ in OPPOSITE:
            face = frozenset(cell[p] for p in FACES[begin])
            found["chords"].setdefault(chord[face], set()).add(rows[place])
    return {kind: list(members.values()) for kind, members in found.items()}
