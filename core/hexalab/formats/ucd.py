"""AVS UCD `.inp` and `.ucd` in text: nodes, cells with a material, values at both.

AVS numbers the top of a hexahedron or wedge first and a pyramid by its apex; deal.II's and Cubit's files, and VTK's
reader, number the first two as VTK does. Files do not tell which; their cells do: see `order_of`.
"""

from __future__ import annotations

import re

import numpy as np

from ..arrays import Array, Floats
from ..cells import HEXAHEDRON, KINDS, PYRAMID, TETRAHEDRON, WEDGE
from ..errors import MeshReadError
from ..mesh import Mesh
from .assembly import Assembly, CellBlock, check_finite, check_ids, free_name
from .cell_orientation import signed_volumes
from .file import File
from .ids import Numbering, narrowed, whole_tags
from .row_chain import row_starts
from .text import Text
from .tokens import quoted
from .typed_rows import Shape, TypedRows, row_form

SHAPES = {
    1: Shape("points", 1),
    2: Shape("lines", 2),
    3: Shape("triangles", 3),
    4: Shape("quadrilaterals", 4),
    5: Shape("tetrahedra", 4, TETRAHEDRON, (0, 1, 2, 3)),
    6: Shape("pyramids", 5, PYRAMID, (0, 1, 2, 3, 4)),
    7: Shape("wedges", 6, WEDGE, (0, 1, 2, 3, 4, 5)),
    8: Shape("hexahedra", 8, HEXAHEDRON, tuple(range(8))),
}
"""Our own numbers of the types, which are words in the file."""

WORDS = {b"pt": 1, b"line": 2, b"tri": 3, b"quad": 4, b"tet": 5, b"pyr": 6, b"prism": 7, b"hex": 8}

CELL = row_form(SHAPES, 2)
"""Number, material, type, nodes."""

OF_AVS = {
    TETRAHEDRON: (0, 1, 3, 2),
    PYRAMID: (1, 2, 3, 4, 0),
    WEDGE: (3, 4, 5, 0, 1, 2),
    HEXAHEDRON: (4, 5, 6, 7, 0, 1, 2, 3),
}
"""VTK's corners out of AVS's nodes."""


def read(file: File) -> Mesh:
    """Read the bytes of a UCD file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """One pass over the five parts of the file."""

    def __init__(self, file: File) -> None:
        if file.data[:1] == b"\x07":
            raise file.error("this AVS UCD file is binary: only UCD in text can be read, save it as ASCII")
        self.out = Assembly(file, "ucd")
        self.text = Text(file, comment=b"#", note=self.out.note)

    def read(self) -> Mesh:
        """Read nodes, cells and values.

        Raises
        ------
        MeshReadError
            A part is cut short, a cell's type is not known or a node isn't there.
        """
        text = self.text
        nodes = text.count("nodes", 4)
        cells = text.count("cells", 4)
        node_values, cell_values, _model_values = (
            text.integer(f"the number of values {where}")
            for where in ("at each node", "of each cell", "of the model")
        )
        numbers, coordinates = self.nodes(nodes)
        self.out.coordinates, self.out.vertex_numbers = coordinates, numbers
        of_cells, kept = self.cells(cells, Numbering(numbers))
        if node_values > 0:
            self.values(node_values, Numbering(numbers), np.ones(nodes, dtype=bool), self.out.point_data)
        if cell_values > 0:
            self.values(cell_values, Numbering(of_cells), kept, self.out.cell_data)
        return self.out.mesh()

    def nodes(self, count: int) -> tuple[Array, Floats]:
        """Numbers, (n,), and places, (3, n), of the nodes."""
        text = self.text
        begin = text.position
        rows = text.numbers(4 * count, np.float64, "nodes").reshape(count, 4)
        numbers = whole_tags(rows[:, 0])
        if numbers is None:
            row = int(np.argmax(~(np.abs(rows[:, 0]) < 2**53) | (rows[:, 0] % 1 != 0)))
            raise text.error("a node has a number that is not whole", text.number_offset(begin, 4 * row))
        coordinates = np.ascontiguousarray(rows[:, 1:].T)
        check_finite(
            coordinates,
            lambda message, node: text.error(
                f"in the nodes, {message}", text.number_offset(begin, 4 * node + 1)
            ),
        )
        return numbers, coordinates

    def cells(self, count: int, numbering: Numbering) -> tuple[Array, Array]:
        """Read the cells; their numbers, and which are kept. Those of lower dimension are features."""
        rows = self.cell_rows(count)
        numbers = rows.column(0)
        kept, cells = rows.cells(self.out)
        for kind, which, tags, places in cells:
            corners = numbering.places(tags)
            if (corners < 0).any():
                node = int(tags.T[(corners < 0).T][0])
                cell = int(numbers[which[(corners < 0).any(axis=0)][0]])
                raise self.text.error(f"cell {cell} refers to node {node}: it is missing", self.begin)
            block = CellBlock(kind, corners, self.locate, cells=places, numbers=numbers[which])
            check_ids(block, numbering.count)
            block.corners = corners[list(self.order_of(block))]
            self.out.blocks.append(block)
        self.out.features += rows.features("material", 1, numbering.places)
        material = rows.column(1)[kept]
        if material.any():
            self.out.cell_data["material"] = narrowed(material)
        return numbers, kept

    def cell_rows(self, count: int) -> TypedRows:
        """The rows of the cells, their types' words as numbers."""
        text = self.text
        text.position = self.begin = text.word_offset()
        ends = np.flatnonzero(np.frombuffer(text.data, np.uint8, offset=self.begin) == ord("\n"))
        end = self.begin + int(ends[count - 1]) if 0 < count <= len(ends) else len(text.data)
        lines = text.data[self.begin : end]
        for word in {match[0].lower() for match in re.finditer(rb"(?<!\S)[A-Za-z]\S*", lines)}:
            if word not in WORDS:
                known = ", ".join(sorted(name.decode() for name in WORDS))
                at = self.begin + lines.lower().index(word)
                raise text.error(
                    f"{quoted(word)} stands where a cell's type was expected, one of {known}", at
                )
            lines = re.sub(rb"(?<!\S)(?i:" + word + rb")(?!\S)", str(WORDS[word]).encode(), lines)
        own = Text(File(lines, text.file.name), note=self.out.note)
        values = own.between(0, len(lines), np.intp, "cells")

        def error_at(message: str, index: int) -> MeshReadError:
            line = lines.count(b"\n", 0, own.number_offset(0, index))
            return text.error(message, self.begin if not line else self.begin + int(ends[line - 1]) + 1)

        text.position = end
        return TypedRows(values, row_starts(values, count, CELL, error_at, "cells"), 2, SHAPES)

    def locate(self, message: str, _cell: int, _corner: int) -> MeshReadError:
        """An error at the cells."""
        return self.text.error(message, self.begin)

    def order_of(self, block: CellBlock) -> tuple[int, ...]:
        """The nodes that are the corners of such cells in VTK's order: AVS's numbering, or VTK's if that fits better.

        The better one leaves fewer cells of that kind inverted; of pyramids, for which both may do, the one
        whose bases are flatter.
        """
        assert self.out.coordinates is not None
        own = tuple(range(len(block.corners)))
        misfits = [self.misfit(block.kind, block.corners[list(order)]) for order in (OF_AVS[block.kind], own)]
        if misfits[0] <= misfits[1]:
            return OF_AVS[block.kind]
        self.out.note(
            f"Cells of the kind {KINDS[block.kind]} are numbered as VTK numbers them, and not as AVS does: read so."
        )
        return own

    def misfit(self, kind: int, corners: Array) -> tuple[float, int]:
        """How badly corners fit, to be compared: volume above pyramids' bases, and number of inverted cells."""
        assert self.out.coordinates is not None
        places = self.out.coordinates
        inverted = int((signed_volumes(kind, corners, places) < 0).sum())
        if kind != PYRAMID:
            return 0.0, inverted
        first, *others = (places[:, corners[corner]] for corner in range(4))
        u, v, w = (other - first for other in others)
        return float(np.abs(np.einsum("in,in->n", u, np.cross(v, w, axis=0))).sum()), inverted

    def values(self, width: int, numbering: Numbering, kept: Array, arrays: dict[str, Array]) -> None:
        """Read the values at nodes or of cells: the sizes of the arrays, a name for each, a row for each entry."""
        text = self.text
        count = text.integer("the number of arrays")
        sizes = [text.integer("the size of an array") for _ in range(max(0, count))]
        if sum(sizes) != width or min(sizes, default=0) < 1:
            raise text.error(f"arrays of sizes {sizes} are announced, but {width} values")
        text.line()
        names = [text.line().split(b",")[0].decode("utf-8", "replace").strip() for _ in sizes]
        rows = text.numbers((width + 1) * numbering.count, np.float64, "values").reshape(-1, width + 1)
        tags = whole_tags(rows[:, 0])
        places = numbering.places(tags) if tags is not None else np.full(len(rows), -1)
        if (places < 0).any():
            raise text.error(f"values of {rows[int(np.argmax(places < 0)), 0]:g} are given: it is missing")
        table = np.empty((numbering.count, width))
        table[places] = rows[:, 1:]
        start = 0
        for name, size in zip(names, sizes, strict=True):
            arrays[free_name(arrays, name)] = table[kept, start : start + size]
            start += size
