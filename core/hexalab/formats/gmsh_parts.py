"""What both versions of `.msh` are read into."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, Floats
from ..cells import KINDS, WEDGE
from .assembly import WEDGE_OF_OTHERS, Assembly
from .gmsh_types import ELEMENTS


@dataclass
class Nodes:
    """The nodes: their numbers in the file, (V,), and coordinates, (3, V)."""

    tags: Array
    coordinates: Floats


@dataclass
class Elements:
    """Volumetric elements of one type.

    Parameters
    ----------
    kind : int
        Index into KINDS.
    corners : (k, n) integers
        Node numbers of the file, in VTK's order.
    tags, entities, physicals : (n,) integers
        The elements' numbers, and the entity and physical group they belong to (0 for none).
    ordinals : (n,) integers
        Places among all elements of the file.
    begin : int
        Byte offset of their section, for errors.
    """

    kind: int
    corners: Array
    tags: Array
    entities: Array
    physicals: Array
    ordinals: Array
    begin: int


def own_corners(out: Assembly, element_type: int, count: int) -> tuple[int, list[int]] | None:
    """The kind of cell that a type becomes and which of its nodes are the corners; None if it is left out."""
    kind, size = ELEMENTS[element_type]
    if not isinstance(kind, int):
        out.leave_out(kind, count)
        return None
    corners = (8, 6, 5, 4)[kind]
    if size > corners and count:
        out.note(f"Cells of higher order ({KINDS[kind]} of {size} nodes) are shown by their corners.")
    return kind, list(WEDGE_OF_OTHERS if kind == WEDGE else range(corners))


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
