"""Physical groups of a `.msh` file, of cells and of elements of lower dimension (SPEC R12, R13)."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..arrays import Array
from ..groups import Group
from .assembly import Assembly
from .feature_blocks import FeatureBlock
from .gmsh_parts import Elements
from .ids import Numbering

PHYSICAL = "physical"

Names = Mapping[tuple[int, int], str]
"""Names of physical groups by dimension and number."""


def groups_of_cells(parts: list[Elements], place: Array, names: Names) -> list[Group]:
    """The physical groups of volumetric elements.

    Parameters
    ----------
    parts : list of Elements
    place : (C,) int
        Rows of the elements in the mesh, part after part.
    names : mapping
    """
    members: dict[int, list[Array]] = {}
    start = 0
    for part in parts:
        rows = place[start : start + len(part.tags)]
        start += len(part.tags)
        for number, which in memberships(part):
            members.setdefault(number, []).append(rows[which])
    return [
        Group(names.get((3, number), str(number)), PHYSICAL, np.concatenate(members[number]), number=number)
        for number in sorted(members)
    ]


def memberships(part: Elements) -> list[tuple[int, Array | slice]]:
    """The physical groups of some elements, and which of them belong to each."""
    found: list[tuple[int, Array | slice]] = []
    for number in np.unique(part.physicals).tolist():
        if number:
            which = part.physicals == number
            found.append((number, slice(None) if which.all() else np.flatnonzero(which)))
    return found + [(number, slice(None)) for number in part.also]


def add_features(out: Assembly, elements: list[Elements], numbering: Numbering, names: Names) -> None:
    """Add the elements of lower dimension."""
    for part in elements:
        if part.dimension == 3 or not len(part.tags):
            continue
        data = {"entity": part.entities, PHYSICAL: part.physicals, "partition": part.partitions}
        rows = np.arange(len(part.tags), dtype=np.int32)
        groups = [
            Group(names.get((part.dimension, number), str(number)), PHYSICAL, rows[which], number=number)
            for number, which in memberships(part)
        ]
        out.features.append(FeatureBlock(part.dimension, numbering.places(part.corners), data, groups))
