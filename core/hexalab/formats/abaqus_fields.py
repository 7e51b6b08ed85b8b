"""Lines of an Abaqus deck field by field: for those blocks that are no regular tables."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import DTypeLike

from ..arrays import Array
from .abaqus_deck import Block
from .ids import whole_tags
from .text import Interrupted

COMMA, NEWLINE = ord(","), ord("\n")


@dataclass
class Lines:
    """Lines that hold anything, with the fields between their commas.

    Parameters
    ----------
    values : (f,) numbers
        All fields, one line after the other; 0 where one is empty.
    first, count : (n,) integers
        Where the fields of each line begin among all, and how many it has; not counted is the empty one behind a
        comma at the line's end.
    comma : (n,) bool
        Whether a comma ends the line.
    has_number : (n,) bool
        Whether its first field is not empty.
    offset : (n,) integers
        Byte offset of the line in its file.
    """

    values: Array
    first: Array
    count: Array
    comma: Array
    has_number: Array
    offset: Array

    def column(self, place: int) -> Array:
        """(n,) the field at a place of each line, 0 where it is left out."""
        found: Array = self.values[self.first + np.minimum(place, self.count - 1)]
        return np.where(self.count > place, found, 0)


def laid_out(block: Block, dtype: DTypeLike) -> Lines:
    """The lines of a block.

    Blanks part fields too, where no comma does: one of `1 0. 0. 0.` has four.

    Raises
    ------
    Interrupted
        Something else than a number stands there.
    """
    letters = np.frombuffer(block.source.data, dtype=np.uint8)[block.begin : block.end]
    comma = letters == COMMA
    solid = (letters > 32) & ~comma
    begins = solid.copy()
    begins[1:] &= ~solid[:-1]
    separators = np.append(np.flatnonzero(comma | (letters == NEWLINE)), len(letters))
    ends_line = np.append(letters[separators[:-1]] == NEWLINE, True)
    # words before each separator, hence in the field that it closes
    words = np.diff(np.searchsorted(np.flatnonzero(begins), separators), prepend=0)
    fields = np.maximum(words, 1)
    fields[ends_line & (words == 0)] = 0
    line = np.cumsum(ends_line) - ends_line
    filled = np.repeat(words > 0, fields)
    values = np.zeros(len(filled), dtype=dtype)
    values[np.flatnonzero(filled)] = numbers(block, dtype)
    ends = np.flatnonzero(ends_line)
    count = np.bincount(line, weights=fields, minlength=len(ends)).astype(np.intp)
    behind_comma = (words[ends] == 0) & (ends > 0) & ~ends_line[ends - 1]
    start = np.append(0, separators[ends[:-1]] + 1) + block.begin
    kept = count > 0
    first = (np.cumsum(count) - count)[kept]
    return Lines(values, first, count[kept], behind_comma[kept], filled[first], start[kept])


def numbers(block: Block, dtype: DTypeLike) -> Array:
    """All numbers of a block; whole ones may be written as `1.`."""
    what = f"*{block.keyword.name}"
    if block.keyword.option("TYPE"):
        what += f", TYPE={block.keyword.option('TYPE')}"
    words = block.source.words
    try:
        return words.between(block.begin, block.end, dtype, what)
    except Interrupted:
        if dtype is not np.int64:
            raise
        tags = whole_tags(words.between(block.begin, block.end, np.float64, what))
        if tags is None:
            raise
        return tags


def count_of_elements(block: Block) -> int:
    """How many elements of a type that is not known stand in a block, one at least.

    A line goes on after a comma; where all lines have as many fields and a comma at their end, each is an element.
    """
    text = block.source.data[block.begin : block.end]
    lines = [line for line in (line.strip() for line in text.split(b"\n")) if line]
    open_ended = [line.endswith(b",") for line in lines]
    if all(open_ended) and len({line.count(b",") for line in lines}) == 1:
        return max(len(lines), 1)
    return max(len(lines) - sum(open_ended[:-1]), 1)
