"""OpenVolumeMesh `.ovm`, ASCII (SPEC R5): hexahedra and other kinds are rebuilt from their half-faces.

A half-edge or half-face is an edge or face and a side: `2 * id + side`. The normals of a cell's half-faces point into
the cell (OpenVolumeMesh's first tutorial, the cells that its kernels and its mesh generator make). Files of the other
convention are as common (its own hand-written Cube_with_props.ovm, what cinolib writes), so that the majority of a
file's cells decides.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..cells import KINDS
from ..errors import MeshReadError
from ..mesh import Mesh
from .assembly import Assembly, CellBlock, check_finite, free_name
from .cell_orientation import Orientation
from .file import File
from .half_faces import polygons, rebuild, rows_of
from .ids import within_int32
from .row_chain import COUNTED, row_starts
from .text import Text
from .tokens import quoted

COMPONENTS = dict.fromkeys(
    ("float", "double", "int", "uint", "unsigned_int", "short", "long", "bool", "char", "uchar"), 1
) | {f"vec{size}{code}": size for size in (2, 3, 4) for code in "fdi"}
"""Numbers in a value of a property's type."""


def read(file: File) -> Mesh:
    """Read the bytes of an `.ovm` file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """One pass over the sections."""

    def __init__(self, file: File) -> None:
        self.text = text = Text(file, comment=b"#")
        self.out = Assembly(file, "ovm", first_number=0)
        if text.word().upper() != b"OVM":
            raise text.error("expected OVM ASCII on the first line", 0)
        if text.peek().lower() == b"vertices":  # as in OpenVolumeMesh's own NonManifold.ovm
            self.out.note(
                "The first line does not say whether the file is ASCII or binary: it is read as ASCII."
            )
            return
        form = text.word()
        if form.upper() != b"ASCII":
            raise text.error(f"the file is in the form {quoted(form)}, expected ASCII")

    def read(self) -> Mesh:
        """Read vertices, edges, faces, polyhedra and properties, in the order that the format prescribes.

        Raises
        ------
        MeshReadError
            A section is missing, or an id of one refers to nothing in the one before.
        """
        text = self.text
        self.expect(b"Vertices")
        count = text.count("vertices", 3)
        start = text.position
        points = np.ascontiguousarray(text.numbers(3 * count, np.float64, "Vertices").reshape(count, 3).T)
        check_finite(
            points, lambda message, vertex: text.error(message, text.number_offset(start, 3 * vertex))
        )
        self.out.coordinates = points
        self.expect(b"Edges")
        edges, edge_error = self.ids(2 * text.count("edges", 2), "Edges")
        self.in_range(edges, count, edge_error, "vertex")
        self.expect(b"Faces")
        half_edges, face_starts, sizes, face_error = self.polygons("faces")
        self.in_range(half_edges, len(edges), face_error, "half-edge", face_starts)
        origins = edges.reshape(-1, 2)[half_edges >> 1, half_edges & 1]
        self.expect(b"Polyhedra")
        half_faces, cell_starts, cell_sizes, cell_error = self.polygons("cells")
        self.in_range(half_faces, 2 * len(sizes), cell_error, "half-face", cell_starts)
        kinds = self.cells(origins, face_starts, sizes, half_faces, cell_starts, cell_sizes)
        self.properties(count, len(cell_sizes), np.flatnonzero(kinds >= 0))
        return self.out.mesh()

    def expect(self, keyword: bytes) -> None:
        """Take the next word; a MeshReadError if it isn't this keyword, in capitals or not."""
        start = self.text.word_offset()
        word = self.text.word()
        if word.lower() != keyword.lower():
            raise self.text.error(f"{quoted(word)} stands where {keyword.decode()} was expected", start)

    def ids(self, count: int, what: str) -> tuple[NDArray[np.int32], Any]:
        """Read (count,) int32, and what makes an error about one of them: of a message and its index."""
        start = self.text.position
        values = self.text.ids(count, what)
        return values, lambda m, index: self.text.error(m, self.text.number_offset(start, index))

    def in_range(self, ids: Array, count: int, error_at: Any, what: str, skip: Array | None = None) -> None:
        """Raise unless all ids are below the count; those at `skip` - 1 are row lengths, and set to 0."""
        if skip is not None:
            ids[skip - 1] = 0
        wrong = (ids < 0) | (ids >= count)
        if len(ids) and wrong.any() and (skip is None or len(skip)):
            index = int(np.argmax(wrong))
            raise error_at(f"{what} {int(ids[index])} is not there, expected 0 to {count - 1}", index)

    def polygons(self, what: str) -> tuple[NDArray[np.int32], Array, Array, Any]:
        """Rows of a count and so many ids: all numbers, where each row's ids begin, their counts."""
        text = self.text
        count = text.count(what, 2)
        start = text.position
        end = self.next_word(b"Polyhedra" if what == "faces" else b"Prop")
        if what == "cells" and end < len(text.data):
            end = max(text.data.rfind(b"\n", start, end), text.data.rfind(b"\r", start, end)) + 1 or end
        values = within_int32(text.between(start, end, np.intp, what.capitalize())).astype(
            np.int32, copy=False
        )

        def error_at(message: str, index: int) -> MeshReadError:
            return text.error(message, text.number_offset(start, index))

        starts = row_starts(values, count, COUNTED, error_at, what.capitalize())
        return values, starts + 1, values[starts].copy(), error_at

    def cells(
        self,
        origins: Array,
        face_starts: Array,
        sizes: Array,
        half_faces: Array,
        starts: Array,
        counts: Array,
    ) -> NDArray[np.int8]:
        """Add the cells kind by kind; returns the kind of each, -1 for what is left out."""
        assert self.out.coordinates is not None

        def loops_of(part: slice) -> Array:
            faces = rows_of(half_faces ^ 1, starts[part], counts[part])  # normals point inwards
            return polygons(faces, origins, face_starts, sizes)

        cells = rebuild(loops_of, len(counts))
        orientation = Orientation(inwards=True, faces="half-faces")
        place = np.cumsum(cells.kinds >= 0) - 1
        for kind in range(len(KINDS)):
            which, own, agreeing = cells.of(kind)
            if len(which):
                block = CellBlock(kind, own, lambda m, *_: self.text.error(m), cells=place[which])
                orientation.add(block, agreeing, self.out.coordinates)
                self.out.blocks.append(block)
        orientation.settle(self.out)
        self.out.leave_out("polyhedra", int((cells.kinds < 0).sum()))
        return cells.kinds

    def properties(self, vertex_count: int, cell_count: int, kept: Array) -> None:
        """Read `VProp type "name"` and `CProp`, each followed by one value per entry; skip the rest."""
        text = self.text
        while word := text.word():
            on = word.decode("latin-1").lower()
            words = text.line().split(None, 1)
            width = COMPONENTS.get(words[0].decode("latin-1").lower(), 0) if words else 0
            if on not in ("vprop", "cprop") or len(words) < 2 or not width:
                self.skip_property()
                continue
            name = words[1].strip().strip(b'"').decode("utf-8", "replace")
            count = vertex_count if on == "vprop" else cell_count
            values = text.numbers(count * width, np.float64, f"the property {quoted(words[1])}").reshape(
                count, width
            )
            arrays = self.out.point_data if on == "vprop" else self.out.cell_data
            arrays[free_name(arrays, name)] = values if on == "vprop" else values[kept]

    def next_word(self, word: bytes) -> int:
        """Where the word occurs next, in its usual spellings; the file's end if it does not."""
        text = self.text
        found = (text.data.find(w, text.position) for w in (word, word.lower(), word.upper()))
        return min((at for at in found if at >= 0), default=len(text.data))

    def skip_property(self) -> None:
        """Go to the next line that begins a property."""
        text = self.text
        at = self.next_word(b"Prop")
        if at < len(text.data):
            at = max(text.position, text.data.rfind(b"\n", text.position, at) + 1)
        text.position = at
