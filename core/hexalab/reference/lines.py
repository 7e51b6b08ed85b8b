r"""Text whose lines say what they are: words and numbers of some lines, found by whole arrays.

A file is looked at in blocks of whole lines, a quarter of a megabyte each, as `hexalab.formats.text` does.

>>> text = Text(File(b"v 1 2 3\nvn 0 0 1\nv 4 5 6\n"))
>>> block = next(blocks(text))
>>> block.lines_of(b"v").tolist(), block.words.tolist()
([0, 2], [4, 4, 4])
>>> values, counts = block.numbers(np.array([0, 2]), np.float64, "the vertices", skipped=1)
>>> values.tolist(), counts.tolist()
([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], [3, 3])
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import DTypeLike, NDArray

from ..arrays import Array
from ..errors import MeshReadError
from ..formats.file import File as File  # of the example above
from ..formats.ids import LARGEST_ID
from ..formats.text import PIECE, Text
from ..formats.tokens import is_number, parse, quoted, respelled

BLANK = 32
NOT_WHOLE = -LARGEST_ID
SMALL_LETTER = 32
"""The bit by which a small letter differs from a capital."""


class Block:
    """Some whole lines of a file.

    Parameters
    ----------
    text : Text
        The file.
    start, end : int
        Byte offsets of the lines.
    newline : int
        The byte that ends a line.

    Attributes
    ----------
    bytes : (n,) uint8
        The lines; may be written into.
    word_starts, word_ends : (W,) intp
        Where words begin and end in `bytes`.
    lines : (L + 1,) intp
        Where lines begin in `bytes`, and the end.
    first : (L + 1,) intp
        The first word of each line.
    words : (L,) intp
        How many words each line has.
    """

    def __init__(self, text: Text, start: int, end: int, newline: int) -> None:
        self.text = text
        self.start = start
        self.bytes = np.frombuffer(text.data, np.uint8, end - start, start).copy()
        solid = np.zeros(len(self.bytes) + 2, dtype=bool)
        np.greater(self.bytes, BLANK, out=solid[1:-1])
        changes = np.flatnonzero(solid[1:] != solid[:-1])
        self.word_starts, self.word_ends = changes[0::2], changes[1::2]
        ends = np.flatnonzero(self.bytes == newline) + 1
        if not len(ends) or ends[-1] < len(self.bytes):
            ends = np.append(ends, len(self.bytes))
        self.lines = np.concatenate([[0], ends])
        self.first = np.searchsorted(self.word_starts, self.lines)
        self.words = np.diff(self.first)

    def lines_of(self, keyword: bytes) -> NDArray[np.intp]:
        """The lines whose first word is the keyword, given in small letters and met in any."""
        found: NDArray[np.intp] = np.flatnonzero(self.words > 0)
        word = self.first[found]
        found = found[self.word_ends[word] - self.word_starts[word] == len(keyword)]
        begins = self.word_starts[self.first[found]]
        for place, letter in enumerate(keyword):
            same = self.bytes[begins + place] | SMALL_LETTER == letter
            found, begins = found[same], begins[same]
        return found

    def offsets(self, lines: Array) -> NDArray[np.int64]:
        """Byte offsets in the file at which the lines begin."""
        begins: NDArray[np.int64] = self.lines[lines].astype(np.int64) + self.start
        return begins

    def cut_words(self, letter: bytes) -> None:
        """Blank what follows the first such letter in each word, and the letter."""
        found = np.flatnonzero(self.bytes == ord(letter))
        word = np.searchsorted(self.word_starts, found, "right") - 1
        earliest = np.ones(len(found), dtype=bool)
        earliest[1:] = word[1:] != word[:-1]
        # +1 where a span to be blanked begins, -1 where its word ends: their sums are 1 within it
        steps = np.zeros(len(self.bytes) + 1, np.int8)
        steps[found[earliest]] = 1
        steps[self.word_ends[word[earliest]]] = -1
        self.bytes[np.cumsum(steps[:-1], dtype=np.int8).view(bool)] = BLANK

    def numbers(
        self, lines: Array, dtype: DTypeLike, what: str, skipped: int = 0
    ) -> tuple[Array, NDArray[np.intp]]:
        """All numbers of some lines.

        Parameters
        ----------
        lines : (n,) intp
            Ascending; each has at least as many words as are skipped.
        dtype : dtype
            float64 or intp; of integers that do not fit, int64 comes back.
        what : str
            Names the lines in errors.
        skipped : int
            Words at each line's beginning that are no numbers.

        Returns
        -------
        values : (m,) array
        counts : (n,) intp
            How many stand on each line.

        Raises
        ------
        MeshReadError
            A word is no number: the line is named.
        """
        counts = self.words[lines] - skipped
        if not counts.sum():
            return np.empty(0, dtype), counts
        chosen = np.zeros(len(self.words), dtype=bool)
        chosen[lines] = True
        own = self.bytes
        if skipped:
            own = own.copy()
            for word in range(skipped):
                self._blank(own, self.first[lines] + word)
        body = own[np.repeat(chosen, np.diff(self.lines))].tobytes()
        values, stopped = parse(body, dtype)
        if stopped and dtype == np.float64:
            values, stopped = parse(respelled(body), dtype)
        if stopped or len(values) != int(counts.sum()):
            raise self._culprit(lines, skipped, dtype, what)
        return values, counts

    def whole_numbers(self, lines: Array, what: str) -> tuple[Array, NDArray[np.intp]]:
        """As `numbers`, as integers; what has a fraction, such as a colour, becomes `NOT_WHOLE`."""
        try:
            return self.numbers(lines, np.intp, what)
        except MeshReadError:
            values, counts = self.numbers(lines, np.float64, what)
        with np.errstate(invalid="ignore"):
            whole = (np.abs(values) < LARGEST_ID) & (values % 1 == 0)
        return np.where(whole, values, NOT_WHOLE).astype(np.int64), counts

    def check(self, lines: Array, good: NDArray[np.bool_], message: str, values: Array) -> None:
        """Raise MeshReadError for the first line that is not good; the message has `{}` for its value."""
        if good.all():
            return
        at = int(np.argmin(good))
        raise self.text.error(message.format(f"{int(values[at]):,}"), int(self.offsets(lines[at])))

    def _blank(self, own: NDArray[np.uint8], words: Array) -> None:
        """Blank words in a copy of the bytes."""
        begins, sizes = self.word_starts[words], self.word_ends[words] - self.word_starts[words]
        for place in range(int(sizes.max(initial=0))):
            own[begins[sizes > place] + place] = BLANK

    def _culprit(self, lines: Array, skipped: int, dtype: DTypeLike, what: str) -> MeshReadError:
        """The error for the first word of the lines that is no number."""
        kind = "a number" if dtype == np.float64 else "a whole number"
        counts = self.words[lines] - skipped
        words = np.repeat(self.first[lines] + skipped - np.cumsum(counts) + counts, counts)
        words += np.arange(len(words))
        for begin, end in zip(self.word_starts[words].tolist(), self.word_ends[words].tolist(), strict=True):
            if not is_number(self.bytes[begin:end].tobytes().strip(), dtype):
                whole = self.text.data[self.start + begin : self.start + end]
                message = f"{quoted(whole)} stands where {kind} was expected, in {what}"
                return self.text.error(message, self.start + begin)
        return self.text.error(f"numbers were expected in {what}", self.start + int(self.lines[lines[0]]))


def blocks(text: Text) -> Iterator[Block]:
    """The file from the text's present position on; lines end in LF or CR LF, or in CR if there is no LF."""
    data = text.data
    newline = b"\n" if b"\n" in data else b"\r"
    start = text.position
    while start < len(data):
        end = start + PIECE
        if end < len(data):
            cut = data.rfind(newline, start, end) + 1 or data.find(newline, end) + 1
            end = cut or len(data)
        end = min(end, len(data))
        yield Block(text, start, end, newline[0])
        start = end


class Rows:
    """Takes lines that are not blank, one after the other.

    Parameters
    ----------
    text : Text
        The file.
    start : int, optional
        The byte offset to begin at; default: the text's present position.
    """

    def __init__(self, text: Text, start: int | None = None) -> None:
        if start is not None:
            text.position = start
        self.text = text
        self.blocks = blocks(text)
        self.block: Block | None = None
        self.left: NDArray[np.intp] = np.empty(0, np.intp)

    def take(self, count: int, what: str) -> Iterator[tuple[Block, NDArray[np.intp]]]:
        """So many lines, as those of block after block; nothing is allocated from the count.

        Raises
        ------
        MeshReadError
            The file ends before.
        """
        taken = 0
        while taken < count:
            if not len(self.left):
                self.block = next(self.blocks, None)
                if self.block is None:
                    raise self.text.error(
                        f"the file ends in {what}: {taken} of {count} lines are there",
                        len(self.text.data.rstrip()),
                    )
                self.left = np.flatnonzero(self.block.words)
                continue
            assert self.block is not None
            some, self.left = self.left[: count - taken], self.left[count - taken :]
            taken += len(some)
            yield self.block, some

    def error(self, message: str, number: int) -> MeshReadError:
        """The error for the line with that number, from 0 on."""
        place = self.text.position
        for block, lines in self.take(number + 1, "the file"):
            place = int(block.offsets(lines[-1]))
        return self.text.error(message, place)


def columns(values: Array, counts: Array, width: int) -> Array:
    """(width, n) the first numbers of rows that have at least so many.

    >>> columns(np.array([1, 2, 3, 4, 5]), np.array([2, 3]), 2).tolist()
    [[1, 3], [2, 4]]
    """
    if len(counts) and (counts == counts[0]).all():
        return np.ascontiguousarray(values.reshape(len(counts), -1)[:, :width].T)
    begins = np.cumsum(counts) - counts
    return np.stack([values[begins + place] for place in range(width)])


def line_of(text: Text, keyword: bytes, number: int, message: str) -> MeshReadError:
    """The error for the line with that number, from 0 on, among those that begin with a keyword.

    The file is looked through once more for it, so that nobody has to remember where lines begin.
    """
    text.position = 3 if text.data.startswith(b"\xef\xbb\xbf") else 0
    for block in blocks(text):
        lines = block.lines_of(keyword)
        if number < len(lines):
            return text.error(message, int(block.offsets(lines[number])))
        number -= len(lines)
    return text.error(message)
