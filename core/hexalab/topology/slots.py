"""The last writer wins: how this house finds equals, and picks one of each, without sorting.

All write their number into the slot of a table that a key chooses, then all read their slot again. NumPy goes
through an index array in order and lets the last value stand, so whoever reads its own number has won its slot,
and everybody else reads who won it. Nothing here depends on which one wins, only on there being one.

- Equal keys choose the same slot, so equals read the same winner. Where different keys may share a slot, each
  loser compares its key with the winner's: if they agree the two are equals, if not it tries again in another
  table or in the next round, where the winners and their equals are gone and there is more room.
- The table needs no clearing: only slots are read that have just been written.

Six million sides of a million cells are matched in a sixth of the time that sorting their keys takes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Number = TypeVar("Number", np.int32, np.intp)


def last_writers(
    table: NDArray[Number], slots: NDArray[np.integer], numbers: NDArray[Number]
) -> NDArray[Number]:
    """Let all write, and tell each who stands in its slot.

    Parameters
    ----------
    table : (T,) int
        Scratch space, more places than any slot; what stands in it before does not matter.
    slots : (N,) int
        Where each writes.
    numbers : (N,) int
        What each writes, distinct within a slot.

    Returns
    -------
    (N,) int
        The number that the last writer of each one's slot wrote.

    Examples
    --------
    Vertices of the two triangles 7 3 5 and 5 3 8, each once. Numbers 0 to 5 go to the slots 7 3 5 5 3 8: number 3
    overwrites 2 in slot 5, number 4 overwrites 1 in slot 3.

    >>> vertices = np.array([7, 3, 5, 5, 3, 8])
    >>> numbers = np.arange(6)
    >>> winners = last_writers(np.empty(9, np.intp), vertices, numbers)
    >>> winners.tolist()
    [0, 4, 3, 3, 4, 5]
    >>> vertices[winners == numbers].tolist()
    [7, 5, 3, 8]
    """
    table[slots] = numbers
    winners: NDArray[Number] = table[slots]
    return winners


def last_writers_by_blocks(
    table: NDArray[Number], blocks: Callable[[], Iterable[tuple[NDArray[Number], NDArray[np.integer]]]]
) -> Iterator[tuple[NDArray[Number], NDArray[Number]]]:
    """The same for more writers than temporaries should be made for at once.

    Parameters
    ----------
    table : (T,) int
    blocks : callable
        Gives the blocks of numbers and slots, the same at both calls: all blocks write before any is read.

    Yields
    ------
    numbers, winners : (n,) int
        Of each block.
    """
    for numbers, slots in blocks():
        table[slots] = numbers
    for numbers, slots in blocks():
        yield numbers, table[slots]
