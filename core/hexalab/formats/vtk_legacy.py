"""VTK legacy `.vtk`, versions 1.0 to 5.1, ASCII and binary (SPEC R3).

`CELLS` is read in both forms, `n size` with rows that begin with their length, and
`OFFSETS`/`CONNECTIVITY`; the word OFFSETS tells them apart, as version lines are not to be trusted. What
stands after the geometry and is no section of the format ends the reading with a note: published files end
in logs of the program that wrote them.
"""

from __future__ import annotations

import re

import numpy as np

from ..arrays import Array
from ..mesh import Mesh
from .assembly import Assembly, check_finite
from .byte_order import as_coordinates
from .file import File
from .row_chain import COUNTED, ErrorAt, row_starts
from .text import Text
from .tokens import NUMBER, quoted
from .vtk_attributes import SECTIONS, Attributes
from .vtk_cells import Rows, add_cells, spans
from .vtk_datasets import refusal
from .vtk_values import Values

HEADER = re.compile(rb"\s*#\s*vtk\s+DataFile[^\r\n]*\r?\n", re.I)


def read(file: File) -> Mesh:
    """Read the bytes of a `.vtk` file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """One pass over the file, section by section."""

    def __init__(self, file: File) -> None:
        self.out = Assembly(file, "vtk", first_number=0)
        self.text = Text(file, note=self.out.note)
        self.values = Values(self.text, self.header())
        self.attributes = Attributes(self.text, self.values, self.out)
        self.cells: tuple[Array, Array | range, Array, ErrorAt] | None = None
        self.types: Array | None = None

    def header(self) -> bool:
        """Read the first lines; whether the file is binary."""
        text = self.text
        match = HEADER.match(text.data, text.position)
        if not match:
            raise text.error("expected ‘# vtk DataFile Version’ on the first line")
        text.position = match.end()
        lines: list[bytes] = []
        while len(lines) < 4 and text.position < len(text.data):
            line = text.line().strip()
            lines.append(line)
            if line.upper() in (b"ASCII", b"BINARY") and text.peek().upper() == b"DATASET":
                return line.upper() == b"BINARY"
        raise text.error(
            f"expected a title, then ASCII or BINARY, then DATASET; found {quoted(b' '.join(lines).strip())}"
        )

    def read(self) -> Mesh:
        """Read section after section; reading stops, with a note, at what isn't of the format behind the cells.

        Raises
        ------
        MeshReadError
            No unstructured grid, no cells, or sections that don't fit one another.
        """
        text = self.text
        while word := text.word():
            start = text.position - len(word)
            keyword = word.decode("latin-1").lower()
            if keyword == "dataset":
                self.dataset()
            elif keyword == "points":
                self.points()
            elif keyword == "cells":
                self.read_cells()
            elif keyword == "cell_types":
                self.read_types()
            elif keyword in SECTIONS:
                self.attributes.section(keyword)
            elif self.cells is None or NUMBER.fullmatch(word):
                raise text.error(
                    f"{quoted(word)} stands where a section was expected, such as POINTS or CELLS", start
                )
            else:
                line = text.file.line_number(start)
                self.out.note(f"Reading stopped at line {line}, which is not of the format: {quoted(word)}.")
                break
        return self.finish()

    def finish(self) -> Mesh:
        """Put points, cells, types and attributes together."""
        text = self.text
        if self.cells is None:
            raise text.error("the file ends before its section CELLS")
        ids, starts, sizes, error_at = self.cells
        if self.types is not None and len(self.types) != len(sizes):
            raise text.error(
                f"CELL_TYPES has {len(self.types)} entries, expected one for each of {len(sizes)} cells"
            )
        if self.out.coordinates is None:
            raise text.error("the file ends before its section POINTS")
        rows = Rows(ids, starts, sizes, self.types, error_at)
        kept = add_cells(self.out, rows)
        rows.orientation.settle(self.out)
        rows.wedges.settle(self.out)
        self.attributes.finish(len(sizes), kept)
        return self.out.mesh()

    def dataset(self) -> None:
        """Read the kind of data set; any but UNSTRUCTURED_GRID is an error that says what was found."""
        word = self.text.word()
        name = word.decode("latin-1").lower()
        if name != "unstructured_grid":
            raise self.text.error(refusal(word.decode("latin-1"), "UNSTRUCTURED_GRID"))

    def points(self) -> None:
        """Read POINTS, of any number type, into (3, V) float64; what isn't finite is an error."""
        text = self.text
        if self.out.coordinates is not None:
            raise text.error("a second section POINTS, expected one")
        count = text.count("points")
        code = self.values.number_type(text.word())
        if code in ("bit", "string"):
            raise text.error(f"the points are of type {code}, expected float or double")
        self.values.begin()
        start = text.position
        if self.values.binary:
            values, error_at = self.values.take(3 * count, code, "POINTS")
            coordinates = as_coordinates(values.reshape(count, 3))
        else:
            text.check_room(3 * count, "POINTS")
            coordinates = np.empty((3, count))
            for part, rows in text.rows(count, 3, np.float64, "POINTS"):
                coordinates[:, part] = rows.T
            error_at = self.values.text_error(start)
        check_finite(coordinates, lambda message, vertex: error_at(message, 3 * vertex))
        self.out.coordinates = coordinates

    def read_cells(self) -> None:
        """Read CELLS, either OFFSETS and CONNECTIVITY (from version 5 on) or rows that begin with their length."""
        text = self.text
        if self.cells is not None:
            raise text.error("a second section CELLS, expected one")
        start = text.word_offset()
        first = text.integer("the number of cells")
        second = text.integer("the number of values in CELLS")
        if first < 0 or second < 0:
            raise text.error(f"CELLS announces {first} and {second}, expected two numbers above zero", start)
        self.values.begin()
        if text.data[text.position : text.position + 64].lstrip().upper().startswith(b"OFFSETS"):
            self.split_cells(first, second)
        else:
            self.counted_cells(first, second)

    def counted_cells(self, count: int, size: int) -> None:
        """`CELLS n size`: each row begins with its number of corners."""
        ids, error_at = self.values.take(size, "i4", "CELLS")
        if count > size:
            raise error_at(
                f"CELLS announces {count} cells in {size} values, expected more values than cells", 0
            )
        uniform = int(ids[0]) if count and size == count * (int(ids[0]) + 1) else 0
        if uniform and (ids[:: uniform + 1] == uniform).all():
            even = range(1, size, uniform + 1)
            self.cells = ids, even, np.broadcast_to(np.int32(uniform), count), error_at
            return
        starts = row_starts(ids, count, COUNTED, error_at, "CELLS") + 1
        self.cells = ids, starts, ids[starts - 1].astype(np.int32), error_at

    def split_cells(self, offset_count: int, size: int) -> None:
        """`CELLS n+1 size`, then OFFSETS and CONNECTIVITY, each with its number type."""
        text = self.text
        text.word()
        code = self.values.number_type(text.word())
        self.values.begin()
        offsets, offset_error = self.values.take(offset_count, code, "OFFSETS")
        word = text.word()
        if word.upper() != b"CONNECTIVITY":
            raise text.error(f"{quoted(word)} stands where CONNECTIVITY was expected")
        code = self.values.number_type(text.word())
        self.values.begin()
        ids, error_at = self.values.take(size, code, "CONNECTIVITY")
        starts, sizes = spans(offsets, size, offset_error)
        self.cells = ids, starts, sizes, error_at

    def read_types(self) -> None:
        """Read CELL_TYPES, VTK's number for each cell; of several such sections the first counts."""
        count = self.text.count("cell types", 0)
        self.values.begin()
        types, _ = self.values.take(count, "i4", "CELL_TYPES")
        if self.types is None:
            self.types = types
