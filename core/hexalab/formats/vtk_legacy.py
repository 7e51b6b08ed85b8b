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

CellRows = tuple[Array, Array | range, Array, ErrorAt]
"""Rows of vertex ids: all their numbers, where each row begins, how long it is, and errors about one of the numbers."""

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
        self.cells: CellRows | None = None
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
        """Read CELLS, of which there is one section."""
        if self.cells is not None:
            raise self.text.error("a second section CELLS, expected one")
        self.cells = self.rows("CELLS")

    def rows(self, what: str) -> CellRows:
        """Read rows of vertex ids: OFFSETS and CONNECTIVITY (from version 5 on), or each begins with its length.

        `what` is the section's keyword, which has just been taken.
        """
        text = self.text
        start = text.word_offset()
        first = text.integer(f"the number of {what.lower()}")
        second = text.integer(f"the number of values in {what}")
        if first < 0 or second < 0:
            raise text.error(f"{what} announces {first} and {second}, expected two numbers above zero", start)
        self.values.begin()
        if text.data[text.position : text.position + 64].lstrip().upper().startswith(b"OFFSETS"):
            return self.split_rows(first, second)
        return self.counted_rows(first, second, what)

    def counted_rows(self, count: int, size: int, what: str) -> CellRows:
        """`CELLS n size`: each row begins with its number of corners."""
        ids, error_at = self.values.take(size, "i4", what)
        if count > size:
            raise error_at(
                f"{what} announces {count} {what.lower()} in {size} values, "
                f"expected more values than {what.lower()}",
                0,
            )
        uniform = int(ids[0]) if count and size == count * (int(ids[0]) + 1) else 0
        if uniform and (ids[:: uniform + 1] == uniform).all():
            even = range(1, size, uniform + 1)
            return ids, even, np.broadcast_to(np.int32(uniform), count), error_at
        starts = row_starts(ids, count, COUNTED, error_at, what) + 1
        return ids, starts, ids[starts - 1].astype(np.int32), error_at

    def split_rows(self, offset_count: int, size: int) -> CellRows:
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
        return ids, starts, sizes, error_at

    def read_types(self) -> None:
        """Read CELL_TYPES, VTK's number for each cell; of several such sections the first counts."""
        count = self.text.count("cell types", 0)
        self.values.begin()
        types, _ = self.values.take(count, "i4", "CELL_TYPES")
        if self.types is None:
            self.types = types
