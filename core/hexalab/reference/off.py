"""Object File Format `.off` of Geomview: OFF, COFF, NOFF, STOFF and their combinations, in text.

A line for each vertex, whose first three numbers are x y z, and one for each face: how many corners, the vertices,
perhaps a colour. Normals, colours and textures are left out. A file of fewer lines than that has its numbers one after
the other, as the format allows.
"""

from __future__ import annotations

import re

import numpy as np

from ..arrays import Array, Floats
from ..errors import MeshReadError
from ..formats.assembly import check_finite
from ..formats.file import File
from ..formats.ids import within_int32
from ..formats.row_chain import COUNTED, row_starts
from ..formats.text import Text
from ..formats.tokens import INTEGER, quoted
from .lines import Rows, columns
from .polygons import Polygons, surface_of
from .surface import TriangleSurface

HEADER = re.compile(rb"\s*(ST)?([CN]*)(4?n?)(?:OFF|off)(?:[^\S\r\n]+(BINARY)\b)?")
"""Textures, colours and normals of vertices, other dimensions than 3, and whether the file is binary."""


def read(file: File) -> TriangleSurface:
    """Read the bytes of an OFF file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """Header, counts, vertices, faces."""

    def __init__(self, file: File) -> None:
        self.text = text = Text(file, comment=b"#")
        match = HEADER.match(text.data, text.position)
        if not match and not INTEGER.fullmatch(text.peek()):
            raise text.error(f"{quoted(text.peek())} stands where OFF was expected", text.word_offset())
        texture, more, dimension, binary = match.groups() if match else (None, b"", b"", None)
        text.position = match.end() if match else text.position
        if binary:
            raise text.error("this OFF file is binary: only OFF in text can be read, save it as ASCII")
        if dimension:
            raise text.error(f"this is {quoted(dimension + b'OFF')}, whose points have not three coordinates")
        self.width = 3 + 2 * bool(texture) + 4 * (b"C" in more) + 3 * (b"N" in more)

    def read(self) -> TriangleSurface:
        """Read vertices and faces.

        Raises
        ------
        MeshReadError
            There are fewer than announced, a row has too few numbers, or a corner is no vertex: the line is named.
        """
        text = self.text
        vertices, faces = text.count("vertices", 3), text.count("faces", 0)
        self.skip_edges()
        self.body = text.position
        newline = b"\n" if b"\n" in text.data else b"\r"
        by_lines = text.data.count(newline, self.body) >= vertices + faces
        points, polygons = (self.by_lines if by_lines else self.by_numbers)(vertices, faces)
        return surface_of(text.file, "off", points, [polygons], [])

    def skip_edges(self) -> None:
        """Go behind the number of edges, which some files leave out."""
        rest = re.match(rb"[^\S\r\n]*\S*", self.text.data[self.text.position :][:100])
        if rest and INTEGER.fullmatch(rest[0].strip()):
            self.text.position += rest.end()

    def by_lines(self, vertices: int, faces: int) -> tuple[Floats, Polygons]:
        """Vertices and faces of a line each."""
        rows = Rows(self.text)
        parts: list[Floats] = [np.empty((3, 0))]
        for block, lines in rows.take(vertices, "the vertices"):
            values, counts = block.numbers(lines, np.float64, "the vertices")
            block.check(lines, counts >= 3, "a vertex has {} numbers, expected x, y and z", counts)
            parts.append(columns(values, counts, 3))
        points = np.concatenate(parts, axis=1)
        check_finite(points, lambda message, vertex: self.line_error(f"in the vertices, {message}", vertex))
        ids: list[Array] = [np.empty(0, np.int32)]
        starts: list[Array] = [np.empty(0, np.int64)]
        sizes: list[Array] = [np.empty(0, np.int32)]
        done = 0
        for block, lines in rows.take(faces, "the faces"):
            values, counts = block.whole_numbers(lines, "the faces")
            begins = np.cumsum(counts) - counts
            size = within_int32(values[begins]).astype(np.int64)
            block.check(
                lines, (size >= 0) & (size < counts), "a face announces {} corners, which are not there", size
            )
            ids.append(within_int32(values).astype(np.int32))
            starts.append(begins + (done + 1))
            sizes.append(size.astype(np.int32))
            done += len(values)
        starting = np.concatenate(starts)

        def error_at(message: str, index: int) -> MeshReadError:
            face = int(np.searchsorted(starting, index, "right")) - 1
            return self.line_error(message, vertices + face)

        return points, Polygons(np.concatenate(ids), starting, np.concatenate(sizes), error_at)

    def line_error(self, message: str, number: int) -> MeshReadError:
        """The error for the line with that number, from 0 on, behind the counts; blank ones do not count."""
        return Rows(self.text, self.body).error(message, number)

    def by_numbers(self, vertices: int, faces: int) -> tuple[Floats, Polygons]:
        """Vertices and faces as numbers one after the other."""
        text, width = self.text, self.width
        values = text.numbers(width * vertices, np.float64, "the vertices").reshape(vertices, width)
        points = np.ascontiguousarray(values[:, :3].T)
        body = self.body
        check_finite(
            points,
            lambda message, vertex: text.error(
                f"in the vertices, {message}", text.number_offset(body, width * vertex)
            ),
        )
        begin = text.position
        ids = text.between(begin, len(text.data), np.intp, "the faces")

        def error_at(message: str, index: int) -> MeshReadError:
            return text.error(message, text.number_offset(begin, index))

        starts = row_starts(ids, faces, COUNTED, error_at, "the faces") + 1
        return points, Polygons(ids, starts, ids[starts - 1].astype(np.int32), error_at)
