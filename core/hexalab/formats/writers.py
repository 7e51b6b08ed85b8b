"""The formats that are written, as rows of a table, and what each has no place for."""

from __future__ import annotations

import gzip
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ..arrays import Array
from ..errors import MeshWriteError
from ..mesh import Mesh
from . import write_abaqus, write_gmsh, write_medit, write_meditb, write_vtk, write_vtu
from .medit import REFERENCE
from .writing import numbers_kept


def everything(_on: str, _name: str, _values: Array) -> bool:
    """All attributes have a place."""
    return True


def nothing(_on: str, _name: str, _values: Array) -> bool:
    """No attribute has a place."""
    return False


def references(_on: str, name: str, values: Array) -> bool:
    """Medit's one whole number for each vertex and cell."""
    return name == REFERENCE and values.ndim == 1 and values.dtype.kind in "iu"


@dataclass(frozen=True)
class Writer:
    """One way to write a mesh.

    Parameters
    ----------
    id : str
        Short name, for `write_bytes` and `hexalab convert --format`.
    format : str
        Row of `FORMATS` that reads it.
    name : str
        What a user calls it.
    extension : str
        Ending of file names, with the dot; the first row that has it is meant by it.
    write : callable
        Mesh in, bytes out.
    keeps : callable
        Whether an attribute has a place: "point" or "cell", name, values.
    largest_number : int
        Up to which number nodes and elements can have their own; 0 if they can't have any.
    in_order : bool
        Whether cells of several kinds stay in their order.
    """

    id: str
    format: str
    name: str
    extension: str
    write: Callable[[Mesh], bytes]
    keeps: Callable[[str, str, Array], bool] = everything
    largest_number: int = 0
    in_order: bool = True


WRITERS: tuple[Writer, ...] = (
    Writer("mesh", "mesh", "Medit ASCII", ".mesh", write_medit.write, references, in_order=False),
    Writer("vtk", "vtk", "VTK legacy 5.1, binary", ".vtk", write_vtk.write),
    Writer("vtu", "vtu", "VTK XML", ".vtu", write_vtu.write),
    Writer("meshb", "meshb", "Medit binary", ".meshb", write_meditb.write, references, in_order=False),
    Writer(
        "msh",
        "msh",
        "Gmsh 4.1, ASCII",
        ".msh",
        write_gmsh.write_4,
        write_gmsh.keeps,
        write_gmsh.LARGEST_NUMBER,
    ),
    Writer(
        "msh2",
        "msh",
        "Gmsh 2.2, ASCII",
        ".msh",
        write_gmsh.write_2,
        write_gmsh.keeps,
        write_gmsh.LARGEST_NUMBER,
    ),
    Writer("inp", "inp", "Abaqus", ".inp", write_abaqus.write, nothing, write_abaqus.LARGEST_NUMBER),
)
"""The formats that are written."""


def writer_of(path: Path, format_id: str | None = None) -> Writer:
    """The row of that id, or the one that the path's ending tells, gzipped or not.

    Raises
    ------
    MeshWriteError
        There is none.
    """
    if format_id is not None:
        for row in WRITERS:
            if row.id == format_id:
                return row
        known = ", ".join(row.id for row in WRITERS)
        raise MeshWriteError(f"meshes can't be written as ‘{format_id}’, expected one of {known}")
    name = path.name.lower().removesuffix(".gz")
    for row in WRITERS:
        if name.endswith(row.extension):
            return row
    known = ", ".join(dict.fromkeys(row.extension for row in WRITERS))
    raise MeshWriteError(f"{path.name}: meshes can't be written with this ending, expected one of {known}")


def packed(data: bytes, path: Path) -> bytes:
    """The bytes of the file at the path: gzipped if its name says so; the same each time."""
    return gzip.compress(data, mtime=0) if path.suffix.lower() == ".gz" else data


def left_behind(mesh: Mesh, row: Writer) -> list[str]:
    """What a mesh has and a file of that format will not have, a sentence for each."""
    lost = [
        f"{name} (of {'vertices' if on == 'point' else 'cells'})"
        for on, data in (("point", mesh.point_data), ("cell", mesh.cell_data))
        for name, values in data.items()
        if not row.keeps(on, name, values)
    ]
    out = [f"{row.name} has no place for the attributes {', '.join(lost)}: left out."] if lost else []
    for what, numbers in (("nodes", mesh.vertex_numbers), ("elements", mesh.cell_numbers)):
        if numbers is not None and not row.largest_number:
            out.append(
                f"{row.name} has no place for the numbers of {what}: they are counted from the first on."
            )
        elif not numbers_kept(numbers, row.largest_number):
            out.append(
                f"Numbers of {what} that occur twice, or are not 1 to {row.largest_number:,}, can't be written as "
                f"{row.name}: all are counted from 1."
            )
    if not row.in_order and len(set(mesh.kinds.tolist())) > 1 and (mesh.kinds[1:] < mesh.kinds[:-1]).any():
        out.append(f"{row.name} groups cells by their kind: their order is another.")
    return out
