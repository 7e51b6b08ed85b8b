"""The mesh: coordinates, cells in the form that `hexalab.cells` describes, attributes."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .arrays import CHUNK, Array, Floats, Ids
from .cells import CORNERS_OF_KIND, HEXAHEDRON, KINDS
from .topology import Topology


@dataclass
class Mesh:
    """A volumetric mesh of hexahedra and cells that collapse from them.

    Parameters
    ----------
    coordinates : (3, V) float64, C-contiguous
        Vertex coordinates in the unit of the file; `points` is the (V, 3) view of it.
    corners : (8, C) int32, C-contiguous
        Vertex ids of each cell's corners; `cells` is the (C, 8) view of it.
    kinds : (C,) uint8
        Index into `KINDS`. A hexahedron that repeats vertices in the file stays a hexahedron.
    point_data, cell_data : dict of str to (V,) or (V, k), (C,) or (C, k) arrays
        The file's own attributes by name, in the file's number type.
    name : str
        File name, for messages and for the status document.
    format : str
        Id of the format it was read from, a row of `hexalab.formats.FORMATS`; "" if made by hand.
    notes : list of str
        What reading had to assume or leave out, one sentence each.
    vertex_numbers, cell_numbers : (V,), (C,) int64 or None
        The file's own numbers of nodes and elements, in any order and with gaps; None where it has none, or where
        they are just the rows counted on.
    """

    coordinates: Floats
    corners: Ids
    kinds: NDArray[np.uint8]
    point_data: dict[str, Array] = field(default_factory=dict)
    cell_data: dict[str, Array] = field(default_factory=dict)
    name: str = ""
    format: str = ""
    notes: list[str] = field(default_factory=list)
    vertex_numbers: NDArray[np.int64] | None = None
    cell_numbers: NDArray[np.int64] | None = None

    def __post_init__(self) -> None:
        self.coordinates = np.ascontiguousarray(self.coordinates, dtype=np.float64)
        self.corners = np.ascontiguousarray(self.corners, dtype=np.int32)
        self.kinds = np.ascontiguousarray(self.kinds, dtype=np.uint8)
        if self.coordinates.ndim != 2 or len(self.coordinates) != 3:
            raise ValueError(f"coordinates must be (3, V), not {self.coordinates.shape}")
        if self.corners.ndim != 2 or len(self.corners) != 8:
            raise ValueError(f"corners must be (8, C), not {self.corners.shape}")
        if self.kinds.shape != (self.cell_count,):
            raise ValueError(f"kinds must be ({self.cell_count},), not {self.kinds.shape}")

    @classmethod
    def from_cells(cls, points: Array, cells: Array, **fields: Any) -> Mesh:
        """Make a mesh of hexahedra from (V, 3) points and (C, 8) vertex ids."""
        cells = np.asarray(cells, dtype=np.int32).reshape(-1, 8)
        kinds = np.zeros(len(cells), dtype=np.uint8)
        return cls(np.asarray(points, dtype=np.float64).reshape(-1, 3).T, cells.T, kinds, **fields)

    @property
    def points(self) -> Floats:
        """(V, 3) float64 view of the coordinates."""
        return self.coordinates.T

    @property
    def cells(self) -> Ids:
        """(C, 8) int32 view of the corners."""
        return self.corners.T

    @property
    def vertex_count(self) -> int:
        """Number of vertices, unreferenced ones included."""
        return int(self.coordinates.shape[1])

    @property
    def cell_count(self) -> int:
        """Number of cells of all kinds."""
        return int(self.corners.shape[1])

    @cached_property
    def kind_counts(self) -> dict[str, int]:
        """Number of cells of each kind that occurs."""
        counts = np.bincount(self.kinds, minlength=len(KINDS))
        return {name: int(count) for name, count in zip(KINDS, counts, strict=True) if count}

    @cached_property
    def referenced(self) -> NDArray[np.bool_]:
        """(V,) bool: whether a cell uses the vertex."""
        used = np.zeros(self.vertex_count, dtype=bool)
        for corner in self.corners:
            used[corner] = True
        return used

    @cached_property
    def extent(self) -> Floats:
        """(2, 3) float64: smallest and largest coordinates over the vertices that cells use."""
        if not self.cell_count:
            return np.zeros((2, 3))
        used = self.coordinates if self.referenced.all() else self.coordinates[:, self.referenced]
        return np.stack([used.min(axis=1), used.max(axis=1)])

    @property
    def centre(self) -> Floats:
        """(3,) float64: middle of the extent."""
        low, high = self.extent
        return np.asarray(low + (high - low) / 2)

    @property
    def diagonal(self) -> float:
        """Length of the extent's diagonal; 1 if the mesh is a single point."""
        low, high = self.extent
        return float(np.sqrt(((high - low) ** 2).sum())) or 1.0

    @cached_property
    def barycentres(self) -> Floats:
        """(3, C) float64: mean of each cell's own corners (a collapsed cell counts each corner once)."""
        return cell_barycentres(self.coordinates, self.corners, self.kinds)

    @cached_property
    def topology(self) -> Topology:
        """Faces, edges, adjacency: computed at first use, part by part, and kept."""
        return Topology(self.corners, self.vertex_count)


def cell_barycentres(coordinates: Floats, corners: Ids, kinds: NDArray[np.uint8]) -> Floats:
    """Mean of each cell's own corners, (3, C) float64."""
    out = np.empty((3, corners.shape[1]))
    for start in range(0, corners.shape[1], CHUNK):
        part = slice(start, start + CHUNK)
        for axis in range(3):
            x = coordinates[axis]
            total = x[corners[0, part]]
            for corner in corners[1:]:
                total = total + x[corner[part]]
            out[axis, part] = total / 8
    for kind in np.unique(kinds):
        if kind == HEXAHEDRON:
            continue
        which = np.flatnonzero(kinds == kind)
        own = corners[np.array(CORNERS_OF_KIND[kind])][:, which]
        out[:, which] = coordinates[:, own].mean(axis=1)
    return out
