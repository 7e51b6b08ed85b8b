"""VTK's cell types and number types, as rows of data (vtkCellType.h, vtkType.h)."""

from __future__ import annotations

from dataclasses import dataclass

from ..cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from .assembly import WEDGE_OF_OTHERS


@dataclass(frozen=True)
class CellType:
    """One of VTK's cell types.

    Parameters
    ----------
    name : str
        Plural, for messages.
    size : int
        Corners of a cell; 0 if they differ from cell to cell.
    kind : int or None
        Index into KINDS if the cell is kept; its own corners then stand first.
    order : tuple of int
        Which of the row's corners are the kind's own, in its order.
    dimension : int
        3 of cells; of points, edges and faces that are kept as features, theirs.
    """

    name: str
    size: int
    kind: int | None = None
    order: tuple[int, ...] = ()
    dimension: int = 3


def _kept(name: str, size: int, kind: int) -> CellType:
    return CellType(name, size, kind, tuple(range((8, 6, 5, 4)[kind])))


def _turned_wedge(name: str, size: int) -> CellType:
    return CellType(name, size, WEDGE, WEDGE_OF_OTHERS)


def _point(name: str, size: int) -> CellType:
    return CellType(name, size, None, (0,), 0)


def _edge(name: str, size: int) -> CellType:
    return CellType(name, size, None, (0, 1), 1)


def _triangle(name: str, size: int) -> CellType:
    return CellType(name, size, None, (0, 1, 2), 2)


def _quadrilateral(name: str, size: int) -> CellType:
    return CellType(name, size, None, (0, 1, 2, 3), 2)


VOXEL = 11
HEXAHEDRON_TYPE = 12
POLYLINE = 4
POLYGON = 7
POLYHEDRON = 42

CELL_TYPES = {
    0: CellType("empty cells", 0),
    1: _point("points", 1),
    2: CellType("poly-vertices", 0),
    3: _edge("lines", 2),
    4: CellType("polylines", 0),
    5: _triangle("triangles", 3),
    6: CellType("triangle strips", 0),
    7: CellType("polygons", 0),
    8: CellType("pixels", 4, None, (0, 1, 3, 2), 2),
    9: _quadrilateral("quadrilaterals", 4),
    10: _kept("tetrahedra", 4, TETRAHEDRON),
    VOXEL: CellType("voxels", 8, HEXAHEDRON, (0, 1, 3, 2, 4, 5, 7, 6)),
    HEXAHEDRON_TYPE: _kept("hexahedra", 8, HEXAHEDRON),
    13: _kept("wedges", 6, WEDGE),
    14: _kept("pyramids", 5, PYRAMID),
    15: CellType("pentagonal prisms", 10),
    16: CellType("hexagonal prisms", 12),
    21: _edge("quadratic edges", 3),
    22: _triangle("quadratic triangles", 6),
    23: _quadrilateral("quadratic quadrilaterals", 8),
    24: _kept("quadratic tetrahedra", 10, TETRAHEDRON),
    25: _kept("quadratic hexahedra", 20, HEXAHEDRON),
    26: _kept("quadratic wedges", 15, WEDGE),
    27: _kept("quadratic pyramids", 13, PYRAMID),
    28: _quadrilateral("biquadratic quadrilaterals", 9),
    29: _kept("triquadratic hexahedra", 27, HEXAHEDRON),
    30: _quadrilateral("quadratic-linear quadrilaterals", 6),
    31: _turned_wedge("quadratic-linear wedges", 12),
    32: _turned_wedge("biquadratic wedges", 18),
    33: _kept("biquadratic hexahedra", 24, HEXAHEDRON),
    34: _triangle("biquadratic triangles", 7),
    35: _edge("cubic lines", 4),
    36: CellType("quadratic polygons", 0),
    37: _kept("triquadratic pyramids", 19, PYRAMID),
    41: CellType("convex point sets", 0),
    POLYHEDRON: CellType("polyhedra", 0),
    68: _edge("Lagrange curves", 0),
    69: _triangle("Lagrange triangles", 0),
    70: _quadrilateral("Lagrange quadrilaterals", 0),
    71: _kept("Lagrange tetrahedra", 0, TETRAHEDRON),
    72: _kept("Lagrange hexahedra", 0, HEXAHEDRON),
    73: _turned_wedge("Lagrange wedges", 0),
    74: _kept("Lagrange pyramids", 0, PYRAMID),
    75: _edge("Bezier curves", 0),
    76: _triangle("Bezier triangles", 0),
    77: _quadrilateral("Bezier quadrilaterals", 0),
    78: _kept("Bezier tetrahedra", 0, TETRAHEDRON),
    79: _kept("Bezier hexahedra", 0, HEXAHEDRON),
    80: _turned_wedge("Bezier wedges", 0),
    81: _kept("Bezier pyramids", 0, PYRAMID),
}

"""VTK's cell types.

Up to VTK 9.6 the normal of 0 1 2 points away from 3 4 5 in wedges of types 13 and 26, and towards it in types 31, 32,
73 and 80: so say vtkCellSizeFilter, vtkCellTypeSource, the face lists of the last four and the classes' documentation.
VTK 9.7 lets it point towards 3 4 5 in all of them; files do not tell which release they were written for.
"""

MAY_HAVE_EIGHT = frozenset(
    {2, 4, 6, 7, VOXEL, HEXAHEDRON_TYPE, 23, 36, 41, POLYHEDRON, 68, 70, 72, 75, 77, 79}
)
"""Types whose cells may have eight nodes; a row of eight that is declared as another one is mislabelled."""

NUMBER_TYPES = {
    "char": "i1",
    "signed_char": "i1",
    "unsigned_char": "u1",
    "short": "i2",
    "unsigned_short": "u2",
    "int": "i4",
    "unsigned_int": "u4",
    "long": "i8",
    "unsigned_long": "u8",
    "long_long": "i8",
    "unsigned_long_long": "u8",
    "float": "f4",
    "double": "f8",
    "vtkidtype": "i4",
    "vtktypeint8": "i1",
    "vtktypeuint8": "u1",
    "vtktypeint16": "i2",
    "vtktypeuint16": "u2",
    "vtktypeint32": "i4",
    "vtktypeuint32": "u4",
    "vtktypeint64": "i8",
    "vtktypeuint64": "u8",
    "vtktypefloat32": "f4",
    "vtktypefloat64": "f8",
}
"""Number types of the legacy format, in lower case. VTK (vtkDataWriter) writes `vtkIdType` as 32 bits."""
