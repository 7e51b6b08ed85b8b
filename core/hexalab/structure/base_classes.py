"""Base sheets and base chords: what runs side by side through one block (SPEC T3; Xu and Chen 2018)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Ids
from ..topology.classes import classes
from .chords import Chords
from .frame import DIRECTION_OF_EDGE, DIRECTION_OF_FACE, ROUND, Frame
from .sheets import Sheets


def base_sheets(frame: Frame, complex_faces: NDArray[np.bool_], sheets: Sheets) -> tuple[Ids, int]:
    """(S,) int32: the base sheet of each sheet, and how many: layers that follow each other within a block."""
    ones, others = [], []
    for start in range(0, frame.paired, CHUNK):
        rows = _inside(frame, complex_faces, start)
        (one, other), (side, far) = frame.face_cells[:, rows], frame.face_locals[:, rows]
        ones.append(sheets.of_cells[DIRECTION_OF_FACE[side], one])
        others.append(sheets.of_cells[DIRECTION_OF_FACE[far], other])
    return classes(sheets.count, lambda: zip(ones, others, strict=True))


def base_chords(frame: Frame, complex_faces: NDArray[np.bool_], chords: Chords) -> tuple[Ids, int]:
    """(K,) int32: the base chord of each chord, and how many: columns side by side within a block."""
    ones, others = [], []
    for start in range(0, frame.paired, CHUNK):
        rows = _inside(frame, complex_faces, start)
        (one, other), (side, far) = frame.face_cells[:, rows], frame.face_locals[:, rows]
        for k in (0, 1):
            turned = frame.meeting(rows, k)
            ones.append(chords.of_cells[DIRECTION_OF_EDGE[ROUND[side, k]], one])
            others.append(chords.of_cells[DIRECTION_OF_EDGE[ROUND[far, turned]], other])
    return classes(chords.count, lambda: zip(ones, others, strict=True))


def _inside(frame: Frame, complex_faces: NDArray[np.bool_], start: int) -> Ids:
    """Rows of a chunk of faces that are within a block."""
    stop = min(start + CHUNK, frame.paired)
    return (np.flatnonzero(~complex_faces[start:stop]) + start).astype(np.int32)
