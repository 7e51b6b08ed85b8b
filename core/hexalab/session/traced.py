"""The structure of an open mesh: traced step by step, and told as tables."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ..arrays import Array, Floats
from ..errors import HexaLabError
from ..mesh import Mesh
from ..structure import Structure, facts_of
from ..structure.matrix import sheet_pairs
from ..structure.members import base_of, cells_of, graph_of
from ..structure.quantities import quantity_values
from ..structure.tables import TABLES, Columns, arcs_table, blocks_table, csv_of
from ..surface import DrawnMesh

STEPS: dict[str, Callable[[Structure], object]] = {
    "faces": lambda structure: structure.frame.joints,
    "edges": lambda structure: structure.frame.cell_edges,
    "irregular edges": lambda structure: structure.graph,
    "sheets": lambda structure: structure.sheets,
    "chords": lambda structure: structure.chords,
    "walls": lambda structure: structure.base_complex,
    "blocks": lambda structure: structure.base_complex.blocks,
    "base complex": lambda structure: structure.skeleton,
    "base sheets": lambda structure: structure.base_sheets,
    "base chords": lambda structure: structure.base_chords,
    "blocks by the inside alone": lambda structure: structure.interior_base_complex,
}
"""What is traced one after the other, so that other questions can come between."""


THINGS = ("arcs", "sheets", "chords", "blocks")
"""What cells are told by."""


class TracedBook:
    """The structure of a mesh, each part found when it is first asked for.

    Parameters
    ----------
    mesh : Mesh
    """

    def __init__(self, mesh: Mesh) -> None:
        self.structure = Structure(mesh)
        self._done = 0

    def trace(self) -> dict[str, Any]:
        """Take the next of `STEPS`; return how many are `done`, `of` how many, and the `next` one's name."""
        names = list(STEPS)
        if self._done < len(names):
            STEPS[names[self._done]](self.structure)
            self._done += 1
        following = names[self._done] if self._done < len(names) else None
        return {"done": self._done, "of": len(names), "next": following}

    @property
    def done(self) -> bool:
        """Whether all steps were taken."""
        return self._done == len(STEPS)

    def facts(self, labels: bool) -> dict[str, Any]:
        """The facts; see `hexalab.structure.facts_of`."""
        return facts_of(self.structure, labels)

    def columns(self, table: str, variant: str) -> Columns:
        """A table; `variant` says which arcs or blocks: "whole" or "interior".

        Raises
        ------
        HexaLabError
            There is no such table.
        """
        if table not in TABLES:
            raise HexaLabError(f"there is no table {table!r} of a structure, but {', '.join(TABLES)}")
        if table == "arcs":
            return arcs_table(self.structure, graph_of(self.structure, variant))
        if table == "blocks":
            return blocks_table(self.structure, base_of(self.structure, variant).blocks)
        return TABLES[table](self.structure)

    def table(self, table: str, variant: str) -> dict[str, Any]:
        """A table as arrays: `rows`, how many, and `columns`, each with `id`, `values`, and `words` if it has some."""
        columns = self.columns(table, variant)
        told = [
            {"id": id, "values": _plain(values), "words": list(words) or None}
            for id, (values, words) in columns.items()
        ]
        return {"rows": len(columns["number"].values), "columns": told}

    def csv(self, table: str, variant: str) -> str:
        """A table as CSV."""
        return csv_of(self.columns(table, variant))

    def pairs(self) -> dict[str, Any]:
        """Which sheets cross and which run side by side; see `hexalab.structure.matrix.SheetPairs`."""
        found = sheet_pairs(self.structure.frame, self.structure.sheets)
        return {
            "count": self.structure.sheets.count,
            "one": found.one,
            "other": found.other,
            "crossings": found.crossings.astype(np.int32),
            "beside": found.beside.astype(np.int32),
        }

    def at(self, cell: int) -> dict[str, Any] | None:
        """The `sheets` and `chords` of a cell in its three directions, and its `block`; None until they are traced."""
        if not self.done:
            return None
        structure = self.structure
        block = int(structure.block_of_cells[cell])
        if block < 0:
            return {"sheets": [], "chords": [], "block": None}
        return {
            "sheets": structure.sheet_of_cells[:, cell].tolist(),
            "chords": structure.chord_of_cells[:, cell].tolist(),
            "block": block,
        }

    def box(
        self, kind: str, numbers: list[int], variant: str, drawn_mesh: DrawnMesh
    ) -> dict[str, Any] | None:
        """`centre` and `size` (of its diagonal), in drawing coordinates, of the box around things; None without any.

        Raises
        ------
        HexaLabError
            There are no things of that kind.
        """
        if kind not in THINGS:
            raise HexaLabError(f"a structure has no {kind!r}, but {', '.join(THINGS)}")
        cells = np.flatnonzero(cells_of(self.structure, kind, numbers, variant))
        if not len(cells):
            return None
        points = drawn_mesh.points(drawn_mesh.mesh.corners[:, cells]).reshape(3, -1)
        low, high = np.nanmin(points, axis=1).astype(float), np.nanmax(points, axis=1).astype(float)
        return {"centre": (low / 2 + high / 2).tolist(), "size": float(np.hypot.reduce(high - low))}

    def values(self, id: str) -> Floats:
        """(C,) float64: a quantity of `hexalab.structure.quantities.QUANTITIES`."""
        return quantity_values(self.structure, id)


def _plain(values: Array) -> Array:
    """A column in a number type that every transport knows."""
    return values.astype(np.uint8 if values.dtype == bool else np.int32)
