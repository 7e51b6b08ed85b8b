"""An Abaqus deck as keywords with their lines: files that it includes stand where they are included.

Rules of Abaqus' manual ("Input Syntax Rules") and of CalculiX' `readinput.c`: a keyword's line begins with one star,
blanks and letter case in it don't count, it goes on after a comma; two stars open a comment.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

from ..errors import MeshReadError
from .container import GZIP, inflated
from .file import File
from .text import Text

KEYWORD = re.compile(rb"\*[^\r\n]*(?:(?<=,)[ \t]*\r?\n[ \t]*[A-Za-z][^\r\n]*)*")
COMMAS = bytes.maketrans(b",", b" ")
BYTE_ORDER_MARK = b"\xef\xbb\xbf"
DEEPEST = 20
MOST_INCLUDED = 2000
"""More files than that, one in another or in all, are no deck but an endless one."""

ELEMENT = re.compile(r"ELEM(?:E|EN)?")
"""Short for ELEMENT."""


class Source:
    """The text of one file of a deck, its comments blanked out.

    Parameters
    ----------
    file : File
    """

    def __init__(self, file: File) -> None:
        self.file = file
        self.data = Text(file, comment=b"**").data
        if b"\n" not in self.data:
            self.data = self.data.replace(b"\r", b"\n")
        if self.data.startswith(BYTE_ORDER_MARK):
            self.data = b"   " + self.data[3:]

    @cached_property
    def words(self) -> Text:
        """The text with blanks for commas, so that numbers are words."""
        text = Text(self.file)
        text.data = self.data.translate(COMMAS)
        return text

    def error(self, message: str, offset: int) -> MeshReadError:
        """The error for what stands at a byte offset."""
        return self.file.error(message, line_at=offset)

    def begins_line(self, offset: int) -> bool:
        """Whether nothing but blanks stands before the offset on its line."""
        start = max(self.data.rfind(b"\n", 0, offset), self.data.rfind(b"\r", 0, offset)) + 1
        return not self.data[start:offset].strip(b" \t")


@dataclass(frozen=True)
class Keyword:
    """A keyword's line.

    Parameters
    ----------
    name : str
        In capitals, without star and blanks: "ENDPART".
    options : dict of str to str
        What stands behind it; the names in capitals.
    """

    name: str
    options: dict[str, str]

    def option(self, name: str) -> str:
        """The value of an option in capitals, "" without it."""
        return self.options.get(name, "").upper()


@dataclass(frozen=True)
class Block:
    """Lines of data.

    Parameters
    ----------
    keyword : Keyword
        What they belong to.
    source : Source
        The file that they stand in.
    begin, end : int
        Their bytes.
    goes_on : bool
        Whether lines of the same keyword came before, in another file.
    """

    keyword: Keyword
    source: Source
    begin: int
    end: int
    goes_on: bool = False

    def error(self, message: str) -> MeshReadError:
        """The error for the block as a whole, at its first line."""
        return self.source.error(message, self.begin)

    def numbers(self) -> list[list[float]]:
        """The lines' numbers: 0 for an empty field, NaN for what is none; for the few lines that place something."""
        text = self.source.data[self.begin : self.end][:10_000].decode("latin-1")
        lines = (line.strip().rstrip(", \t") for line in text.splitlines() if line.strip())
        return [[number(word.strip()) for word in line.split(",")] for line in lines]


def number(word: str) -> float:
    """The number that a word is, 0 if it is empty, else NaN."""
    try:
        return float(word.lower().replace("d", "e")) if word else 0.0
    except ValueError:
        return float("nan")


def decoded(line: bytes) -> str:
    """The text of a line: UTF-8 as tools of today write it, else Latin-1."""
    try:
        return line.decode()
    except UnicodeDecodeError:
        return line.decode("latin-1")


def keyword_of(line: bytes) -> Keyword:
    """The keyword that a line, or several joined by commas, hold."""
    words = decoded(line).split(",")
    name = "".join(words[0].split()).lstrip("*").upper()
    pairs = (word.partition("=") for word in words[1:])
    options = {"".join(key.split()).upper(): value.strip() for key, _, value in pairs if key.strip()}
    return Keyword("ELEMENT" if ELEMENT.fullmatch(name) else name, options)


class Deck:
    """Goes through a deck and all that it includes.

    Parameters
    ----------
    file : File
        The main file; `companion` of it finds the others.
    """

    def __init__(self, file: File) -> None:
        self.file = file
        self.missing: list[str] = []
        self.keywords = 0
        self.included = 0
        self.last: Keyword | None = None

    def blocks(self) -> Iterator[Block]:
        """Every keyword with its lines, in the order of the deck.

        Raises
        ------
        MeshReadError
            A file includes itself, or more are included than a deck has.
        """
        yield from self.of(Source(self.file), (self.file.name,))

    def of(self, source: Source, within: tuple[str, ...]) -> Iterator[Block]:
        """The blocks of one file; `within` are the names of those that include it, and its own."""
        found = [match for match in KEYWORD.finditer(source.data) if source.begins_line(match.start())]
        begins = [match.start() for match in found] + [len(source.data)]
        if len(within) > 1:
            yield from self.more(source, 0, begins[0])
        for match, end in zip(found, begins[1:], strict=True):
            self.keywords += 1
            keyword = keyword_of(match[0])
            begin = match.end()
            if keyword.name == "INCLUDE":
                yield from self.other(keyword, source, match.start(), within)
                yield from self.more(source, begin, end)
                continue
            self.last = keyword
            yield Block(keyword, source, begin, end)
            if keyword.name in ("NODE", "ELEMENT") and "INPUT" in keyword.options:
                yield from self.other(keyword, source, match.start(), within)

    def more(self, source: Source, begin: int, end: int) -> Iterator[Block]:
        """Lines that go on with the last keyword: at the start of a file that is included, and behind it."""
        if self.last and source.data[begin:end].strip():
            yield Block(self.last, source, begin, end, goes_on=True)

    def other(self, keyword: Keyword, source: Source, line: int, within: tuple[str, ...]) -> Iterator[Block]:
        """The blocks of the file that the INPUT of a keyword names; a file that is not there is kept in mind."""
        name = keyword.options.get("INPUT", "")
        file = source.file.companion(name)
        if file is None:
            self.missing.append(name.strip("\"'")[:100] or "a file without a name")
            return
        self.included += 1
        if file.name in within:
            raise source.error(
                f"{file.name} is included by itself: expected a deck that comes to an end", line
            )
        if len(within) >= DEEPEST or self.included > MOST_INCLUDED:
            raise source.error("too many files include others: expected a deck that comes to an end", line)
        if file.data.startswith(GZIP):
            file = replace(file, data=inflated(file))
        yield from self.of(Source(file), (*within, file.name))
