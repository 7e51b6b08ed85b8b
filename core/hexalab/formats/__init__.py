"""Mesh files: bytes in, `Mesh` out, and back (SPEC R).

>>> mesh = read_bytes(open("cube.mesh", "rb").read(), "cube.mesh")    # doctest: +SKIP
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import BinaryIO

from ..errors import MeshReadError, MeshWriteError
from ..mesh import Mesh
from .companions import beside, together
from .container import unwrapped
from .file import File
from .registry import FORMATS, Format, choose
from .writers import WRITERS, Writer, left_behind, packed, writer_of

__all__ = [
    "FORMATS",
    "WRITERS",
    "Format",
    "Writer",
    "left_behind",
    "read",
    "read_bytes",
    "write",
    "write_bytes",
    "writer_of",
]


def read_bytes(
    data: bytes | bytearray | memoryview,
    name: str = "",
    companions: Mapping[str, bytes | bytearray | memoryview] | None = None,
) -> Mesh:
    """Read a mesh from the bytes of a file.

    Parameters
    ----------
    data : bytes
        The file, gzipped or not. Anything else than `bytes` is copied once.
    name : str
        Its name: for messages, and its ending tells the format where the content does not.
    companions : dict of str to bytes, optional
        Files that it may refer to, by name, such as those that an Abaqus deck includes.

    Returns
    -------
    Mesh
        With `name`, `format` and `notes` set.

    Raises
    ------
    MeshReadError
        The bytes are no mesh that can be read; it names file, place, what was found and what was expected.
    """
    file = unwrapped(
        File(data if isinstance(data, bytes) else bytes(data), name, together(companions or {}, name))
    )
    del data
    return _read(file)


def _read(file: File) -> Mesh:
    """Read a file that is not wrapped."""
    try:
        mesh = choose(file).read(file)
    except MemoryError:
        raise file.error("there is not enough memory for this mesh") from None
    mesh.included = file.included
    return mesh


def read(file: str | os.PathLike[str] | BinaryIO) -> Mesh:
    """Read a mesh from a path or an open binary file; see `read_bytes`.

    Files that the file at a path refers to are read as well, out of its folder and the folders in that.
    """
    if isinstance(file, str | os.PathLike):
        path = Path(file)
        try:
            with open(path, "rb") as stream:
                data = stream.read()
        except OSError as error:
            raise MeshReadError(
                f"the file can't be read: {error.strerror or error}", file=str(path)
            ) from None
        return _read(unwrapped(File(data, path.name, beside(path))))
    return read_bytes(file.read(), str(getattr(file, "name", "")))


def write_bytes(mesh: Mesh, format_id: str) -> bytes:
    """The bytes of a file of that format (a row of WRITERS).

    Raises
    ------
    MeshWriteError
        The format is unknown or can't be written.
    ValueError
        An attribute that the mesh was given since it was made has not a row for each vertex or cell.
    """
    mesh.check_data()
    return writer_of(Path(), format_id).write(mesh)


def write(mesh: Mesh, path: str | os.PathLike[str], format_id: str | None = None) -> list[str]:
    """Write a mesh to a file.

    Parameters
    ----------
    mesh : Mesh
    path : str or path
        Its ending tells the format, if `format_id` does not; with .gz at its end the file is gzipped.
    format_id : str, optional
        Row of `WRITERS`, such as "msh2" for version 2.2 of Gmsh's format.

    Returns
    -------
    list of str
        A sentence for each thing of the mesh that the format has no place for; none if all of it was written.

    Raises
    ------
    MeshWriteError
        No format that can be written has that ending or id, or the file can't be written.
    ValueError
        An attribute that the mesh was given since it was made has not a row for each vertex or cell.
    """
    path = Path(path)
    row = writer_of(path, format_id)
    try:
        path.write_bytes(packed(write_bytes(mesh, row.id), path))
    except OSError as error:
        raise MeshWriteError(f"{path} can't be written: {error.strerror or error}") from None
    return left_behind(mesh, row)
