"""A mesh as rows of VTK's cells, for both of its formats: cells, then features, each with what is known of it.

Groups become arrays of 0 and 1 (`group_arrays`), the file's own numbers global ids. An array that says something of
features alone is 0 of cells, and the other way round, or NaN where it has no whole numbers.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..cells import CORNERS_OF_KIND, HEXAHEDRON
from ..groups import Features
from ..mesh import Mesh
from ..numbering import cell_numbers, vertex_numbers
from .group_arrays import MARK, group_arrays

TYPES_OF_KINDS = (12, 13, 14, 10)
"""VTK's cell type for each kind."""

TYPES_OF_FEATURES = {(0, 1): 1, (1, 2): 3, (2, 3): 5, (2, 4): 9}
"""VTK's cell type for each dimension and number of corners."""

NODE_IDS, ELEMENT_IDS = "GlobalNodeId", "GlobalElementId"
"""Names of the arrays of numbers, as VTK's Exodus reader calls them."""


@dataclass
class Grid:
    """What both formats write.

    Parameters
    ----------
    offsets : (n + 1,) int64
    ids : (m,) int32
    types : (n,) uint8
    point_data, cell_data : dict of str to arrays
    point_ids, cell_ids : (V,), (n,) int64 or None
    """

    offsets: NDArray[np.int64]
    ids: NDArray[np.int32]
    types: NDArray[np.uint8]
    point_data: dict[str, Array]
    cell_data: dict[str, Array]
    point_ids: NDArray[np.int64] | None
    cell_ids: NDArray[np.int64] | None


def grid_of(mesh: Mesh) -> Grid:
    """The rows of a mesh."""
    offsets, ids = connectivity(mesh)
    types = np.array(TYPES_OF_KINDS, dtype=np.uint8)[mesh.kinds]
    point_data = {**mesh.point_data, **group_arrays(mesh, "vertex")}
    cell_data = {**mesh.cell_data, **group_arrays(mesh, "cell")}
    point_ids = vertex_numbers(mesh) if told(mesh, mesh.vertex_numbers) else None
    cell_ids = cell_numbers(mesh) if told(mesh, mesh.cell_numbers) else None
    for features in mesh.features:
        for part, size in parted(features):
            rows = features.corners[:size, part]
            ends = offsets[-1] + size * np.arange(1, len(part) + 1)
            offsets = np.concatenate([offsets, ends])
            ids = np.concatenate([ids, rows.T.reshape(-1)])
            number = TYPES_OF_FEATURES[features.dimension, size]
            types = np.concatenate([types, np.full(len(part), number, dtype=np.uint8)])
            cell_data = extended(cell_data, arrays_of(features, part), len(types) - len(part), len(part))
            if cell_ids is not None:
                more = int(cell_ids.max(initial=0)) + np.arange(1, len(part) + 1)
                cell_ids = np.concatenate([cell_ids, more])
    return Grid(offsets, ids, types, point_data, cell_data, point_ids, cell_ids)


def told(mesh: Mesh, numbers: Array | None) -> bool:
    """Whether numbers have to be written: they are not the rows from 0 on, which VTK counts by itself."""
    return numbers is not None or mesh.first_number != 0


def parted(features: Features) -> list[tuple[Array, int]]:
    """Which features have how many corners: triangles and quadrilaterals are rows of different types."""
    if features.dimension < 2:
        return [(np.arange(features.count), features.dimension + 1)]
    triangle = features.corners[2] == features.corners[3]
    parts = [(np.flatnonzero(triangle), 3), (np.flatnonzero(~triangle), 4)]
    return [(part, size) for part, size in parts if len(part)]


def arrays_of(features: Features, part: Array) -> dict[str, Array]:
    """What is known of some of the features."""
    out = {name: np.asarray(values)[part] for name, values in features.data.items()}
    for group in features.groups:
        mask = np.zeros(features.count, dtype=np.uint8)
        mask[group.members] = 1
        out[MARK + group.id] = mask[part]
    return out


def extended(data: dict[str, Array], more: dict[str, Array], before: int, count: int) -> dict[str, Array]:
    """Arrays of so many rows with those of the rows that follow."""
    out = {}
    for name, values in data.items():
        rest = more.get(name)
        if rest is None or values.ndim > 1:
            missing = 0 if values.dtype.kind in "iub" else np.nan
            rest = np.full((count, *values.shape[1:]), missing, dtype=values.dtype)
        out[name] = np.concatenate([values, rest])
    for name, values in more.items():
        if name not in out:
            out[name] = np.concatenate([np.zeros(before, dtype=values.dtype), values])
    return out


def connectivity(mesh: Mesh) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    """Offsets (C + 1) and vertex ids of the cells' own corners, in VTK's order, cell after cell."""
    sizes = np.array([len(own) for own in CORNERS_OF_KIND])[mesh.kinds]
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    ids = np.empty(int(offsets[-1]), dtype=np.int32)
    if (mesh.kinds == HEXAHEDRON).all():
        ids.reshape(-1, 8)[:] = mesh.corners.T
        return offsets, ids
    for kind, own in enumerate(CORNERS_OF_KIND):
        which = np.flatnonzero(mesh.kinds == kind)
        for number, place in enumerate(own):
            ids[offsets[which] + number] = mesh.corners[place][which]
    return offsets, ids
