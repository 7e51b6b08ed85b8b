"""All groups of a mesh (SPEC R12): the named ones of its file, and those that arrays of few whole numbers make."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .arrays import Array, Ids
from .errors import HexaLabError
from .groups import Group
from .mesh import Mesh

MOST_VALUES = 1000
"""An array of more different values than that makes no groups."""

SAMPLE = 4096
"""Values of an array that tell quickly that there are too many different ones."""

FEW = 16
"""So many groups are few, though each has one member."""

OWNERS = frozenset(("reference", "physical", "entity", "partition", "material", "attribute"))
"""Arrays that readers make of what a cell belongs to: groups of one cell are groups there too."""

NONE = frozenset(("physical", "partition"))
"""Arrays in which 0 says that a cell belongs to nothing."""

NOWHERE = -1


@dataclass(frozen=True, eq=False)
class Grouping:
    """Groups of one origin, which cells can be coloured by.

    Parameters
    ----------
    origin : str
    groups : tuple of Group
        Of cells.
    cell_count : int
    """

    origin: str
    groups: tuple[Group, ...]
    cell_count: int

    @cached_property
    def labels(self) -> Ids:
        """(C,) int32: place of each cell's group among them, -1 in none; in several, the one of fewest members."""
        out = np.full(self.cell_count, NOWHERE, dtype=np.int32)
        for place in sorted(range(len(self.groups)), key=lambda place: -self.groups[place].count):
            out[self.groups[place].members] = place
        return out

    @cached_property
    def in_several(self) -> int:
        """Number of cells that are in more than one of the groups."""
        times = np.zeros(self.cell_count, dtype=np.int32)
        for group in self.groups:
            times[group.members] += 1
        return int(np.count_nonzero(times > 1))


def groups_of(mesh: Mesh) -> tuple[Group, ...]:
    """List all groups of a mesh: named sets of cells and vertices, then those that arrays of cells make.

    An array makes a group of each of its values where they are whole numbers and few: at most `MOST_VALUES`, and, but
    for the arrays that say what a cell belongs to, no more than half as many as there are cells, or `FEW`. Of an
    origin that has named groups no array makes others.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    tuple of Group
        With ids of their own; groups without members are listed too.
    """
    return (*mesh.groups, *_of_arrays(mesh))


def group_of_cells(groups: Iterable[Group], name: str) -> Group:
    """Find a group of cells by its id, or by its name in any letter case.

    Raises
    ------
    HexaLabError
        There is none, or several are called so.
    """
    some = [group for group in groups if group.on == "cell"]
    found = [group for group in some if group.id == name] or [
        group for group in some if group.name.upper() == name.upper()
    ]
    if len(found) > 1:
        raise HexaLabError(
            f"several groups are called {name!r}: {', '.join(group.id for group in found)}, expected one of these"
        )
    if not found:
        known = ", ".join(group.id for group in some) or "none"
        raise HexaLabError(f"the mesh has no group {name!r}; it has {known}")
    return found[0]


def groupings(mesh: Mesh, groups: tuple[Group, ...]) -> dict[str, Grouping]:
    """Part the groups of cells by their origins, in order."""
    parted: dict[str, list[Group]] = {}
    for group in groups:
        if group.on == "cell":
            parted.setdefault(group.origin, []).append(group)
    return {origin: Grouping(origin, tuple(some), mesh.cell_count) for origin, some in parted.items()}


def _of_arrays(mesh: Mesh) -> Iterator[Group]:
    named = {group.origin for group in mesh.groups}
    for name, values in mesh.cell_data.items():
        if name not in named:
            yield from groups_by_value(name, np.asarray(values))


def feature_groups(data: Mapping[str, Array], groups: tuple[Group, ...]) -> tuple[Group, ...]:
    """All groups of features: the named ones, then those that their data make."""
    named = {group.origin for group in groups}
    made = (
        group
        for name, values in data.items()
        if name not in named
        for group in groups_by_value(name, np.asarray(values))
    )
    return (*groups, *made)


def groups_by_value(name: str, values: Array) -> Iterator[Group]:
    """The groups that an array of few whole numbers makes, in the order of its values; none of any other array.

    >>> [(group.id, group.members.tolist()) for group in groups_by_value("reference", np.array([7, 2, 7]))]
    [('reference:2', [1]), ('reference:7', [0, 2])]
    """
    whole = _whole(values)
    if whole is None:
        return
    most = MOST_VALUES if name in OWNERS else min(MOST_VALUES, max(FEW, len(whole) // 2))
    if len(np.unique(whole[:: max(1, len(whole) // SAMPLE)])) > most:
        return
    low, high = int(whole.min()), int(whole.max())
    if high - low < 2**15:
        short = (whole.astype(np.int64) - low).astype(
            np.int16
        )  # numpy sorts short integers by their digits, in one pass
        counts = np.bincount(short)
        found = np.flatnonzero(counts)
        sizes = counts[found]
    else:
        short = whole
        found, sizes = np.unique(whole, return_counts=True)
        found, low = found.astype(np.int64), 0
    if len(found) > most:
        return
    order = np.argsort(short, kind="stable").astype(np.int32)
    ends = np.cumsum(sizes)
    for value, end, size in zip(found.tolist(), ends.tolist(), sizes.tolist(), strict=True):
        number = value + low
        if number or name not in NONE:
            yield Group(str(number), name, order[end - size : end], number=number)


def _whole(values: Array) -> Array | None:
    """The values as integers; None if they are several in a row, or some are no whole numbers."""
    if values.ndim != 1 or not values.size:
        return None
    if values.dtype.kind == "b":
        return values.astype(np.int8)
    if values.dtype.kind in "iu":
        return values if values.dtype.kind == "i" or int(values.max()) < 2**63 else None
    for some in (values[:: max(1, len(values) // SAMPLE)], values):
        with np.errstate(invalid="ignore"):
            if not ((some % 1 == 0) & (np.abs(some) < 2**53)).all():
                return None
    return values.astype(np.int64)
