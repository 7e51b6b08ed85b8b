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

__all__ = ["FORMATS", "Format", "left_behind", "read", "read_bytes", "write", "write_bytes"]


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
        return choose(file).reader(file)
    except MemoryError:
        raise file.error("there is not enough memory for this mesh") from None


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
    """The bytes of a file of that format (a row of FORMATS that has a writer).

    Raises
    ------
    MeshWriteError
        The format is unknown or can't be written.
    ValueError
        An attribute that the mesh was given since it was made has not a row for each vertex or cell.
    """
    mesh.check_data()
    for row in FORMATS:
        if row.id == format_id and row.writer:
            return row.writer(mesh)
    known = ", ".join(row.id for row in FORMATS if row.writer)
    raise MeshWriteError(f"meshes can't be written as ‘{format_id}’, expected one of {known}")


def write(mesh: Mesh, path: str | os.PathLike[str]) -> None:
    """Write a mesh to a file; the path's ending tells the format.

    Parameters
    ----------
    mesh : Mesh
    path : str or path
        Ends in an extension of one of the `FORMATS` that have a writer.

    Raises
    ------
    MeshWriteError
        No format that can be written has that ending, or the file can't be written.
    ValueError
        An attribute that the mesh was given since it was made has not a row for each vertex or cell.
    """
    path = Path(path)
    row = _written_as(path)
    try:
        path.write_bytes(write_bytes(mesh, row.id))
    except OSError as error:
        raise MeshWriteError(f"{path} can't be written: {error.strerror or error}") from None


def left_behind(mesh: Mesh, path: str | os.PathLike[str]) -> list[str]:
    """Names of the mesh's attributes for which the format of a file to be written has no place.

    Raises
    ------
    MeshWriteError
        No format that can be written has the path's ending.
    """
    keeps = _written_as(Path(path)).keeps
    names = dict.fromkeys([*mesh.point_data, *mesh.cell_data])
    return [] if keeps is None else [name for name in names if name not in keeps]


def _written_as(path: Path) -> Format:
    """The format that the path's ending tells."""
    for row in FORMATS:
        if row.writer and path.suffix.lower() in row.extensions:
            return row
    known = ", ".join(extension for row in FORMATS if row.writer for extension in row.extensions)
    raise MeshWriteError(f"{path.name}: meshes can't be written with this ending, expected one of {known}")
