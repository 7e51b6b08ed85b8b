"""Rows of a binary PLY file: where each begins, and lists of numbers out of them.

A row's length is known from the lists in it. Where rows are alike they stand at equal distances, and numbers are taken
by strides. Else every byte of a stretch is taken for the beginning of a row, and the true beginnings are found among
them by pointer jumping (`hexalab.formats.row_chain`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import CHUNK, Array
from ..formats.file import File
from ..formats.ids import within_int32
from ..formats.row_chain import RowForm, jumped
from .ply_header import Element, Property

STRETCH = 1 << 18
"""Bytes in which rows are looked for at a time."""

MOST_RUNS = 16
"""After so many runs of rows that are alike, the rest is done stretch by stretch."""

FIRST = 256
"""So many rows are compared before all are."""


@dataclass(frozen=True)
class Table:
    """The rows of an element.

    Parameters
    ----------
    file : File
    element : Element
    starts : (n,) int64 or range
        Byte offset of each row; a range if all lists of a property have one length.
    end : int
        Where the last row ends.
    """

    file: File
    element: Element
    starts: Array | range
    end: int

    def numbers(self, wanted: Property) -> Array:
        """(n,) the numbers of a property before which no list stands."""
        offset = 0
        for one in self.element.properties:
            if one is wanted:
                break
            offset += one.dtype.itemsize
        return self.at(wanted.dtype, offset)

    def at(self, dtype: np.dtype[np.generic], offset: int, width: int | None = None) -> Array:
        """(n,) the number, or (n, width) the numbers, so many bytes behind where rows begin."""
        shape = (len(self.starts),) if width is None else (len(self.starts), width)
        if isinstance(self.starts, range):
            if not len(self.starts):
                return np.empty(shape, dtype)
            first = self.starts.start + offset
            strides = (self.starts.step,) if width is None else (self.starts.step, dtype.itemsize)
            return np.ndarray(shape, dtype, self.file.data, first, strides)
        assert width is None
        found: Array = anywhere(self.file.data, dtype)[self.starts + offset]
        return found

    def lists(self, wanted: Property) -> tuple[Array, Array | range, Array, Array | range]:
        """The lists of a property.

        Returns
        -------
        ids : (m,) integers
            All of them, one after the other.
        starts : (n,) int64 or range
        sizes : (n,) int32
            Of each list in `ids`.
        places : (n,) int64 or range
            Byte offset of each list's first entry.
        """
        data, at = self.file.data, self.starts
        if isinstance(at, range):
            offset = 0
            for one in self.element.properties:
                size = self.size_of_first(one, offset)
                if one is wanted:
                    ids = self.at(one.dtype, offset + size[0], size[1])
                    own = range(0, size[1] * len(at), size[1]) if size[1] else range(0)
                    begin = at.start + offset + size[0]
                    places = range(begin, begin + at.step * len(at), at.step)
                    sizes = np.broadcast_to(np.int32(size[1]), len(at))
                    return ids.reshape(-1), own if size[1] else np.zeros(len(at), np.int64), sizes, places
                offset += size[0] + size[1] * one.dtype.itemsize
        place = np.asarray(at).copy()
        for one in self.element.properties:
            if one.counted_by is None:
                place += one.dtype.itemsize
                continue
            count = anywhere(data, one.counted_by)[place].astype(np.int64)
            place += one.counted_by.itemsize
            if one is wanted:
                return *gathered(data, one.dtype, place, count), count.astype(np.int32), place
            place += count * one.dtype.itemsize
        raise KeyError(wanted.name)

    def size_of_first(self, one: Property, offset: int) -> tuple[int, int]:
        """Bytes of the number in front of a list, and its entries; of a single number 0 and 1."""
        if one.counted_by is None or not len(self.starts):
            return 0, 1
        return one.counted_by.itemsize, int(self.at(one.counted_by, offset)[0])


def anywhere(data: bytes, dtype: np.dtype[np.generic]) -> Array:
    """The numbers that begin at each byte."""
    return np.ndarray((max(0, len(data) - dtype.itemsize + 1),), dtype, data, 0, (1,))


def gathered(data: bytes, dtype: np.dtype[np.generic], places: Array, counts: Array) -> tuple[Array, Array]:
    """Lists one after the other as int32, and where each begins; ids that do not fit stay out of range."""
    numbers = anywhere(data, dtype)
    starts = np.cumsum(counts) - counts
    out = np.empty(int(counts.sum()), np.int32)
    for first in range(0, len(counts), CHUNK):
        part = slice(first, first + CHUNK)
        own = counts[part].astype(np.intp)
        within = np.arange(int(own.sum())) - np.repeat(starts[part] - starts[first], own)
        found = numbers[np.repeat(places[part], own) + dtype.itemsize * within]
        begin = int(starts[first])
        out[begin : begin + len(found)] = within_int32(found.astype(np.int64))
    return out, starts


def table_of(file: File, element: Element, start: int) -> Table:
    """Find the rows of an element.

    Raises
    ------
    MeshReadError
        They do not fit into the file.
    """
    position, left = start, element.count
    parts: list[Array | range] = []
    while left:
        rows = (run_of if len(parts) < MOST_RUNS else chain_of)(file.data, element, position, left)
        if not len(rows):
            found = element.count - left
            raise file.error(
                f"the file ends in the element {element.name}: {found} of {element.count} rows are there, or a list's "
                "length is wrong",
                offset=position,
            )
        left -= len(rows)
        position = end_of(file.data, element, int(rows[-1]))
        parts.append(rows)
    if not parts:
        return Table(file, element, range(0), start)
    starts = parts[0] if len(parts) == 1 else np.concatenate([np.asarray(part) for part in parts])
    return Table(file, element, starts, position)


def run_of(data: bytes, element: Element, position: int, most: int) -> range:
    """The rows from a byte on that have lists as long as the first one; none if it does not fit into the file."""
    step = end_of(data, element, position) - position
    if step <= 0:
        return range(0)
    most = min(most, (len(data) - position) // step)
    run = 0
    for upto in (min(most, FIRST), most):
        alike = np.ones(upto, dtype=bool)
        offset = 0
        for one in element.properties:
            if one.counted_by is not None:
                sizes: Array = np.ndarray((upto,), one.counted_by, data, position + offset, (step,))
                alike &= sizes == sizes[0]
                offset += one.counted_by.itemsize + (int(sizes[0]) - 1) * one.dtype.itemsize
            offset += one.dtype.itemsize
        run = upto if alike.all() else int(np.argmin(alike))
        if run < upto:
            break
    return range(position, position + run * step, step)


def end_of(data: bytes, element: Element, position: int) -> int:
    """Where the row that begins at a byte ends; -1 if it does not fit into the file."""
    for one in element.properties:
        size = one.dtype.itemsize
        if one.counted_by is not None:
            if position + one.counted_by.itemsize > len(data):
                return -1
            count = int(np.frombuffer(data, one.counted_by, 1, position)[0])
            if count < 0:
                return -1
            position += one.counted_by.itemsize
            size *= count
        position += size
        if position > len(data):
            return -1
    return position


def chain_of(data: bytes, element: Element, position: int, most: int) -> Array:
    """The rows of any lengths that a stretch of the file holds; none if the first does not fit into the file."""
    end = end_of(data, element, position)
    if end <= position:
        return np.empty(0, np.int64)
    if end - position > STRETCH:
        return np.array([position])
    stretch = data[position : position + STRETCH]
    starts, _ = jumped(
        np.frombuffer(stretch, np.uint8), RowForm((0,), lambda _: lengths_of(stretch, element)), most
    )
    return starts + position


def lengths_of(stretch: bytes, element: Element) -> Array:
    """(n,) int64: how long a row would be that began at each byte; 0 if it would not fit."""
    size = len(stretch)
    place = np.arange(size, dtype=np.int64)
    for one in element.properties:
        if one.counted_by is None:
            place += one.dtype.itemsize
            continue
        fits = place + one.counted_by.itemsize <= size
        count = np.zeros(size, np.int64)
        count[fits] = anywhere(stretch, one.counted_by)[place[fits]]
        fits &= (count >= 0) & (count <= size)
        place += one.counted_by.itemsize + np.where(fits, count, 0) * one.dtype.itemsize
        place[~fits] = size + 1
    return np.where(place <= size, place - np.arange(size), 0)
