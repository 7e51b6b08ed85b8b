"""An Abaqus deck whose numbers have gaps, and what stands in it."""

from __future__ import annotations

import numpy as np

from hexalab.cells import COLLAPSE, HEXAHEDRON, TETRAHEDRON
from hexalab.mesh import Mesh
from tests.core.conftest import grid_points

ELEMENTS = (1043, 7, 900, 22)
"""Numbers of the elements, in the order of their rows."""

SETS = {"STEEL": (1043, 22), "ALU": (7, 900)}

BAD = 22
"""The element whose corner is pushed through the cell."""


def node(row: int) -> int:
    """The number of a node."""
    return 10 * row + 5


UNUSED = node(18)


def deck(*, bad: bool = True, sets: dict[str, tuple[int, ...]] = SETS) -> bytes:
    """Four unit cubes in a plane, the last of them invalid at a corner; one node belongs to no element."""
    points, cells = grid_points((2, 2, 1))
    points = np.concatenate([points, [[9.0, 9, 9]]])
    if bad:
        points[17] = [1.2, 1.2, 0.2]
    lines = ["*NODE", *(f"{node(row)}, {x}, {y}, {z}" for row, (x, y, z) in enumerate(points.tolist()))]
    lines.append("*ELEMENT, TYPE=C3D8")
    for number, corners in zip(ELEMENTS, cells.tolist(), strict=True):
        lines.append(", ".join(map(str, [number, *map(node, corners)])))
    for name, members in sets.items():
        lines += [f"*ELSET, ELSET={name}", ", ".join(map(str, members))]
    return "\n".join([*lines, ""]).encode()


def two_kinds() -> Mesh:
    """Two cubes side by side, and a tetrahedron on top of one."""
    points, cells = grid_points((2, 1, 1))
    points = np.concatenate([points, [[0.5, 0.5, 2]]])
    tetrahedron = np.array([6, 7, 9, 12])[list(COLLAPSE[TETRAHEDRON])]
    corners = np.concatenate([cells, [tetrahedron]]).T
    return Mesh(points.T, corners, np.array([HEXAHEDRON, HEXAHEDRON, TETRAHEDRON], np.uint8))


EMPTY = Mesh(np.zeros((3, 0)), np.zeros((8, 0), np.int32), np.zeros(0, np.uint8))
"""A mesh of nothing."""
