"""What a mesh may be compared with, read from a file: another mesh, or a reference surface."""

from __future__ import annotations

import os
from pathlib import Path

from ..diagnosis import turn_round
from ..errors import MeshReadError, NoCellsError
from ..formats import read
from ..mesh import Mesh
from ..reference import TriangleSurface, faces_alone, is_surface, read_reference

HEAD = 8192
"""Bytes by which a surface is told from a mesh."""


def read_body(path: str | os.PathLike[str]) -> Mesh | TriangleSurface:
    """Read a mesh; or a surface, where the file has no volumetric cells.

    Raises
    ------
    MeshReadError
        It is neither.
    """
    if holds_surface(path):
        return read_reference(path)
    try:
        return turn_round(read(path))
    except NoCellsError as found:
        return faces_alone(found)


def holds_surface(path: str | os.PathLike[str]) -> bool:
    """Whether a file is of a format that holds surfaces alone, by its first bytes and its name.

    Raises
    ------
    MeshReadError
        It can't be read.
    """
    try:
        with open(path, "rb") as file:
            return is_surface(file.read(HEAD), Path(path).name)
    except OSError as error:
        raise MeshReadError(f"the file can't be read: {error.strerror or error}", file=str(path)) from None
