"""Writes Medit `.mesh`, ASCII."""

from __future__ import annotations

import numpy as np

from ..arrays import CHUNK, Array
from ..cells import CORNERS_OF_KIND
from ..mesh import Mesh
from .medit import REFERENCE
from .medit_keywords import ORDERS

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
        own = np.array(CORNERS_OF_KIND[kind])[list(ORDERS.get(kind, range(len(CORNERS_OF_KIND[kind]))))]
        parts.append(f"{keyword}\n{len(which)}\n".encode())
        rows = [mesh.corners[place][which].astype(np.int64) + 1 for place in own]
        parts += formatted("%d " * len(rows) + "%d\n", [*rows, references[which]])
    return b"".join([*parts, b"End\n"])


def whole_numbers(values: Array | None, count: int) -> Array:
    """The references, zeros where there are none that the format can hold."""
    if values is None or values.ndim != 1 or values.dtype.kind not in "iu":
        return np.zeros(count, dtype=np.int32)
    return values


def formatted(row: str, columns: list[Array]) -> list[bytes]:
    """The columns as text, chunk by chunk, each row formatted alike."""
    out = []
    for start in range(0, len(columns[0]), CHUNK):
        lists = [column[start : start + CHUNK].tolist() for column in columns]
        numbers = [number for entry in zip(*lists, strict=True) for number in entry]
        out.append((row * len(lists[0]) % tuple(numbers)).encode())
    return out
