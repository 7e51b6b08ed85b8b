"""Words and numbers in pieces of text, found and parsed by whole arrays."""

from __future__ import annotations

import re
import warnings
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

WORD = re.compile(rb"\S+")
NUMBER = re.compile(
    rb"[+-]?(?:\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?|nan(?:\(\w*\))?|inf(?:inity)?)", re.I
)
INTEGER = re.compile(rb"[+-]?\d+")
RUN_OF_NUMBERS = re.compile(rb"\s*+(?:(?>" + NUMBER.pattern + rb")(?!\S)\s*+)*+", re.I)
RUN_OF_INTEGERS = re.compile(rb"\s*+(?:" + INTEGER.pattern + rb"(?!\S)\s*+)*+")
FORTRAN_EXPONENT = re.compile(rb"(?<=[\d.])[dD](?=[+-]?\d)")
VISUAL_C = re.compile(rb"(?<![^\s,+-])1\.#(?:(INF)|QNAN|SNAN|IND)\d*", re.I)
"""Infinite and not a number as Microsoft's runtime printed them before 2015."""

UNUSUAL = re.compile(rb"(?<![^\s,])[+-]?(?:nan\(\w*\)|1\.#(?:INF|QNAN|SNAN|IND)\d*)", re.I)
"""What only some C runtimes print for a number that is not finite: told in a note."""


def parse(piece: bytes, dtype: DTypeLike) -> tuple[NDArray[Any], bool]:
    """The numbers that a piece of text begins with, and whether something else stopped them.

    No count is passed to numpy: where the text has fewer numbers, it returns memory that was never written.
    Nor white space alone, in which it finds a zero. Where a word is no number, numpy 2.2 warns and gives the numbers
    before it; later releases give nothing, so that they are asked once more for the text before that word.

    Integers that `dtype` has no room for make int64 of them: where it is 32 bits wide, as `intp` is in WebAssembly,
    they have been moved to the ends of its range.
    """
    if piece.isspace():
        return np.empty(0, dtype=dtype), False
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", DeprecationWarning)
        try:
            values = np.fromstring(piece, dtype=dtype, sep=" ")
        except ValueError:
            run = (RUN_OF_NUMBERS if dtype == np.float64 else RUN_OF_INTEGERS).match(piece)
            good = run.end() if run and run.end() < len(piece) else 0
            return parse(piece[:good], dtype)[0], True
    if values.dtype.itemsize < 8 and at_an_end(values):
        return parse(piece, np.int64)
    return values, bool(caught)


def at_an_end(values: NDArray[Any]) -> bool:
    """Whether one of the integers is the smallest or largest of its type."""
    ends = np.iinfo(values.dtype)
    return bool(len(values) and (values.max() == ends.max or values.min() == ends.min))


def respelled(piece: bytes) -> bytes:
    """The text with Fortran's exponents and Visual C's words as numpy knows them; as many words as before."""
    piece = VISUAL_C.sub(lambda match: b"inf" if match[1] else b"nan", piece)
    return FORTRAN_EXPONENT.sub(b"e", piece)


def piece_end(data: bytes, start: int, size: int) -> int:
    """Where to cut a piece of about that size: after white space, so that no number is cut in two."""
    end = start + size
    while end < len(data):
        cut = data.rfind(b"\n", start, end) + 1
        if not cut:
            cut = max(data.rfind(space, start, end) for space in (b" ", b"\t", b"\r")) + 1
        if cut > start:
            return cut
        end = end + size
    return len(data)


def token_starts(piece: bytes) -> NDArray[np.intp]:
    """Offsets at which words begin."""
    solid = np.frombuffer(piece, dtype=np.uint8) > 32
    begins = solid.copy()
    begins[1:] &= ~solid[:-1]
    return np.flatnonzero(begins)


def word_span(piece: bytes, count: int) -> tuple[int, int] | None:
    """Where the word number `count` (from 1) begins and ends."""
    starts = token_starts(piece)
    match = WORD.match(piece, int(starts[count - 1])) if len(starts) >= count else None
    return match.span() if match else None


def is_number(word: bytes, dtype: DTypeLike) -> bool:
    """Whether all of the word is one number."""
    if dtype == np.float64:
        return bool(NUMBER.fullmatch(respelled(word)))
    return bool(INTEGER.fullmatch(word))


def quoted(word: bytes | str) -> str:
    """A word of the file as an error message shows it: short, printable, in quotes."""
    if not word:
        return "the end of the file"
    text = word[:40] if isinstance(word, str) else word[:40].decode("utf-8", "replace")
    text = "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in text)
    return f"‘{text}{'...' if len(word) > 40 else ''}’"
