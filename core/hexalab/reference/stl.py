"""STL, in text and binary. The format knows triangles alone: their corners that are at one place become one vertex.

Normals, colours and the names of solids are left out; triangles are seen from outside as their corners go round.
"""

from __future__ import annotations

import re

import numpy as np

from ..arrays import Array, Floats
from ..errors import MeshReadError
from ..formats.assembly import check_finite
from ..formats.file import File
from ..formats.foreign import is_binary_stl
from ..formats.row_chain import ErrorAt
from ..formats.text import Text
from .lines import blocks, line_of
from .polygons import finished
from .surface import TriangleSurface
from .welding import welded

HEADER = 84
"""Bytes before the first triangle: a text of 80 bytes, and the number of triangles."""

TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
"""A triangle of a binary file, 50 bytes."""

SOLID = re.compile(rb"(?:\s|\xef\xbb\xbf)*solid\b[^\0]*\Z", re.I)
"""How a file in text begins; a binary one, which may begin with the word, has zeros among its first bytes."""

LOOKED_AT = 1024

IN_FACET = (b"facet", b"outer", b"loop", b"vertex")
"""First words of the lines at which no whole file ends."""


def read(file: File) -> TriangleSurface:
    """Read the bytes of an STL file; raises MeshReadError."""
    text = not is_binary_stl(file.data[:HEADER], len(file.data)) and SOLID.match(file.data[:LOOKED_AT])
    return read_text(file) if text else read_binary(file)


def read_binary(file: File) -> TriangleSurface:
    """Read a binary file.

    Raises
    ------
    MeshReadError
        It is shorter than its number of triangles asks for.
    """
    data, notes = file.data, list[str]()
    if len(data) < HEADER:
        raise file.error(
            f"the file has {len(data)} bytes, expected the {HEADER} that a binary STL file begins with"
        )
    count = int.from_bytes(data[HEADER - 4 : HEADER], "little")
    size = HEADER + count * TRIANGLE.itemsize
    if len(data) < size:
        raise file.error(
            f"{count} triangles are announced, which take {size} bytes with what stands before them, but the file has "
            f"{len(data)}: it is cut short or the number is wrong",
            offset=HEADER - 4,
        )
    if len(data) > size:
        notes.append(f"What follows the last triangle was left out: {len(data) - size:,} bytes.")
    rows = np.frombuffer(data, TRIANGLE, count, HEADER)["corners"]
    axes: list[Array] = [np.ascontiguousarray(rows[:, :, axis]).reshape(-1) for axis in range(3)]

    def error_at(message: str, corner: int) -> MeshReadError:
        return file.error(message, offset=HEADER + corner // 3 * TRIANGLE.itemsize + 12 * (corner % 3 + 1))

    return joined(file, axes, error_at, notes)


def read_text(file: File) -> TriangleSurface:
    """Read a file in text, of one solid or several.

    Raises
    ------
    MeshReadError
        A facet has not three vertices of three numbers, or the file ends within one: the line is named.
    """
    text, notes = Text(file), list[str]()
    parts: list[Floats] = [np.empty((0, 3))]
    facets = vertices = 0
    for block in blocks(text):
        corners, begun = block.lines_of(b"vertex"), block.lines_of(b"facet")
        before = vertices + np.searchsorted(corners, begun)
        wrong = before != 3 * (facets + np.arange(len(begun)))
        if wrong.any():
            at = int(np.argmax(wrong))
            have = int(before[at]) - 3 * max(0, facets + at - 1)
            raise text.error(
                f"a facet begins here, and the one before it has {have} vertices, expected 3",
                int(block.offsets(begun[at])),
            )
        values, counts = block.numbers(corners, np.float64, "a vertex", skipped=1)
        block.check(corners, counts == 3, "a vertex has {} numbers, expected 3", counts)
        parts.append(values.reshape(-1, 3))
        facets, vertices = facets + len(begun), vertices + len(corners)
    check_end(text, facets, vertices, notes)
    points = np.concatenate(parts)
    axes: list[Array] = [np.ascontiguousarray(points[:, axis]) for axis in range(3)]
    return joined(file, axes, lambda message, corner: line_of(text, b"vertex", corner, message), notes)


def check_end(text: Text, facets: int, vertices: int, notes: list[str]) -> None:
    """Raise MeshReadError if the file ends within a facet; note it if it does not end with `endsolid`."""
    end = len(text.data.rstrip())
    begin = max(text.data.rfind(b"\n", 0, end), text.data.rfind(b"\r", 0, end)) + 1
    last = text.data[begin : begin + LOOKED_AT].split()[0].lower()
    if vertices != 3 * facets or last in IN_FACET:
        have = vertices - 3 * (facets - 1)
        raise text.error(
            f"the file ends in facet {facets}, of which {max(0, have)} vertices are there: it is cut short",
            end,
        )
    if last not in (b"endsolid", b"end"):
        notes.append("The file does not end with endsolid: it may be cut short.")


def joined(file: File, axes: list[Array], error_at: ErrorAt, notes: list[str]) -> TriangleSurface:
    """The surface of corners, three for each triangle: x, y and z of all of them."""
    check_finite(np.stack(axes), lambda message, corner: error_at(f"in the corners, {message}", corner))
    first, ids = welded(axes)
    points = np.stack([axis[first] for axis in axes]).astype(np.float64)
    points += 0.0  # -0 becomes 0, whichever of the two came first
    return finished(file.name, "stl", points, np.ascontiguousarray(ids.reshape(-1, 3).T), notes, "triangles")
