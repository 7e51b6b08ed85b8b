"""VTK XML `.vtu` (SPEC R4): ascii, base64 and appended arrays, compressed or not, one or several pieces."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..errors import MeshReadError
from ..mesh import Mesh
from .assembly import Assembly, check_finite, free_name
from .byte_order import as_coordinates, native
from .cell_orientation import Orientation
from .feature_blocks import FeatureBlock
from .file import File
from .group_arrays import attach
from .tokens import quoted
from .vtk_cells import Rows, add_cells, spans
from .vtk_datasets import refusal
from .vtk_types import POLYHEDRON
from .vtk_wedges import WedgeNumbering
from .vtu_arrays import Arrays
from .vtu_faces import FacesOfPiece
from .xml_tags import Element, parse


def read(file: File) -> Mesh:
    """Read the bytes of a `.vtu` file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """Joins the pieces of the file."""

    kind = "UnstructuredGrid"
    """The kind of data that is read."""

    def __init__(self, file: File) -> None:
        self.file = file
        self.out = Assembly(file, "vtu", first_number=0)
        root = parse(file, "AppendedData")
        top = root.first("VTKFile")
        if top is None:
            raise file.error("expected the element VTKFile", line_at=0)
        kind = top.attributes.get("type", "")
        if kind != self.kind:
            raise file.error(refusal(kind, self.kind), line_at=top.begin)
        grid = top.first(self.kind)
        self.pieces = grid.all("Piece") if grid else []
        if not self.pieces:
            raise file.error("the file has no element Piece", line_at=top.begin)
        self.arrays = Arrays(file, top, top.first("AppendedData"))
        self.vertex_count = 0
        self.orientation = Orientation(inwards=False, faces="faces")
        self.wedges = WedgeNumbering()

    def read(self) -> Mesh:
        """Read the pieces and join them, their vertices and cells one after the other.

        Attributes that not every piece has, in the same width, are left out.

        Raises
        ------
        MeshReadError
            An array is missing, damaged, or of another length than its piece says.
        """
        coordinates: list[Array] = []
        data: list[tuple[dict[str, Array], dict[str, Array]]] = []
        numbers: list[tuple[Array | None, Array | None]] = []
        for piece in self.pieces:
            points = self.points(piece)
            if not points.shape[1]:
                continue
            coordinates.append(points)
            kept, features = self.cells(piece, points)
            cell_data, cell_ids = self.attributes(piece, "CellData", self.count(piece, "NumberOfCells"))
            point_data, point_ids = self.attributes(piece, "PointData", points.shape[1])
            data.append((point_data, attach(features, cell_data, kept)))
            self.out.features += features
            numbers.append((point_ids, cell_ids if kept is None or cell_ids is None else cell_ids[kept]))
            self.vertex_count += points.shape[1]
        if coordinates:
            self.out.coordinates = np.concatenate(coordinates, axis=1)
            self.out.point_data = joined([points for points, _ in data])
            self.out.cell_data = joined([cells for _, cells in data])
            self.out.vertex_numbers = joined_ids([points for points, _ in numbers])
            self.out.cell_numbers = joined_ids([cells for _, cells in numbers])
        self.orientation.settle(self.out)
        self.wedges.settle(self.out)
        return self.out.mesh()

    def count(self, piece: Element, name: str) -> int:
        """An attribute of a piece that counts; nothing is allocated from it."""
        text = piece.attributes.get(name, "")
        if not text.strip().isdigit() or len(text) > 18:
            raise self.arrays.error(piece, f"{name} is {quoted(text)}, expected a whole number")
        return int(text)

    def section(self, piece: Element, name: str) -> Element:
        """The element of that name in a piece; its absence is an error."""
        element = piece.first(name)
        if element is None:
            raise self.arrays.error(piece, f"the piece has no element {name}")
        return element

    def points(self, piece: Element) -> Array:
        """(3, n) float64."""
        count = self.count(piece, "NumberOfPoints")
        if not count:
            return np.empty((3, 0))
        element = self.section(piece, "Points").first("DataArray")
        if element is None:
            raise self.arrays.error(piece, "Points has no DataArray")
        values = self.arrays.values(element, "the points")
        if len(values) != 3 * count:
            raise self.arrays.error(element, f"Points has {len(values)} numbers, expected {3 * count}")
        points = as_coordinates(values.reshape(count, 3))
        check_finite(points, lambda message, _: self.arrays.error(element, message))
        return points

    def cells(self, piece: Element, points: Array) -> tuple[Array | None, list[FeatureBlock]]:
        """Add the piece's cells; returns the rows that were kept, None for all, and its features."""
        cells = self.section(piece, "Cells")
        named = {child.attributes.get("Name", "").lower(): child for child in cells.all("DataArray")}
        for name in ("connectivity", "offsets", "types"):
            if name not in named:
                raise self.arrays.error(cells, f"Cells has no DataArray {name}")
        count = self.count(piece, "NumberOfCells")
        ids = self.arrays.values(named["connectivity"], "connectivity")
        ends = self.arrays.values(named["offsets"], "offsets")
        types = self.arrays.values(named["types"], "types")
        for name, values in (("offsets", ends), ("types", types), ("connectivity", ids)):
            if values.dtype.kind not in "iu":
                raise self.arrays.error(named[name], f"{name} are of type {values.dtype}, expected integers")
            if name != "connectivity" and len(values) != count:
                raise self.arrays.error(named[name], f"{len(values)} {name} for {count} cells")

        def error_at(message: str, _: int) -> MeshReadError:
            return self.arrays.error(named["connectivity"], message)

        offsets = np.concatenate([np.zeros(1, np.int64), ends.astype(np.int64)])
        starts, sizes = spans(offsets, len(ids), error_at)
        part = Assembly(self.file, "vtu", points, notes=self.out.notes, left_out=self.out.left_out)
        faces = FacesOfPiece(self.arrays, cells, count).loops if (types == POLYHEDRON).any() else None
        kept = add_cells(
            part, Rows(ids, starts, sizes, types, error_at, self.orientation, self.wedges, faces)
        )
        first_cell = sum(block.corners.shape[1] for block in self.out.blocks)
        for block in part.blocks:
            self.out.add_piece(block, points.shape[1], self.vertex_count, first_cell)
        for feature in part.features:
            beyond = (feature.corners < 0) | (feature.corners >= points.shape[1])
            feature.corners = np.where(beyond, -1, feature.corners + np.int32(self.vertex_count))
        return kept, part.features

    def attributes(self, piece: Element, section: str, count: int) -> tuple[dict[str, Array], Array | None]:
        """The arrays of PointData or CellData, (count, k), and the one that is declared to be global ids."""
        out: dict[str, Array] = {}
        element, ids = piece.first(section), None
        global_ids = element.attributes.get("GlobalIds", "") if element else ""
        for child in element.all("DataArray") if element else []:
            name = child.attributes.get("Name", "") or "unnamed"
            if child.attributes.get("type") == "String":
                continue
            values = native(self.arrays.values(child, f"the array {quoted(name)}"))
            if not count or len(values) % count:
                self.out.note(
                    f"The array {quoted(name)} has {len(values)} numbers for {count} entries: left out."
                )
                continue
            if name == global_ids and values.dtype.kind in "iu" and len(values) == count:
                ids = values
            else:
                out[free_name(out, name)] = values.reshape(count, len(values) // count)
        return out, ids


def joined_ids(pieces: list[Array | None]) -> Array | None:
    """The numbers of all pieces; None if one has none."""
    found = [numbers for numbers in pieces if numbers is not None]
    return np.concatenate(found) if found and len(found) == len(pieces) else None


def joined(pieces: list[dict[str, Array]]) -> dict[str, Array]:
    """Arrays of several pieces, one after the other; those that every piece has in the same width."""
    if len(pieces) == 1:
        return pieces[0]
    out = {}
    for name, values in pieces[0].items():
        parts = [piece[name] for piece in pieces if name in piece]
        if len(parts) == len(pieces) and all(part.shape[1] == values.shape[1] for part in parts):
            out[name] = np.concatenate(parts)
    return out
