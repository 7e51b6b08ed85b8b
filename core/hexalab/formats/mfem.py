"""MFEM `.mesh`, version 1: sections of elements and vertices in text (mfem.org/mesh-format-v1.0).

Elements keep their attribute as "attribute". A curved mesh has the coordinates of its vertices in the section nodes, as
the first values of a continuous grid function; its cells are shown by their corners.
"""

from __future__ import annotations

import re

import numpy as np

from ..arrays import Array, Floats
from ..cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from ..errors import MeshReadError
from ..groups import Group
from ..mesh import Mesh
from .assembly import WEDGE_OF_OTHERS, Assembly, CellBlock, check_finite
from .file import File
from .ids import as_int32, narrowed
from .row_chain import row_starts
from .text import Text
from .tokens import is_number, quoted
from .typed_rows import Shape, TypedRows, row_form

SHAPES = {
    0: Shape("points", 1),
    1: Shape("lines", 2),
    2: Shape("triangles", 3),
    3: Shape("quadrilaterals", 4),
    4: Shape("tetrahedra", 4, TETRAHEDRON, (0, 1, 2, 3)),
    5: Shape("hexahedra", 8, HEXAHEDRON, tuple(range(8))),
    6: Shape("wedges", 6, WEDGE, WEDGE_OF_OTHERS),
    7: Shape("pyramids", 5, PYRAMID, (0, 1, 2, 3, 4)),
}
"""MFEM's numbers of geometries."""

SETS = "attribute_set"
"""Origin of the groups that sets of attributes make."""

ELEMENT = row_form(SHAPES, 1)
"""Attribute, geometry, vertices."""

HEADER = re.compile(rb"MFEM\s+(?:(mesh)\s+v1\.[0-3]|([^\r\n]*?))\s*(?:[\r\n]|$)")

SET = re.compile(rb'"([^"\r\n]*)"\s+\d+((?:\s+\d+)*)')
"""A set of attributes: its name, how many there are, and they."""

CONTINUOUS = re.compile(rb"H1(?:Pos|Ser|@\w)?_\w+|Linear|Quadratic|QuadraticPos|Cubic")
"""Collections whose first values are those of the vertices, one for each."""

SAVE = "save it by Mesh::Print as ‘MFEM mesh v1.0’, or as VTK by Mesh::PrintVTK"


def read(file: File) -> Mesh:
    """Read the bytes of an MFEM mesh; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """One pass over the sections."""

    def __init__(self, file: File) -> None:
        self.out = Assembly(file, "mfem", first_number=0)
        self.text = Text(file, comment=b"#", note=self.out.note)
        self.sets: dict[bytes, list[tuple[bytes, bytes]]] = {}

    def read(self) -> Mesh:
        """Read section after section.

        Raises
        ------
        MeshReadError
            It is another kind of MFEM mesh, has another dimension, is cut short, or its vertices have no place.
        """
        text = self.text
        header = HEADER.match(text.data, text.word_offset())
        if not header or not header[1]:
            kind = quoted(header[2]) if header else "a header that is not known"
            raise text.error(f"this MFEM mesh is {kind}; only ‘MFEM mesh v1.0’ to v1.3 can be read: {SAVE}")
        text.position = header.end()
        while word := text.word():
            self.section(word)
        self.groups()
        return self.out.mesh()

    def section(self, word: bytes) -> None:
        """Read or skip what follows a section's name."""
        text = self.text
        if word == b"dimension":
            start = text.word_offset()
            dimension = text.integer("the dimension")
            if dimension != 3:
                raise text.error(f"the dimension is {dimension}, expected 3: a volumetric mesh", start)
        elif word == b"elements":
            self.elements()
        elif word == b"vertices":
            self.vertices()
        elif is_number(word, np.float64):
            raise text.error(
                f"{quoted(word)} stands where a section was expected: the section before has more numbers than "
                "it announces",
                text.position - len(word),
            )
        elif word == b"boundary":
            self.boundary()
        elif word in (b"attribute_sets", b"bdr_attribute_sets"):
            start = text.position
            self.skip()
            self.sets[word] = SET.findall(text.data, start, text.position)
        else:
            self.skip()

    def skip(self) -> None:
        """Go to the next section."""
        section = re.compile(rb"^[ \t]*(?:elements|boundary|vertices|bdr_attribute_sets|mfem_\w+)\s*$", re.M)
        match = section.search(self.text.data, self.text.position)
        self.text.position = match.start() if match else len(self.text.data)

    def rows(self, what: str) -> TypedRows:
        """Rows of elements, whose number stands before them."""
        text = self.text
        count = text.count(what, 3)
        begin = text.position
        end = re.compile(rb"(?<!\S)[A-Za-z]").search(text.data, begin)
        values = text.between(begin, end.start() if end else len(text.data), np.intp, what)
        starts = row_starts(
            values,
            count,
            ELEMENT,
            lambda message, index: text.error(message, text.number_offset(begin, index)),
            what,
        )
        self.begin = begin
        return TypedRows(values, starts, 1, SHAPES)

    def elements(self) -> None:
        """Read the elements; those that are no cells are counted."""
        rows = self.rows("elements")
        kept, cells = rows.cells(self.out)
        begin = self.begin
        for kind, which, corners, places in cells:

            def locate(message: str, cell: int, _corner: int, which: Array = which) -> MeshReadError:
                index = int(rows.starts[which[cell]])
                return self.text.error(message, self.text.number_offset(begin, index))

            self.out.blocks.append(CellBlock(kind, as_int32(corners), locate, cells=places))
        self.out.cell_data["attribute"] = narrowed(rows.column(0)[kept])

    def boundary(self) -> None:
        """Read the elements of the boundary, which are features."""
        rows = self.rows("boundary elements")
        self.out.features += rows.features("attribute", 0, as_int32)

    def groups(self) -> None:
        """Make groups of the sets of attributes, those of the boundary's of features."""
        attributes = self.out.cell_data.get("attribute", np.zeros(0, dtype=np.int32))
        for name, numbers in self.sets.get(b"attribute_sets", ()):
            self.out.groups.append(Group(called(name), SETS, members(attributes, numbers)))
        for name, numbers in self.sets.get(b"bdr_attribute_sets", ()):
            for block in self.out.features:
                block.groups.append(Group(called(name), SETS, members(block.data["attribute"], numbers)))

    def vertices(self) -> None:
        """Read the vertices: a dimension and coordinates, or the section nodes that has them."""
        text = self.text
        count = text.count("vertices", 0)
        if text.peek() == b"nodes":
            text.word()
            coordinates = self.nodes(count)
        else:
            start = text.word_offset()
            dimension = text.integer("the dimension of the vertices")
            if dimension != 3:
                raise text.error(f"the vertices have {dimension} coordinates, expected 3", start)
            coordinates = text.numbers(3 * count, np.float64, "vertices").reshape(count, 3).T
        check_finite(coordinates, lambda message, _: text.error(f"in vertices, {message}"))
        self.out.coordinates = np.ascontiguousarray(coordinates)

    def nodes(self, count: int) -> Floats:
        """(3, count) places of the vertices out of the grid function of a curved mesh.

        Raises
        ------
        MeshReadError
            The function isn't continuous, so that a vertex has no place of its own, or its layout isn't known.
        """
        text = self.text
        start = text.position
        head = re.compile(
            rb"\s*FiniteElementSpace\s+FiniteElementCollection:\s*(\S+)\s+VDim:\s*(\d+)\s+Ordering:\s*([01])\s"
        ).match(text.data, start)
        if not head:
            raise text.error("the section nodes does not begin with its FiniteElementSpace")
        collection = head[1]
        if not CONTINUOUS.fullmatch(collection):
            raise text.error(
                f"the nodes are of {quoted(collection)}, which gives vertices no place of their own, expected a "
                f"continuous collection such as H1_3D_P1: {SAVE}",
                head.start(1),
            )
        if head[2] != b"3":
            raise text.error(f"the nodes have {head[2].decode()} coordinates, expected 3", head.start(2))
        word = re.compile(rb"(?<!\S)(?!nan|inf)[A-Za-z]", re.I).search(text.data, head.end())
        values = text.between(head.end(), word.start() if word else len(text.data), np.float64, "nodes")
        size = len(values) // 3
        if len(values) % 3 or size < count:
            raise text.error(
                f"the section nodes has {len(values)} numbers, expected three for each of {count} vertices or more",
                start,
            )
        if size > count:
            self.out.note(f"Curved cells ({collection.decode()}) are shown by their corners.")
        table = values.reshape(3, size) if head[3] == b"0" else values.reshape(size, 3).T
        return table[:, :count]


def called(name: bytes) -> str:
    """The name of a set."""
    return name.decode("utf-8", "replace")


def members(attributes: Array, numbers: bytes) -> Array:
    """Rows of the elements that have one of the attributes."""
    return np.flatnonzero(np.isin(attributes, [int(number) for number in numbers.split()]))
