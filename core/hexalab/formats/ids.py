"""Whole numbers of a file: vertex ids as int32, all others as wide as they need; a file's own numbering made ours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from .byte_order import native

LARGEST_ID = 2**31 - 2


def within_int32(values: Array) -> Array:
    """The vertex ids, those that do not fit int32 moved to its ends, so that a range check finds them.

    For ids alone: a reference or an attribute would come out as another number.
    """
    if values.dtype.itemsize <= 4 and values.dtype.kind == "i":
        return values
    if not values.size:
        return values
    if values.dtype == np.int64 and values.dtype.isnative and values.strides[-1] == 8:
        good = values.view(np.uint64).max() <= LARGEST_ID  # one pass finds the negative ones too
    else:
        good = int(values.max()) <= LARGEST_ID and int(values.min()) >= -LARGEST_ID
    return values if good else np.clip(values, -LARGEST_ID, LARGEST_ID)


def as_int32(values: Array) -> Array:
    """The vertex ids as int32, in either byte order; no copy where they are that already.

    Those that do not fit are moved to the range's ends, as by `within_int32`. Of 64-bit numbers that fit, the
    lower halves are taken where they stand: one pass over the bits that any of them has tells that they fit.
    """
    if values.dtype.kind == "i" and values.dtype.itemsize == 4:
        return values
    if values.dtype.itemsize == 8 and values.size and values.flags.aligned and values.flags.c_contiguous:
        bits = np.bitwise_or.reduce(values.view(np.uint64), axis=None)
        if 0 <= int(np.array([bits]).view(values.dtype)[0]) <= LARGEST_ID:
            order = values.dtype.str[0]
            return values.view(f"{order}i4")[..., 1 if order == ">" else 0 :: 2]
    return within_int32(native(values)).astype(np.int32)


def fits_int32(values: Array) -> bool:
    """Whether int32 can hold all of the integers."""
    if not values.size or (values.dtype.kind == "i" and values.dtype.itemsize <= 4):
        return True
    return int(values.max()) < 2**31 and int(values.min()) >= -(2**31)


def put(out: Array, part: slice, values: Array) -> Array:
    """Store integers in `out[part]`; the array they stand in, which is `out` as int64 where int32 can't hold them."""
    if out.dtype == np.int32 and not fits_int32(values):
        out = out.astype(np.int64)
    out[part] = values
    return out


def narrowed(values: Array) -> Array:
    """The integers as int32 if it can hold all of them, else as int64 (or as they are, where that can't)."""
    if fits_int32(values):
        return values.astype(np.int32)
    return values if values.dtype.kind == "u" and int(values.max()) >= 2**63 else values.astype(np.int64)


def whole_tags(values: Array) -> NDArray[np.int64] | None:
    """Numbers of entries that were read as floats; None if one is not a whole number."""
    if not np.isfinite(values).all() or (np.abs(values) >= 2**53).any() or (values % 1).any():
        return None
    return values.astype(np.int64)


class Numbering:
    """A file's own numbers of vertices or cells, in any order and with gaps.

    Parameters
    ----------
    tags : (n,) integers
        The number of each entry, in file order; where one occurs twice, the first counts.
    """

    def __init__(self, tags: Array) -> None:
        self.count = len(tags)
        self.first = int(tags[0]) if len(tags) else 0
        self.consecutive = bool((np.diff(tags) == 1).all())
        if not self.consecutive:
            self.order = np.argsort(tags, kind="stable")
            self.sorted = tags[self.order]

    def places(self, tags: Array) -> NDArray[np.int32]:
        """Place in file order of each number; -1 where it is not there. Same shape as `tags`."""
        if not self.count:
            return np.full(tags.shape, -1, dtype=np.int32)
        if self.consecutive:
            places = tags.astype(np.int64) - self.first
            return np.where((places >= 0) & (places < self.count), places, -1).astype(np.int32)
        found = np.searchsorted(self.sorted, tags)
        found[found == self.count] = 0
        return np.where(self.sorted[found] == tags, self.order[found], -1).astype(np.int32)
