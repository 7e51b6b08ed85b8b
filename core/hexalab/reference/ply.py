"""PLY, in text and in both binary forms.

Elements may stand in any order and have any properties: x y z of `vertex` and the list `vertex_indices` of `face` are
taken, by their names, and all others passed over by their types.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Floats
from ..errors import MeshReadError
from ..formats.assembly import check_finite
from ..formats.byte_order import native
from ..formats.file import File
from ..formats.ids import within_int32
from ..formats.row_chain import ErrorAt
from ..formats.text import Text
from ..formats.tokens import quoted
from .lines import Rows
from .ply_header import Element, Header, Property, header_of
from .ply_rows import table_of
from .polygons import Polygons, surface_of
from .surface import TriangleSurface

AXES = ("x", "y", "z")

LISTS = ("vertex_indices", "vertex_index")
"""Names of the list of a face's corners."""


def read(file: File) -> TriangleSurface:
    """Read the bytes of a PLY file; raises MeshReadError."""
    header = header_of(file)
    vertices, faces = (element_of(file, header, name) for name in ("vertex", "face"))
    axes, corners = axes_of(file, vertices), corners_of(file, faces)
    reader = (Binary if header.order else InText)(file, header)
    for element in header.elements:
        if element is vertices:
            reader.vertices(element, axes)
        elif element is faces:
            reader.faces(element, corners)
        elif element.properties:
            reader.skip(element)
        if reader.points is not None and reader.polygons is not None:
            break
    assert reader.points is not None and reader.polygons is not None
    return surface_of(file, "ply", reader.points, [reader.polygons], [])


def element_of(file: File, header: Header, name: str) -> Element:
    """The element of that name."""
    for element in header.elements:
        if element.name == name:
            return element
    others = ", ".join(f"{element.name} ({element.count})" for element in header.elements)[:200] or "none"
    hint = "; triangle strips are not read" if any("strip" in one.name for one in header.elements) else ""
    raise file.error(
        f"the file has no element {quoted(name)}, only {others}: expected a surface{hint}", line_at=0
    )


def axes_of(file: File, vertices: Element) -> list[Property]:
    """The properties x, y and z."""
    plain = {}
    for one in vertices.properties:
        if one.counted_by is not None:
            break
        plain[one.name] = one
    for name in AXES:
        if name not in plain:
            raise file.error(
                f"the element vertex has no number {name} in front of its lists, only {vertices.named}",
                line_at=0,
            )
    return [plain[name] for name in AXES]


def corners_of(file: File, faces: Element) -> Property:
    """The list of a face's corners."""
    for one in faces.properties:
        if one.name in LISTS and one.counted_by is not None:
            if one.dtype.kind == "f":
                raise file.error(f"the list {one.name} is of type {one.dtype}, expected integers", line_at=0)
            return one
    raise file.error(f"the element face has no list {' or '.join(LISTS)}, only {faces.named}", line_at=0)


class Reader:
    """What both readers come to."""

    points: Floats | None = None
    polygons: Polygons | None = None

    def keep(self, points: Floats, locate: ErrorAt) -> None:
        """Keep (3, V) points; raises MeshReadError if one is not finite."""
        check_finite(points, lambda message, vertex: locate(f"in the vertices, {message}", vertex))
        self.points = points


class Binary(Reader):
    """Takes elements from the bytes, one after the other."""

    def __init__(self, file: File, header: Header) -> None:
        self.file = file
        self.position = header.end

    def skip(self, element: Element) -> None:
        """Go behind an element."""
        self.position = table_of(self.file, element, self.position).end

    def vertices(self, element: Element, axes: list[Property]) -> None:
        """Read the coordinates."""
        table = table_of(self.file, element, self.position)
        self.position = table.end
        points = np.empty((3, element.count))
        with np.errstate(invalid="ignore"):
            for axis, own in zip(points, axes, strict=True):
                axis[:] = native(table.numbers(own))
        self.keep(points, lambda message, vertex: self.file.error(message, offset=table.starts[vertex]))

    def faces(self, element: Element, corners: Property) -> None:
        """Read the lists of corners."""
        table = table_of(self.file, element, self.position)
        self.position = table.end
        ids, starts, sizes, places = table.lists(corners)

        def error_at(message: str, index: int) -> MeshReadError:
            face = int(np.searchsorted(np.asarray(starts), index, "right")) - 1
            place = int(places[face]) + (index - int(starts[face])) * corners.dtype.itemsize
            return self.file.error(message, offset=place)

        self.polygons = Polygons(ids, starts, sizes, error_at)


class InText(Reader):
    """Takes elements from the lines: one for each row."""

    def __init__(self, file: File, header: Header) -> None:
        self.text = Text(file)
        self.text.position = header.end
        self.rows = Rows(self.text)
        self.begin = header.end
        self.taken = 0

    def skip(self, element: Element) -> None:
        """Go behind an element."""
        for _ in self.rows.take(element.count, f"the element {element.name}"):
            pass
        self.taken += element.count

    def line_error(self, message: str, number: int) -> MeshReadError:
        """The error for the line with that number behind the header, from 0 on."""
        return Rows(self.text, self.begin).error(message, number)

    def vertices(self, element: Element, axes: list[Property]) -> None:
        """Read the coordinates."""
        places = [element.properties.index(axis) for axis in axes]
        parts: list[Floats] = [np.empty((3, 0))]
        first = self.taken
        for block, lines in self.rows.take(element.count, "the vertices"):
            values, counts = block.numbers(lines, np.float64, "the vertices")
            block.check(lines, counts > max(places), "a vertex has {} numbers, expected x, y and z", counts)
            begins = np.cumsum(counts) - counts
            parts.append(np.stack([values[begins + place] for place in places]))
        self.taken += element.count
        self.keep(
            np.concatenate(parts, axis=1), lambda message, vertex: self.line_error(message, first + vertex)
        )

    def faces(self, element: Element, corners: Property) -> None:
        """Read the lists of corners."""
        ids: list[Array] = [np.empty(0, np.int32)]
        starts: list[Array] = [np.empty(0, np.int64)]
        sizes: list[Array] = [np.empty(0, np.int32)]
        first, done = self.taken, 0
        for block, lines in self.rows.take(element.count, "the faces"):
            values, counts = block.whole_numbers(lines, "the faces")
            ends = np.cumsum(counts)
            place = ends - counts
            for one in element.properties:
                if one.counted_by is None:
                    place = place + 1
                    continue
                block.check(lines, place < ends, "a face has {} numbers, and no list of corners", counts)
                size = within_int32(values[place]).astype(np.int64)
                block.check(
                    lines,
                    (size >= 0) & (place + size < ends),
                    "a list of {} numbers is announced, which are not there",
                    size,
                )
                place = place + 1
                if one is corners:
                    break
                place = place + size
            ids.append(within_int32(values).astype(np.int32))
            starts.append(place + done)
            sizes.append(size.astype(np.int32))
            done += len(values)
        self.taken += element.count
        starting = np.concatenate(starts)

        def error_at(message: str, index: int) -> MeshReadError:
            return self.line_error(message, first + int(np.searchsorted(starting, index, "right")) - 1)

        self.polygons = Polygons(np.concatenate(ids), starting, np.concatenate(sizes), error_at)
