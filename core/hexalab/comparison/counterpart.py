"""What a mesh is compared with: another mesh, or a reference surface."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..arrays import Floats
from ..mesh import Mesh
from ..quality import quality
from ..reference import TriangleSurface, boundary_of
from .connectivity import difference_in_cells
from .triangle_index import TriangleIndex
from .volumes import volume_of

ROUNDING = 1e-9
"""A change of a metric by no more than this part of its values is none: files hold so many digits."""


@dataclass(frozen=True, eq=False)
class Counterpart:
    """The other of two that are compared.

    Parameters
    ----------
    name : str
        For the screen.
    surface : TriangleSurface
        What distances are measured to: a mesh's boundary, or the reference surface itself.
    mesh : Mesh, optional
        The other mesh, if it has the same cells as the one that is compared with it; None else.
    difference : str
        What tells the cells apart, where it is a mesh with others; "" for a reference surface.
    second : bool
        Whether this is the second of the two: changes are what the second has more than the first.
    volume : float, optional
        See `volume_of`.
    """

    name: str
    surface: TriangleSurface
    mesh: Mesh | None = None
    difference: str = ""
    second: bool = True
    volume: float | None = None

    @property
    def is_surface(self) -> bool:
        """Whether it is a reference surface, and no mesh."""
        return self.mesh is None and not self.difference

    @cached_property
    def index(self) -> TriangleIndex:
        """The surface's triangles, to be found by place."""
        return TriangleIndex(self.surface.points, self.surface.triangles)

    def change(self, mesh: Mesh, metric: str) -> Floats:
        """Subtract the first mesh's values of a metric from the second's.

        Parameters
        ----------
        mesh : Mesh
            The one that is compared with this, of the same cells.
        metric : str

        Returns
        -------
        (C,) float64
            See `change_of`.
        """
        ours, theirs = quality(mesh, metric), quality(self.same_cells, metric)
        return change_of(ours, theirs) if self.second else change_of(theirs, ours)

    def displacement(self, mesh: Mesh) -> Floats:
        """(V, 3) float64: way of each vertex from the first mesh to the second, in the file's unit."""
        way = self.same_cells.points - mesh.points
        return way if self.second else -way

    @property
    def same_cells(self) -> Mesh:
        """The mesh of the same cells; ValueError where there is none."""
        if self.mesh is None:
            raise ValueError(f"{self.name} has not the same cells: they can't be compared one by one")
        return self.mesh


def change_of(first: Floats, second: Floats) -> Floats:
    """Subtract values of the same cells, (C,) float64 each.

    Returns
    -------
    (C,) float64
        0 where they are the same but for `ROUNDING`; infinite where one of both is; NaN where both are NaN, as for a
        kind of cell that has not got the metric.

    >>> change_of(np.array([0.5, 1.0, np.inf]), np.array([0.75, 1.0 + 1e-12, np.inf])).tolist()
    [0.25, 0.0, 0.0]
    """
    with np.errstate(invalid="ignore", over="ignore"):
        change: Floats = second - first
        alike = np.abs(change) <= ROUNDING * np.maximum(np.abs(first), np.abs(second))
    change[alike & np.isfinite(change)] = 0.0
    change[first == second] = 0.0  # infinities of one sign
    return change


def counterpart_of(mesh: Mesh, other: Mesh | TriangleSurface, second: bool = True) -> Counterpart:
    """Make a mesh or a surface the counterpart of a mesh."""
    if isinstance(other, TriangleSurface):
        return Counterpart(other.name, other, second=second, volume=volume_of(other))
    difference = difference_in_cells(mesh, other)
    return Counterpart(
        other.name, boundary_of(other), None if difference else other, difference, second, volume_of(other)
    )


def moved(mesh: Mesh, coordinates: Floats, name: str = "") -> Mesh:
    """The same cells with vertices elsewhere: (3, V) float64; nothing else of the mesh comes along."""
    bare = replace(
        mesh, coordinates=coordinates, point_data={}, cell_data={}, notes=[], groups=(), features=()
    )
    bare.name = name
    return bare
