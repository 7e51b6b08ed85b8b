"""Elements of lower dimension as a reader finds them, block by block; they become the mesh's features (SPEC R13)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from ..arrays import Array
from ..groups import CORNERS_OF_DIMENSION, DIMENSIONS, Features, Group
from .ids import narrowed

CALLED: dict[tuple[int, int], str] = {
    (0, 1): "points",
    (1, 2): "lines",
    (2, 3): "triangles",
    (2, 4): "quadrilaterals",
}
"""What elements of a dimension with so many corners are called."""


@dataclass
class FeatureBlock:
    """Elements of one dimension.

    Parameters
    ----------
    dimension : int
        0, 1 or 2.
    corners : (k, n) integers
        Vertices counted from 0, k of them: one, two, and three or four.
    data : dict of str to (n,) integers
        What the file says of each.
    groups : list of Group
        Named sets of them; members are columns of `corners`.
    rows : (n,) integers, optional
        Which rows of the file's cells they are, where these have arrays; see `attach`.
    """

    dimension: int
    corners: Array
    data: dict[str, Array] = field(default_factory=dict)
    groups: list[Group] = field(default_factory=list)
    rows: Array | None = None

    @property
    def count(self) -> int:
        """Number of elements."""
        return int(self.corners.shape[1])

    @property
    def called(self) -> str:
        """What they are, for messages."""
        return CALLED[self.dimension, len(self.corners)]


def joined_features(
    blocks: list[FeatureBlock], vertex_count: int, note: Callable[[str], None]
) -> tuple[Features, ...]:
    """The features of all blocks; those that refer to vertices that are not there are left out, with a note."""
    found = []
    for dimension in range(len(DIMENSIONS)):
        some = [block for block in blocks if block.dimension == dimension and block.count]
        if some:
            found.append(joined(dimension, some, vertex_count, note))
    return tuple(found)


def joined(
    dimension: int, blocks: list[FeatureBlock], vertex_count: int, note: Callable[[str], None]
) -> Features:
    """The features of one dimension."""
    rows = CORNERS_OF_DIMENSION[dimension]
    parts, kept_of, start = [], [], 0
    for block in blocks:
        corners = block.corners
        kept = ((corners >= 0) & (corners < vertex_count)).all(axis=0)
        if not kept.all():
            gone = int(np.count_nonzero(~kept))
            refer = "refers" if gone == 1 else "refer"
            called = block.called[:-1] if gone == 1 else block.called
            note(f"{gone:,} {called} {refer} to vertices that are not there: left out.")
        if len(corners) == rows - 1:
            corners = np.concatenate([corners, corners[-1:]])
        parts.append(corners[:, kept].astype(np.int32))
        kept_of.append(kept)
    names = dict.fromkeys(name for block in blocks for name in block.data)
    data = {}
    for name in names:
        values = np.concatenate(
            [
                np.asarray(block.data.get(name, np.zeros(block.count, dtype=np.int32)))[kept]
                for block, kept in zip(blocks, kept_of, strict=True)
            ]
        )
        if values.any():
            data[name] = narrowed(values)
    members: dict[tuple[str, str, int | None], list[Array]] = {}
    for block, kept in zip(blocks, kept_of, strict=True):
        place = np.where(kept, np.cumsum(kept) - 1 + start, -1).astype(np.int32)
        for group in block.groups:
            rows_now = group.among(place).members
            members.setdefault((group.name, group.origin, group.number), []).append(rows_now)
        start += int(np.count_nonzero(kept))
    groups = named_apart(
        [
            Group(name, origin, np.concatenate(some), number=number)
            for (name, origin, number), some in members.items()
        ]
    )
    return Features(dimension, np.concatenate(parts, axis=1), data, tuple(groups))


def named_apart(groups: list[Group]) -> list[Group]:
    """The groups, those of one origin with names of their own: a second "steel" becomes "steel_2".

    >>> [group.id for group in named_apart([Group("a", "elset", []), Group("a", "elset", [])])]
    ['elset:a', 'elset:a_2']
    """
    taken: set[tuple[str, str]] = set()
    out = []
    for group in groups:
        first = name = group.name or "unnamed"
        number = 2
        while (group.on, f"{group.origin}:{name}") in taken:
            name, number = f"{first}_{number}", number + 1
        taken.add((group.on, f"{group.origin}:{name}"))
        out.append(replace(group, name=name))
    return out
