"""Blocks that come back turned: on some way through them one ends with another direction than one began with."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Ids
from ..topology.classes import directed_classes
from .frame import AT_END, DIRECTION_OF_EDGE, DIRECTION_OF_FACE, ROUND, ROUND_SENSE, Frame
from .joints import SAME_WAY


def turned_blocks(
    frame: Frame, complex_faces: NDArray[np.bool_], labels: Ids, some: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    """(B,) bool: which of some blocks, (B,) bool, come back turned.

    The three directions of each cell are linked to those of the next cells of its block. A block that never
    turns has three classes of them, each of which can be directed alike.
    """
    free = np.flatnonzero(~complex_faces[: frame.paired] & some[labels[frame.face_cells[0, : frame.paired]]])
    axes = directed_classes(3 * frame.count, lambda: _links(frame, free.astype(np.int32)))
    block_of = np.empty(axes.count, np.int32)
    block_of[axes.labels] = np.concatenate([labels, labels, labels])
    turned = some & (np.bincount(block_of, minlength=len(some)) < 3)
    turned[block_of[axes.one_sided]] = True
    return turned


def _links(frame: Frame, faces: Ids) -> Iterator[tuple[Ids, Ids, NDArray[np.bool_]]]:
    """Directions of the cells on both sides of faces: numbers are direction * N + cell."""
    count = frame.count
    for start in range(0, len(faces), CHUNK):
        rows = faces[start : start + CHUNK]
        (one, other), (side, far) = frame.face_cells[:, rows], frame.face_locals[:, rows]
        left, right = DIRECTION_OF_FACE[side], DIRECTION_OF_FACE[far]
        yield left * count + one, right * count + other, AT_END[side] == AT_END[far]
        mirrored = frame.joints.turns[rows] >= SAME_WAY
        for k in (0, 1):
            turned = frame.meeting(rows, k)
            left, right = DIRECTION_OF_EDGE[ROUND[side, k]], DIRECTION_OF_EDGE[ROUND[far, turned]]
            against = (ROUND_SENSE[side, k] == ROUND_SENSE[far, turned]) ^ mirrored
            yield left * count + one, right * count + other, against
