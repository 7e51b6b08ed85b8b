"""What writers share of groups: names of their own, one number for each cell, elements of lower dimension."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..groups import Features, Group
from .medit_features import REFERENCE

LARGEST = 2**31 - 1


def names_of(groups: Sequence[Group], clean: Callable[[str], str]) -> list[str]:
    """A name for each group, cleaned, no two alike whatever their letter case.

    A group that an array makes is called by the array and its value; one whose name is taken gets its origin before.
    """
    taken: set[str] = set()
    out = []
    for group in groups:
        first = f"{group.origin}_{group.name}"
        candidates = [first] if group.name == str(group.number) else [group.name, first]
        number = 2
        while candidates and clean(candidates[0]).upper() in taken:
            candidates = candidates[1:] or [f"{first}_{number}"]
            number += 1
        out.append(clean(candidates[0]))
        taken.add(out[-1].upper())
    return out


def tags_of(groups: Sequence[Group]) -> list[int]:
    """A number from 1 on for each group: its own where no group before has it, else the next that is free."""
    own = [group.number for group in groups if group.number and 0 < group.number <= LARGEST]
    taken: set[int] = set()
    free = max(own, default=0) + 1
    out = []
    for group in groups:
        number = group.number or 0
        if not 0 < number <= LARGEST or number in taken:
            number, free = free, free + 1
        taken.add(number)
        out.append(number)
    return out


def apart(groups: Sequence[Group], count: int) -> bool:
    """Whether no member is in two of the groups."""
    times = np.zeros(count, dtype=np.int32)
    for group in groups:
        times[group.members] += 1
    return not (times > 1).any()


def numbered(groups: Sequence[Group], count: int) -> tuple[list[Group], NDArray[np.int64]]:
    """The groups of the first origin that can be told by one number for each member, and (count,) these numbers.

    No groups and zeros if there is no such origin.
    """
    values = np.zeros(count, dtype=np.int64)
    for origin in dict.fromkeys(group.origin for group in groups):
        some = [group for group in groups if group.origin == origin]
        if apart(some, count):
            for group, number in zip(some, tags_of(some), strict=True):
                values[group.members] = number
            return some, values
    return [], values


def reference_of(features: Features) -> Array:
    """(n,) the one number that a format has for each element: its reference, else its group's."""
    for name in (REFERENCE, "physical", "entity"):
        if name in features.data:
            return np.asarray(features.data[name])
    for name, values in features.data.items():
        if name != "partition":
            return np.asarray(values)
    from_marks = [group for group in features.groups if group.origin != "mark"]
    return numbered(from_marks, features.count)[1]
