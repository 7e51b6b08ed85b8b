"""Wavefront OBJ: vertices and faces. Normals, textures, names, lines, curves and everything else are passed over.

A corner is `a`, `a/b`, `a//c` or `a/b/c`, of which the vertex `a` counts; negative ones are counted back from the
vertices before the face. What may follow a vertex's x y z, its weight or colour, is left out.
"""

from __future__ import annotations

import re

import numpy as np

from ..arrays import Array, Floats
from ..errors import MeshReadError
from ..formats.assembly import check_finite
from ..formats.file import File
from ..formats.ids import within_int32
from ..formats.text import Text
from .lines import Block, blocks, columns, line_of
from .polygons import Polygons, surface_of
from .surface import TriangleSurface

CONTINUED = re.compile(rb"\\[ \t]*(?:\r\n|\r|\n)")
"""A line that goes on in the next one."""


def read(file: File) -> TriangleSurface:
    """Read the bytes of an OBJ file; raises MeshReadError."""
    text = Text(file, comment=b"#")
    if b"\\" in text.data:
        text.data = CONTINUED.sub(lambda match: b" " * len(match[0]), text.data)
    return Reader(text).read()


class Reader:
    """One pass over the file, block by block."""

    def __init__(self, text: Text) -> None:
        self.text = text
        self.points: list[Floats] = [np.empty((3, 0))]
        self.ids: list[Array] = [np.empty(0, np.int32)]
        self.sizes: list[Array] = [np.empty(0, np.int32)]
        self.vertex_count = 0

    def read(self) -> TriangleSurface:
        """Read vertices and faces.

        Raises
        ------
        MeshReadError
            A word is no number, a vertex has less than three, or a corner is no vertex: the line is named.
        """
        text = self.text
        for block in blocks(text):
            vertices = block.lines_of(b"v")
            self.faces(block, vertices)
            self.vertices(block, vertices)
        points = np.concatenate(self.points, axis=1)
        check_finite(
            points, lambda message, vertex: line_of(text, b"v", vertex, f"in the vertices, {message}")
        )
        sizes = np.concatenate(self.sizes)
        ends = np.cumsum(sizes, dtype=np.int64)

        def error_at(message: str, index: int) -> MeshReadError:
            return line_of(text, b"f", int(np.searchsorted(ends, index, "right")), message)

        polygons = Polygons(np.concatenate(self.ids), ends - sizes, sizes, error_at, base=1)
        return surface_of(text.file, "obj", points, [polygons], [])

    def vertices(self, block: Block, lines: Array) -> None:
        """Read lines `v x y z`."""
        values, counts = block.numbers(lines, np.float64, "a vertex", skipped=1)
        block.check(lines, counts >= 3, "a vertex has {} numbers, expected x, y and z", counts)
        if len(lines):
            self.points.append(columns(values, counts, 3))
            self.vertex_count += len(lines)

    def faces(self, block: Block, vertices: Array) -> None:
        """Read lines `f a b c`, of a block with vertices on these lines, which have not been counted yet."""
        lines = block.lines_of(b"f")
        if not len(lines):
            return
        block.cut_words(b"/")
        values, counts = block.numbers(lines, np.intp, "a face", skipped=1)
        ids = within_int32(values).astype(np.int32)
        if (ids <= 0).any():
            before = self.vertex_count + np.searchsorted(vertices, lines)
            ids = self.counted_back(block, lines, ids, counts, np.repeat(before, counts))
        self.ids.append(ids - np.int32(1))
        self.sizes.append(counts.astype(np.int32))

    def counted_back(self, block: Block, lines: Array, ids: Array, counts: Array, before: Array) -> Array:
        """The ids with -1 as the last of the vertices before, -2 as the one before it, ...; 0 is an error."""
        wrong = (ids == 0) | (ids < -before)
        if wrong.any():
            at = int(np.argmax(wrong))
            line = int(np.searchsorted(np.cumsum(counts), at, "right"))
            back = f" or -1 to -{int(before[at])}" if before[at] else ""
            raise self.text.error(
                f"a face refers to vertex {int(ids[at])}, expected a number from 1 on{back}",
                int(block.offsets(lines[line])),
            )
        return np.where(ids < 0, before + 1 + ids, ids).astype(np.int32)
