"""Abaqus and CalculiX `.inp` (SPEC R5): *NODE and *ELEMENT of the C3D8 family and its smaller relatives.

Numbers of nodes and elements may have gaps; rows may go on over several lines. Parts have numbers of their
own; they are shown where they lie, instances are not moved.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from ..arrays import Array
from ..cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from ..errors import MeshReadError
from ..mesh import Mesh
from .assembly import WEDGE_OF_OTHERS, Assembly, CellBlock, check_finite
from .file import File
from .ids import Numbering, whole_tags
from .text import Text

KEYWORD = re.compile(rb"\*[^\r\n]*(?:(?<=,)[ \t]*\r?\n[ \t]*[A-Za-z][^\r\n]*)*")
VOLUME = re.compile(r"(?:C3D|DC3D|DCC3D|AC3D|EC3D|Q3D|COH3D|GK3D|SC|CSS)(\d+)[A-Z]*")
COMMAS = bytes.maketrans(b",", b" ")

KINDS_OF_SIZE = {
    4: TETRAHEDRON,
    5: PYRAMID,
    6: WEDGE,
    8: HEXAHEDRON,
    10: TETRAHEDRON,
    13: PYRAMID,
    15: WEDGE,
    20: HEXAHEDRON,
    27: HEXAHEDRON,
}
"""By the number of nodes in an element type's name."""


NOT_FOLLOWED = {
    "SYSTEM": "Nodes are shown where their numbers say: *SYSTEM, which moves them, is not followed.",
    "INSTANCE": "Parts are shown where they lie: instances are neither moved nor repeated.",
} | {
    name: f"*{name} makes {what} of others: these are not shown."
    for name, what in (
        ("NGEN", "nodes"), ("NFILL", "nodes"), ("NCOPY", "nodes"), ("NMAP", "nodes"),
        ("ELGEN", "elements"), ("ELCOPY", "elements"),
    )
}  # fmt: skip
"""Keywords that change the mesh and are not followed: what is noted of each."""


@dataclass
class Part:
    """A scope of node numbers: blocks of nodes, and of elements by size."""

    tags: list[Array] = field(default_factory=list)
    points: list[Array] = field(default_factory=list)
    elements: list[tuple[int, Array, Array, int]] = field(default_factory=list)


def read(file: File) -> Mesh:
    """Read the bytes of an `.inp` file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """One pass from keyword line to keyword line."""

    def __init__(self, file: File) -> None:
        plain = Text(file, comment=b"**")
        self.keywords = plain.data
        self.text = Text(file)
        self.text.data = plain.data.translate(COMMAS)
        self.out = Assembly(file, "inp")
        self.part = Part()
        self.parts = [self.part]

    def read(self) -> Mesh:
        """Read every keyword's lines, then join the parts; `*INCLUDE` and what isn't followed is noted.

        Raises
        ------
        MeshReadError
            No keyword, no `*NODE`, or rows that don't fit; the line is named.
        """
        found = [match for match in KEYWORD.finditer(self.keywords) if self.begins_line(match.start())]
        if not found:
            raise self.text.error("the file has no keyword such as *NODE", 0)
        ends = [match.start() for match in found[1:]] + [len(self.keywords)]
        for match, end in zip(found, ends, strict=True):
            words = [word.strip() for word in match[0].decode("latin-1").split(",")]
            name = words[0].lstrip("*").strip().upper()
            pairs = (word.partition("=") for word in words[1:])
            options = {key.strip().upper(): value.strip() for key, _, value in pairs}
            if "INPUT" in options and name in ("INCLUDE", "NODE", "ELEMENT"):
                self.out.note(f"The file includes {options['INPUT']}, which was not read.")
            if name in NOT_FOLLOWED:
                self.out.note(NOT_FOLLOWED[name])
            elif name == "NODE":
                if options.get("SYSTEM", "R").upper() != "R":
                    self.out.note(NOT_FOLLOWED["SYSTEM"])
                self.nodes(match.end(), end)
            elif name == "ELEMENT":
                self.elements(options.get("TYPE", "").upper(), match.end(), end)
            elif name in ("PART", "END PART"):
                self.part = Part()
                self.parts.append(self.part)
        if not any(part.tags for part in self.parts):
            raise self.text.error("the file has no *NODE section", 0)
        self.join()
        return self.out.mesh()

    def begins_line(self, offset: int) -> bool:
        """Whether nothing but blanks stands before the offset on its line."""
        start = max(self.keywords.rfind(b"\n", 0, offset), self.keywords.rfind(b"\r", 0, offset)) + 1
        return not self.keywords[start:offset].strip(b" \t\xef\xbb\xbf")

    def nodes(self, begin: int, end: int) -> None:
        """Rows of number, x, y, z; more numbers in a row (a normal) are skipped."""
        self.text.position = begin
        width = self.text.first_row_width() if self.text.word_offset() < end else 4
        values = self.text.between(begin, end, np.float64, "*NODE")
        if width < 4 or len(values) % width:
            raise self.text.error(
                f"*NODE has {len(values)} numbers, the first row {width}: expected number, x, y, z in each",
                begin,
            )
        rows = values.reshape(-1, width)
        points = np.ascontiguousarray(rows[:, 1:4].T)
        check_finite(
            points, lambda message, row: self.text.error(message, self.text.number_offset(begin, row * width))
        )
        tags = whole_tags(rows[:, 0])
        if tags is None:
            raise self.text.error("a node of this section has a number that is not whole", begin)
        self.part.tags.append(tags)
        self.part.points.append(points)

    def elements(self, element_type: str, begin: int, end: int) -> None:
        """Rows of number and nodes."""
        match = VOLUME.fullmatch(element_type)
        size = int(match[1][:4]) if match else 0
        if size not in KINDS_OF_SIZE:
            lines = self.text.data.count(b"\n", begin, end) - 1
            self.out.leave_out(f"elements of type {element_type[:20] or 'unknown'}", max(lines, 1))
            return
        values = self.text.between(begin, end, np.int64, f"*ELEMENT, TYPE={element_type}")
        if len(values) % (size + 1):
            raise self.text.error(
                f"*ELEMENT, TYPE={element_type} has {len(values)} numbers, expected {size + 1} in each row",
                begin,
            )
        rows = values.reshape(-1, size + 1)
        self.part.elements.append((size, rows[:, 0], rows[:, 1:], begin))

    def join(self) -> None:
        """Join the parts, their vertices one after the other."""
        first = 0
        parts = [part for part in self.parts if part.tags]
        orphans = [element for part in self.parts if not part.tags for element in part.elements]
        for part in parts:
            numbering = Numbering(np.concatenate(part.tags))
            for size, tags, nodes, begin in part.elements + (orphans if part is parts[0] else []):
                self.add(size, tags, nodes, begin, numbering, first)
            first += numbering.count
        self.out.coordinates = np.concatenate([points for part in parts for points in part.points], axis=1)
        self.out.vertex_numbers = np.concatenate([tags for part in parts for tags in part.tags])

    def add(self, size: int, tags: Array, nodes: Array, begin: int, numbering: Numbering, first: int) -> None:
        """Add a block of elements."""
        kind = KINDS_OF_SIZE[size]
        own = (8, 6, 5, 4)[kind]
        order = list(WEDGE_OF_OTHERS) if kind == WEDGE else list(range(own))
        corners = numbering.places(np.ascontiguousarray(nodes[:, order].T))
        missing = corners < 0
        if missing.any():
            cell = int(np.argmax(missing.any(axis=0)))
            node = int(nodes[cell, order[int(np.argmax(missing[:, cell]))]])
            raise self.text.error(
                f"element {int(tags[cell])} refers to node {node}, which is missing",
                self.text.number_offset(begin, cell * (size + 1)),
            )
        if size > own:
            self.out.note(f"Cells of higher order (elements of {size} nodes) are shown by their corners.")
        self.out.blocks.append(CellBlock(kind, corners + np.int32(first), self.locate, numbers=tags))

    def locate(self, message: str, _cell: int, _corner: int) -> MeshReadError:
        """An error without a line; nodes that are missing have been found in `add`, with theirs."""
        return self.text.error(message)
