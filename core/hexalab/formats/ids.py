"""Vertex ids: kept as int32, whatever the file has."""

from __future__ import annotations

import numpy as np

from ..mesh import Array

LARGEST_ID = 2**31 - 2


def within_int32(values: Array) -> Array:
    """The integers, those that do not fit int32 moved to its ends, so that a range check finds them."""
    if values.dtype.itemsize <= 4 and values.dtype.kind == "i":
        return values
    if len(values) and (int(values.max()) > LARGEST_ID or int(values.min()) < -LARGEST_ID):
        return np.clip(values, -LARGEST_ID, LARGEST_ID)
    return values
