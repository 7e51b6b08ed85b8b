"""HexaLab: read, measure, filter and draw hexahedral meshes.

>>> mesh = hexalab.read("bunny.mesh")                                            # doctest: +SKIP
>>> hexalab.statistics(hexalab.quality(mesh, "scaled_jacobian"))["min"]          # doctest: +SKIP
"""

from __future__ import annotations

import os
from importlib import import_module
from typing import Any, BinaryIO

from . import formats
from .cell_lists import LIST_FORMS, cell_list
from .cells import KINDS
from .comparison import compare
from .diagnosis import Finding, diagnose, turn_round
from .errors import HexaLabError, MeshReadError, MeshWriteError
from .formats import FORMATS, WRITERS, write
from .grouping import groups_of
from .groups import Features, Group
from .mesh import Mesh
from .numbering import cell_numbers, cells_numbered, vertex_numbers, vertices_numbered
from .quality import METRICS, Metric, Validity, certify, histogram, quality, quality_many, statistics
from .reference import TriangleSurface, read_reference
from .selection import select_cells
from .structure import Structure, structure
from .summary import summarise

__version__ = "1.0.0"

__all__ = [
    "FORMATS",
    "KINDS",
    "LIST_FORMS",
    "METRICS",
    "WRITERS",
    "Features",
    "Finding",
    "Group",
    "HexaLabError",
    "Mesh",
    "MeshReadError",
    "MeshWriteError",
    "Metric",
    "Structure",
    "TriangleSurface",
    "Validity",
    "cell_list",
    "cell_numbers",
    "cells_numbered",
    "certify",
    "compare",
    "diagnose",
    "groups_of",
    "histogram",
    "quality",
    "quality_many",
    "read",
    "read_reference",
    "select_cells",
    "show",
    "statistics",
    "structure",
    "summarise",
    "vertex_numbers",
    "vertices_numbered",
    "write",
]


def read(file: str | os.PathLike[str] | BinaryIO) -> Mesh:
    """Read a mesh from a path or an open binary file, gzipped or not.

    A mesh whose every cell is inverted is turned round, and `Mesh.notes` says so.

    Parameters
    ----------
    file : str, path or binary file
        The content decides on the format; a name's ending only where the content does not tell.

    Returns
    -------
    Mesh

    Raises
    ------
    MeshReadError
        If it is no mesh that can be read: file, place, what was found and what was expected.
    """
    return turn_round(formats.read(file))


def show(mesh: Any, status: dict[str, Any] | None = None, *, compare: Any = None, height: int = 520) -> Any:
    """Show a mesh in a notebook: Jupyter, VS Code, Colab, marimo.

    Parameters
    ----------
    mesh : Mesh, path, meshio.Mesh, pyvista.UnstructuredGrid or (points, cells)
        Of arrays: (V, 3) coordinates and (C, 8) vertices of hexahedra.
    status : dict, optional
        Settings, whole or in part.
    compare : Mesh, TriangleSurface, path, ..., optional
        Another mesh, shown beside it, or a surface that it is measured against.
    height : int
        Of the view, in pixels.

    Returns
    -------
    View
        The widget: `view.status` are all settings, to read and to set; `view.picked` is the cell in the inspector;
        `view.screenshot()` gives a PNG.

    Raises
    ------
    HexaLabError
        It can't be shown: what was found, and what is taken.
    MeshReadError
        It is a file that can't be read.
    ImportError
        The widget's packages are not installed: ``pip install 'hexalab[notebook]'``.
    """
    try:
        view = import_module("hexalab.hosts.notebook.widget").View
    except ModuleNotFoundError as error:
        raise ImportError(f"show needs the package {error.name}: pip install 'hexalab[notebook]'") from None
    meshes = import_module("hexalab.hosts.notebook.meshes")
    other = None if compare is None else meshes.counterpart_of(compare)
    return view(meshes.offer_of(mesh), status, height, other)
