"""Blocks of numbers in a `.msh` file, ASCII or binary."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import MeshReadError
from .byte_order import native
from .file import File
from .text import Text
from .tokens import quoted

FIRST_VERSION = re.compile(rb"\s*\$NO[DE]\s")
"""How a file of version 1 begins."""


class Numbers:
    """Takes numbers from the present position of a `.msh` file.

    Parameters
    ----------
    file : File
        The file; its section $MeshFormat is read at once.
    note : callable, optional
        Takes a sentence for the user.

    Attributes
    ----------
    text : Text
        The file and the present position.
    version : str
        As the file says, "2.2" or "4.1" among others; "1" if it begins with its nodes.
    """

    def __init__(self, file: File, note: Callable[[str], object] | None = None) -> None:
        self.text = text = Text(file, note=note)
        self.version, self.binary, self.order, self.size_code = "1", False, "<", "i4"
        if FIRST_VERSION.match(text.data, text.position):
            return
        start = text.data.find(b"$MeshFormat")
        if start < 0:
            raise file.error(
                "the file has neither $MeshFormat nor $NOD, expected Gmsh's .msh 1 to 4.1", line_at=0
            )
        text.position = start + len("$MeshFormat")
        self.version = text.word().decode("latin-1")
        binary = text.integer("the file type, 0 or 1")
        size = text.integer("the size of numbers")
        if binary not in (0, 1) or size not in (4, 8):
            raise text.error(
                f"the file type {binary} and number size {size} were found, expected 0 or 1, 4 or 8"
            )
        self.binary = binary == 1
        self.size_code = f"i{size}"
        if self.binary:
            text.line()
            mark = text.data[text.position : text.position + 4]
            if mark not in (b"\1\0\0\0", b"\0\0\0\1"):
                raise file.error(
                    "expected the number 1 as 4 bytes after the format's line", offset=text.position
                )
            self.order = "<" if mark == b"\1\0\0\0" else ">"
            text.position += 4
        end = text.word()
        if end != b"$EndMeshFormat":
            raise text.error(f"{quoted(end)} stands where $EndMeshFormat was expected")

    def begin(self) -> None:
        """Go to a section's numbers, from behind its name."""
        if self.binary:
            self.text.line()

    def ints(self, count: int, what: str) -> NDArray[Any]:
        """C's int."""
        return self.take(count, "i4", what)

    def sizes(self, count: int, what: str) -> NDArray[Any]:
        """C's size_t."""
        return self.take(count, self.size_code, what)

    def doubles(self, count: int, what: str) -> NDArray[Any]:
        """C's double."""
        return self.take(count, "f8", what)

    def take(self, count: int, code: str, what: str) -> NDArray[Any]:
        """So many numbers as an array."""
        text = self.text
        if not self.binary:
            return text.numbers(count, np.float64 if code == "f8" else np.intp, what)
        dtype = np.dtype(self.order + code)
        return native(np.frombuffer(self.bytes(count * dtype.itemsize, what), dtype))

    def bytes(self, size: int, what: str) -> memoryview:
        """So many bytes of a binary file."""
        text = self.text
        left = len(text.data) - text.position
        if not 0 <= size <= left:
            raise self.error(
                f"{what} should be {size} bytes, but the file has only {left} more", text.position
            )
        text.position += size
        return memoryview(text.data)[text.position - size : text.position]

    def count(self, number: int, least: int, what: str) -> int:
        """A number of entries from a header, each of at least so many bytes or digits.

        Raises
        ------
        MeshReadError
            The rest of the file has no room for so many: nothing is allocated for a number that lies.
        """
        left = len(self.text.data) - self.text.position + 1
        if number < 0 or number * least > left:
            raise self.error(f"{number} {what} are announced, but the file has only {left - 1} more bytes")
        return number

    def error(self, message: str, offset: int | None = None) -> MeshReadError:
        """The error at a place, by line or by byte."""
        offset = self.text.position if offset is None else offset
        if self.binary:
            return self.text.file.error(message, offset=offset)
        return self.text.error(message, offset)
