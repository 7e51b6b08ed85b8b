"""VTK XML `.vtp`, data of polygons: Polys and Strips of all pieces; Verts and Lines are left out, with a note."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..arrays import Array, Floats
from ..errors import MeshReadError
from ..formats.byte_order import native
from ..formats.file import File
from ..formats.ids import within_int32
from ..formats.vtk_cells import spans
from ..formats.vtu import Reader as VtuReader
from ..formats.xml_tags import Element
from .polygons import Polygons, surface_of
from .strips import cut_strips
from .surface import TriangleSurface

FACES: tuple[tuple[str, Callable[..., Polygons]], ...] = (("Polys", Polygons), ("Strips", cut_strips))
"""Sections of faces, and what makes polygons of their rows."""

LEFT_OUT = (("Verts", "points"), ("Lines", "lines"))
"""Sections of cells that are no faces, and what to call them."""


def read(file: File) -> TriangleSurface:
    """Read the bytes of a `.vtp` file; raises MeshReadError."""
    return Reader(file).surface()


class Reader(VtuReader):
    """Joins the pieces of the file."""

    kind = "PolyData"

    def surface(self) -> TriangleSurface:
        """Read the pieces, whose vertices come one after the other.

        Raises
        ------
        MeshReadError
            An array is missing, damaged, or of another length than its piece says; there are no faces.
        """
        points: list[Floats] = [np.empty((3, 0))]
        parts: list[Polygons] = []
        for piece in self.pieces:
            own = self.points(piece)
            before = sum(one.shape[1] for one in points)
            for section, make in FACES:
                if piece.first(section) and self.announced(piece, section):
                    parts.append(self.faces(piece, section, make, own.shape[1], before))
            for section, name in LEFT_OUT:
                self.out.leave_out(name, self.announced(piece, section))
            points.append(own)
        if self.out.left_out:
            self.out.note(f"Left out, as they are no faces: {self.out.counts_left_out()}.")
        return surface_of(self.file, "vtp", np.concatenate(points, axis=1), parts, self.out.notes)

    def announced(self, piece: Element, section: str) -> int:
        """How many cells a section of a piece should have."""
        name = f"NumberOf{section}"
        return self.count(piece, name) if name in piece.attributes else 0

    def faces(
        self, piece: Element, section: str, make: Callable[..., Polygons], vertices: int, before: int
    ) -> Polygons:
        """The polygons of a section of a piece that has so many vertices, and so many before it."""
        cells = self.section(piece, section)
        named = {child.attributes.get("Name", "").lower(): child for child in cells.all("DataArray")}
        for name in ("connectivity", "offsets"):
            if name not in named:
                raise self.arrays.error(cells, f"{section} has no DataArray {name}")
        ids, ends = (self.integers(named[name], name) for name in ("connectivity", "offsets"))
        count = self.announced(piece, section)
        if len(ends) != count:
            raise self.arrays.error(named["offsets"], f"{len(ends)} offsets for {count} cells of {section}")

        def error_at(message: str, _: int) -> MeshReadError:
            return self.arrays.error(named["connectivity"], message)

        offsets = np.concatenate([np.zeros(1, np.int64), within_int32(ends).astype(np.int64)])
        starts, sizes = spans(offsets, len(ids), error_at)
        beyond = (ids < 0) | (ids >= vertices)
        if beyond.any():
            found = int(ids[int(np.argmax(beyond))])
            raise error_at(
                f"{section} refer to vertex {found}, which is not there: expected 0 to {vertices - 1}", 0
            )
        return make(within_int32(ids).astype(np.int64) + before, starts, sizes, error_at)

    def integers(self, element: Element, name: str) -> Array:
        """The whole numbers of an array."""
        values = native(self.arrays.values(element, name))
        if values.dtype.kind not in "iu":
            raise self.arrays.error(element, f"{name} are of type {values.dtype}, expected integers")
        return values
