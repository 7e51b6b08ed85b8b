"""Which side of which cell meets which: the matching of faces.

Sorting the keys of six million sides is what takes longest when a mesh of a million cells opens, above all in
WebAssembly. A table is quicker: each side writes its number into the slot of its face, and the last writer
wins (see `slots`). A side that did not win compares its key with the winner's; if they agree the two are one
face. A round settles every winner, and what is left goes to the next; three or four rounds do for most meshes,
and what is left then is sorted.

Two cubes side by side have twelve sides, `local * 2 + cell`; side 6 (cell 0, face 3) meets side 11 (cell 1,
face 5):

>>> from .keys import face_keys
>>> corners = np.array([[0, 1, 4, 3, 6, 7, 10, 9], [1, 2, 5, 4, 7, 8, 11, 10]], np.int32).T
>>> keys = face_keys(corners, vertex_count=12)
>>> keys.slot.tolist()
[1, 5, 25, 29, 3, 7, 5, 9, 15, 19, 1, 5]
>>> match(keys, cell_count=2, vertex_count=12).partner.tolist()
[-1, -1, -1, -1, -1, -1, 11, -1, -1, -1, -1, 6]

Slot 5 is wanted by sides 1, 6 and 11, and slot 1 by 0 and 10; sides 11 and 10 win. Side 6 finds its own key in
11, so they are partners. Sides 1 and 0 find other keys and write again in the second round, where nobody is left
to overwrite them.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..arrays import Array, Ids
from .keys import SLOTS_PER_VERTEX, FaceKeys, Slots
from .slots import last_writers_by_blocks

SINGLE, VANISHED = -1, -2
"""In `Pairing.partner`: no other cell has this face; the face has fewer than three vertices."""

ROUNDS = 24
"""After so many rounds what is left is sorted: a vertex that is the smallest of very many faces."""

_BLOCK = 1 << 16


class Pairing(NamedTuple):
    """Sides paired with sides; a side is `local * C + cell`.

    Attributes
    ----------
    partner : (6 C,) int32
        The side across the face, `SINGLE` or `VANISHED`.
    crowd : (K,) intp
        Sides whose face is not plain: more than two sides have it, or twice the same cell. In order of their
        group.
    group : (K,) intp
        Number of the face of each side in `crowd`, from 0.
    """

    partner: Ids
    crowd: Slots
    group: Slots


def match(keys: FaceKeys, cell_count: int, vertex_count: int) -> Pairing:
    """Pair the sides of equal keys; a face of more sides pairs two by two, and one may be left over."""
    partner = np.full(len(keys.slot), SINGLE, np.int32)
    table = np.empty(SLOTS_PER_VERTEX * vertex_count, np.int32)
    sides: Array | None = None
    if keys.vanished:
        partner[keys.slot < 0] = VANISHED
        sides = np.flatnonzero(keys.slot >= 0)
    pairs = 0
    for _ in range(ROUNDS):
        sides, found = _round(keys, table, partner, sides)
        pairs += found
        if not len(sides):
            break
    else:
        one, other = _sorted_matches(keys, np.arange(len(partner)) if sides is None else sides)
        partner[one] = other
        partner[other] = one
        pairs += len(one)
    if np.count_nonzero(partner >= 0) != 2 * pairs:
        return _part_crowds(partner, cell_count)
    return Pairing(partner, np.empty(0, np.intp), np.empty(0, np.intp))


def _round(keys: FaceKeys, table: Ids, partner: Ids, sides: Array | None) -> tuple[Array, int]:
    """Let sides (all if None) write into their slots and pair with the winners; return who is left, and the pairs."""
    left: list[Array] = []
    pairs = 0
    for here, winner in last_writers_by_blocks(table, lambda: _blocks(keys, sides)):
        lost = np.flatnonzero(winner != here)
        one, other = here[lost], winner[lost]
        same = keys.parts[0][one] == keys.parts[0][other]
        for part in keys.parts[1:]:
            same &= part[one] == part[other]
        agree = np.flatnonzero(same)
        if len(agree) < len(one):
            left.append(one[np.flatnonzero(~same)])
            one, other = one[agree], other[agree]
        partner[one] = other
        partner[other] = one
        pairs += len(one)
    return np.concatenate(left) if left else np.empty(0, np.int32), pairs


def _blocks(keys: FaceKeys, sides: Array | None) -> Iterator[tuple[Array, Slots]]:
    """Sides and their slots, block by block.

    Blocks bound the temporaries; and a browser makes fast machine code of a loop only after it has run some
    times.
    """
    count = len(keys.slot) if sides is None else len(sides)
    for start in range(0, count, _BLOCK):
        stop = min(start + _BLOCK, count)
        if sides is None:
            yield np.arange(start, stop, dtype=np.int32), keys.slot[start:stop]
        else:
            here = sides[start:stop]
            yield here, keys.slot[here]


def _sorted_matches(keys: FaceKeys, sides: Array) -> tuple[Array, Array]:
    """Pair each side with the first of its face, by sorting."""
    columns = [part[sides] for part in keys.parts] + [keys.slot[sides]]
    order = np.lexsort(columns)
    sides = sides[order]
    new = np.zeros(len(sides), dtype=bool)
    new[:1] = True
    for column in columns:
        column = column[order]
        new[1:] |= column[1:] != column[:-1]
    leader = sides[np.maximum.accumulate(np.where(new, np.arange(len(sides)), 0))]
    follows = np.flatnonzero(~new)
    return sides[follows], leader[follows]


def _part_crowds(partner: Ids, cell_count: int) -> Pairing:
    """Pair the sides of faces that more than two sides have anew: as many as can be, never a cell with itself.

    The rounds leave such a face as a star: all its sides point to one winner, which points back to but one of
    them. With the face's sides in order of their cells, each of the first pairs with the one `step` places on,
    which is so far that no cell reaches from one to the other.

    Parameters
    ----------
    partner : (6 C,) int32
        As the rounds leave it; crowds are changed in place.
    cell_count : int

    Examples
    --------
    Cells 0, 1 and 2 share their face 0 (sides 0, 1, 2), and the star's middle is 2. Half of three sides, rounded
    up, is a step of two: 0 pairs with 2, and 1 is left over.

    >>> _part_crowds(np.array([2, 2, 1] + [SINGLE] * 15, np.int32), cell_count=3).partner[:3].tolist()
    [2, -1, 0]

    Cell 0 has the same face at sides 0 and 3, cells 1 and 2 have it at sides 1 and 2. In order of cells the sides
    are 0 3 1 2, and a step of two pairs 0 with 1 and 3 with 2, where a step of one would pair cell 0 with itself.

    >>> pairing = _part_crowds(np.array([3, 3, 3, 2] + [SINGLE] * 14, np.int32), cell_count=3)
    >>> pairing.crowd.tolist(), pairing.partner[:4].tolist()
    ([0, 3, 1, 2], [1, 0, 3, 2])
    """
    # The middles of stars: a partner of somebody that it does not point back to.
    paired = np.flatnonzero(partner >= 0)
    mate = partner[paired]
    leaders = np.unique(mate[partner[mate] != paired])
    leads = np.zeros(len(partner) - VANISHED, dtype=bool)
    leads[leaders] = True
    followers = np.flatnonzero(leads[partner])
    sides = np.concatenate([leaders, followers])
    group = np.searchsorted(leaders, np.concatenate([leaders, partner[followers]]))
    cells = sides % cell_count
    order = np.lexsort((sides, cells, group))
    sides, group, cells = sides[order], group[order], cells[order]
    partner[sides] = SINGLE
    # Sides of each face, where they begin, and how many of them the cell that has most has.
    size = np.bincount(group)
    first = np.cumsum(size) - size
    most = np.zeros(len(size), np.intp)
    np.maximum.at(most, group, _occurrence(group, cells) + 1)
    step = np.maximum(most, (size + 1) // 2)
    one = np.flatnonzero(np.arange(len(sides)) - first[group] < (size - step)[group])
    other = one + step[group[one]]
    partner[sides[one]] = sides[other]
    partner[sides[other]] = sides[one]
    return Pairing(partner, sides.astype(np.intp), group.astype(np.intp))


def unfold(pairing: Pairing, sides: Array) -> Pairing:
    """Part the pairs that join a cell to itself, given the first side of each: such a face has one cell."""
    partner, crowd, group = pairing
    mates = partner[sides]
    partner[sides] = SINGLE
    partner[mates] = SINGLE
    start = int(group[-1]) + 1 if len(group) else 0
    more = np.arange(start, start + len(sides))
    both = np.stack([sides, mates], axis=1).reshape(-1)
    return Pairing(
        partner, np.concatenate([crowd, both]).astype(np.intp), np.concatenate([group, np.repeat(more, 2)])
    )


def _occurrence(group: Array, cells: Array) -> Array:
    """How many times the same cell came before in the same group, both sorted.

    >>> _occurrence(np.array([0, 0, 0, 0, 1, 1]), np.array([4, 4, 4, 7, 7, 9])).tolist()
    [0, 1, 2, 0, 0, 0]
    """
    place = np.arange(len(group))
    new = np.ones(len(group), dtype=bool)
    new[1:] = (group[1:] != group[:-1]) | (cells[1:] != cells[:-1])
    return np.asarray(place - np.maximum.accumulate(np.where(new, place, 0)))
