"""Elements in text, a row each, whose type says how many nodes follow it: AVS UCD and MFEM.

>>> shapes = {2: Shape("lines", 2), 4: Shape("tetrahedra", 4, TETRAHEDRON, (0, 1, 2, 3))}
>>> values = np.array([7, 2, 10, 11, 7, 4, 10, 11, 12, 13])         # what stands before the type, type, nodes
>>> rows = TypedRows(values, np.array([0, 4]), 1, shapes)
>>> rows.corners(4, np.array([1])).ravel().tolist()
[10, 11, 12, 13]
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..arrays import Array
from ..cells import TETRAHEDRON as TETRAHEDRON  # of the example above
from .assembly import Assembly
from .feature_blocks import FeatureBlock
from .row_chain import RowForm

LOWER = {"points": 0, "lines": 1, "triangles": 2, "quadrilaterals": 2}
"""Dimension of the elements that are kept as features."""


@dataclass(frozen=True)
class Shape:
    """One type of element.

    Parameters
    ----------
    name : str
        Plural, for what is told of those that are left out.
    size : int
        Number of nodes.
    kind : int, optional
        Index into KINDS; None for elements that are no cells.
    order : tuple of int
        Which of the nodes are the corners of such a cell, in VTK's order.
    """

    name: str
    size: int
    kind: int | None = None
    order: tuple[int, ...] = ()


class Cells(NamedTuple):
    """Cells of one kind: their rows, what stands for their corners, (k, n), and their places among all cells."""

    kind: int
    rows: Array
    corners: Array
    places: Array


def row_form(shapes: Mapping[int, Shape], place: int) -> RowForm:
    """The form of rows with the type's number at that place, and nothing after it but the nodes."""
    sizes = np.zeros(max(shapes) + 1, dtype=np.int64)
    for number, shape in shapes.items():
        sizes[number] = place + 1 + shape.size

    def length(types: Array) -> Array:
        known = (types >= 0) & (types < len(sizes))
        return np.where(known, sizes[np.where(known, types, 0)], 0)

    return RowForm((place,), length)


@dataclass(frozen=True)
class TypedRows:
    """All rows of a section.

    Parameters
    ----------
    values : (n,) integers
        The section's numbers.
    starts : (m,) integers
        Where each row begins.
    place : int
        Where in a row the type stands; nodes come after it.
    shapes : mapping
        What the types are.
    """

    values: Array
    starts: Array
    place: int
    shapes: Mapping[int, Shape]

    def column(self, place: int) -> Array:
        """(m,) the value at that place of each row."""
        found: Array = self.values[self.starts + place]
        return found

    def by_type(self) -> Iterator[tuple[Shape, int, Array]]:
        """Each type that occurs, its number and the rows that have it."""
        types = self.column(self.place)
        for number in np.unique(types).tolist():
            yield self.shapes[number], number, np.flatnonzero(types == number)

    def cells(self, out: Assembly) -> tuple[Array, list[Cells]]:
        """(m,) which rows are cells, and the cells of each kind; what is no feature either is counted in `out`."""
        kept = np.zeros(len(self.starts), dtype=bool)
        found = []
        for shape, number, which in self.by_type():
            if shape.kind is None:
                if shape.name not in LOWER:
                    out.leave_out(shape.name, len(which))
                continue
            kept[which] = True
            found.append((shape.kind, which, self.corners(number, which)))
        place = np.cumsum(kept) - 1
        return kept, [Cells(kind, which, corners, place[which]) for kind, which, corners in found]

    def features(self, name: str, place: int, vertices: Callable[[Array], Array]) -> list[FeatureBlock]:
        """The elements of lower dimension.

        Parameters
        ----------
        name : str
            What the number at `place` of a row says of it.
        place : int
        vertices : callable
            Gives the rows of vertices for what stands for them, -1 where one is not there.
        """
        blocks = []
        for shape, _, which in self.by_type():
            if shape.kind is None and shape.name in LOWER:
                first = self.starts[which] + self.place + 1
                nodes = np.stack([self.values[first + node] for node in range(shape.size)])
                said = {name: self.column(place)[which]}
                blocks.append(FeatureBlock(LOWER[shape.name], vertices(nodes), said))
        return blocks

    def corners(self, number: int, which: Array) -> Array:
        """(k, n) what stands for the corners, in VTK's order, of those rows, all of which have that type."""
        first = self.starts[which] + self.place + 1
        return np.stack([self.values[first + node] for node in self.shapes[number].order])
