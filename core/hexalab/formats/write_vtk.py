"""Writes VTK legacy 5.1, binary, and what `.vtk` and `.vtu` files share."""

from __future__ import annotations

import numpy as np

from ..arrays import CHUNK, Array
from ..mesh import Mesh
from .vtk_grid import ELEMENT_IDS, NODE_IDS, grid_of

NAMES = {
    "i1": "signed_char",
    "u1": "unsigned_char",
    "i2": "short",
    "u2": "unsigned_short",
    "i4": "int",
    "u4": "unsigned_int",
    "i8": "vtktypeint64",
    "u8": "vtktypeuint64",
    "f4": "float",
    "f8": "double",
}
"""The legacy format's name for numpy's number types."""


def write(mesh: Mesh) -> bytes:
    """The bytes of a `.vtk` file, version 5.1, binary, with all attributes; cells stay in their order."""
    grid = grid_of(mesh)
    offsets, ids, cell_count = grid.offsets, grid.ids, len(grid.types)
    parts: list[bytes] = [
        b"# vtk DataFile Version 5.1\n",
        title(mesh.name) + b"\nBINARY\nDATASET UNSTRUCTURED_GRID\n",
        f"POINTS {mesh.vertex_count} double\n".encode(),
        interleaved(mesh.coordinates, ">f8"),
        f"\nCELLS {len(offsets)} {len(ids)}\nOFFSETS vtktypeint64\n".encode(),
        offsets.astype(">i8").tobytes(),
        b"\nCONNECTIVITY vtktypeint64\n",
        *(ids[start : start + CHUNK].astype(">i8").tobytes() for start in range(0, len(ids), CHUNK)),
        f"\nCELL_TYPES {cell_count}\n".encode(),
        grid.types.astype(">i4").tobytes(),
        b"\n",
    ]
    for section, data, numbers, name_of_numbers, count in (
        ("POINT_DATA", grid.point_data, grid.point_ids, NODE_IDS, mesh.vertex_count),
        ("CELL_DATA", grid.cell_data, grid.cell_ids, ELEMENT_IDS, cell_count),
    ):
        data = {name: values for name, values in data.items() if values.size}
        if data or numbers is not None:
            parts.append(f"{section} {count}\n".encode())
        if numbers is not None:
            parts += [f"GLOBAL_IDS {name_of_numbers} vtktypeint64\n".encode()]
            parts += [numbers.astype(">i8").tobytes(), b"\n"]
        if data:
            parts.append(f"FIELD FieldData {len(data)}\n".encode())
        for name, values in data.items():
            values = storable(values)
            width = values.size // count if count else 1
            number_type = NAMES[values.dtype.str[1:]]
            parts.append(f"{encoded(name)} {width} {count} {number_type}\n".encode())
            parts += [values.astype(values.dtype.newbyteorder(">")).tobytes(), b"\n"]
    return b"".join(parts)


def interleaved(coordinates: Array, dtype: str) -> bytes:
    """The bytes of x y z, x y z, ..."""
    return np.ascontiguousarray(coordinates.T, dtype=dtype).tobytes()


def storable(values: Array) -> Array:
    """The values in a number type that VTK's formats have."""
    if values.dtype.kind == "b":
        return values.astype(np.uint8)
    if values.dtype.str[1:] not in NAMES:
        return values.astype(np.float64)
    return values


def title(name: str) -> bytes:
    """The file's second line: 255 characters at most, without line ends."""
    return " ".join((name or "mesh").split()).encode("ascii", "replace")[:255]


def encoded(name: str) -> str:
    """An array's name with VTK's percent codes for what would end a word."""
    data = name.encode("utf-8")
    return "".join(chr(c) if 33 <= c < 127 and c not in b'%"' else f"%{c:02X}" for c in data) or "unnamed"
