"""Peeling (SPEC F2; the paper, Cell filters): hides the layers next to the boundary."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids


def peel(depth: Ids, layers: int) -> NDArray[np.bool_]:
    """Cells fewer hops over faces from the boundary than so many layers, (C,) bool.

    Parameters
    ----------
    depth : (C,) int32
        Hop distance; -1 for a cell from which no way leads to the boundary: it goes last.
    layers : int
        0 hides nothing; one more than the largest depth, the slider's right end, everything.
    """
    if layers <= 0:
        return np.zeros(len(depth), dtype=bool)
    if layers > depth.max(initial=0):
        return np.ones(len(depth), dtype=bool)
    hidden: NDArray[np.bool_] = depth.view(np.uint32) < np.uint32(layers)
    return hidden
