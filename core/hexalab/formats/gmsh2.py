"""Nodes and elements of `.msh` 2."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..errors import MeshReadError
from .assembly import Assembly
from .byte_order import as_coordinates, native
from .gmsh_numbers import Numbers
from .gmsh_parts import Elements, Nodes, nodes_of, own_corners
from .ids import whole_tags
from .row_chain import RowForm, row_starts

MOST_TAGS = 1000


def _sound(length: Array, *counts: Array) -> Array:
    """The lengths, 0 where one of the counts they are made of makes no sense."""
    good = np.ones(len(length), dtype=bool)
    for count in counts:
        good &= (count >= 0) & (count <= 2**31)
    return np.where(good, length, 0)


def _line_length(types: Array, tag_counts: Array) -> Array:
    nodes, tags = nodes_of(types), tag_counts.astype(np.int64)
    return _sound(3 + tags + nodes, nodes - 1, MOST_TAGS - tags, tags)


def _group_length(types: Array, follow: Array, tag_counts: Array) -> Array:
    nodes, tags, follow = nodes_of(types), tag_counts.astype(np.int64), follow.astype(np.int64)
    return _sound(3 + follow * (1 + tags + nodes), nodes - 1, MOST_TAGS - tags, tags, follow)


LINES = RowForm((1, 2), _line_length)
"""ASCII: number, type, count of tags, tags, nodes."""

GROUPS = RowForm((0, 1, 2), _group_length)
"""Binary: type, elements that follow, count of tags; then for each its number, tags, nodes."""


class Gmsh2:
    """Reads the two sections of a version 2 file."""

    def __init__(self, numbers: Numbers) -> None:
        self.numbers = numbers

    def nodes(self) -> Nodes:
        """Read what follows `$Nodes`: in ASCII a line per node, in binary rows of int32 and three doubles.

        Raises
        ------
        MeshReadError
            The section is cut short, or a node's number isn't whole.
        """
        numbers = self.numbers
        count = numbers.count(numbers.text.integer("the number of nodes"), 7, "nodes")
        if not numbers.binary:
            values = numbers.doubles(4 * count, "$Nodes").reshape(count, 4)
            tags = whole_tags(values[:, 0])
            if tags is None:
                raise numbers.error("a node of $Nodes has a number that is not whole")
            return Nodes(tags, np.ascontiguousarray(values[:, 1:].T))
        numbers.begin()
        dtype = np.dtype([("tag", numbers.order + "i4"), ("x", numbers.order + "f8", 3)])
        rows = np.frombuffer(numbers.bytes(count * dtype.itemsize, "$Nodes"), dtype)
        return Nodes(native(rows["tag"]).astype(np.int64), as_coordinates(rows["x"]))

    def elements(self, out: Assembly) -> list[Elements]:
        """Read what follows `$Elements`; what isn't volumetric is counted in `out`.

        In ASCII each element says its own type and number of tags, in binary a group of elements does.

        Raises
        ------
        MeshReadError
            The rows don't fit the count announced or one another.
        """
        numbers = self.numbers
        text = numbers.text
        count = numbers.count(numbers.text.integer("the number of elements"), 4, "elements")
        numbers.begin()
        begin = text.position
        end = text.data.find(b"$EndElements", begin)
        if end < 0:
            raise numbers.error("the file ends before $EndElements", begin)
        if not numbers.binary:
            values = text.between(begin, end, np.intp, "$Elements")
            starts = row_starts(values, count, LINES, self.error_at, "$Elements")
            types, tag_counts, tags = values[starts + 1], values[starts + 2], values[starts]
            return self.parts(out, values, types, tag_counts, tags, starts + 3, begin)
        size = self.binary_size(begin, end)
        values = numbers.ints(size, "$Elements").astype(np.int32)
        groups = row_starts(values, None, GROUPS, self.error_at, "$Elements")
        follow = values[groups + 1].astype(np.int64)
        if int(follow.sum()) != count:
            raise numbers.error(f"$Elements has {int(follow.sum())} elements, but announces {count}", begin)
        types, tag_counts = np.repeat(values[groups], follow), np.repeat(values[groups + 2], follow)
        within = np.arange(count) - np.repeat(np.cumsum(follow) - follow, follow)
        rows = np.repeat(groups + 3, follow) + within * (1 + tag_counts + nodes_of(types))
        return self.parts(out, values, types, tag_counts, values[rows], rows + 1, begin)

    def binary_size(self, begin: int, end: int) -> int:
        """Number of ints between two offsets; the end mark stands right behind them or on the next line.

        Raises
        ------
        MeshReadError
            The bytes make no whole number of ints.
        """
        size = end - begin
        if size % 4 and self.numbers.text.data[end - 1 : end] == b"\n":
            size -= 1
        if size % 4:
            raise self.numbers.error(f"$Elements are {size} bytes, expected a multiple of 4", begin)
        return size // 4

    def error_at(self, message: str, _index: int) -> MeshReadError:
        """An error about the section, whichever of its numbers is wrong."""
        return self.numbers.error(message)

    def parts(
        self,
        out: Assembly,
        values: Array,
        types: Array,
        tag_counts: Array,
        tags: Array,
        after: Array,
        begin: int,
    ) -> list[Elements]:
        """Elements by type.

        Parameters
        ----------
        out : Assembly
            Where elements that aren't volumetric are counted.
        values : (n,) int
            The section's numbers.
        types, tag_counts, tags : (m,) int
            Of each element: gmsh's type, how many tags it has, its number.
        after : (m,) int
            Where each element's tags begin in `values`; its nodes stand behind them.
        begin : int
            Byte at which the section begins, for errors.

        Returns
        -------
        list of Elements
            One for each type that is kept.
        """
        parts = []
        for number in np.unique(types).tolist():
            which = np.flatnonzero(types == number)
            own = own_corners(out, number, len(which))
            if own is None:
                continue
            kind, order = own
            nodes = after[which] + tag_counts[which]
            corners = np.stack([values[nodes + corner] for corner in order])
            first, second = (
                np.where(
                    tag_counts[which] > place, values[np.minimum(after[which] + place, len(values) - 1)], 0
                )
                for place in (0, 1)
            )
            parts.append(Elements(kind, corners, tags[which], second, first, which, begin))
        return parts
