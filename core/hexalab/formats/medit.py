"""Medit `.mesh`, ASCII (SPEC R1).

Keywords in any order and letter case, comments from `#`, any white space. A row of vertices or cells ends
with a reference or not: what the numbers up to the next keyword come to decides. References that are not
all zero become the attribute "reference". Edges, triangles and quadrilaterals are the mesh's features, with what
Corners, Ridges and Required* name of them.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from ..arrays import Array, Ids
from ..errors import MeshReadError
from ..mesh import Mesh
from .assembly import Assembly, CellBlock, check_finite
from .file import File
from .ids import narrowed, put, whole_tags, within_int32
from .medit_features import NEXT_KEYWORD, REFERENCE, FeatureSections
from .medit_keywords import CELLS, CURVED, FEATURES, MARKS, ORDERS, SKIPPED
from .text import Interrupted, Text
from .tokens import NUMBER, is_number, quoted


def read(file: File) -> Mesh:
    """Read the bytes of a `.mesh` file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """One pass over the file, section by section."""

    def __init__(self, file: File) -> None:
        self.out = Assembly(file, "mesh")
        self.text = Text(file, comment=b"#", note=self.out.note)
        self.features = FeatureSections(self.text, self.out)
        self.point_references: Array | None = None
        self.cell_references: list[Array] = []

    def read(self) -> Mesh:
        """Read section after section up to the keyword End, whose absence is noted.

        References become an attribute where one of them isn't 0.

        Raises
        ------
        MeshReadError
            A section is cut short or the dimension isn't 3; the line is named.
        """
        text, ended = self.text, False
        while word := text.word():
            ended = word.lower() == b"end"
            if ended:
                break
            self.section(word)
        if not ended:
            self.out.note("The file does not end with the keyword End: it may be cut short.")
        if self.point_references is not None and self.point_references.any():
            self.out.point_data[REFERENCE] = self.point_references
        self.features.elements.finish()
        references = np.concatenate(self.cell_references) if self.cell_references else np.zeros(0)
        if references.any():
            self.out.cell_data[REFERENCE] = references
        return self.out.mesh()

    def section(self, word: bytes) -> None:
        """Read or skip what follows a keyword."""
        text, keyword = self.text, word.decode("latin-1").lower()
        if keyword == "meshversionformatted":
            text.integer("the format's version")
        elif keyword == "dimension":
            start = text.word_offset()
            dimension = text.integer("the dimension")
            if dimension != 3:
                raise text.error(f"the dimension is {dimension}, expected 3: a volumetric mesh", start)
        elif keyword == "vertices":
            self.vertices()
        elif keyword in CELLS:
            self.cells(keyword)
        elif keyword in FEATURES or keyword in MARKS:
            self.features.section(keyword)
        elif NUMBER.fullmatch(word):
            raise text.error(
                f"{quoted(word)} stands where a keyword was expected: the section before has more numbers "
                "than it announces",
                text.position - len(word),
            )
        else:
            if keyword in CURVED:
                self.out.leave_out(f"curved {CURVED[keyword]}", text.count(CURVED[keyword]))
            elif keyword not in SKIPPED:
                self.out.note(f"The section {quoted(word)} is not of the format and was skipped.")
            self.skip()

    def skip(self) -> None:
        """Go to the next keyword."""
        match = NEXT_KEYWORD.search(self.text.data, self.text.position)
        self.text.position = match.start() if match else len(self.text.data)

    def vertices(self) -> None:
        """Read `Vertices`: x, y, z and a reference, which some tools leave out.

        Which of both it is shows in the first row; where the section has just as many numbers as the other form
        takes, it is read so.
        """
        if self.out.coordinates is not None:
            raise self.text.error("a second section Vertices: expected one")
        count = self.text.count("vertices", 3)
        start = self.text.position
        width = self.guess(4)
        try:
            values = self.vertex_rows(count, width)
        except Interrupted as stop:
            if stop.found != count * (7 - width):
                raise
            self.text.position, width = start, 7 - width
            values = self.vertex_rows(count, width)
        self.out.coordinates = values[:3]
        if width == 4:
            self.point_references = whole_references(values[3])
            if np.abs(values[3]).max(initial=0) >= 2**53:
                self.point_references = self.long_references(start)

    def long_references(self, start: int) -> Array:
        """References of vertices that a float64 rounds, out of their words; as they are where one is not whole."""
        words = self.text.data[start : self.text.position].split()[3::4]
        try:
            return np.array(words).astype(np.int64)
        except (ValueError, OverflowError):
            return np.array(words).astype(np.float64)

    def vertex_rows(self, count: int, width: int) -> Array:
        """(width, count) float64."""
        text = self.text
        begin = text.position
        self.check_room(count, width, 7 - width, "Vertices")
        out = np.empty((width, count))
        for part, rows in text.rows(count, width, np.float64, "Vertices"):
            out[:, part] = rows.T
            check_finite(out[:3, part], partial(self.vertex_error, begin, width, part.start))
        return out

    def vertex_error(self, begin: int, width: int, first: int, message: str, vertex: int) -> MeshReadError:
        """The error for a vertex of a piece of the section that begins at byte `begin`."""
        return self.text.error(message, self.text.number_offset(begin, (first + vertex) * width))

    def cells(self, keyword: str) -> None:
        """Read a section of cells: corners, counted from 1, and a reference, which some tools leave out."""
        kind, own, row = CELLS[keyword]
        count = self.text.count(keyword, row)
        start = self.text.position
        width = self.guess(row + 1)
        other = 2 * row + 1 - width
        try:
            corners, references = self.cell_rows(keyword, count, width)
        except Interrupted as stop:
            self.text.position = start
            if stop.found % (row + 1) == row and is_number(stop.word, np.float64):
                corners, references = self.cells_of_real_references(keyword, count, stop)
                width = row + 1
            elif stop.found == count * other:
                width = other
                corners, references = self.cell_rows(keyword, count, width)
            else:
                raise
        if row > own and count:
            self.out.note(f"Cells of higher order ({keyword}) are shown by their corners.")
        text = self.text

        def locate(message: str, cell: int, corner: int) -> MeshReadError:
            return text.error(message, text.number_offset(start, cell * width + corner))

        self.out.blocks.append(CellBlock(kind, corners, locate, base=1))
        self.cell_references.append(references)

    def cells_of_real_references(self, keyword: str, count: int, stop: Interrupted) -> tuple[Ids, Array]:
        """`cell_rows` of a section whose references are written as ‘0.0’; raises `stop` if its ids are no integers."""
        _, own, row = CELLS[keyword]
        corners, references = np.empty((own, count), dtype=np.int32), np.zeros(count)
        for part, rows in self.text.rows(count, row + 1, np.float64, keyword.capitalize()):
            ids = whole_tags(rows[:, :own])
            if ids is None:
                raise stop
            np.subtract(within_int32(ids).T, 1, out=corners[:, part], casting="unsafe")
            references[part] = rows[:, row]
        self.out.note(
            f"The references of {keyword.capitalize()} are written as numbers with a decimal point."
        )
        return in_own_order(keyword, corners), whole_references(references)

    def cell_rows(self, keyword: str, count: int, width: int) -> tuple[Ids, Array]:
        """(own corners, count) zero-based, and (count,) references as int32, or int64 where one is large."""
        _, own, row = CELLS[keyword]
        self.check_room(count, width, 2 * row + 1 - width, keyword.capitalize())
        corners = np.empty((own, count), dtype=np.int32)
        references: Array = np.zeros(count, dtype=np.int32)
        for part, rows in self.text.rows(count, width, np.intp, keyword.capitalize()):
            small = within_int32(rows)
            np.subtract(small[:, :own].T, 1, out=corners[:, part], casting="unsafe")
            if width > row and small is rows:
                references[part] = rows[:, row]
            elif width > row:
                references = put(references, part, rows[:, row])
        return in_own_order(keyword, corners), references

    def guess(self, width: int) -> int:
        """The width if the next line has as many numbers or more than one row, else one less."""
        words = self.text.first_row_width()
        return width - 1 if words == width - 1 else width

    def check_room(self, count: int, width: int, other: int, what: str) -> None:
        """Raise if fewer bytes are left than so many rows take; the other width may still fit."""
        left = len(self.text.data) - self.text.position
        if count * width * 2 > left + 1:
            message = f"{what} should be {count * width} numbers, but the file has only {left} more bytes"
            raise Interrupted(self.text.error(message), count * other)


def in_own_order(keyword: str, corners: Ids) -> Ids:
    """A section's corners in VTK's order."""
    order = ORDERS.get(CELLS[keyword][0])
    return corners if order is None else corners[list(order)]


def whole_references(values: Array) -> Array:
    """References as integers where all are whole: int32 if it can hold them, else int64."""
    if values.dtype.kind != "f":
        return narrowed(values)
    whole = whole_tags(values)
    return values if whole is None else narrowed(whole)
