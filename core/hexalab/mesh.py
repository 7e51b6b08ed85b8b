"""The mesh: coordinates, cells in the form that `hexalab.cells` describes, attributes."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .arrays import CHUNK, Array, Floats, Ids
from .cells import CORNERS_OF_KIND, HEXAHEDRON, KINDS
from .groups import Features, Group, checked_features, checked_groups
from .topology import Topology

GEOMETRY = frozenset(("coordinates", "corners", "kinds"))
"""The fields that everything computed of a mesh depends on."""


@dataclass(eq=False)
class Mesh:
    """A volumetric mesh of hexahedra and cells that collapse from them.

    What is computed of it is kept, so coordinates, corners and kinds stay as they are: its arrays are read-only views,
    and another mesh is made of this one by ``dataclasses.replace(mesh, coordinates=...)``. An array that was handed
    over is not copied where it has the right type already: who goes on writing into it copies it first.

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
    first_number : int
        What such rows are counted from: 1 where the format does so, 0 in VTK's and in meshes made by hand.
    groups : tuple of Group
        Named sets of cells and of vertices.
    features : tuple of Features
        The file's elements of lower dimension, one for each dimension that there is, the lowest first.
    included : dict of str to str
        Files that the file includes and that were read with it: name, and SHA-256 in hexadecimal.

    Raises
    ------
    ValueError
        An array has the wrong shape, length or type, or a corner is no vertex: which, and what was expected.

    >>> Mesh.from_cells(np.zeros((8, 3)), [[0, 1, 2, 3, 4, 5, 6, 8]])
    Traceback (most recent call last):
    ValueError: corners refer to vertices 0 to 8, expected 0 to 7
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
    first_number: int = 0
    groups: tuple[Group, ...] = ()
    features: tuple[Features, ...] = ()
    included: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        coordinates, corners, kinds = map(np.asarray, (self.coordinates, self.corners, self.kinds))
        if coordinates.ndim != 2 or len(coordinates) != 3 or coordinates.dtype.kind not in "iufb":
            raise ValueError(f"coordinates must be (3, V) numbers, not {shape_of(coordinates)}")
        if corners.ndim != 2 or len(corners) != 8:
            raise ValueError(f"corners must be (8, C), not {corners.shape}")
        if kinds.shape != corners.shape[1:]:
            raise ValueError(f"kinds must be ({corners.shape[1]},), not {kinds.shape}")
        check_range(corners, coordinates.shape[1], "corners refer to vertices")
        check_range(kinds, len(KINDS), "kinds are")
        for name, values, dtype in (
            ("coordinates", coordinates, np.float64), ("corners", corners, np.int32), ("kinds", kinds, np.uint8)
        ):  # fmt: skip
            array = np.ascontiguousarray(values, dtype=dtype)
            if array.flags.writeable:
                array = array.view()
                array.flags.writeable = False
            self.__dict__[name] = array
        self.vertex_numbers = numbers_of(self.vertex_numbers, self.vertex_count, "vertex_numbers")
        self.cell_numbers = numbers_of(self.cell_numbers, self.cell_count, "cell_numbers")
        self.groups = checked_groups(self.groups, self.cell_count, self.vertex_count)
        self.features = checked_features(self.features, self.vertex_count)
        self.check_data()

    def __setattr__(self, name: str, value: object) -> None:
        if name in GEOMETRY and name in self.__dict__:
            raise AttributeError(
                f"a mesh keeps its {name}, as what is computed of them is kept; "
                f"make another by dataclasses.replace(mesh, {name}=...)"
            )
        super().__setattr__(name, value)

    def check_data(self) -> None:
        """Make arrays of all attributes.

        Raises
        ------
        ValueError
            One has not a number or a row of numbers for each vertex or cell.
        """
        self.point_data = checked(self.point_data, self.vertex_count, "point_data", "vertices")
        self.cell_data = checked(self.cell_data, self.cell_count, "cell_data", "cells")

    @classmethod
    def from_cells(cls, points: ArrayLike, cells: ArrayLike, **fields: Any) -> Mesh:
        """Make a mesh of hexahedra from (V, 3) points and (C, 8) vertex ids."""
        cells = np.asarray(cells).reshape(-1, 8)
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
        return np.asarray(low / 2 + high / 2)

    @property
    def diagonal(self) -> float:
        """Length of the extent's diagonal; 1 if the mesh is a single point."""
        return diagonal_of(*self.extent)

    @cached_property
    def within_reach(self) -> tuple[Mesh, int]:
        """A mesh to compute with, and the power of two that its coordinates have to be multiplied with.

        It is this one, and 0, where the longest side of the extent is between 2^-50 and 2^50. Of coordinates beyond,
        products pass what float64 can hold; so they are scaled until the side is about 1, which is exact.
        """
        low, high = self.extent
        half = float((high / 2 - low / 2).max())
        if half == 0 or not np.isfinite(half) or 2.0**-51 <= half <= 2.0**49:
            return self, 0
        exponent = int(np.frexp(half)[1]) + 1
        with np.errstate(over="ignore"):
            coordinates = np.ldexp(self.coordinates, -exponent)
        return replace(self, coordinates=coordinates), exponent

    @cached_property
    def barycentres(self) -> Floats:
        """(3, C) float64: mean of each cell's own corners (a collapsed cell counts each corner once)."""
        return cell_barycentres(self.coordinates, self.corners, self.kinds)

    @cached_property
    def topology(self) -> Topology:
        """Faces, edges, adjacency: computed at first use, part by part, and kept."""
        return Topology(self.corners, self.vertex_count)


def diagonal_of(low: Floats, high: Floats) -> float:
    """Length of the diagonal of a box from its corners (3,); 1 for a single point."""
    with np.errstate(over="ignore"):
        sides = high - low
        squared = float((sides * sides).sum())
        within = 1e-300 < squared < 1e300
        return (float(np.sqrt(squared)) if within else float(np.hypot.reduce(sides))) or 1.0


def shape_of(values: Array) -> str:
    """Shape and type of an array, for messages."""
    return f"{values.shape} {values.dtype}"


def check_range(values: Array, count: int, what: str) -> None:
    """Raise ValueError unless all values are integers from 0 on, below the count."""
    if not values.size:
        return
    if values.dtype.kind not in "iu":
        raise ValueError(f"{what} {values.dtype}, expected integers")
    if values.dtype == np.int32 and values.flags.c_contiguous:
        if int(values.view(np.uint32).max()) < count:  # the negative ones are the largest
            return
    elif int(values.min()) >= 0 and int(values.max()) < count:
        return
    raise ValueError(f"{what} {values.min()} to {values.max()}, expected 0 to {count - 1}")


def numbers_of(values: Any, count: int, what: str) -> NDArray[np.int64] | None:
    """The file's own numbers as int64, one for each of so many entries; raises ValueError."""
    if values is None:
        return None
    numbers = np.asarray(values)
    if numbers.shape != (count,) or (count and numbers.dtype.kind not in "iu"):
        raise ValueError(f"{what} must be ({count},) integers, not {shape_of(numbers)}")
    return numbers.astype(np.int64, copy=False)


def checked(data: dict[str, Array], count: int, name: str, entries: str) -> dict[str, Array]:
    """The attributes as arrays; raises ValueError where one has not a row for each of so many entries."""
    arrays = {key: np.asarray(values) for key, values in data.items()}
    for key, values in arrays.items():
        if values.ndim not in (1, 2) or len(values) != count or values.dtype.kind not in "iufb":
            raise ValueError(
                f"{name}[{key!r}] must be a number or a row of numbers for each of {count} {entries}, "
                f"not {shape_of(values)}"
            )
    return arrays


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
