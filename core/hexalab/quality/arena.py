"""Memory and arithmetic of one block of cells: named arrays that are kept, values that are computed once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np

from ..arrays import Array, Floats

BLOCK = 4096
"""Cells computed together: the few megabytes of intermediates stay in cache."""

T = TypeVar("T")


def shared(compute: Callable[[Any], T]) -> Any:
    """Make a method a property that is computed once per block."""
    key = compute.__name__

    def get(self: Any) -> T:
        if key not in self.known:
            self.known[key] = compute(self)
        value: T = self.known[key]
        return value

    get.__doc__ = compute.__doc__
    return property(get)


class Arena:
    """Memory for one block at a time, handed out by name and kept between blocks."""

    def __init__(self, capacity: int = BLOCK) -> None:
        self.capacity = capacity
        self.count = capacity
        self.known: dict[str, Any] = {}
        self._arrays: dict[str, Array] = {}

    def array(self, name: str, *shape: int) -> Floats:
        """Float array of `shape` + (cells of the block,), the same memory whenever the name comes again."""
        whole = self._arrays.get(name)
        if whole is None:
            whole = self._arrays[name] = np.empty((*shape, self.capacity))
        return whole if self.count == self.capacity else whole[..., : self.count]

    def begin(self, count: int) -> None:
        """Forget what was computed, for a block of `count` cells."""
        self.count = count
        self.known.clear()


def dot(a: Floats, b: Floats, out: Floats, scratch: Floats) -> Floats:
    """Sum of the products of the components (first axis)."""
    np.multiply(a[0], b[0], out=out)
    np.multiply(a[1], b[1], out=scratch)
    out += scratch
    np.multiply(a[2], b[2], out=scratch)
    out += scratch
    return out


def cross(a: Floats, b: Floats, out: Floats, scratch: Floats) -> Floats:
    """Cross product over the components (first axis)."""
    for axis, (i, j) in enumerate(((1, 2), (2, 0), (0, 1))):
        np.multiply(a[i], b[j], out=out[axis])
        np.multiply(a[j], b[i], out=scratch)
        out[axis] -= scratch
    return out
