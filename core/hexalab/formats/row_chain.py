"""Rows of differing length, one after the other, whose length stands in their first values.

Where a row begins is known only from the row before. Two ways avoid walking: runs of rows that begin alike
have one length and are found by comparing strided slices; where runs are short, every value is taken for
the beginning of a row, and the set of true beginnings is doubled until it holds all (pointer jumping,
log2(count) passes).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..errors import MeshReadError

ErrorAt = Callable[[str, int], MeshReadError]
"""Makes the error for a message about the number with that index in a block."""

MOST_RUNS = 512
"""After so many runs, the rest is done by pointer jumping."""


@dataclass(frozen=True)
class RowForm:
    """How long a row is.

    Parameters
    ----------
    keys : tuple of int
        Places in a row of the values that its length depends on.
    length : callable
        From one array for each key to the rows' lengths in values, those keys included; below 1 if they
        make no sense.
    """

    keys: tuple[int, ...]
    length: Callable[..., Array]


COUNTED = RowForm((0,), lambda size: np.where(size >= 0, size.astype(np.int64) + 1, 0))
"""Each row begins with the number of values that follow."""


def row_starts(values: Array, count: int | None, form: RowForm, error_at: ErrorAt, what: str) -> Array:
    """Where each row begins in `values`.

    Parameters
    ----------
    values : (n,) integers
        The rows and nothing else.
    count : int or None
        Rows there should be; None for as many as there are.
    form : RowForm
        How long a row is.
    error_at : callable
        Makes the error for the value at an index.
    what : str
        Names the rows in errors.

    Returns
    -------
    starts : (rows,) int64

    Raises
    ------
    MeshReadError
        A length makes no sense, a row runs past the end, or their number is another.
    """
    size, position, found = len(values), 0, 0
    parts: list[Array] = [np.empty(0, dtype=np.int64)]
    while position < size and (count is None or found < count) and len(parts) <= MOST_RUNS:
        run, step = first_run(values, position, form)
        if not run:
            raise error_at(f"a row of {what} does not fit before the section's end", position)
        run = run if count is None else min(run, count - found)
        parts.append(position + step * np.arange(run, dtype=np.int64))
        position += step * run
        found += run
    if position < size and (count is None or found < count):
        rest, end = jumped(values[position:], form, None if count is None else count - found)
        parts.append(rest + position)
        found += len(rest)
        position += end
    if position != size or (count is not None and found != count):
        expected = "a whole number of" if count is None else str(count)
        raise error_at(
            f"{what} should be {expected} rows in {size} values, but {found} rows take {position}",
            min(position, size - 1),
        )
    return np.concatenate(parts)


def first_run(values: Array, position: int, form: RowForm) -> tuple[int, int]:
    """How many rows from a position on have the same keys, and their length in values.

    0 rows if the first doesn't fit into `values`.
    """
    size = len(values)
    if position + max(form.keys) >= size:
        return 0, 0
    keys = [int(values[position + key]) for key in form.keys]
    step = int(form.length(*(np.array([key]) for key in keys))[0])
    if step < 1 or position + step > size:
        return 0, 0
    most = (size - position) // step
    run, block = 1, 64
    while run < most:
        upto = min(run + block, most)
        same = np.ones(upto - run, dtype=bool)
        for key, value in zip(form.keys, keys, strict=True):
            begin = position + run * step + key
            same &= values[begin : begin + (upto - run - 1) * step + 1 : step] == value
        if not same.all():
            return run + int(np.argmin(same)), step
        run, block = upto, block * 4
    return run, step


def jumped(values: Array, form: RowForm, count: int | None) -> tuple[Array, int]:
    """Beginnings of the rows by pointer jumping, and where the last ends; stops before a misfit."""
    size = len(values)
    usable = size - max(form.keys)
    after = np.full(size + 1, size, dtype=np.int64)
    lengths = form.length(*(values[key : key + usable] for key in form.keys))
    after[:usable] = np.arange(usable) + lengths
    fits = np.zeros(size + 1, dtype=bool)
    fits[:usable] = (lengths > 0) & (after[:usable] <= size)
    after[~fits] = size
    starts: Array = np.zeros(1, dtype=np.int64)
    jump: Array = after
    while count is None or len(starts) < count:
        following: Array = jump[starts]
        following = following[following < size]
        if not len(following):
            break
        starts = np.concatenate([starts, following])
        jump = jump[jump]
    starts = starts[:count]
    starts = starts[: int(np.argmin(fits[starts]))] if not fits[starts].all() else starts
    return starts, int(after[starts[-1]]) if len(starts) else 0
