"""Nodes and elements of `.msh` 2."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from .byte_order import as_coordinates, native
from .gmsh_parts import Elements, Nodes, Rows, nodes_of, sound
from .gmsh_sections import Lines
from .row_chain import RowForm, row_starts

MOST_TAGS = 1000


def _line_length(types: Array, tag_counts: Array) -> Array:
    nodes, tags = nodes_of(types), tag_counts.astype(np.int64)
    return sound(3 + tags + nodes, nodes - 1, MOST_TAGS - tags, tags)


def _group_length(types: Array, follow: Array, tag_counts: Array) -> Array:
    nodes, tags, follow = nodes_of(types), tag_counts.astype(np.int64), follow.astype(np.int64)
    return sound(3 + follow * (1 + tags + nodes), nodes - 1, MOST_TAGS - tags, tags, follow)


LINES = RowForm((1, 2), _line_length)
"""ASCII: number, type, count of tags, tags, nodes."""

GROUPS = RowForm((0, 1, 2), _group_length)
"""Binary: type, elements that follow, count of tags; then for each its number, tags, nodes."""

PHYSICAL, ENTITY, PARTITION = 0, 1, 3
"""Which of an element's tags says what; the one before the partition says how many partitions there are."""


class Gmsh2(Lines):
    """Reads the two sections of a version 2 file."""

    def nodes(self) -> Nodes:
        """Read what follows `$Nodes`: in ASCII a line per node, in binary rows of int32 and three doubles.

        Raises
        ------
        MeshReadError
            The section is cut short, or a node's number isn't whole.
        """
        numbers = self.numbers
        if not numbers.binary:
            return self.nodes_of(self.ascii_nodes(4, "$Nodes", b"$EndNodes"), "$Nodes")
        count = numbers.count(numbers.text.integer("the number of nodes"), 7, "nodes")
        numbers.begin()
        dtype = np.dtype([("tag", numbers.order + "i4"), ("x", numbers.order + "f8", 3)])
        rows = np.frombuffer(numbers.bytes(count * dtype.itemsize, "$Nodes"), dtype)
        return Nodes(native(rows["tag"]).astype(np.int64), as_coordinates(rows["x"]))

    def elements(self) -> list[Elements]:
        """Read what follows `$Elements`; what isn't volumetric is counted.

        In ASCII each element says its own type and number of tags, in binary a group of elements does.

        Raises
        ------
        MeshReadError
            The rows don't fit the count announced or one another.
        """
        values, count, begin = self.element_values("$Elements", b"$EndElements")
        if not self.numbers.binary:
            at = self.starts(values, count, LINES, "$Elements")
            types, tag_counts, tags, after = values[at + 1], values[at + 2], values[at], at + 3
        else:
            groups = row_starts(values, None, GROUPS, self.error_at, "$Elements")
            follow = values[groups + 1].astype(np.int64)
            if int(follow.sum()) != count:
                raise self.numbers.error(
                    f"$Elements has {int(follow.sum())} elements, but announces {count}", begin
                )
            types, tag_counts = np.repeat(values[groups], follow), np.repeat(values[groups + 2], follow)
            within = np.arange(count) - np.repeat(np.cumsum(follow) - follow, follow)
            rows = np.repeat(groups + 3, follow) + within * (1 + tag_counts + nodes_of(types))
            tags, after = values[rows], rows + 1
        physicals, entities, partitions = (
            np.where(tag_counts > place, values[np.minimum(after + place, len(values) - 1)], 0)
            for place in (PHYSICAL, ENTITY, PARTITION)
        )
        return Rows(values, after + tag_counts, types, tags, entities, physicals, partitions, begin).by_type(
            self.out
        )
