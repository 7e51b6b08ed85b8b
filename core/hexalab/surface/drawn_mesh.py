"""What all surfaces of one mesh share, kept as long as the mesh is open."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats, Ids
from ..mesh import Mesh
from ..topology import Topology
from .collapse import first_places
from .frame import Frame, frame_of
from .records import Floats32


def without_repeats(mesh: Mesh) -> Mesh:
    """The mesh with each cell that repeats another collapsed to a vertex, so that the other has faces of its own."""
    again = mesh.topology.repeated_cells
    if not len(again):
        return mesh
    corners = mesh.corners.copy()
    corners[:, again] = corners[0, again]
    return replace(mesh, corners=corners)


class DrawnMesh:
    """A mesh made ready to be drawn: `mesh`, in which each cell is there once, and the `whole` mesh it comes from.

    >>> drawn_mesh = DrawnMesh(mesh)
    >>> surface = extract_surface(drawn_mesh, shown, "lines")
    """

    def __init__(self, mesh: Mesh) -> None:
        self.whole = mesh
        self.mesh = without_repeats(mesh)

    @property
    def topology(self) -> Topology:
        """The mesh's topology."""
        return self.mesh.topology

    @cached_property
    def frame(self) -> Frame:
        """The box that drawing coordinates are made of."""
        return frame_of(self.whole)

    @cached_property
    def coordinates(self) -> Floats32:
        """(3, V) float32 drawing coordinates: the frame centred on the origin, its diagonal 1.

        One row for each axis: in WebAssembly three gathers of single numbers take half the time of one
        gather of rows.
        """
        out = np.empty((3, self.mesh.vertex_count), np.float32)
        centre, diagonal = self.frame.centre, self.frame.diagonal
        with np.errstate(all="ignore"):
            for axis in range(3):
                out[axis] = (self.mesh.coordinates[axis] - centre[axis]) / diagonal
        return out

    def exposed(self, rows: Array) -> NDArray[np.bool_]:
        """Which faces, by their rows, are not the mesh's own boundary: if they are drawn, filters expose them."""
        faces = self.topology.faces
        return np.asarray((rows < faces.paired) | (rows >= faces.boundary_end))

    def moved(self, cell: int) -> Floats:
        """(3,) float64: how far a cell is drawn from its place, in drawing coordinates."""
        del cell
        return np.zeros(3)

    def points(self, vertices: Array) -> Floats32:
        """Drawing coordinates of vertices of any shape, axis first."""
        out = np.empty((3, *vertices.shape), np.float32)
        for axis in range(3):
            out[axis] = self.coordinates[axis][vertices]
        return out

    def barycentres(self, cells: Array) -> Floats:
        """Mean of some cells' distinct corners in drawing coordinates, (3, n) float64."""
        corners: Ids = self.mesh.corners[:, cells]
        first = first_places(corners)
        weights = (np.arange(8)[:, None] == first) if first is not None else np.ones(corners.shape, bool)
        points = self.points(corners).astype(np.float64)
        return np.asarray((points * weights).sum(axis=1) / weights.sum(axis=0))
