"""What `show` takes, as an offer: our mesh, a path, meshes of meshio and PyVista, arrays."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import HexaLabError
from ...formats import read
from ...formats.group_arrays import MARK
from ...mesh import Mesh
from ...reference import TriangleSurface
from ...session import prepared
from ..offers import AnyOffer, FileOffer, Offer, other_file

HEXAHEDRON = 8


@dataclass(frozen=True)
class MeshOffer:
    """A mesh that is in memory already."""

    given: Mesh
    name: str

    @cached_property
    def _prepared(self) -> Mesh:
        return prepared(self.given)

    def mesh(self) -> Mesh:
        """The mesh, `prepared`."""
        return self._prepared

    def hasher(self) -> Callable[[], str]:
        """It was read from no file."""
        return str

    def size(self) -> None:
        """It was read from no file."""


@dataclass(frozen=True)
class KnownSurface:
    """A reference surface that is in memory already."""

    given: TriangleSurface

    @property
    def name(self) -> str:
        """Shown to the user."""
        return self.given.name or "surface"

    def surface(self) -> TriangleSurface:
        """The surface."""
        return self.given

    def hasher(self) -> Callable[[], str]:
        """It was read from no file."""
        return str

    def size(self) -> None:
        """It was read from no file."""


def offer_of(thing: Any) -> Offer:
    """Make whatever is to be shown a mesh at hand.

    Parameters
    ----------
    thing : Mesh, path, meshio.Mesh, pyvista.UnstructuredGrid or (points, cells)
        Of arrays: (V, 3) coordinates and (C, 8) vertices of hexahedra.

    Raises
    ------
    HexaLabError
        It is none of these, or its arrays fit no mesh.
    MeshReadError
        It is a file that can't be read.
    """
    if isinstance(thing, Mesh):
        return MeshOffer(thing, thing.name or "mesh")
    if isinstance(thing, str | os.PathLike):
        offer = FileOffer(Path(thing), Path(thing).name)
        offer.mesh()
        return offer
    maker = type(thing).__module__.split(".")[0]
    if maker == "meshio" and hasattr(thing, "cells"):
        whole = _with_sets(thing)
        return MeshOffer(_through_file(lambda path: whole.write(path, file_format="vtu")), "meshio mesh")
    if maker == "pyvista" and hasattr(thing, "cast_to_unstructured_grid"):
        grid = thing.cast_to_unstructured_grid()
        return MeshOffer(_through_file(lambda path: grid.save(path, binary=True)), "PyVista mesh")
    if isinstance(thing, tuple | list) and len(thing) == 2:
        return MeshOffer(_of_arrays(*thing), "mesh")
    raise HexaLabError(
        f"found {type(thing).__module__}.{type(thing).__qualname__}, expected a Mesh, a path, a mesh of meshio or "
        "PyVista, or arrays (points, cells)"
    )


def counterpart_of(thing: Any) -> AnyOffer:
    """Make whatever a mesh is to be compared with an offer: as `offer_of`, or a reference surface, or a path to one."""
    if isinstance(thing, str | os.PathLike):
        return other_file(Path(thing))
    return KnownSurface(thing) if isinstance(thing, TriangleSurface) else offer_of(thing)


def _with_sets(mesh: Any) -> Any:
    """A mesh of meshio whose sets of cells and points are arrays of 0 and 1, as they are read from a file."""
    cells, points = dict(mesh.cell_data), dict(mesh.point_data)
    for name, parts in mesh.cell_sets.items():
        masks = [np.zeros(len(block.data), dtype=np.uint8) for block in mesh.cells]
        for mask, rows in zip(masks, parts, strict=True):
            if rows is not None:
                mask[np.asarray(rows, dtype=np.int64)] = 1
        cells[f"{MARK}set:{name}"] = masks
    for name, rows in mesh.point_sets.items():
        mask = np.zeros(len(mesh.points), dtype=np.uint8)
        mask[np.asarray(rows, dtype=np.int64)] = 1
        points[f"{MARK}set:{name}"] = mask
    return type(mesh)(mesh.points, mesh.cells, point_data=points, cell_data=cells)


def _through_file(write: Any) -> Mesh:
    """Another library's mesh by way of a file: all kinds of cells and all attributes come along as in any file."""
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "mesh.vtu")
        write(path)
        return read(path)


def _of_arrays(points: Any, cells: Any) -> Mesh:
    points, cells = np.asarray(points), np.asarray(cells)
    if points.ndim != 2 or points.shape[1] != 3:
        raise HexaLabError(f"points: found an array of shape {points.shape}, expected (V, 3)")
    if cells.ndim != 2 or cells.shape[1] != HEXAHEDRON:
        raise HexaLabError(f"cells: found an array of shape {cells.shape}, expected (C, 8)")
    if not np.issubdtype(cells.dtype, np.integer):
        raise HexaLabError(f"cells: found numbers of type {cells.dtype}, expected integers")
    return Mesh.from_cells(points, cells)
