"""The surface that a mesh is measured against: triangles. And the boundary of a volumetric mesh as one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..arrays import CHUNK, Array, Floats, Ids
from ..mesh import Mesh, check_range, diagonal_of, shape_of
from .cutting import scale_of, triangles_of


@dataclass(frozen=True, eq=False)
class TriangleSurface:
    """Triangles in space, closed or not.

    Its arrays are read-only views, as those of a `Mesh`; what is computed of it is kept.

    Parameters
    ----------
    points : (3, V) float64, C-contiguous
        Vertex coordinates in the unit of the file; there may be some that no triangle uses.
    triangles : (3, T) int32, C-contiguous
        Vertex ids, counter-clockwise as seen from outside. Readers leave out triangles that have a vertex twice.
    name : str
        File name, for messages.
    format : str
        Id of the format it was read from: a row of `REFERENCE_FORMATS`, or of `hexalab.formats.FORMATS`.
    notes : sequence of str
        What reading had to assume or leave out, one sentence each; kept as a tuple.
    rows : (V,) int32 or None
        Of the boundary of a mesh, which vertex of the mesh each point is; None of a surface that was read.

    Raises
    ------
    ValueError
        An array has the wrong shape, a coordinate is not finite, or a corner is no vertex: which, and what was
        expected.

    >>> TriangleSurface(np.zeros((3, 3)), [[0], [1], [3]])
    Traceback (most recent call last):
    ValueError: triangles refer to vertices 0 to 3, expected 0 to 2
    """

    points: Floats
    triangles: Ids
    name: str = ""
    format: str = ""
    notes: Sequence[str] = ()
    rows: Ids | None = None

    def __post_init__(self) -> None:
        points, triangles = np.asarray(self.points), np.asarray(self.triangles)
        if points.ndim != 2 or len(points) != 3 or points.dtype.kind not in "iuf":
            raise ValueError(f"points must be (3, V) numbers, not {shape_of(points)}")
        if triangles.ndim != 2 or len(triangles) != 3:
            raise ValueError(f"triangles must be (3, T), not {triangles.shape}")
        check_range(triangles, points.shape[1], "triangles refer to vertices")
        if not np.isfinite(points).all():
            vertex = int(np.argmin(np.isfinite(points).all(axis=0)))
            raise ValueError(f"point {vertex} is {points[:, vertex].tolist()}, expected finite coordinates")
        self._set("points", points, np.float64)
        self._set("triangles", triangles, np.int32)
        object.__setattr__(self, "notes", tuple(self.notes))
        if self.rows is not None:
            rows = np.asarray(self.rows)
            if rows.shape != points.shape[1:] or (rows.size and rows.dtype.kind not in "iu"):
                raise ValueError(f"rows must be ({points.shape[1]},) integers, not {shape_of(rows)}")
            self._set("rows", rows, np.int32)

    def _set(self, name: str, values: Array, dtype: type) -> None:
        """Keep a read-only array."""
        array: Array = np.ascontiguousarray(values, dtype=dtype).view()
        array.flags.writeable = False
        object.__setattr__(self, name, array)

    @property
    def count(self) -> int:
        """Number of triangles."""
        return int(self.triangles.shape[1])

    @cached_property
    def vertices_used(self) -> Ids:
        """(n,) int32: the vertices that triangles use, ascending."""
        used = np.zeros(self.points.shape[1], dtype=bool)
        for corner in self.triangles:
            used[corner] = True
        return np.flatnonzero(used).astype(np.int32)

    @cached_property
    def extent(self) -> Floats:
        """(2, 3) float64: smallest and largest coordinates over the vertices that triangles use."""
        if not self.count:
            return np.zeros((2, 3))
        used = self.vertices_used
        own = self.points if len(used) == self.points.shape[1] else self.points[:, used]
        return np.stack([own.min(axis=1), own.max(axis=1)])

    @property
    def diagonal(self) -> float:
        """Length of the extent's diagonal; 1 if the surface is a single point."""
        return diagonal_of(*self.extent)

    @cached_property
    def area(self) -> float:
        """Sum of the triangles' areas."""
        total = 0.0
        for p, q, r in self._chunks():
            u, v = q - p, r - p
            x, y, z = cross(u, v)
            total += float(np.sqrt(x * x + y * y + z * z).sum())
        return self._rescaled(total / 2, 2)

    @cached_property
    def volume(self) -> float:
        """Volume that the triangles enclose; positive if they are seen counter-clockwise from outside.

        It means something only if the surface is `closed`. By the divergence theorem it is the sum of the tetrahedra
        over the triangles, det(p, q, r) / 6, here with the extent's centre as their common apex, so that little is
        lost to rounding wherever the surface lies.
        """
        total = 0.0
        for p, q, r in self._chunks():
            x, y, z = cross(q, r)
            total += float((p[0] * x + p[1] * y + p[2] * z).sum())
        return self._rescaled(total / 6, 3)

    @cached_property
    def closed(self) -> bool:
        """Whether each edge belongs to two triangles, which go along it in opposite directions.

        Each side of a triangle has a number: its two vertices, the smaller first, and the direction in the last bit.
        Sorted, those of a closed surface come in pairs 2 k, 2 k + 1, whose k differ from pair to pair.
        """
        if not self.count:
            return False
        span = self.points.shape[1]
        sides = np.empty((3, self.count), np.int64)
        for place in range(3):
            one, other = (self.triangles[(place + step) % 3].astype(np.int64) for step in (0, 1))
            sides[place] = (np.minimum(one, other) * span + np.maximum(one, other)) * 2 + (one > other)
        flat = np.sort(sides, axis=None)
        return bool(
            len(flat) % 2 == 0 and (flat[0::2] % 2 == 0).all() and (flat[1::2] == flat[0::2] + 1).all()
        )

    @cached_property
    def _scale(self) -> float:
        low, high = self.extent
        return scale_of((high / 2 - low / 2)[:, None])

    def _chunks(self) -> Iterator[Array]:
        """Corners of some triangles after others, (3, 3, n): corner, axis; from the centre, times the scale."""
        low, high = self.extent
        centre = low / 2 + high / 2
        for start in range(0, self.count, CHUNK):
            own = self.triangles[:, start : start + CHUNK]
            yield np.stack(
                [[(axis[ids] - middle) * self._scale for axis, middle in zip(self.points, centre, strict=True)]
                 for ids in own]
            )  # fmt: skip

    def _rescaled(self, value: float, power: int) -> float:
        """A product of so many scaled lengths in the unit of the file; infinite where it is too large."""
        for _ in range(power):
            value /= self._scale
        return value


def cross(u: Array, v: Array) -> tuple[Floats, Floats, Floats]:
    """Cross products of (3, n) vectors, component by component."""
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def boundary_of(mesh: Mesh) -> TriangleSurface:
    """The boundary of a volumetric mesh.

    Its faces look outwards, as the cells' corners are numbered: of an inverted mesh they look inwards. A quadrilateral
    is cut along its shorter diagonal, as VTK's vtkTriangleFilter does if it is convex (`hexalab.reference.cutting`). A
    cell that repeats another counts once, as it is drawn once: the two would else take each other's faces away.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    TriangleSurface
        Only the vertices of the boundary are kept, in the mesh's order; `rows` says which they are. Without triangles,
        if no face belongs to exactly one cell.
    """
    again = mesh.topology.repeated_cells
    own = mesh
    if len(again):
        corners = mesh.corners.copy()
        corners[:, again] = corners[0, again]
        own = replace(mesh, corners=corners)
    topology = own.topology
    rows = topology.faces.boundary
    faces = topology.corners_of(topology.face_cells[0, rows], topology.face_locals[0, rows])
    triangles = triangles_of_faces(mesh.coordinates, faces)
    used = np.zeros(mesh.vertex_count, dtype=bool)
    used[faces] = True
    kept = np.flatnonzero(used).astype(np.int32)
    place = np.empty(mesh.vertex_count, np.int32)
    place[kept] = np.arange(len(kept), dtype=np.int32)
    return TriangleSurface(
        mesh.coordinates[:, kept], place[triangles], mesh.name, mesh.format, mesh.notes, rows=kept
    )


def triangles_of_faces(points: Floats, faces: Ids) -> Ids:
    """(3, T) int32 triangles of (4, n) faces, of which triangles repeat their last corner; see `triangles_of`."""
    ids = np.ascontiguousarray(faces.T).reshape(-1)
    return triangles_of(points, ids, range(0, len(ids), 4), np.where(faces[2] == faces[3], 3, 4))
