"""Writes Medit `.mesh`, ASCII."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..mesh import Mesh
from .medit import REFERENCE
from .writing import formatted, own_corners

SECTIONS = ("Hexahedra", "Prisms", "Pyramids", "Tetrahedra")
"""For each kind, the keyword of its section."""


def write(mesh: Mesh) -> bytes:
    """The bytes of a `.mesh` file.

    Coordinates are written with as many digits as bring back the same float64. Cells are grouped by kind,
    in file order within each. Of the attributes, an integer "reference" is kept; the format has no place
    for others.
    """
    parts = [b"MeshVersionFormatted 2\nDimension 3\n", f"Vertices\n{mesh.vertex_count}\n".encode()]
    references = whole_numbers(mesh.point_data.get(REFERENCE), mesh.vertex_count)
    parts += formatted("%r %r %r %d\n", [*mesh.coordinates, references])
    references = whole_numbers(mesh.cell_data.get(REFERENCE), mesh.cell_count)
    for kind, keyword in enumerate(SECTIONS):
        which = np.flatnonzero(mesh.kinds == kind)
        if not len(which):
            continue
        parts.append(f"{keyword}\n{len(which)}\n".encode())
        rows = [corner + 1 for corner in own_corners(mesh, kind, which)]
        parts += formatted("%d " * len(rows) + "%d\n", [*rows, references[which]])
    return b"".join([*parts, b"End\n"])


def whole_numbers(values: Array | None, count: int) -> Array:
    """The references, zeros where there are none that the format can hold."""
    if values is None or values.ndim != 1 or values.dtype.kind not in "iu":
        return np.zeros(count, dtype=np.int32)
    return values
