"""Writes VTK legacy 5.1, binary, and what `.vtk` and `.vtu` files share."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array
from ..cells import CORNERS_OF_KIND, HEXAHEDRON
from ..mesh import Mesh

TYPES_OF_KINDS = (12, 13, 14, 10)
"""VTK's cell type for each kind."""

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
    offsets, ids = connectivity(mesh)
    parts: list[bytes] = [
        b"# vtk DataFile Version 5.1\n",
        title(mesh.name) + b"\nBINARY\nDATASET UNSTRUCTURED_GRID\n",
        f"POINTS {mesh.vertex_count} double\n".encode(),
        interleaved(mesh.coordinates, ">f8"),
        f"\nCELLS {len(offsets)} {len(ids)}\nOFFSETS vtktypeint64\n".encode(),
        offsets.astype(">i8").tobytes(),
        b"\nCONNECTIVITY vtktypeint64\n",
        *(ids[start : start + CHUNK].astype(">i8").tobytes() for start in range(0, len(ids), CHUNK)),
        f"\nCELL_TYPES {mesh.cell_count}\n".encode(),
        cell_types(mesh).astype(">i4").tobytes(),
        b"\n",
    ]
    for section, data, count in (
        ("POINT_DATA", mesh.point_data, mesh.vertex_count),
        ("CELL_DATA", mesh.cell_data, mesh.cell_count),
    ):
        data = {name: values for name, values in data.items() if values.size}
        if data:
            parts.append(f"{section} {count}\nFIELD FieldData {len(data)}\n".encode())
        for name, values in data.items():
            values = storable(values)
            width = values.size // count if count else 1
            number_type = NAMES[values.dtype.str[1:]]
            parts.append(f"{encoded(name)} {width} {count} {number_type}\n".encode())
            parts += [values.astype(values.dtype.newbyteorder(">")).tobytes(), b"\n"]
    return b"".join(parts)


def connectivity(mesh: Mesh) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    """Offsets (C + 1) and vertex ids of the cells' own corners, in VTK's order, cell after cell."""
    sizes = np.array([len(own) for own in CORNERS_OF_KIND])[mesh.kinds]
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    ids = np.empty(int(offsets[-1]), dtype=np.int32)
    if (mesh.kinds == HEXAHEDRON).all():
        ids.reshape(-1, 8)[:] = mesh.corners.T
        return offsets, ids
    for kind, own in enumerate(CORNERS_OF_KIND):
        which = np.flatnonzero(mesh.kinds == kind)
        for number, place in enumerate(own):
            ids[offsets[which] + number] = mesh.corners[place][which]
    return offsets, ids


def cell_types(mesh: Mesh) -> NDArray[np.uint8]:
    """(C,) VTK's cell types."""
    return np.array(TYPES_OF_KINDS, dtype=np.uint8)[mesh.kinds]


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
