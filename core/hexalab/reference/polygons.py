"""What every reader of surfaces ends with: polygons become triangles, checked, with notes of what was left out."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Array, Floats, Ids
from ..errors import MeshReadError
from ..formats.byte_order import native
from ..formats.file import File
from ..formats.ids import LARGEST_ID, as_int32
from ..formats.row_chain import ErrorAt
from .cutting import triangles_of
from .surface import TriangleSurface


@dataclass(frozen=True)
class Polygons:
    """Polygons as rows of vertex ids.

    Parameters
    ----------
    ids : (n,) integers
        Vertex ids from 0 on, those of each polygon in a row; there may be other numbers between the rows.
    starts : (P,) integers or range
        Where each polygon begins in `ids`; checked to lie within, with its size.
    sizes : (P,) integers
        How many corners each has.
    error_at : callable
        `error_at(message, index)` makes the error for `ids[index]`.
    base : int
        What the file counts vertices from, for messages.
    """

    ids: Array
    starts: Array | range
    sizes: Array
    error_at: ErrorAt
    base: int = 0


def surface_of(
    file: File, format_id: str, points: Floats, parts: list[Polygons], notes: list[str]
) -> TriangleSurface:
    """Cut the polygons of a file into triangles.

    Parameters
    ----------
    file : File
    format_id : str
        Row of the registry.
    points : (3, V) float64
        Finite.
    parts : list of Polygons
        One after the other.
    notes : list of str
        Those of the reader, to which others are added.

    Raises
    ------
    MeshReadError
        A corner is no vertex, or there are no triangles.
    """
    if points.shape[1] > LARGEST_ID:
        raise file.error(f"{points.shape[1]} vertices are more than 2,147,483,646")
    few = many = 0
    triangles: list[Ids] = [np.empty((3, 0), np.int32)]
    for part in parts:
        sizes, starts = np.asarray(part.sizes), part.starts
        small = sizes < 3
        if small.any():
            starts, sizes = np.asarray(starts)[~small], sizes[~small]
            few += int(np.count_nonzero(small))
        many += int(np.count_nonzero(sizes > 4))
        ids = checked_ids(replace(part, starts=starts, sizes=sizes), points.shape[1])
        triangles.append(triangles_of(points, ids, starts, sizes))
    if few:
        notes.append(f"Left out, as they have less than three corners: faces ({few:,}).")
    if many:
        notes.append(
            f"Faces of more than four corners ({many:,}) were cut into triangles as fans from their first corners: "
            "of one that is not convex, triangles may lie outside of it."
        )
    return finished(file.name, format_id, points, np.concatenate(triangles, axis=1), notes)


def finished(
    name: str, format_id: str, points: Floats, triangles: Ids, notes: list[str], what: str = "faces"
) -> TriangleSurface:
    """The surface of (3, T) triangles without those that have a vertex twice; raises MeshReadError if none is left."""
    a, b, c = triangles
    flat = (a == b) | (b == c) | (c == a)
    count = int(np.count_nonzero(flat))
    if count:
        triangles = triangles[:, ~flat]
        notes.append(f"Left out, as they have a vertex twice: triangles ({count:,}).")
    if not triangles.shape[1]:
        of_them = f" ({' '.join(notes[:2])})" if notes else ""
        raise MeshReadError(f"the file has no {what}, expected a surface{of_them}", file=name)
    return TriangleSurface(points, triangles, name, format_id, notes)


def checked_ids(polygons: Polygons, vertex_count: int) -> Array:
    """The ids as native integers; raises MeshReadError if a polygon's corner is no vertex."""
    ids = as_int32(native(polygons.ids))
    wrong = (ids < 0) | (ids >= vertex_count)
    if not wrong.any():
        return ids
    # among the numbers between the rows, such as their lengths, may be some that are no vertices
    starts = np.asarray(polygons.starts, dtype=np.int64)
    before = np.concatenate([[0], np.cumsum(wrong)])
    bad = before[starts + polygons.sizes] > before[starts]
    if not bad.any():
        return ids
    row = int(np.argmax(bad))
    index = int(starts[row]) + int(np.argmax(wrong[starts[row] :]))
    found = int(ids[index])
    name = f"vertex {found + polygons.base}" if abs(found) < LARGEST_ID - 1 else "a number that is none"
    expected = (
        f"expected {polygons.base} to {vertex_count - 1 + polygons.base}"
        if vertex_count
        else "there are none"
    )
    raise polygons.error_at(f"a face refers to {name}, which is not there: {expected}", index)
