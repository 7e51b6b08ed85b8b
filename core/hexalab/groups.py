"""Named sets of cells or vertices (SPEC R12), and elements of lower dimension with theirs (R13)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from .arrays import Array, Ids

On = Literal["cell", "vertex"]

DIMENSIONS = ("corners", "edges", "faces")
"""What features of dimension 0, 1 and 2 are called."""

CORNERS_OF_DIMENSION = (1, 2, 4)
"""How many rows the corners of features have: a triangle repeats its last one."""


@dataclass(frozen=True, eq=False)
class Group:
    """A named set of cells, of vertices, or of features.

    Parameters
    ----------
    name : str
        The file's name for it.
    origin : str
        What kind of set it is in the file: "elset", "nset", "material", "instance", "part", "surface", "physical",
        "ridges", ...; for a set that an array of whole numbers tells, the array's name.
    members : (n,) int32
        Rows, rising, each once.
    on : "cell" or "vertex"
        What the members are; those of features are features.
    number : int, optional
        What the file knows it by beside its name: the tag of a physical group, the value in an array.

    Examples
    --------
    >>> Group("STEEL", "elset", [4, 1, 4]).members.tolist()
    [1, 4]
    """

    name: str
    origin: str
    members: Array
    on: On = "cell"
    number: int | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "members", rising(self.members))

    @property
    def id(self) -> str:
        """Name for programs and for settings documents: "elset:STEEL"."""
        return f"{self.origin}:{self.name}"

    @property
    def count(self) -> int:
        """Number of members."""
        return len(self.members)

    def has(self, row: int) -> bool:
        """Whether a row is a member."""
        place = int(np.searchsorted(self.members, row))
        return place < self.count and int(self.members[place]) == row

    def among(self, place: Ids) -> Group:
        """The same group of other rows: `place` has the new row of each old one, -1 where it is gone."""
        rows = place[self.members]
        return Group(self.name, self.origin, rows[rows >= 0], self.on, self.number)


def rising(members: ArrayLike) -> Ids:
    """Rows as int32, rising, each once; raises ValueError where they are no whole numbers from 0 on."""
    rows = np.asarray(members)
    if not rows.size:
        return np.zeros(0, dtype=np.int32)
    if rows.ndim != 1 or rows.dtype.kind not in "iu" or int(rows.min()) < 0 or int(rows.max()) >= 2**31:
        raise ValueError(f"members must be (n,) rows from 0 on, not {rows.shape} {rows.dtype}")
    if not (np.diff(rows) > 0).all():
        rows = np.unique(rows)
    return rows.astype(np.int32, copy=False)


@dataclass(frozen=True, eq=False)
class Features:
    """Elements of one lower dimension: corners, edges, or faces.

    Parameters
    ----------
    dimension : int
        0, 1 or 2.
    corners : (1, n), (2, n) or (4, n) int32
        Vertex ids; a triangle repeats its last one.
    data : dict of str to (n,) integers
        What the file says of each: "reference", "physical", "entity", ...
    groups : tuple of Group
        Named sets; their members are columns of `corners`.
    """

    dimension: int
    corners: Ids
    data: Mapping[str, Array] = field(default_factory=dict)
    groups: tuple[Group, ...] = ()

    def __post_init__(self) -> None:
        rows = CORNERS_OF_DIMENSION[self.dimension]
        corners = np.ascontiguousarray(self.corners, dtype=np.int32)
        if corners.ndim != 2 or len(corners) != rows:
            raise ValueError(f"corners of {self.called} must be ({rows}, n), not {corners.shape}")
        object.__setattr__(self, "corners", corners)
        for name, values in self.data.items():
            if np.shape(values) != (self.count,):
                raise ValueError(
                    f"data[{name!r}] must have a number for each of {self.count} {self.called}, "
                    f"not {np.shape(values)}"
                )
        check_members(self.groups, self.count, self.called)

    @property
    def called(self) -> str:
        """What they are: "corners", "edges", "faces"."""
        return DIMENSIONS[self.dimension]

    @property
    def count(self) -> int:
        """Number of elements."""
        return int(self.corners.shape[1])

    def within(self, place: Ids) -> Features:
        """Those whose vertices are all kept: `place` has the new row of each old vertex, -1 where it is gone."""
        corners = place[self.corners]
        kept = np.flatnonzero((corners >= 0).all(axis=0))
        order = np.full(self.count, -1, dtype=np.int32)
        order[kept] = np.arange(len(kept), dtype=np.int32)
        data = {name: np.asarray(values)[kept] for name, values in self.data.items()}
        return Features(
            self.dimension, corners[:, kept], data, tuple(group.among(order) for group in self.groups)
        )


def check_members(groups: tuple[Group, ...], count: int, called: str) -> None:
    """Raise ValueError if a group has a member that is not there."""
    for group in groups:
        if group.count and int(group.members[-1]) >= count:
            raise ValueError(
                f"the group {group.name!r} has member {int(group.members[-1])}, expected 0 to {count - 1} of {called}"
            )


def checked_groups(groups: Any, cells: int, vertices: int) -> tuple[Group, ...]:
    """The groups of a mesh; raises ValueError where a member is not there, or two have one id."""
    found = tuple(groups)
    for on, count, called in (("cell", cells, "cells"), ("vertex", vertices, "vertices")):
        check_members(tuple(group for group in found if group.on == on), count, called)
    ids = [(group.on, group.id) for group in found]
    if len(set(ids)) < len(ids):
        twice = next(id for id in ids if ids.count(id) > 1)
        raise ValueError(f"two groups are called {twice[1]!r}, expected names of their own")
    return found


def checked_features(features: Any, vertices: int) -> tuple[Features, ...]:
    """The features of a mesh, one for each dimension that there is; raises ValueError."""
    found = tuple(sorted((part for part in features if part.count), key=lambda part: part.dimension))
    if len({part.dimension for part in found}) < len(found):
        raise ValueError("features must be one for each dimension")
    for part in found:
        if int(part.corners.min()) < 0 or int(part.corners.max()) >= vertices:
            raise ValueError(
                f"{part.called} refer to vertices {part.corners.min()} to {part.corners.max()}, "
                f"expected 0 to {vertices - 1}"
            )
    return found
