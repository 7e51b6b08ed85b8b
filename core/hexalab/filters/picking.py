"""Hand-picking (SPEC F4; the paper, Manual Selection): dig, undig and isolate, and cells by number.

What was picked is two lists of cells, so that it can be undone, saved and typed. Each operation makes a new
record.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Picking:
    """What was picked.

    Attributes
    ----------
    isolated : bool
        Everything is hidden but `shown`.
    hidden, shown : tuple of int
        Cells that were dug and undug; no cell is in both.
    """

    isolated: bool = False
    hidden: tuple[int, ...] = ()
    shown: tuple[int, ...] = ()


NOTHING_PICKED = Picking()


def dig(picking: Picking, cell: int) -> Picking:
    """Hide a cell; one that was undug just is so no longer."""
    if cell in picking.shown:
        return replace(picking, shown=_without(picking.shown, cell))
    return replace(picking, hidden=(*_without(picking.hidden, cell), cell))


def undig(picking: Picking, cell: int) -> Picking:
    """Show a cell; one that was dug just is so no longer."""
    if cell in picking.hidden:
        return replace(picking, hidden=_without(picking.hidden, cell))
    return replace(picking, shown=(*_without(picking.shown, cell), cell))


def isolate(cells: Iterable[int]) -> Picking:
    """Hide all other cells."""
    return Picking(isolated=True, shown=tuple(cells))


def pick(
    hidden: NDArray[np.bool_], isolated: bool, dug: Iterable[int], undug: Iterable[int]
) -> NDArray[np.bool_]:
    """Change what the other filters hide, (C,) bool; a new array. Numbers that no cell has are left out.

    Parameters
    ----------
    hidden : (C,) bool
    isolated : bool
    dug, undug : iterables of int
        A cell in both is shown.
    """
    count = len(hidden)
    picked = np.ones(count, dtype=bool) if isolated else hidden.copy()
    picked[_known(dug, count)] = True
    picked[_known(undug, count)] = False
    return picked


def _known(cells: Iterable[int], count: int) -> NDArray[np.intp]:
    ids = np.fromiter(cells, dtype=np.int64)
    return ids[(ids >= 0) & (ids < count)].astype(np.intp)


def _without(cells: tuple[int, ...], cell: int) -> tuple[int, ...]:
    return tuple(other for other in cells if other != cell)
