"""Sections of `.msh` 1 to 3: a line for each node and each element, which may be fewer than announced."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..arrays import Array
from ..errors import MeshReadError
from .assembly import Assembly
from .gmsh_numbers import Numbers
from .gmsh_parts import Nodes
from .ids import whole_tags
from .row_chain import RowForm, row_starts
from .text import Interrupted


class Lines:
    """Reads sections of lines.

    Parameters
    ----------
    numbers : Numbers
        The file.
    out : Assembly
        Gets notes and what is left out.
    """

    def __init__(self, numbers: Numbers, out: Assembly) -> None:
        self.numbers = numbers
        self.out = out

    def ascii_nodes(self, width: int, name: str, end: bytes) -> Array:
        """(n, width) float64 of a section of nodes in ASCII, whose number stands before them.

        As many as there are, with a note, where the section's end is marked before the number announced.
        """
        numbers, text = self.numbers, self.numbers.text
        count = numbers.count(text.integer("the number of nodes"), 7, "nodes")
        begin = text.position
        try:
            values = numbers.doubles(width * count, name)
        except Interrupted as stop:
            if stop.word != end or stop.found % width:
                raise
            text.position = begin
            self.out.note(
                f"{name} announces {count:,} nodes and has {stop.found // width:,}, which are read."
            )
            count = stop.found // width
            values = numbers.doubles(width * count, name)
        return values.reshape(count, width)

    def nodes_of(self, rows: Array, name: str) -> Nodes:
        """Nodes out of rows of a number and three coordinates."""
        tags = whole_tags(rows[:, 0])
        if tags is None:
            raise self.numbers.error(f"a node of {name} has a number that is not whole")
        return Nodes(tags, np.ascontiguousarray(rows[:, 1:4].T))

    def element_values(self, name: str, end: bytes) -> tuple[Array, int, int]:
        """All numbers of a section of elements, how many elements it announces, and where it begins."""
        numbers, text = self.numbers, self.numbers.text
        count = numbers.count(text.integer("the number of elements"), 4, "elements")
        numbers.begin()
        begin = text.position
        stop = text.data.find(end, begin)
        if stop < 0:
            raise numbers.error(f"the file ends before {end.decode()}", begin)
        if not numbers.binary:
            return text.between(begin, stop, np.intp, name), count, begin
        return numbers.ints(self.binary_size(begin, stop), name).astype(np.int32), count, begin

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
            raise self.numbers.error(f"the elements are {size} bytes, expected a multiple of 4", begin)
        return size // 4

    def starts(self, values: Array, count: int, form: RowForm, name: str) -> Array:
        """Where each element begins, of as many as are there or, if these are more, are announced.

        Gmsh reads no more than announced, so that neither is done here.
        """
        starts = row_starts(values, None, form, self.error_at, name)
        if len(starts) != count:
            read = "which are read" if len(starts) < count else f"of which {count:,} are read"
            self.out.note(f"{name} announces {count:,} elements and has {len(starts):,}, {read}.")
        return starts[:count]

    @property
    def error_at(self) -> Callable[[str, int], MeshReadError]:
        """Makes an error about the section, whichever of its numbers is wrong."""
        return lambda message, _: self.numbers.error(message)
