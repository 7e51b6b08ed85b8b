"""Nodes, elements and entities of `.msh` 3, as Gmsh writes it when asked for (`Mesh.MshFileVersion` 3).

Gmsh's manual does not describe this version: the layout is that of files which Gmsh 4.15 writes.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from .byte_order import as_coordinates, native
from .gmsh_parts import Elements, Nodes, Rows, nodes_of, sound
from .gmsh_sections import Lines
from .gmsh_types import DIMENSION
from .row_chain import RowForm


def _line_length(types: Array, count: Array) -> Array:
    count, nodes = count.astype(np.int64), nodes_of(types)
    return sound(4 + count, nodes - 1, count - nodes)


LINES = RowForm((1, 3), _line_length)
"""Number, type, entity, how many numbers follow: the nodes, and behind them what is not of use here."""


class Gmsh3(Lines):
    """Reads the sections of a version 3 file."""

    physical_of: tuple[Array, ...] = (np.zeros((2, 0), dtype=np.int64),) * 4
    """For each dimension: entities, rising, and their physical groups."""

    def nodes(self) -> Nodes:
        """Read what follows `$Nodes`: number, x, y, z, and the entity for parametric nodes, 0 for others.

        Raises
        ------
        MeshReadError
            The section is cut short, or a node is parametric.
        """
        numbers = self.numbers
        if not numbers.binary:
            rows = self.ascii_nodes(5, "$Nodes", b"$EndNodes")
            self.check(rows[:, 4])
            return self.nodes_of(rows, "$Nodes")
        count = numbers.count(numbers.text.integer("the number of nodes"), 7, "nodes")
        numbers.begin()
        order = numbers.order
        dtype = np.dtype([("tag", order + "i4"), ("x", order + "f8", 3), ("entity", order + "i4")])
        packed = np.frombuffer(numbers.bytes(count * dtype.itemsize, "$Nodes"), dtype)
        self.check(packed["entity"])
        return Nodes(native(packed["tag"]).astype(np.int64), as_coordinates(packed["x"]))

    def check(self, entities: Array) -> None:
        """Raise if a node is parametric: more numbers than can be told follow it."""
        if entities.any():
            raise self.numbers.error(
                "parametric nodes of version 3 can't be read: save the mesh without them"
            )

    def elements(self) -> list[Elements]:
        """Read what follows `$Elements`; raises MeshReadError."""
        values, count, begin = self.element_values("$Elements", b"$EndElements")
        at = self.starts(values, count, LINES, "$Elements")
        entities, none = values[at + 2], np.zeros(len(at), dtype=np.int32)
        types = values[at + 1]
        physicals = np.zeros(len(at), dtype=np.int64)
        for dimension, (known, groups) in enumerate(self.physical_of):
            if not len(known):
                continue
            found = np.searchsorted(known, entities).clip(max=len(known) - 1)
            own = (known[found] == entities) & (DIMENSION[types] == dimension)
            physicals[own] = groups[found[own]]
        rows = Rows(values, at + 4, types, values[at], entities, physicals, none, begin)
        return rows.by_type(self.out)

    def entities(self) -> None:
        """Read which physical group each entity belongs to, the first: text, in binary files too."""
        text = self.numbers.text
        counts = [self.numbers.count(text.integer("the number of entities"), 2, "entities") for _ in range(4)]
        rows: list[list[tuple[int, int]]] = [[], [], [], []]
        for dimension, count in enumerate(counts):
            for _ in range(count):
                tag = text.integer("an entity's number")
                if dimension:
                    self.tags()
                groups = self.tags()
                if groups and max(abs(tag), abs(groups[0])) < 2**31:
                    rows[dimension].append((tag, abs(groups[0])))
        self.physical_of = tuple(np.array(sorted(some), dtype=np.int64).reshape(-1, 2).T for some in rows)

    def tags(self) -> list[int]:
        """A counted list of whole numbers."""
        text = self.numbers.text
        count = self.numbers.count(text.integer("a number of tags"), 2, "tags")
        return [text.integer("a tag") for _ in range(count)]
