"""Text of a mesh file: words one by one, blocks of numbers by a C-level call over their bytes.

A block is parsed in pieces of a quarter of a megabyte, so that what is made of each piece is made in cache
and only one piece is ever held twice. Nothing looks at single numbers unless something is wrong with them;
then the guilty one is searched for.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from ..errors import MeshReadError
from .file import File
from .ids import as_int32, put
from .tokens import (
    INTEGER,
    NUMBER,
    UNUSUAL,
    WORD,
    is_number,
    parse,
    piece_end,
    quoted,
    respelled,
    token_starts,
    word_span,
)

PIECE = 1 << 18
"""Bytes parsed by one call: small enough for the cache, large enough that the call's own cost is nothing."""


class Interrupted(MeshReadError):
    """Something other than a number stands in a block, or the file ends in it.

    Parameters
    ----------
    found : int
        How many numbers of the block stand before it.
    word : bytes
        What stands there; empty at the end of the file.
    """

    def __init__(self, error: MeshReadError, found: int, word: bytes = b"") -> None:
        super().__init__(error.message, file=error.file, line=error.line, offset=error.offset)
        self.found = found
        self.word = word


class Text:
    """Reads a text file from front to back.

    Parameters
    ----------
    file : File
        The file; a byte order mark at its start is skipped.
    comment : bytes
        What opens a comment that runs to the end of the line; comments count as white space.
    note : callable, optional
        Takes a sentence about numbers that are spelled in a way worth telling; `Assembly.note`.
    """

    def __init__(self, file: File, comment: bytes = b"", note: Callable[[str], object] | None = None) -> None:
        self.file = file
        self.note = note
        self.data = file.data
        if comment and comment in self.data:
            self.data = re.sub(re.escape(comment) + rb"[^\r\n]*", lambda m: b" " * len(m[0]), self.data)
        self.position = 3 if self.data.startswith(b"\xef\xbb\xbf") else 0

    def error(self, message: str, offset: int | None = None) -> MeshReadError:
        """The error for what stands at the byte offset (default: the present position)."""
        return self.file.error(message, line_at=self.position if offset is None else offset)

    def peek(self) -> bytes:
        """The next word, empty at the end of the file."""
        match = WORD.search(self.data, self.position)
        return match[0] if match else b""

    def word(self) -> bytes:
        """Take the next word, empty at the end of the file."""
        match = WORD.search(self.data, self.position)
        if not match:
            self.position = len(self.data)
            return b""
        self.position = match.end()
        return match[0]

    def line(self) -> bytes:
        """Take the rest of the line, without its end."""
        end = self.data.find(b"\n", self.position)
        end = len(self.data) if end < 0 else end
        line = self.data[self.position : end]
        self.position = min(end + 1, len(self.data))
        return line.rstrip(b"\r")

    def word_offset(self) -> int:
        """Where the next word begins."""
        match = WORD.search(self.data, self.position)
        return match.start() if match else len(self.data)

    def integer(self, what: str) -> int:
        """Take a whole number; `what` names it in the error."""
        start = self.word_offset()
        word = self.word()
        if not INTEGER.fullmatch(word) or len(word) > 20:
            raise self.error(f"{quoted(word)} stands where {what} was expected, a whole number", start)
        return int(word)

    def count(self, what: str, least_numbers: int = 1) -> int:
        """Take the number of entries that follow, each of at least so many numbers.

        Raises
        ------
        MeshReadError
            If it is negative or more than the bytes that are left can hold.
        """
        start = self.word_offset()
        count = self.integer(f"the number of {what}")
        room = (len(self.data) - self.position + 1) // 2
        if count < 0:
            raise self.error(f"the number of {what} is {count}", start)
        if count * least_numbers > room:
            raise self.error(
                f"{count} {what} are announced, but the file has only {len(self.data) - self.position} more "
                "bytes: it is cut short or the number is wrong",
                start,
            )
        return count

    def pieces(self, count: int, dtype: DTypeLike, what: str) -> Iterator[NDArray[Any]]:
        """Take `count` numbers, as consecutive arrays.

        Parameters
        ----------
        count : int
            How many numbers the block holds; not trusted, nothing of that size is allocated.
        dtype : dtype
            float64 or intp. (intp, not int64: parsing 32-bit numbers is a third faster in WebAssembly, where
            they saturate; not int32, as that wraps silently elsewhere.)
        what : str
            Names the block in errors.

        Raises
        ------
        Interrupted
            If something else than a number comes before the last one.
        """
        data, found = self.data, 0
        while found < count:
            size = min(PIECE, 64 + 24 * (count - found))
            end = piece_end(data, self.position, size)
            piece = data[self.position : end]
            values, stopped = parse(piece, dtype)
            if stopped and found + len(values) < count and dtype == np.float64:
                values, stopped = parse(respelled(piece), dtype)
            if (stopped or end == len(data)) and found + len(values) < count:
                raise self.interruption(piece, dtype, what, found, count)
            values = values[: count - found]
            found += len(values)
            if found == count:
                last = word_span(piece, len(values))
                if not last or not is_number(piece[slice(*last)], dtype):
                    raise self.interruption(piece, dtype, what, found - len(values), count)
                if dtype == np.float64 and not NUMBER.fullmatch(piece, *last):
                    values[-1] = parse(respelled(piece[slice(*last)]), dtype)[0][0]
                self.tell_unusual(values, piece)
                self.position += last[1]
            else:
                self.tell_unusual(values, piece)
                self.position = end
            yield values

    def tell_unusual(self, values: NDArray[Any], piece: bytes) -> None:
        """Note a word such as ‘-nan(ind)’, where a sum tells that one may be there."""
        if self.note is None or values.dtype.kind != "f":
            return
        with np.errstate(all="ignore"):
            if np.isfinite(values.sum()):
                return
        if match := UNUSUAL.search(piece):
            self.note(f"Values such as {quoted(match[0])} are taken as not a number or infinite.")

    def numbers(self, count: int, dtype: DTypeLike, what: str) -> NDArray[Any]:
        """Take `count` numbers as one array, integers as int64 where `dtype` can't hold them; see `pieces`."""
        self.check_room(count, what)
        return self.gathered(count, np.empty(count, dtype), dtype, what)

    def integers(self, count: int, what: str) -> NDArray[Any]:
        """Take `count` whole numbers as int32; as int64 where one does not fit."""
        self.check_room(count, what)
        return self.gathered(count, np.empty(count, np.int32), np.intp, what)

    def ids(self, count: int, what: str) -> NDArray[np.int32]:
        """Take `count` ids as int32; those that do not fit become an end of its range."""
        return as_int32(self.integers(count, what))

    def gathered(self, count: int, out: NDArray[Any], dtype: DTypeLike, what: str) -> NDArray[Any]:
        """Take `count` numbers, parsed as `dtype`, into `out`."""
        start = 0
        for values in self.pieces(count, dtype, what):
            part = slice(start, start + len(values))
            if out.dtype == values.dtype:
                out[part] = values
            else:
                out = put(out, part, values)
            start += len(values)
        return out

    def rows(
        self, count: int, width: int, dtype: DTypeLike, what: str
    ) -> Iterator[tuple[slice, NDArray[Any]]]:
        """Take `count` rows of `width` numbers: pairs of a slice of rows and their numbers, (n, width)."""
        row = 0
        rest: NDArray[Any] = np.empty(0, dtype=dtype)
        for piece in self.pieces(count * width, dtype, what):
            values: NDArray[Any] = np.concatenate([rest, piece]) if len(rest) else piece
            whole = len(values) // width
            rest = values[whole * width :]
            yield slice(row, row + whole), values[: whole * width].reshape(whole, width)
            row += whole

    def between(self, start: int, end: int, dtype: DTypeLike, what: str) -> NDArray[Any]:
        """All numbers between two byte offsets; anything else raises Interrupted."""
        arrays: list[NDArray[Any]] = [np.empty(0, dtype=dtype)]
        self.position, found = start, 0
        while self.position < end:
            cut = min(piece_end(self.data, self.position, PIECE), end)
            piece = self.data[self.position : cut]
            values, stopped = parse(piece, dtype)
            if stopped and dtype == np.float64:
                values, stopped = parse(respelled(piece), dtype)
            if stopped:
                raise self.interruption(piece, dtype, what, found, -1)
            self.tell_unusual(values, piece)
            arrays.append(values)
            found += len(values)
            self.position = cut
        return np.concatenate(arrays)

    def check_room(self, count: int, what: str) -> None:
        """Raise MeshReadError if the bytes left can't hold so many numbers."""
        left = len(self.data) - self.position
        if count * 2 > left + 1:
            raise self.error(f"{what} should be {count} numbers, but the file has only {left} more bytes")

    def number_offset(self, start: int, index: int) -> int:
        """Byte offset of the number with that index in the block that starts at the byte offset `start`."""
        while True:
            end = piece_end(self.data, start, PIECE)
            starts = token_starts(self.data[start:end])
            if index < len(starts) or end == len(self.data):
                return start + int(starts[min(index, len(starts) - 1)]) if len(starts) else start
            index -= len(starts)
            start = end

    def first_row_width(self) -> int:
        """How many words stand on the next line that has any, or on its first kilobyte."""
        start = self.word_offset()
        line = re.split(rb"[\r\n]", self.data[start : start + 1024], maxsplit=1)[0]
        return len(line.split())

    def interruption(self, piece: bytes, dtype: DTypeLike, what: str, found: int, count: int) -> Interrupted:
        """Find what is not a number in the piece at the present position."""
        for token in WORD.finditer(piece):
            if not is_number(token[0], dtype):
                kind = "a number" if dtype == np.float64 else "a whole number"
                message = f"{quoted(token[0])} stands where {kind} was expected, in {what}"
                if count >= 0:
                    message += f", which should be {count} numbers: this is number {found + 1}"
                return Interrupted(self.error(message, self.position + token.start()), found, token[0])
            found += 1
        message = f"the file ends in {what}: {found} of {count} numbers are there"
        return Interrupted(self.error(message, len(self.data.rstrip())), found)
