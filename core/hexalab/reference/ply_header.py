"""The header of a PLY file: its elements, and what each of their rows has."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..formats.file import File
from ..formats.tokens import INTEGER, quoted

TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1",
    "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
    "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
}  # fmt: skip
"""Codes of numpy for the format's number types."""

ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
"""The forms of the file, and the byte order of their numbers."""

START = re.compile(rb"(?:\xef\xbb\xbf)?ply[ \t]*(\r\n|\n|\r)")


@dataclass(frozen=True)
class Property:
    """One number, or one list of numbers, of each row of an element.

    Parameters
    ----------
    name : str
    dtype : dtype
        Of the number, or of those in the list.
    counted_by : dtype or None
        Of the number of entries in front of a list; None if it is no list.
    """

    name: str
    dtype: np.dtype[np.generic]
    counted_by: np.dtype[np.generic] | None = None


@dataclass(frozen=True)
class Element:
    """One table of the file.

    Parameters
    ----------
    name : str
    count : int
        Rows, as announced; not checked.
    properties : tuple of Property
    """

    name: str
    count: int
    properties: tuple[Property, ...]

    @cached_property
    def named(self) -> str:
        """The names of its properties, for messages."""
        return ", ".join(one.name for one in self.properties)[:200] or "none"


@dataclass(frozen=True)
class Header:
    """What stands before the numbers.

    Parameters
    ----------
    order : str
        "<" or ">" of a binary file, "" of one in text.
    elements : tuple of Element
        In the order of the file.
    end : int
        Byte offset of the first number.
    """

    order: str
    elements: tuple[Element, ...]
    end: int


def header_of(file: File) -> Header:
    """Read the header; raises MeshReadError naming the line."""
    start = START.match(file.data)
    if not start:
        raise file.error("expected ‘ply’ on the first line", line_at=0)
    newline = rb"\r" if start[1] == b"\r" else rb"\r?\n"
    end = re.compile(rb"(?<=[\r\n])end_header[ \t]*" + newline).search(file.data, start.end())
    if not end:
        raise file.error("the file has no line end_header: it is cut short", line_at=len(file.data.rstrip()))
    order: str | None = None
    elements: list[tuple[str, int, list[Property]]] = []
    for line in re.compile(rb"[^\r\n]+").finditer(file.data, start.end(), end.start()):
        words = line[0].decode("latin-1").split()
        if not words or words[0] in ("comment", "obj_info"):
            continue
        if words[0] == "format" and len(words) > 1 and words[1] in ORDERS:
            order = ORDERS[words[1]]
        elif words[0] == "element" and len(words) == 3 and INTEGER.fullmatch(words[2].encode()[:19]):
            elements.append((words[1], int(words[2][:19]), []))
            if elements[-1][1] < 0:
                raise file.error(f"the element {quoted(words[1])} has {words[2]} rows", line_at=line.start())
        elif words[0] == "property" and elements and (found := property_of(words, order or "")):
            elements[-1][2].append(found)
        else:
            raise file.error(
                f"{quoted(line[0].strip())} stands in the header, expected format, element, property or comment, "
                "each with what belongs to it",
                line_at=line.start(),
            )
    if order is None:
        raise file.error(f"the header has no line format, expected one of {', '.join(ORDERS)}", line_at=0)
    parts = tuple(Element(name, count, tuple(properties)) for name, count, properties in elements)
    return Header(order, parts, end.end())


def property_of(words: list[str], order: str) -> Property | None:
    """The property of a line's words; None if they make none."""
    if len(words) == 3 and words[1] in TYPES:
        return Property(words[2], np.dtype(order + TYPES[words[1]]))
    if len(words) == 5 and words[1] == "list" and words[2] in TYPES and words[3] in TYPES:
        counted_by = np.dtype(order + TYPES[words[2]])
        return (
            Property(words[4], np.dtype(order + TYPES[words[3]]), counted_by)
            if counted_by.kind in "iu"
            else None
        )
    return None
