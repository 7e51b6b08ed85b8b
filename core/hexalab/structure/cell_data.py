"""Structure as attributes of cells, for files."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from ..arrays import Ids
from ..mesh import Mesh
from .structure import Structure


def _sheet(direction: int, structure: Structure) -> Ids:
    sheets: Ids = structure.sheet_of_cells[direction]
    return sheets


def _chord(direction: int, structure: Structure) -> Ids:
    chords: Ids = structure.chord_of_cells[direction]
    return chords


CELL_DATA: dict[str, Callable[[Structure], Ids]] = {
    **{f"sheet_{k + 1}": partial(_sheet, k) for k in range(3)},
    **{f"chord_{k + 1}": partial(_chord, k) for k in range(3)},
    "block": lambda structure: structure.block_of_cells,
    "irregular_distance": lambda structure: structure.irregular_distance_of_cells,
}
"""Name of each attribute, and its values, (C,) int32: numbers from 0 on, -1 where nothing is traced or no way leads."""


def cell_data(structure: Structure) -> dict[str, Ids]:
    """All of `CELL_DATA` by name; where the file has such a name, ours is `NAME (traced)`."""
    taken = structure.mesh.cell_data
    return {
        f"{name} (traced)" if name in taken else name: values(structure) for name, values in CELL_DATA.items()
    }


def with_structure(mesh: Mesh) -> Mesh:
    """Add the structure to a mesh as attributes of its cells; see `cell_data`."""
    return replace(mesh, cell_data={**mesh.cell_data, **cell_data(Structure(mesh))})
