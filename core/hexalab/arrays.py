"""Types of arrays that all rooms share, the size of a chunk, and counting."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
Floats = NDArray[np.float64]
Ids = NDArray[np.int32]


def tally(labels: Array, count: int) -> Ids:
    """(count,) int32: how often each number occurs in an array of any shape.

    `numpy.add.at` with an int32 does so in place; `numpy.bincount` would make a copy of twice the size before.
    """
    out: Ids = np.zeros(count, np.int32)
    np.add.at(out, labels, np.int32(1))
    return out


CHUNK = 32768
"""Cells in a chunk: temporaries stay in cache and memory is bounded."""
