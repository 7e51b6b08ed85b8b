"""What all versions of `.msh` are read into."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, Floats
from ..cells import KINDS, WEDGE
from .assembly import WEDGE_OF_OTHERS, Assembly
from .gmsh_types import ELEMENTS, LOWER


@dataclass
class Nodes:
    """The nodes: their numbers in the file, (V,), and coordinates, (3, V)."""

    tags: Array
    coordinates: Floats


@dataclass
class Elements:
    """Elements of one type.

    Parameters
    ----------
    dimension, kind : int
        Of volumetric elements 3 and the index into KINDS; of others theirs, and -1.
    corners : (k, n) integers
        Node numbers of the file, in VTK's order.
    tags : (n,) integers
        The elements' numbers.
    entities, physicals, partitions : (n,) integers
        The entity, physical group and partition they belong to (0 for none).
    ordinals : (n,) integers
        Places among all elements of the file.
    begin : int
        Byte offset of their section, for errors.
    also : tuple of int
        Further physical groups that all of them belong to.
    """

    dimension: int
    kind: int
    corners: Array
    tags: Array
    entities: Array
    physicals: Array
    partitions: Array
    ordinals: Array
    begin: int
    also: tuple[int, ...] = ()


@dataclass
class Rows:
    """All elements of a section whose rows tell everything themselves (versions 1 to 3).

    Parameters
    ----------
    values : (n,) integers
        The section's numbers.
    nodes : (m,) int
        Where each element's nodes begin in `values`.
    types, tags, entities, physicals, partitions : (m,) integers
        Of each element: gmsh's type, its number, what it belongs to (0 for none).
    begin : int
        Byte at which the section begins, for errors.
    """

    values: Array
    nodes: Array
    types: Array
    tags: Array
    entities: Array
    physicals: Array
    partitions: Array
    begin: int

    def by_type(self, out: Assembly) -> list[Elements]:
        """The elements of each type; `out` gets notes."""
        parts = []
        for number in np.unique(self.types).tolist():
            which = np.flatnonzero(self.types == number)
            dimension, kind, order = own_corners(out, number, len(which))
            corners = np.stack([self.values[self.nodes[which] + corner] for corner in order])
            entities, physicals, partitions = (
                self.entities[which],
                self.physicals[which],
                self.partitions[which],
            )
            tags = self.tags[which]
            parts.append(
                Elements(dimension, kind, corners, tags, entities, physicals, partitions, which, self.begin)
            )
        return parts


def own_corners(out: Assembly, element_type: int, count: int) -> tuple[int, int, list[int]]:
    """Dimension, kind (-1 of lower dimensions) and which of its nodes are the corners, of elements of a type."""
    kind, size = ELEMENTS[element_type]
    if isinstance(kind, str):
        dimension, corners = LOWER[kind]
        if size > corners and count:
            out.note(f"Elements of higher order ({kind} of {size} nodes) are kept by their corners.")
        return dimension, -1, list(range(corners))
    corners = (8, 6, 5, 4)[kind]
    if size > corners and count:
        out.note(f"Cells of higher order ({KINDS[kind]} of {size} nodes) are shown by their corners.")
    return 3, kind, list(WEDGE_OF_OTHERS if kind == WEDGE else range(corners))


def node_counts() -> Array:
    """Number of nodes by element type; 0 for an unknown type."""
    sizes = np.zeros(max(ELEMENTS) + 1, dtype=np.int64)
    for number, (_, size) in ELEMENTS.items():
        sizes[number] = size
    return sizes


NODES_OF_TYPE = node_counts()
"""(types,) number of nodes; 0 where there is no such type."""


def nodes_of(types: Array) -> Array:
    """Number of nodes of each element, 0 for an unknown type."""
    known = (types >= 0) & (types < len(NODES_OF_TYPE))
    return np.where(known, NODES_OF_TYPE[np.where(known, types, 0)], 0)


def sound(length: Array, *counts: Array) -> Array:
    """The lengths of rows, 0 where one of the counts they are made of makes no sense."""
    good = np.ones(len(length), dtype=bool)
    for count in counts:
        good &= (count >= 0) & (count <= 2**31)
    return np.where(good, length, 0)
