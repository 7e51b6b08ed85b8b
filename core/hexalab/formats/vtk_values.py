"""Blocks of numbers in a legacy `.vtk` file, ASCII or big-endian binary."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..errors import MeshReadError
from .row_chain import ErrorAt
from .text import Text
from .tokens import quoted
from .vtk_types import NUMBER_TYPES

OLD_NAME = re.compile("(bit|char|short|int|long|float|double)[0-9]+")
"""A type with the number of components behind it, as old files have; VTK looks at how the word begins."""


class Values:
    """Takes blocks of numbers from the text's present position.

    Parameters
    ----------
    text : Text
        The file.
    binary : bool
        Whether blocks are binary; then each begins right after the line that announces it.
    """

    def __init__(self, text: Text, binary: bool) -> None:
        self.text = text
        self.binary = binary

    def begin(self) -> None:
        """Go to where the numbers begin, from behind the words that announce them."""
        if self.binary:
            start = self.text.position
            rest = self.text.line()
            if rest.strip():
                raise self.text.error(f"{quoted(rest.strip())} stands where the line should end", start)

    def number_type(self, word: bytes) -> str:
        """The code that numpy has for a VTK number type, without byte order; "bit" and "string" stay."""
        name = word.decode("latin-1").lower()
        if name not in NUMBER_TYPES and (known := OLD_NAME.fullmatch(name)):
            if self.text.note:
                self.text.note(f"The type of numbers {quoted(word)} is taken as {known[1]}, as VTK does.")
            name = known[1]
        if name in ("bit", "string", "utf8_string"):
            return "bit" if name == "bit" else "string"
        if name not in NUMBER_TYPES:
            raise self.text.error(
                f"{quoted(word)} stands where a type of numbers was expected, such as float"
            )
        return NUMBER_TYPES[name]

    def take(self, count: int, code: str, what: str) -> tuple[Array, ErrorAt]:
        """Take `count` numbers.

        Returns
        -------
        values : (count,) array
            In the file's number type; binary ones are a big-endian view of the file's bytes.
        error_at : callable
            Makes errors about one of them.
        """
        start = self.text.position
        if self.binary:
            return self.take_binary(count, code, what, start)
        if code == "i4":
            values: Array = self.text.integers(count, what)
        elif code in ("f4", "f8"):
            values = self.text.numbers(count, np.float64, what).astype(code, copy=False)
        else:
            values = self.text.numbers(count, np.int64, what)
            fitting = values.astype("u1" if code == "bit" else code, copy=False)
            values = fitting if (fitting == values).all() else values
        return values, self.text_error(start)

    def text_error(self, start: int) -> ErrorAt:
        """`error_at` for the block of text that begins at the byte `start`."""

        def error_at(message: str, index: int) -> MeshReadError:
            return self.text.error(message, self.text.number_offset(start, index))

        return error_at

    def take_binary(self, count: int, code: str, what: str, start: int) -> tuple[Array, ErrorAt]:
        """`take` for a binary file."""
        data = self.text.data
        dtype = np.dtype(">u1" if code == "bit" else f">{code}")
        size = (count + 7) // 8 if code == "bit" else count * dtype.itemsize
        if count < 0 or size > len(data) - start:
            raise self.text.file.error(
                f"{what} should be {size} bytes, but the file has only {len(data) - start} more: it is cut "
                "short or the number is wrong",
                offset=start,
            )
        self.text.position = start + size
        values: NDArray[Any] = np.frombuffer(data, dtype, size // dtype.itemsize, start)
        if code == "bit":
            values = np.unpackbits(values)[:count]

        def error_at(message: str, index: int) -> MeshReadError:
            return self.text.file.error(message, offset=start + index * dtype.itemsize)

        return values, error_at

    def skip_strings(self, count: int) -> None:
        """Go behind `count` strings: lines in ASCII, else each behind its length (vtkDataWriter)."""
        text, data = self.text, self.text.data
        text.line()
        for _ in range(count):
            if text.position >= len(data):
                raise text.error(f"the file ends in an array of {count} strings")
            if not self.binary:
                text.line()
                continue
            size = (8, 4, 2, 1)[data[text.position] >> 6]
            head = int.from_bytes(data[text.position : text.position + size], "big")
            text.position += size + (head & ((1 << (8 * size - 2)) - 1))


def decoded(name: bytes) -> str:
    """An array's name, without VTK's percent codes."""
    parts = name.split(b"%")
    out = [parts[0]]
    for part in parts[1:]:
        try:
            out.append(bytes([int(part[:2], 16)]) + part[2:])
        except ValueError:
            out.append(b"%" + part)
    return b"".join(out).decode("utf-8", "replace")
