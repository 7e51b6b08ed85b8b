"""Cells as a text that other programs take: a list of numbers, an element set, a physical group, a selection."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .arrays import Array
from .errors import HexaLabError
from .mesh import Mesh
from .numbering import cell_numbers

PER_LINE = 16
"""Numbers on a line of *ELSET (Abaqus Keywords Guide)."""


@dataclass(frozen=True)
class ListForm:
    """One way to write cells.

    Parameters
    ----------
    id : str
    name : str
        What a user calls it.
    by_row : bool
        Whether cells are told by their rows from 0; else by the file's numbers.
    write : callable
        Numbers or rows and a name in, text out.
    """

    id: str
    name: str
    by_row: bool
    write: Callable[[Array, str], str]


def _plain(numbers: Array, _name: str) -> str:
    return "\n".join(map(str, numbers.tolist())) + "\n" if len(numbers) else ""


def _elset(numbers: Array, name: str) -> str:
    lines = [f"*ELSET, ELSET={name}"]
    for start in range(0, len(numbers), PER_LINE):
        lines.append(", ".join(map(str, numbers[start : start + PER_LINE].tolist())))
    return "\n".join(lines) + "\n"


def _physical_group(numbers: Array, name: str) -> str:
    """A script for Gmsh's Python interface: a group is made of entities, so the elements get one of their own."""
    return (
        "# after gmsh.initialize() and gmsh.open(...)\n"
        f"elements = {numbers.tolist()}\n"
        "entity = gmsh.model.addDiscreteEntity(3)\n"
        "for tag in elements:\n"
        "    kind, nodes, _, before = gmsh.model.mesh.getElement(tag)\n"
        "    gmsh.model.mesh.removeElements(3, before, [tag])\n"
        "    gmsh.model.mesh.addElementsByType(entity, kind, [tag], nodes)\n"
        f'gmsh.model.addPhysicalGroup(3, [entity], name="{name}")\n'
    )


def _paraview(rows: Array, _name: str) -> str:
    """A query as ParaView's Find Data makes it of "is one of"; its ids are rows from 0."""
    return f"isin(id, [{', '.join(map(str, rows.tolist()))}])\n"


LIST_FORMS: tuple[ListForm, ...] = (
    ListForm("list", "List of numbers", False, _plain),
    ListForm("elset", "Abaqus *ELSET", False, _elset),
    ListForm("gmsh", "Gmsh physical group", False, _physical_group),
    ListForm("paraview", "ParaView ids", True, _paraview),
)
"""The ways, as rows with `id`, `name` and more."""


def cell_list(mesh: Mesh, cells: ArrayLike, form: str = "list", name: str = "cells") -> str:
    """Write cells as a text that other programs take.

    Parameters
    ----------
    mesh : Mesh
    cells : (n,) int
        Rows of cells.
    form : str
        Id of a row of `LIST_FORMS`.
    name : str
        What the set is called, where it is called anything.

    Returns
    -------
    str

    Raises
    ------
    HexaLabError
        There is no such form.

    >>> mesh = Mesh.from_cells(np.zeros((8, 3)), [[0, 1, 2, 3, 4, 5, 6, 7]] * 2, first_number=1)
    >>> print(cell_list(mesh, [0, 1], "elset", "WORST"), end="")
    *ELSET, ELSET=WORST
    1, 2
    """
    rows = np.asarray(cells, dtype=np.int64)
    for row in LIST_FORMS:
        if row.id == form:
            return row.write(rows if row.by_row else cell_numbers(mesh, rows), name)
    raise HexaLabError(
        f"cells can't be listed as {form!r}, expected one of {', '.join(row.id for row in LIST_FORMS)}"
    )
