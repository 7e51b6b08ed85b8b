"""A comparison as attributes of a mesh, for other programs."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from ..arrays import Array
from ..mesh import Mesh
from ..quality import METRICS, quality_many
from ..reference import TriangleSurface, boundary_of
from .counterpart import change_of, counterpart_of
from .distances import Measuring


def with_comparison(mesh: Mesh, other: Mesh | TriangleSurface, metrics: Iterable[str] = METRICS) -> Mesh:
    """Add what a comparison tells of vertices and cells to a mesh.

    Parameters
    ----------
    mesh : Mesh
        The first.
    other : Mesh or TriangleSurface
        The second.
    metrics : iterable of str
        Ids of the metrics whose changes are wanted.

    Returns
    -------
    Mesh
        With `distance` at its vertices, NaN inside. If the cells are the same, also with `displacement` (three
        components) at the vertices, and `change_METRIC` at the cells.
    """
    counterpart = counterpart_of(mesh, other)
    distances = Measuring(boundary_of(mesh), counterpart.index).finish().of_vertices(mesh.vertex_count)
    points: dict[str, Array] = {**mesh.point_data, "distance": distances}
    cells: dict[str, Array] = dict(mesh.cell_data)
    if counterpart.mesh is not None:
        points["displacement"] = counterpart.displacement(mesh)
        wanted = list(metrics)
        first, second = quality_many(mesh, wanted), quality_many(counterpart.mesh, wanted)
        cells.update({f"change_{metric}": change_of(first[metric], second[metric]) for metric in wanted})
    return replace(mesh, point_data=points, cell_data=cells)
