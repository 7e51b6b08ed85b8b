"""Nodes and elements of `.msh` 1: the sections $NOD and $ELM, ASCII (Gmsh's manual, "MSH file format version 1")."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from .gmsh_parts import Elements, Nodes, Rows, nodes_of, sound
from .gmsh_sections import Lines
from .row_chain import RowForm


def _line_length(types: Array, count: Array) -> Array:
    count = count.astype(np.int64)
    return sound(np.where(count == nodes_of(types), 5 + count, 0), count - 1)


LINES = RowForm((1, 4), _line_length)
"""Number, type, physical group, entity, number of nodes, nodes."""


class Gmsh1(Lines):
    """Reads the two sections of a version 1 file."""

    def nodes(self) -> Nodes:
        """Read what follows `$NOD`: a line per node; raises MeshReadError."""
        return self.nodes_of(self.ascii_nodes(4, "$NOD", b"$ENDNOD"), "$NOD")

    def elements(self) -> list[Elements]:
        """Read what follows `$ELM`; raises MeshReadError where its rows don't fit their types."""
        values, count, begin = self.element_values("$ELM", b"$ENDELM")
        at = self.starts(values, count, LINES, "$ELM")
        none = np.zeros(len(at), dtype=np.int32)
        rows = Rows(values, at + 5, values[at + 1], values[at], values[at + 3], values[at + 2], none, begin)
        return rows.by_type(self.out)
