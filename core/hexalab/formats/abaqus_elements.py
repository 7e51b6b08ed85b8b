"""The elements of Abaqus and CalculiX by the names of their types: volumetric ones, and edges and faces.

Sources: the element libraries of Abaqus' manual (solid, cohesive, gasket, continuum shell, solid shell, acoustic,
heat transfer, piezoelectric, electromagnetic, fluid) and of CalculiX' (C3D, DC3D and F3D).
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

from ..cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE

KINDS_OF_SIZE = {
    4: TETRAHEDRON,
    5: PYRAMID,
    6: WEDGE,
    8: HEXAHEDRON,
    10: TETRAHEDRON,
    13: PYRAMID,
    15: WEDGE,
    20: HEXAHEDRON,
    27: HEXAHEDRON,
}
"""By the number of nodes in a type's name."""

ALL = tuple(KINDS_OF_SIZE)

FAMILIES = {
    "C3D": ALL, "DC3D": ALL, "DCC3D": ALL, "AC3D": ALL, "EC3D": ALL, "EMC3D": ALL, "Q3D": ALL,
    "F3D": (4, 6, 8), "FC3D": (4, 5, 6, 8),
    "COH3D": (6, 8), "GK3D": (6, 8), "SC": (6, 8), "CSS": (8,),
}  # fmt: skip
"""What a type's name begins with, and the numbers of nodes that volumetric elements of the family have.

Not among them are gasket elements of 12 and 18 nodes, cylindrical (CCL) and infinite ones (CIN3D): elements whose
corners the straight edges of a cell do not stand for.
"""

NAME = re.compile(rf"({'|'.join(FAMILIES)})(\d{{1,2}})([A-Z]*)")
LINE = re.compile(r"GK3D\d+L.*")
"""Gasket elements along a line: plane, though their names look like those of tetrahedra and wedges."""

FACES = {
    HEXAHEDRON: ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)),
    WEDGE: ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)),
    PYRAMID: ((0, 1, 2, 3), (0, 4, 1), (1, 4, 2), (2, 4, 3), (3, 4, 0)),
    TETRAHEDRON: ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)),
}
"""Nodes of the faces S1, S2, ... of each kind (Abaqus Elements Guide, "Three-dimensional solid element library")."""

PLANE = r"(?:S|M3D|R3D|SFM3D|DS|CPS|CPE|CPEG|CAX|DC2D|AC2D)"

LOWER = (
    (1, 2, re.compile(r"(?:T[23]D|RB[23]D|R2D)([23])[A-Z]*"), {"2": 2, "3": 3}),
    (1, 2, re.compile(r"(?:B[23]|PIPE[23])([123])[A-Z]*"), {"1": 2, "2": 3, "3": 2}),
    (2, 3, re.compile(PLANE + r"([36])[A-Z]*"), {"3": 3, "6": 6}),
    (2, 3, re.compile(r"STRI(3|65)"), {"3": 3, "65": 6}),
    (2, 4, re.compile(PLANE + r"([489])(?:R5|[A-Z]*)"), {"4": 4, "8": 8, "9": 9}),
)
"""Elements of lower dimension: dimension, corners, name, and the number of nodes by the name's digits.

They are trusses and rigid beams; beams and pipes; shells, membranes, rigid, surface and plane elements.
"""

VARIABLE = (("C3D27", 21, 27), ("C3D15V", 15, 18))
"""Types whose nodes in the middle of faces may be missing: fewest and most nodes."""


@dataclass(frozen=True)
class ElementType:
    """What the rows of a type hold.

    Parameters
    ----------
    name : str
        As the file has it, in capitals.
    kind : int
        Index into KINDS; -1 of elements of lower dimension.
    least, most : int
        How many nodes a row has; they differ where nodes in the middle of faces may be missing.
    dimension, corners : int
        Of elements of lower dimension theirs.
    """

    name: str
    kind: int
    least: int
    most: int
    dimension: int = 3
    corners: int = 0


@cache
def element_type(name: str) -> ElementType | None:
    """The type of that name, in capitals; None if it is none of elements that can be kept."""
    for dimension, corners, pattern, nodes in LOWER:
        lower = pattern.fullmatch(name)
        if lower:
            size = nodes[lower[1]]
            return ElementType(name, -1, size, size, dimension, corners)
    match = NAME.fullmatch(name)
    if not match or LINE.fullmatch(name):
        return None
    size = int(match[2])
    if size not in FAMILIES[match[1]]:
        return None
    for start, least, most in VARIABLE:
        if name.startswith(start):
            return ElementType(name, KINDS_OF_SIZE[size], least, most)
    return ElementType(name, KINDS_OF_SIZE[size], size, size)
