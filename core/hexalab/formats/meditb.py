"""Medit `.meshb`, binary versions 1 to 4, both byte orders (SPEC R2; libMeshb's documentation).

The file is a list of sections; each names the byte where the next one begins. Version 1 has 32-bit reals, 2
has 64-bit reals, 3 has 64-bit positions too, 4 has 64-bit integers throughout.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from ..errors import MeshReadError
from ..mesh import Mesh
from .assembly import Assembly, CellBlock, check_finite
from .byte_order import as_coordinates, native
from .file import File
from .ids import within_int32
from .medit import whole_references
from .medit_features import REFERENCE, MarkedElements
from .medit_keywords import ORDERS

DIMENSION, VERTICES, END = 3, 4, 54

CELLS = {
    8: (TETRAHEDRON, 4, 4),
    9: (WEDGE, 6, 6),
    10: (HEXAHEDRON, 8, 8),
    49: (PYRAMID, 5, 5),
    30: (TETRAHEDRON, 4, 10),
    33: (HEXAHEDRON, 8, 27),
    86: (WEDGE, 6, 18),
    87: (PYRAMID, 5, 14),
}
"""Section number: kind, corners, vertices in a row (without the reference)."""

FEATURES = {5: ("edges", 2), 6: ("triangles", 3), 7: ("quadrilaterals", 4)}
"""Elements of lower dimension: section's number to its keyword, and vertices in a row (without the reference)."""

MARKS = {13: "corners", 14: "ridges", 15: "requiredvertices", 16: "requirededges"}
"""Sections that name some of the vertices or edges."""

MOST_SECTIONS = 100_000


def read(file: File) -> Mesh:
    """Read the bytes of a `.meshb` file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """Goes from section to section."""

    def __init__(self, file: File) -> None:
        self.file = file
        self.position = 0
        self.out = Assembly(file, "meshb")
        self.references: list[Array] = []
        self.elements = MarkedElements(self.out)
        mark = file.data[:4]
        if mark not in (b"\1\0\0\0", b"\0\0\0\1"):
            raise file.error("expected the number 1 in the first 4 bytes", offset=0)
        self.order = "<" if mark == b"\1\0\0\0" else ">"
        self.position = 4
        self.version = self.integer("i4", "the version")
        if not 1 <= self.version <= 4:
            raise file.error(f"the file has version {self.version}, expected 1 to 4", offset=4)
        self.real = "f4" if self.version == 1 else "f8"
        self.whole = "i8" if self.version == 4 else "i4"
        self.place = "i8" if self.version >= 3 else "i4"

    def read(self) -> Mesh:
        """Follow the chain of sections: each says at which byte the next begins, the last 0.

        Raises
        ------
        MeshReadError
            A section points backwards or out of the file, or is shorter than it says.
        """
        ended = False
        for _ in range(MOST_SECTIONS):
            if self.position + 4 > len(self.file.data):
                break
            begin = self.position
            section = self.integer("i4", "a section's number")
            if section == END:
                ended = True
                break
            following = self.integer(self.place, "a section's end")
            if following and not begin + 4 + int(self.place[1]) <= following <= len(self.file.data):
                raise self.error(
                    f"section {section} says that the next begins at byte {following}, expected one behind it "
                    f"in the file's {len(self.file.data)} bytes",
                    begin,
                )
            self.section(section)
            if not following:
                break
            self.position = following
        if not ended:
            self.out.note("The file does not end with the section End: it may be cut short.")
        self.elements.finish()
        references = np.concatenate(self.references) if self.references else np.zeros(0)
        if references.any():
            self.out.cell_data[REFERENCE] = references
        return self.out.mesh()

    def error(self, message: str, offset: int | None = None) -> MeshReadError:
        """An error at a byte of the file; at the present position by default."""
        return self.file.error(message, offset=self.position if offset is None else offset)

    def take(self, dtype: np.dtype[Any], count: int, what: str) -> NDArray[Any]:
        """So many entries from the present position."""
        left = len(self.file.data) - self.position
        if count < 0 or count * dtype.itemsize > left:
            raise self.error(f"{count} {what} are announced, {dtype.itemsize} bytes each, with {left} left")
        values = np.frombuffer(self.file.data, dtype, count, self.position)
        self.position += count * dtype.itemsize
        return values

    def integer(self, code: str, what: str) -> int:
        """The next integer, "i4" or "i8" in the file's byte order; `what` is its name in errors."""
        return int(self.take(np.dtype(self.order + code), 1, what)[0])

    def section(self, section: int) -> None:
        """Read what the section holds, if it is of use."""
        if section == DIMENSION:
            dimension = self.integer("i4", "the dimension")
            if dimension != 3:
                raise self.error(f"the dimension is {dimension}, expected 3: a volumetric mesh")
        elif section == VERTICES:
            self.vertices()
        elif section in CELLS:
            self.cells(section)
        elif section in FEATURES or section in MARKS:
            self.features(section)

    def features(self, section: int) -> None:
        """Read elements of lower dimension, or numbers of them; what can't be read costs them, not the mesh."""
        keyword, width = FEATURES.get(section, (MARKS.get(section, ""), 0))
        try:
            count = self.integer(self.whole, f"the number of {keyword}")
            columns = width + 1
            rows = self.take(np.dtype((self.order + self.whole, (columns,))), count, keyword)
        except MeshReadError as error:
            self.out.note(f"{keyword.capitalize()} were left out. {error}.")
            return
        table = native(rows).reshape(count, columns)
        if width:
            self.elements.add(keyword, table[:, :width].T, whole_references(table[:, width]))
        else:
            self.elements.mark(keyword, table[:, 0])

    def vertices(self) -> None:
        """Read rows of three reals, float32 in version 1 and float64 from 2 on, and a reference."""
        if self.out.coordinates is not None:
            raise self.error("a second section Vertices: expected one")
        count = self.integer(self.whole, "the number of vertices")
        begin = self.position
        dtype = np.dtype([("x", self.order + self.real, 3), ("reference", self.order + self.whole)])
        rows = self.take(dtype, count, "vertices")
        coordinates = as_coordinates(rows["x"])
        check_finite(
            coordinates, lambda message, vertex: self.error(message, begin + vertex * dtype.itemsize)
        )
        self.out.coordinates = coordinates
        if rows["reference"].any():
            self.out.point_data[REFERENCE] = whole_references(native(rows["reference"]))

    def cells(self, section: int) -> None:
        """Read rows of corners, counted from 1, and a reference; int64 in version 4, int32 before."""
        kind, own, row = CELLS[section]
        count = self.integer(self.whole, "the number of cells")
        begin = self.position
        size = (row + 1) * int(self.whole[1])
        rows = self.take(np.dtype((self.order + self.whole, (row + 1,))), count, "cells").reshape(
            count, row + 1
        )
        if row > own and count:
            self.out.note("Cells of higher order are shown by their corners.")
        corners = np.empty((own, count), dtype=np.int32)
        for place, column in enumerate(ORDERS.get(kind, tuple(range(own)))):
            np.subtract(within_int32(rows[:, column]), 1, out=corners[place], casting="unsafe")

        def locate(message: str, cell: int, corner: int) -> MeshReadError:
            return self.error(message, begin + cell * size + corner * int(self.whole[1]))

        self.out.blocks.append(CellBlock(kind, corners, locate, base=1))
        self.references.append(whole_references(native(rows[:, row])))
