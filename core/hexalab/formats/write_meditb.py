"""Writes Medit `.meshb`, binary (libMeshb's documentation)."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..mesh import Mesh
from .ids import fits_int32
from .medit import REFERENCE
from .meditb import DIMENSION, END, VERTICES
from .write_medit import whole_numbers
from .writing import own_corners

SECTIONS = (10, 9, 49, 8)
"""For each kind, the number of its section."""


def write(mesh: Mesh) -> bytes:
    """The bytes of a `.meshb` file, little-endian: version 2, 3 from 2 GB on, 4 where a reference needs 64 bits.

    Cells are grouped by kind, in file order within each. Of the attributes, an integer "reference" is kept.
    """
    points = whole_numbers(mesh.point_data.get(REFERENCE), mesh.vertex_count)
    cells = whole_numbers(mesh.cell_data.get(REFERENCE), mesh.cell_count)
    size = 100 + 28 * mesh.vertex_count + 36 * mesh.cell_count
    version = 4 if not (fits_int32(points) and fits_int32(cells)) else 3 if size >= 2**31 else 2
    whole, place = np.dtype("<i8" if version == 4 else "<i4"), np.dtype("<i8" if version > 2 else "<i4")
    rows = np.empty(mesh.vertex_count, np.dtype([("place", "<f8", 3), ("reference", whole)]))
    rows["place"], rows["reference"] = mesh.coordinates.T, points
    out = [np.array([1, version], "<i4").tobytes()]
    position = 8
    for keyword, head, body in [
        (DIMENSION, np.array([3], "<i4").tobytes(), b""),
        (VERTICES, np.array([mesh.vertex_count], whole).tobytes(), rows.tobytes()),
        *((keyword, count, body) for keyword, count, body in sections(mesh, cells, whole)),
    ]:
        position += 4 + place.itemsize + len(head) + len(body)
        out += [np.array([keyword], "<i4").tobytes(), np.array([position], place).tobytes(), head, body]
    return b"".join([*out, np.array([END], "<i4").tobytes(), np.array([0], place).tobytes()])


def sections(
    mesh: Mesh, references: Array, whole: np.dtype[np.signedinteger]
) -> list[tuple[int, bytes, bytes]]:
    """Number, count and rows of the section of each kind that there is."""
    out = []
    for kind, keyword in enumerate(SECTIONS):
        which = np.flatnonzero(mesh.kinds == kind)
        if len(which):
            rows = np.stack(
                [*(corner + 1 for corner in own_corners(mesh, kind, which)), references[which]], axis=1
            )
            out.append((keyword, np.array([len(which)], whole).tobytes(), rows.astype(whole).tobytes()))
    return out
