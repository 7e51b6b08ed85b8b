"""The faces of the polyhedra in a piece of a `.vtu` file, in both forms that VTK has written."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..arrays import Array
from ..errors import MeshReadError
from .byte_order import native
from .half_faces import LARGEST_FACE, MOST_FACES, polygons, rows_of
from .ids import LARGEST_ID, within_int32
from .vtk_polyhedra import stream_loops
from .vtu_arrays import Arrays
from .xml_tags import Element

OLD = ("faces", "faceoffsets")
"""Streams of faces, and where each cell's stream ends, -1 for cells that are no polyhedra."""

NEW = ("face_connectivity", "face_offsets", "polyhedron_to_faces", "polyhedron_offsets")
"""Vertices of faces, where each face ends, faces of polyhedra, where each cell's faces end (VTK 9.4 and later)."""


class FacesOfPiece:
    """Gives the loops of the faces of polyhedra.

    Parameters
    ----------
    arrays : Arrays
        The file's arrays.
    cells : Element
        The piece's element Cells.
    count : int
        Cells of the piece.

    Raises
    ------
    MeshReadError
        An array is damaged, or of another length than the others say.
    """

    loops: Callable[[Array], Array]

    def __init__(self, arrays: Arrays, cells: Element, count: int) -> None:
        self.arrays = arrays
        self.named = {child.attributes.get("Name", "").lower(): child for child in cells.all("DataArray")}
        self.loops = self.no_loops
        if all(name in self.named for name in NEW):
            self.read_new(count)
        elif all(name in self.named for name in OLD):
            self.read_old(count)

    def no_loops(self, which: Array) -> Array:
        """Loops where the file has no faces: none."""
        return np.full((len(which), MOST_FACES, LARGEST_FACE), -1, dtype=np.int32)

    def integers(self, name: str) -> Array:
        """The array of that name, (n,) intp; what does not fit int32 is moved to its ends."""
        element = self.named[name]
        values = self.arrays.values(element, name)
        if values.dtype.kind not in "iu":
            raise self.arrays.error(element, f"{name} are of type {values.dtype}, expected integers")
        return within_int32(native(values)).astype(np.intp, copy=False)

    def error(self, name: str, message: str) -> MeshReadError:
        """The error for an array."""
        return self.arrays.error(self.named[name], message)

    def ends(self, name: str, size: int, count: int | None = None) -> tuple[Array, Array]:
        """Starts and ends of rows from an array of their ends; negative ends are rows that are not there."""
        ends = self.integers(name)
        if count is not None and len(ends) != count:
            raise self.error(name, f"{name} has {len(ends)} entries, expected one for each of {count} cells")
        reached = np.maximum.accumulate(np.concatenate([np.zeros(1, np.intp), ends]))
        starts = reached[:-1]
        if len(ends) and (reached[-1] > size or (ends[ends >= 0] < starts[ends >= 0]).any()):
            raise self.error(name, f"{name} should rise from 0 to {size}, the values that they count")
        return starts, np.maximum(ends, starts)

    def read_old(self, count: int) -> None:
        """Streams of faces."""
        stream = self.integers("faces")
        starts, ends = self.ends("faceoffsets", len(stream), count)
        self.loops = lambda which: stream_loops(stream, starts[which], ends[which])

    def read_new(self, count: int) -> None:
        """Faces as arrays of their own."""
        vertices = self.integers("face_connectivity")
        vertices = np.where(vertices < 0, LARGEST_ID, vertices)
        face_starts, face_ends = self.ends("face_offsets", len(vertices))
        sizes = face_ends - face_starts
        faces = self.integers("polyhedron_to_faces")
        wrong = (faces < 0) | (faces >= len(sizes))
        if wrong.any():
            number = int(faces[np.argmax(wrong)])
            raise self.error(
                "polyhedron_to_faces", f"face {number} is not there, expected 0 to {len(sizes) - 1}"
            )
        starts, ends = self.ends("polyhedron_offsets", len(faces), count)

        def loops(which: Array) -> Array:
            rows = rows_of(faces, starts[which], ends[which] - starts[which])
            return polygons(np.where(rows < 0, -1, 2 * rows), vertices, face_starts, sizes)

        self.loops = loops
