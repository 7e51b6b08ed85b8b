"""Writes VTK XML `.vtu`: base64 arrays in zlib blocks with 64-bit headers."""

from __future__ import annotations

import binascii
import zlib

import numpy as np

from ..arrays import Array
from ..mesh import Mesh
from .vtk_grid import ELEMENT_IDS, NODE_IDS, grid_of
from .vtu_arrays import TYPES
from .write_vtk import storable

BLOCK = 1 << 20
NAMES = {code: name for name, code in TYPES.items()}


def write(mesh: Mesh) -> bytes:
    """The bytes of a `.vtu` file with all attributes; cells stay in their order."""
    grid = grid_of(mesh)
    parts = [
        b'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
        b'header_type="UInt64" compressor="vtkZLibDataCompressor">\n<UnstructuredGrid>\n',
        f'<Piece NumberOfPoints="{mesh.vertex_count}" NumberOfCells="{len(grid.types)}">\n'.encode(),
    ]
    for section, data, numbers, name_of_numbers in (
        ("PointData", grid.point_data, grid.point_ids, NODE_IDS),
        ("CellData", grid.cell_data, grid.cell_ids, ELEMENT_IDS),
    ):
        declared = f' GlobalIds="{name_of_numbers}"' if numbers is not None else ""
        parts.append(f"<{section}{declared}>\n".encode())
        if numbers is not None:
            parts += array(name_of_numbers, numbers, 1)
        for name, values in data.items():
            if not values.size:
                continue
            parts += array(name, values, values.shape[1] if values.ndim == 2 else 1)
        parts.append(f"</{section}>\n".encode())
    parts += [b"<Points>\n", *array("Points", mesh.coordinates.T, 3), b"</Points>\n<Cells>\n"]
    for name, values in (("connectivity", grid.ids), ("offsets", grid.offsets[1:]), ("types", grid.types)):
        parts += array(name, values, 1)
    parts.append(b"</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")
    return b"".join(parts)


def array(name: str, values: Array, width: int) -> list[bytes]:
    """A DataArray element."""
    values = storable(values)
    little = np.ascontiguousarray(values, dtype=values.dtype.newbyteorder("<"))
    data = memoryview(little.reshape(-1).view(np.uint8).data)
    blocks = [zlib.compress(data[start : start + BLOCK], 6) for start in range(0, len(data), BLOCK)]
    header = [len(blocks), BLOCK, len(data) % BLOCK, *map(len, blocks)] if blocks else [0]
    kind = NAMES[values.dtype.str[1:]]
    return [
        f'<DataArray type="{kind}" Name="{escaped(name)}" NumberOfComponents="{width}" '.encode(),
        b'format="binary">\n',
        base64(np.array(header, dtype="<u8").tobytes()),
        base64(b"".join(blocks)),
        b"\n</DataArray>\n",
    ]


def base64(data: bytes) -> bytes:
    """Base64 without line breaks, as VTK reads it."""
    return binascii.b2a_base64(data, newline=False)


def escaped(text: str) -> str:
    """A name as the value of an XML attribute, which is not empty and has no control characters."""
    text = "".join(" " if c < " " and c != "\n" else c for c in text) or "unnamed"
    for character, entity in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;"), ("\n", "&#10;")):
        text = text.replace(character, entity)
    return text
