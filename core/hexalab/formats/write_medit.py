"""Writes Medit `.mesh`, ASCII."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..arrays import Array
from ..mesh import Mesh
from .medit_features import MARK, REFERENCE
from .vtk_grid import parted
from .writing import formatted, own_corners
from .written_groups import numbered, reference_of

SECTIONS = ("Hexahedra", "Prisms", "Pyramids", "Tetrahedra")
"""For each kind, the keyword of its section."""

KEYWORDS = {2: "Edges", 3: "Triangles", 4: "Quadrilaterals"}
"""The sections of elements of lower dimension, by their corners."""

MARKS = {
    (0, "corners"): "Corners",
    (0, "required"): "RequiredVertices",
    (1, "ridges"): "Ridges",
    (1, "required"): "RequiredEdges",
}
"""The sections that name some vertices or edges."""


def write(mesh: Mesh) -> bytes:
    """The bytes of a `.mesh` file.

    Coordinates are written with as many digits as bring back the same float64. Cells are grouped by kind,
    in file order within each. Of the attributes, an integer "reference" is kept; the format has no place
    for others. Edges are one section, so that Ridges can count them.
    """
    parts = [b"MeshVersionFormatted 2\nDimension 3\n", f"Vertices\n{mesh.vertex_count}\n".encode()]
    references = whole_numbers(mesh.point_data.get(REFERENCE), mesh.vertex_count)
    parts += formatted("%r %r %r %d\n", [*mesh.coordinates, references])
    references = cell_references(mesh)
    for kind, keyword in enumerate(SECTIONS):
        which = np.flatnonzero(mesh.kinds == kind)
        if not len(which):
            continue
        parts.append(f"{keyword}\n{len(which)}\n".encode())
        rows = [corner + 1 for corner in own_corners(mesh, kind, which)]
        parts += formatted("%d " * len(rows) + "%d\n", [*rows, references[which]])
    for keyword, table in feature_rows(mesh):
        parts.append(f"{keyword}\n{len(table)}\n".encode())
        parts += formatted(" ".join(["%d"] * table.shape[1]) + "\n", [*table.T])
    return b"".join([*parts, b"End\n"])


def cell_references(mesh: Mesh) -> Array:
    """(C,) the attribute "reference", else the numbers of groups that no cell is in two of, else 0."""
    if has_references(mesh):
        return mesh.cell_data[REFERENCE]
    return numbered([group for group in mesh.groups if group.on == "cell"], mesh.cell_count)[1]


def feature_rows(mesh: Mesh) -> Iterator[tuple[str, Array]]:
    """Keyword and rows, (n, k), of each section of elements of lower dimension and of what is marked of them."""
    for features in mesh.features:
        references = reference_of(features)
        for part, size in parted(features) if features.dimension else ():
            vertices = features.corners[:size, part] + 1
            yield KEYWORDS[size], np.concatenate([vertices, references[None, part]]).T
        for group in features.groups:
            keyword = MARKS.get((features.dimension, group.name)) if group.origin == MARK else None
            if keyword:
                rows = features.corners[0, group.members] if not features.dimension else group.members
                yield keyword, (rows.astype(np.int64) + 1)[:, None]
        if features.dimension == 0 and not any(group.origin == MARK for group in features.groups):
            yield MARKS[0, "corners"], features.corners.T.astype(np.int64) + 1


def has_references(mesh: Mesh) -> bool:
    """Whether the attribute "reference" tells the cells' references."""
    own = mesh.cell_data.get(REFERENCE)
    return own is not None and is_reference(own)


def is_reference(values: Array) -> bool:
    """Whether the format can hold the values."""
    return values.ndim == 1 and values.dtype.kind in "iu"


def whole_numbers(values: Array | None, count: int) -> Array:
    """The references, zeros where there are none that the format can hold."""
    if values is None or not is_reference(values):
        return np.zeros(count, dtype=np.int32)
    return values
