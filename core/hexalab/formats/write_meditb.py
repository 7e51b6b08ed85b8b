"""Writes Medit `.meshb`, binary (libMeshb's documentation)."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..mesh import Mesh
from .ids import fits_int32
from .medit_features import REFERENCE
from .meditb import DIMENSION, END, VERTICES
from .write_medit import cell_references, feature_rows, whole_numbers
from .writing import own_corners

SECTIONS = (10, 9, 49, 8)
"""For each kind, the number of its section."""

FEATURES = {
    "Edges": 5,
    "Triangles": 6,
    "Quadrilaterals": 7,
    "Corners": 13,
    "Ridges": 14,
    "RequiredVertices": 15,
    "RequiredEdges": 16,
}
"""The numbers of the other sections."""


def write(mesh: Mesh) -> bytes:
    """The bytes of a `.meshb` file, little-endian: version 2, 3 from 2 GB on, 4 where a reference needs 64 bits.

    Cells are grouped by kind, in file order within each. Of the attributes, an integer "reference" is kept.
    """
    points = whole_numbers(mesh.point_data.get(REFERENCE), mesh.vertex_count)
    cells = cell_references(mesh)
    marked = list(feature_rows(mesh))
    size = 100 + 28 * mesh.vertex_count + 36 * mesh.cell_count
    size += sum(8 * table.size for _, table in marked)
    narrow = all(fits_int32(values) for values in (points, cells, *(table for _, table in marked)))
    version = 4 if not narrow else 3 if size >= 2**31 else 2
    whole, place = np.dtype("<i8" if version == 4 else "<i4"), np.dtype("<i8" if version > 2 else "<i4")
    rows = np.empty(mesh.vertex_count, np.dtype([("place", "<f8", 3), ("reference", whole)]))
    rows["place"], rows["reference"] = mesh.coordinates.T, points
    out = [np.array([1, version], "<i4").tobytes()]
    position = 8
    for keyword, head, body in [
        (DIMENSION, np.array([3], "<i4").tobytes(), b""),
        (VERTICES, np.array([mesh.vertex_count], whole).tobytes(), rows.tobytes()),
        *sections(mesh, cells, whole),
        *(
            (FEATURES[name], np.array([len(table)], whole).tobytes(), table.astype(whole).tobytes())
            for name, table in marked
        ),
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
