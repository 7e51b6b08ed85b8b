"""Which sheets cross, and which run side by side (Xu and Chen 2018)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from .frame import DIRECTION_OF_FACE, Frame
from .sheets import Sheets


@dataclass(frozen=True)
class SheetPairs:
    """Pairs of sheets, the smaller number first; a sheet that crosses itself stands with itself.

    Attributes
    ----------
    one, other : (P,) int32
    crossings : (P,) int64
        How often they cross in a cell.
    beside : (P,) int64
        Faces of the mesh on both sides of which they run in parallel.
    """

    one: Ids
    other: Ids
    crossings: NDArray[np.int64]
    beside: NDArray[np.int64]


def sheet_pairs(frame: Frame, sheets: Sheets) -> SheetPairs:
    """Count for every two sheets how often they meet."""
    a, b, c = sheets.of_cells
    crossing = _keys(sheets, [(a, b), (b, c), (a, c)])
    (one, other), (side, far) = frame.face_cells[:, : frame.paired], frame.face_locals[:, : frame.paired]
    parallel = sheets.of_cells[DIRECTION_OF_FACE[side], one], sheets.of_cells[DIRECTION_OF_FACE[far], other]
    beside = _keys(sheets, [parallel])
    keys = np.union1d(crossing[0], beside[0])
    span = max(sheets.count, 1)
    return SheetPairs(
        (keys // span).astype(np.int32),
        (keys % span).astype(np.int32),
        _at(keys, *crossing),
        _at(keys, *beside),
    )


def _keys(sheets: Sheets, pairs: list[tuple[Ids, Ids]]) -> tuple[Array, Array]:
    """Different pairs as one number each, ascending, and how often each occurs."""
    keys = [
        np.minimum(one, other).astype(np.int64) * sheets.count + np.maximum(one, other)
        for one, other in pairs
    ]
    return np.unique(np.concatenate(keys), return_counts=True)


def _at(keys: Array, found: Array, counts: Array) -> NDArray[np.int64]:
    out = np.zeros(len(keys), np.int64)
    out[np.searchsorted(keys, found)] = counts
    return out
