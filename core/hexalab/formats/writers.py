"""The formats that are written, as rows of a table, and what each has no place for."""

from __future__ import annotations

import gzip
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from ..arrays import Array
from ..errors import MeshWriteError
from ..grouping import Grouping
from ..groups import Group
from ..mesh import Mesh
from ..topology.lookup import sides_of
from . import gmsh_entities, write_abaqus, write_gmsh, write_medit, write_meditb, write_vtk, write_vtu
from .medit_features import REFERENCE
from .writing import numbers_kept
from .written_groups import numbered, tags_of

MOST_NAMES = 6


def everything(_on: str, _name: str, _values: Array) -> bool:
    """All attributes have a place."""
    return True


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
    any_number : bool
        Whether nodes and elements may have any whole numbers, several the same.
    memberships : {"all", "one", "number"}
        Of the groups that a cell is in, what has a place: all, the name of one, or one number.
    nodes : bool
        Whether groups of vertices have a place.
    dimensions : tuple of int
        Which features have a place.
    faces_of_cells : bool
        Whether faces have one only where they are those of cells.
    """

    id: str
    format: str
    name: str
    extension: str
    write: Callable[[Mesh], bytes]
    keeps: Callable[[str, str, Array], bool] = everything
    largest_number: int = 0
    in_order: bool = True
    any_number: bool = False
    memberships: Literal["all", "one", "number"] = "all"
    nodes: bool = True
    dimensions: tuple[int, ...] = (0, 1, 2)
    faces_of_cells: bool = False


WRITERS: tuple[Writer, ...] = (
    Writer(
        "mesh", "mesh", "Medit ASCII", ".mesh", write_medit.write, references,
        in_order=False, memberships="number", nodes=False,
    ),
    Writer("vtk", "vtk", "VTK legacy 5.1, binary", ".vtk", write_vtk.write, any_number=True),
    Writer("vtu", "vtu", "VTK XML", ".vtu", write_vtu.write, any_number=True),
    Writer(
        "meshb", "meshb", "Medit binary", ".meshb", write_meditb.write, references,
        in_order=False, memberships="number", nodes=False,
    ),
    Writer(
        "msh",
        "msh",
        "Gmsh 4.1, ASCII",
        ".msh",
        write_gmsh.write_4,
        write_gmsh.keeps,
        gmsh_entities.LARGEST_NUMBER,
        nodes=False,
    ),
    Writer(
        "msh2",
        "msh",
        "Gmsh 2.2, ASCII",
        ".msh",
        write_gmsh.write_2,
        write_gmsh.keeps,
        gmsh_entities.LARGEST_NUMBER,
        memberships="one",
        nodes=False,
    ),
    Writer(
        "inp",
        "inp",
        "Abaqus",
        ".inp",
        write_abaqus.write,
        write_abaqus.keeps,
        write_abaqus.LARGEST_NUMBER,
        dimensions=(2,),
        faces_of_cells=True,
    ),
)  # fmt: skip
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
    out += [*_numbers_lost(mesh, row), *groups_lost(mesh, row), *features_lost(mesh, row)]
    if not row.in_order and len(set(mesh.kinds.tolist())) > 1 and (mesh.kinds[1:] < mesh.kinds[:-1]).any():
        out.append(f"{row.name} groups cells by their kind: their order is another.")
    return out


def _numbers_lost(mesh: Mesh, row: Writer) -> Iterator[str]:
    for what, numbers in (("nodes", mesh.vertex_numbers), ("elements", mesh.cell_numbers)):
        if row.any_number:
            continue
        if numbers is not None and not row.largest_number:
            yield f"{row.name} has no place for the numbers of {what}: they are counted from the first on."
        elif not numbers_kept(numbers, row.largest_number):
            yield (
                f"Numbers of {what} that occur twice, or are not 1 to {row.largest_number:,}, can't be written as "
                f"{row.name}: all are counted from 1."
            )


def groups_lost(mesh: Mesh, row: Writer) -> Iterator[str]:
    """What of the named groups a format has no place for."""
    cells = [group for group in mesh.groups if group.on == "cell"]
    nodes = [group for group in mesh.groups if group.on == "vertex"]
    if nodes and not row.nodes:
        yield f"{row.name} has no place for sets of nodes: {names_told(nodes)} left out."
    if row.memberships == "one":
        several = Grouping("", tuple(cells), mesh.cell_count).in_several
        if several:
            yield (
                f"{row.name} has one group for each element: {several:,} that are in several belong to the "
                "one of fewest members."
            )
    elif row.memberships == "number" and cells:
        kept: list[Group] = []
        if not write_medit.has_references(mesh):
            kept, _ = numbered(cells, mesh.cell_count)
            if kept:
                pairs = zip(kept, tags_of(kept), strict=True)
                told = ", ".join(f"{number} is {group.name}" for group, number in list(pairs)[:MOST_NAMES])
                more = f" and {len(kept) - MOST_NAMES} more" if len(kept) > MOST_NAMES else ""
                yield f"{row.name} has one number for each element and no names: {told}{more}."
        lost = [group for group in cells if group not in kept and not told_by_array(mesh, group)]
        if lost:
            yield f"{row.name} has no place for the groups {names_told(lost)}: left out."


def told_by_array(mesh: Mesh, group: Group) -> bool:
    """Whether the attribute "reference" tells the group."""
    return group.origin == REFERENCE and write_medit.has_references(mesh)


def features_lost(mesh: Mesh, row: Writer) -> Iterator[str]:
    """What of the elements of lower dimension a format has no place for."""
    lost = [f"{part.count:,} {part.called}" for part in mesh.features if part.dimension not in row.dimensions]
    if lost:
        yield f"{row.name} has no place for elements of lower dimension: {', '.join(lost)} left out."
    for part in mesh.features if row.faces_of_cells else ():
        if part.dimension == 2:
            cells, _ = sides_of(mesh.corners, mesh.vertex_count, part.corners)
            count = int(np.count_nonzero(cells < 0))
            if count:
                others = "other is" if count == 1 else "others are"
                yield f"{row.name} has surfaces of faces of cells: {count:,} {others} left out."


def names_told(groups: Sequence[Group]) -> str:
    """The names of groups, the first few of them."""
    more = f" and {len(groups) - MOST_NAMES} more" if len(groups) > MOST_NAMES else ""
    return ", ".join(group.name for group in groups[:MOST_NAMES]) + more
