"""Rows of *NODE and *ELEMENT as arrays.

Fields stand between commas, and one that is empty or left out is 0. A row of *NODE is a line. A row of *ELEMENT goes
on over lines until it has all nodes of its type; what is left on the line then is passed over (Abaqus' manual,
"Input Syntax Rules"; CalculiX' `splitline.f`, `nodes.f`, `elements.f`).

Nearly all blocks are regular: every row has the same number of fields and none is empty. They are parsed by one call
over pieces of their bytes, in which a line's end counts as a comma; that each line ends where it should is seen from
the separators' places. Any other block is laid out field by field (`abaqus_fields`).
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from ..arrays import Array, Floats
from ..errors import MeshReadError
from .abaqus_deck import Block
from .abaqus_elements import ElementType
from .abaqus_fields import NEWLINE, Lines, laid_out
from .ids import whole_tags
from .text import PIECE
from .tokens import FORTRAN_EXPONENT, piece_end

LINES_AS_COMMAS = bytes.maketrans(b"\n", b",")
WHITE = b" \t\r\n\v\f"


@dataclass
class ElementRows:
    """Elements of one type.

    Parameters
    ----------
    block : Block
        Where they stand.
    type : ElementType
    numbers : (n,) int64
    nodes : (n, k) int64
        Numbers of their first nodes, as many as the type's fewest.
    surplus : int
        How many elements have more nodes than their type; these are passed over.
    """

    block: Block
    type: ElementType
    numbers: Array
    nodes: Array
    surplus: int = 0

    def error(self, message: str, element: int) -> MeshReadError:
        """The error for the element at a place among these, with its line."""
        lines = laid_out(self.block, np.int64)
        first = lines_of_elements(self.block, self.type, lines)[0]
        return self.block.source.error(message, int(lines.offset[first[element]]))


def node_rows(block: Block) -> tuple[Array, Floats]:
    """Numbers (n,) int64 and coordinates (3, n) of the nodes of a block, as they stand there.

    Raises
    ------
    MeshReadError
        Something else than a number, or a row without a whole number at its front.
    """
    rows = regular(block, np.float64, 4, 4)
    if rows is None or rows.shape[1] < 4:
        lines = laid_out(block, np.float64)
        if not lines.has_number.all():
            at = int(lines.offset[int(np.argmin(lines.has_number))])
            raise block.source.error("a row of *NODE begins with a comma, expected the node's number", at)
        rows = np.stack([lines.column(place) for place in range(4)], axis=1)
    tags = whole_tags(rows[:, 0])
    if tags is None:
        with np.errstate(invalid="ignore"):
            whole = (np.abs(rows[:, 0]) < 2**53) & (rows[:, 0] % 1 == 0)
        row = int(np.argmin(whole))
        raise node_error(block, f"a node has the number {rows[row, 0]}, which is not whole", row)
    return tags, np.ascontiguousarray(rows[:, 1:4].T)


def node_error(block: Block, message: str, row: int) -> MeshReadError:
    """The error for a row of *NODE, with its line."""
    return block.source.error(message, int(laid_out(block, np.float64).offset[row]))


def element_rows(block: Block, kind: ElementType) -> ElementRows:
    """The elements of a block.

    Raises
    ------
    MeshReadError
        Something else than a whole number, or an element with fewer nodes than its type.
    """
    rows = regular(block, np.int64, kind.least + 1, kind.most + 1)
    if rows is not None and rows.shape[1] > kind.least:
        surplus = len(rows) if rows.shape[1] > kind.most + 1 else 0
        return ElementRows(block, kind, rows[:, 0], rows[:, 1 : kind.least + 1], surplus)
    lines = laid_out(block, np.int64)
    first, counts = lines_of_elements(block, kind, lines)
    at = lines.first[first]
    nodes = lines.values[at[:, None] + np.arange(1, kind.least + 1)]
    return ElementRows(block, kind, lines.values[at], nodes, int((counts > kind.most + 1).sum()))


def lines_of_elements(block: Block, kind: ElementType, lines: Lines) -> tuple[Array, Array]:
    """The line that each element begins on, and how many fields it has with those of the lines it goes on over.

    A line goes on although no comma ends it, as CalculiX allows, only where the next one completes the element:
    if that holds more, it is another element, and a node is missing.
    """
    counts, commas = lines.count.tolist(), lines.comma.tolist()
    fewest, most = kind.least + 1, kind.most + 1
    first, totals = [], []
    line, end = 0, len(counts)
    while line < end:
        first.append(line)
        total = counts[line]
        while line + 1 < end and (total < fewest or (total < most and commas[line])):
            more = total + counts[line + 1]
            if more > most and (total >= fewest or not commas[line]):
                break
            total = more
            line += 1
        if total < fewest:
            number = int(lines.values[lines.first[first[-1]]])
            message = f"element {number} of type {kind.name} has {total - 1} nodes, expected {kind.least}"
            raise block.source.error(message, int(lines.offset[first[-1]]))
        totals.append(total)
        line += 1
    return np.array(first, dtype=np.intp), np.array(totals, dtype=np.intp)


def regular(block: Block, dtype: DTypeLike, fewest: int, most: int) -> NDArray[Any] | None:
    """The rows of a block, (n, k), if all have the same number of fields and none is empty; else None.

    Rows of whole numbers may go on over lines, where the first has less than the fewest fields and ends in a comma;
    then none has more than the most.
    """
    text = block.source.data[block.begin : block.end].strip(WHITE)
    if not text:
        return np.empty((0, fewest), dtype=dtype)
    if b"\r" in text:
        text = text.replace(b"\r\n", b"\n")
    wraps = False
    if b",\n" in text or text.endswith(b","):
        line = text.split(b"\n", 1)[0]
        wraps = dtype is np.int64 and line.endswith(b",") and line.count(b",") < fewest
        text = text.rstrip(b",").replace(b",\n", b"," if wraps else b"\n")
    width = text.count(b",", 0, text.find(b"\n") % (len(text) + 1)) + 1
    if wraps and width > most:
        return None
    arrays: list[NDArray[Any]] = []
    start = 0
    while start < len(text):
        end = piece_end(text, start, PIECE)
        values = values_of(text[start:end].rstrip(b"\n"), dtype, width)
        if values is None:
            return None
        arrays.append(values)
        start = end
    rows: NDArray[Any] = np.concatenate(arrays)
    return rows


def values_of(piece: bytes, dtype: DTypeLike, width: int) -> NDArray[Any] | None:
    """The numbers of lines, (n, width), if each line has that many and nothing else; else None."""
    letters = np.frombuffer(piece, dtype=np.uint8)
    separators = np.flatnonzero((letters == ord(",")) | (letters == NEWLINE))
    rows, rest = divmod(len(separators) + 1, width)
    if rest or piece.count(b"\n") != rows - 1 or (letters[separators[width - 1 :: width]] != NEWLINE).any():
        return None
    values = parsed(piece.translate(LINES_AS_COMMAS), dtype)
    return None if values is None or len(values) != rows * width else values.reshape(rows, width)


def parsed(text: bytes, dtype: DTypeLike) -> NDArray[Any] | None:
    """Numbers between commas; None if anything else stands there, an empty field among them.

    numpy warns of what is no number in some releases and raises in others.
    """
    values = numbers_of(text, dtype)
    if values is None and dtype is np.float64 and FORTRAN_EXPONENT.search(text):
        return numbers_of(FORTRAN_EXPONENT.sub(b"e", text), dtype)
    return values


def numbers_of(text: bytes, dtype: DTypeLike) -> NDArray[Any] | None:
    """As `parsed`, with exponents that begin with E alone."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", DeprecationWarning)
        try:
            values = np.fromstring(text, dtype=dtype, sep=" , ")
        except ValueError:
            return None
    return None if caught else values
