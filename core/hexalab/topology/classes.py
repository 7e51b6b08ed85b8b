"""Classes under "is linked to": connected components over arrays, with and without a sense of direction.

Each thing points to another of its class with a smaller number, its root to itself. A round hooks the larger of
every link's two roots to the smaller and shortens all ways to the roots; links within one class are dropped.
The number of rounds grows with the logarithm of a class's extent. Links come in blocks, twice: most are settled
by the first round, and never stand in memory at once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Ids

Links = Callable[[], Iterable[tuple[Ids, Ids]]]
"""Gives the two ends of all links, block by block, the same at both calls."""

DirectedLinks = Callable[[], Iterable[tuple[Ids, Ids, NDArray[np.bool_]]]]
"""The same with whether the two ends of each link point against each other."""


def classes(count: int, links: Links) -> tuple[Ids, int]:
    """Find which of so many things are linked, directly or through others.

    Parameters
    ----------
    count : int
        Below 2**31.
    links : callable
        Ends of links, int32 below `count`.

    Returns
    -------
    labels : (count,) int32
        Class of each, numbered in the order of their first members.
    int
        Number of classes.

    Examples
    --------
    >>> left, right = np.array([4, 1, 5], np.int32), np.array([1, 3, 2], np.int32)
    >>> labels, found = classes(6, lambda: [(left, right)])
    >>> labels.tolist(), found
    ([0, 1, 2, 1, 1, 2], 3)
    """
    root: Ids = np.arange(count, dtype=np.int32)
    for left, right in links():
        root[np.maximum(left, right)] = np.minimum(left, right)
    _shorten(root)
    rest = links()
    while True:
        ones, others = [], []
        for left, right in rest:
            one, other = root[left], root[right]
            apart = np.flatnonzero(one != other)
            if len(apart):
                ones.append(one[apart])
                others.append(other[apart])
        if not ones:
            return _numbered(root)
        left, right = np.concatenate(ones), np.concatenate(others)
        root[np.maximum(left, right)] = np.minimum(left, right)
        _shorten(root)
        rest = [(left, right)]


@dataclass(frozen=True)
class Directed:
    """Classes of things that point somewhere.

    Attributes
    ----------
    labels : (count,) int32
        Class of each, numbered in the order of their first members.
    count : int
        Number of classes.
    turned : (count,) bool
        Whether each points against the first of its class; of a one-sided class, along some way that leads there.
    one_sided : (classes,) bool
        Whether some way leads from a member to itself and turns it round: they can't all be directed alike.
    """

    labels: Ids
    count: int
    turned: NDArray[np.bool_]
    one_sided: NDArray[np.bool_]


def directed_classes(count: int, links: DirectedLinks) -> Directed:
    """Find classes of things that point somewhere, and whether all of a class can be directed alike.

    Parameters
    ----------
    count : int
        Below 2**30.
    links : callable
        Ends of links, int32 below `count`, and whether the ends point against each other.

    Examples
    --------
    Three in a ring, one link of which turns: a Moebius strip. Two more that point against each other.

    >>> left, right = np.array([0, 1, 2, 3], np.int32), np.array([1, 2, 0, 4], np.int32)
    >>> found = directed_classes(5, lambda: [(left, right, np.array([False, False, True, True]))])
    >>> found.labels.tolist(), found.count, found.one_sided.tolist()
    ([0, 0, 0, 1, 1], 2, [True, False])
    """
    # Twice the number that each points to, and one more where the way there turns round.
    root: Ids = np.arange(0, 2 * count, 2, dtype=np.int32)
    for left, right, against in links():
        root[np.maximum(left, right)] = np.minimum(left, right) << 1 | against
    _shorten_directed(root)
    turning: list[Ids] = []
    rest = links()
    while True:
        found: list[tuple[Ids, Ids, Ids]] = []
        for left, right, against in rest:
            one, other = root[left], root[right]
            sense = (one ^ other ^ against) & 1
            one >>= 1
            other >>= 1
            apart = one != other
            if apart.any():
                found.append((one[apart], other[apart], sense[apart]))
            odd = sense > apart
            if odd.any():
                turning.append(one[odd])
        if not found:
            break
        left, right, against = (np.concatenate(parts) for parts in zip(*found, strict=True))
        root[np.maximum(left, right)] = np.minimum(left, right) << 1 | against
        _shorten_directed(root)
        rest = [(left, right, against)]
    turned = (root & 1).astype(bool)
    root >>= 1
    labels, classes_found = _numbered(root)
    one_sided = np.zeros(classes_found, dtype=bool)
    for some in turning:
        one_sided[labels[some]] = True
    return Directed(labels, classes_found, turned, one_sided)


def _shorten(root: Ids) -> None:
    """Let each point to its root; blocks gain from what those before them found."""
    changed = True
    while changed:
        changed = False
        for start in range(0, len(root), CHUNK):
            part = root[start : start + CHUNK]
            further = root[part]
            if not np.array_equal(further, part):
                part[:] = further
                changed = True


def _shorten_directed(root: Ids) -> None:
    changed = True
    while changed:
        changed = False
        for start in range(0, len(root), CHUNK):
            part = root[start : start + CHUNK]
            further = root[part >> 1]
            further ^= part & 1
            if not np.array_equal(further, part):
                part[:] = further
                changed = True


def _numbered(root: Ids) -> tuple[Ids, int]:
    """Number classes in the order of their roots, each the smallest of its members: labels, and how many."""
    first = root == np.arange(len(root), dtype=np.int32)
    labels = np.cumsum(first, dtype=np.int32)
    labels -= 1
    return labels[root], int(np.count_nonzero(first))


def by_appearance(labels: Ids, count: int) -> Ids:
    """(count,) int32: a new number for each label, in the order in which they come first; all of them come."""
    flat = labels.reshape(-1)
    first = np.empty(count, np.int64)
    first[flat[::-1]] = np.arange(len(flat) - 1, -1, -1)  # the last writer wins
    number = np.empty(count, np.int32)
    number[np.argsort(first)] = np.arange(count, dtype=np.int32)
    return number
