"""Surfaces in the formats of meshes: the faces of a file without cells, or the boundary of a volumetric mesh."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..diagnosis import turn_round
from ..errors import MeshReadError, NoCellsError
from ..formats.file import File
from ..formats.foreign import foreign
from ..formats.registry import HEAD, Format, choose
from .polygons import finished
from .registry import endings
from .surface import TriangleSurface, boundary_of, triangles_of_faces


def read(file: File) -> TriangleSurface:
    """Read a file of any format of meshes; raises MeshReadError."""
    try:
        mesh = turn_round(format_of(file).read(file))
    except NoCellsError as error:
        return faces_alone(error)
    surface = boundary_of(mesh)
    if not surface.count:
        raise file.error("the cells of the mesh leave no face on its boundary, expected a surface")
    cells = "cell" if mesh.cell_count == 1 else "cells"
    note = f"The surface is the boundary of a volumetric mesh of {mesh.cell_count:,} {cells}."
    return replace(surface, name=file.name, notes=[*surface.notes, note])


def format_of(file: File) -> Format:
    """The format of a mesh; that it is unknown is told with the endings of surfaces, too."""
    try:
        return choose(file)
    except MeshReadError:
        if foreign(file.data[:HEAD], file.name, len(file.data)):
            raise
        raise file.error(
            f"neither the content nor the name tells of a known format, expected one of {endings()}"
        ) from None


def faces_alone(found: NoCellsError) -> TriangleSurface:
    """Make the triangles and quadrilaterals of a file without cells a surface.

    Raises
    ------
    MeshReadError
        It has none of them either.
    """
    name = found.file
    faces = next((part.corners for part in found.features if part.dimension == 2), None)
    if faces is None:
        raise MeshReadError(
            "the file has neither faces nor volumetric cells, expected a surface or a mesh", file=name
        )
    triangles = triangles_of_faces(found.coordinates, np.ascontiguousarray(faces))
    return finished(name, found.format, found.coordinates, triangles, list(found.notes))
