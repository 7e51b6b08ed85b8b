"""Some out of many places on a surface, spread evenly over it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .records import Floats32

Indices = NDArray[np.intp]

MOST = 1000
"""Places that are chosen at most."""

STEPS = 4
"""Sides of cubes are powers of the so many-th root of 2: a surface that changes a little keeps its cubes."""

COARSEST, FINEST = -72, 48
"""Steps among which the cubes' side is looked for: from 2^18 diagonals down to 2^-12."""

LOOKED_AT = 131_072
"""Places that are looked at to find the side of the cubes."""

FAR = 2.0**17
"""Cubes from the middle, beyond which all is one."""

TABLE = 4_194_304
"""Cubes that may be counted in a table."""

APART = 0.5
"""Of the cubes' side: places that look the same way are no nearer to each other."""

OPPOSITE = -0.5
"""Cosine below which two places look opposite ways, as those on both sides of a thin plate."""


class Cubes(NamedTuple):
    """Cubes of one side, and for each place the one that it is in.

    Attributes
    ----------
    number : (N,) int64
    limit : int
        Of the numbers, which are below it.
    """

    number: NDArray[np.int64]
    limit: int


def spread(places: Floats32, normals: Floats32, most: int = MOST) -> Indices:
    """Choose places: of each cube the one nearest to its middle, and of those that look the opposite way another.

    The cubes are as small as a number of places lets them be. Of two that are nearer to each other than `APART` sides
    and don't look opposite ways, the one farther from its cube's middle is left out again. So no two that were chosen
    are nearer, and no place is farther from one that was chosen than the diagonal of a cube and half a side.

    Parameters
    ----------
    places, normals : (3, N) float32
        Finite; the normals of length 1.
    most : int
        2 or more.

    Returns
    -------
    (n,) intp
        Ascending; all of them where they are no more than `most`.
    """
    if places.shape[1] <= most:
        return np.arange(places.shape[1])
    step = _finest(places, most) + 1
    chosen: Indices = np.arange(places.shape[1])
    while len(chosen) > most:
        step -= 1
        chosen, aside = _candidates(places, normals, _side_of(step))
    order = np.argsort(aside, kind="stable")
    chosen = chosen[order]
    kept = _kept(places[:, chosen], normals[:, chosen], APART * _side_of(step))
    return np.asarray(np.sort(chosen[kept]))


def _side_of(step: int) -> float:
    return float(2.0 ** (-step / STEPS))


def _finest(places: Floats32, most: int) -> int:
    """The step of the smallest cubes of which no more than that hold a place, as far as some of the places tell."""
    some = places[:, :: max(1, places.shape[1] // LOOKED_AT)]
    low, high = COARSEST, FINEST + 1
    while high - low > 1:
        middle = (low + high) // 2
        if _occupied(_cubes(some, _side_of(middle))) <= most:
            low = middle
        else:
            high = middle
    return low


def _cubes(places: Floats32, side: float) -> Cubes:
    """The cube of each place; the middle of one of them is the frame's."""
    number, count = np.zeros(places.shape[1], np.int64), 1
    for axis in places:
        steps = np.clip(np.rint(axis / np.float32(side)), -FAR, FAR).astype(np.int64)
        steps -= steps.min()
        across = int(steps.max()) + 1
        number = number * across + steps
        count *= across
    return Cubes(number, count)


def _occupied(cubes: Cubes) -> int:
    """How many cubes hold a place."""
    if cubes.limit > TABLE:
        return len(np.unique(cubes.number))
    table = np.zeros(cubes.limit, dtype=bool)
    table[cubes.number] = True
    return int(np.count_nonzero(table))


def _candidates(places: Floats32, normals: Floats32, side: float) -> tuple[Indices, Floats32]:
    """Of each cube the place nearest to its middle, and that of those that look the opposite way.

    Returns
    -------
    chosen : (n,) intp
    aside : (n,) float32
        Squares of their distances from the middles, over the side.
    """
    number, count = _cubes(places, side)
    if count > TABLE:
        found, number = np.unique(number, return_inverse=True)
        count = len(found)
    aside = np.zeros(places.shape[1], np.float32)
    for axis in places:
        off = axis / np.float32(side)
        off -= np.rint(off)
        aside += off * off
    first = _nearest(number, count, aside)
    mates = first[number]
    along = sum(normal * normal[mates] for normal in normals)
    opposite = np.flatnonzero(along < OPPOSITE)
    second = opposite[_chosen(_nearest(number[opposite], count, aside[opposite]))]
    chosen = np.concatenate([_chosen(first), second])
    return chosen, aside[chosen]


def _nearest(number: NDArray[np.int64], count: int, aside: Floats32) -> Indices:
    """(count,) place nearest to the middle of each cube, the first of several; -1 for an empty cube."""
    least = np.full(count, np.inf, np.float32)
    np.minimum.at(least, number, aside)
    nearest = np.flatnonzero(aside == least[number])[::-1]
    first = np.full(count, -1, np.intp)
    first[number[nearest]] = nearest  # the last one stays, which is the first place
    return first


def _chosen(first: Indices) -> Indices:
    return first[first >= 0]


def _kept(places: Floats32, normals: Floats32, apart: float) -> NDArray[np.bool_]:
    """Which places stay, the best of which stand first: each but those near to a better one that stays."""
    square = np.zeros((places.shape[1],) * 2, np.float32)
    along = np.zeros_like(square)
    with np.errstate(over="ignore"):
        for x, n in zip(places, normals, strict=True):
            square += (x[:, None] - x) ** 2
            along += n[:, None] * n
    near = (square < apart * apart) & (along > OPPOSITE)
    better = np.tril(near, -1)
    kept = np.zeros(len(near), dtype=bool)
    left = np.ones(len(near), dtype=bool)
    while left.any():
        best = left & ~better[:, left].any(axis=1)
        kept |= best
        left &= ~(best | near[:, best].any(axis=1))
    return kept
