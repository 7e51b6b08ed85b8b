"""Surfaces that a mesh is measured against: bytes in, `TriangleSurface` out.

>>> surface = read_reference("bunny.stl")                                          # doctest: +SKIP
>>> surface.count, surface.closed, surface.area                                    # doctest: +SKIP
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import BinaryIO

from ..errors import MeshReadError
from ..formats.companions import beside, together
from ..formats.container import unwrapped
from ..formats.file import File
from .others import faces_alone
from .others import read as read_other
from .registry import REFERENCE_FORMATS, ReferenceFormat, format_of, is_surface
from .surface import TriangleSurface, boundary_of

__all__ = [
    "REFERENCE_FORMATS",
    "ReferenceFormat",
    "TriangleSurface",
    "boundary_of",
    "faces_alone",
    "is_surface",
    "read_reference",
    "read_reference_bytes",
]


def read_reference_bytes(
    data: bytes | bytearray | memoryview,
    name: str = "",
    companions: Mapping[str, bytes | bytearray | memoryview] | None = None,
) -> TriangleSurface:
    """Read a surface from the bytes of a file; what is read, returned and raised is as for `read_reference`.

    Parameters
    ----------
    data : bytes
        The file, gzipped or not.
    name : str
        Its name: for messages, and its ending tells the format where the content does not.
    companions : dict of str to bytes, optional
        Files that it may refer to, by name, such as those that an Abaqus deck includes.
    """
    whole = data if isinstance(data, bytes) else bytes(data)
    return _read(File(whole, name, together(companions or {}, name)))


def read_reference(file: str | os.PathLike[str] | BinaryIO) -> TriangleSurface:
    """Read a surface from a path or an open binary file, gzipped or not.

    Parameters
    ----------
    file : str, path or binary file
        STL, OBJ, OFF, PLY, polygons of VTK, or any format of meshes: of a volumetric mesh the boundary is taken, and
        `TriangleSurface.notes` says so.

    Returns
    -------
    TriangleSurface
        With at least one triangle.

    Raises
    ------
    MeshReadError
        If it is no surface that can be read: file, place, what was found and what was expected.
    """
    if isinstance(file, str | os.PathLike):
        path = Path(file)
        try:
            data = path.read_bytes()
        except OSError as error:
            raise MeshReadError(
                f"the file can't be read: {error.strerror or error}", file=str(path)
            ) from None
        return _read(File(data, path.name, beside(path)))
    return read_reference_bytes(file.read(), str(getattr(file, "name", "")))


def _read(file: File) -> TriangleSurface:
    """Read a file that may be gzipped."""
    file = unwrapped(file)
    row = format_of(file.data, file.name)
    try:
        return row.read(file) if row else read_other(file)
    except MemoryError:
        raise file.error("there is not enough memory for this surface") from None
