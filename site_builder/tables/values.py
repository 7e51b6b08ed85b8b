"""What stands in a row of the table of meshes: functions that read it from what is known of the mesh."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ..model.catalogue import MeshEntry
from ..model.facts import Facts

Value = str | int | float | bool | None
"""What stands in a cell of the table; None where there is nothing, or nobody knows."""


@dataclass(frozen=True)
class Row:
    """A mesh, and where the site is.

    Parameters
    ----------
    mesh : MeshEntry
    root : str
        Address of the site, ending in a slash.
    pictured : bool
        Whether the site has a picture of the mesh.
    """

    mesh: MeshEntry
    root: str
    pictured: bool


def of_source(name: str) -> Callable[[Row], Value]:
    """What a mesh's source says of itself."""
    return lambda row: getattr(row.mesh.source, name) or None


def fact(name: str) -> Callable[[Row], Value]:
    """A fact, by its name."""

    def value(row: Row) -> Value:
        found: Value = getattr(row.mesh.facts, name)
        return found

    return value


def kind(name: str) -> Callable[[Row], Value]:
    """How many cells are of a kind."""
    return lambda row: None if row.mesh.facts.kinds is None else row.mesh.facts.kinds.get(name, 0)


def extent(axis: int) -> Callable[[Row], Value]:
    """The extent along an axis, in the unit of the file."""

    def value(row: Row) -> Value:
        box = row.mesh.facts.extent
        return box[1][axis] - box[0][axis] if box else None

    return value


def validity(name: str) -> Callable[[Row], Value]:
    """How many cells are certified valid, invalid, or neither."""

    def value(row: Row) -> Value:
        counts: dict[str, Any] = {**(row.mesh.facts.validity or {})}
        return counts.get(name)

    return value


def traced(*path: str) -> Callable[[Row], Value]:
    """A figure of the structure; None where there was no cell to trace it through."""

    def value(row: Row) -> Value:
        found: Any = row.mesh.facts.structure
        if row.mesh.facts.blocks is None:
            return None
        for name in path:
            found = found.get(name) if found else None
        result: Value = found
        return result

    return value


def irregular_edge_share(row: Row) -> Value:
    """The part of the interior edges that is irregular."""
    return irregular_share(row.mesh.facts)


def irregular_share(facts: Facts) -> float | None:
    """The part of the interior edges that is irregular, 0 to 1."""
    irregular, edges = facts.irregular_edges, facts.interior_edges
    return None if irregular is None or not edges else irregular / edges


def same_as(row: Row) -> Value:
    """The id of the row that is this mesh in another format."""
    return f"{row.mesh.source.slug}/{row.mesh.same_as}" if row.mesh.same_as else None


def depth(row: Row) -> Value:
    """The largest hop distance of a cell from the boundary."""
    layers = row.mesh.facts.cells_per_depth
    return len(layers) - 1 if layers else None


def findings(row: Row) -> Value:
    """The ids of what the diagnosis found."""
    found = row.mesh.facts.findings
    return None if found is None else " ".join(finding["id"] for finding in found)


def address(row: Row) -> Value:
    """Where the file is."""
    return row.mesh.remote or row.root + row.mesh.file_address
