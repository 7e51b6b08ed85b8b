"""Chords: columns of cells, each entered and left through opposite faces (SPEC T2)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Ids, tally
from ..topology.classes import by_appearance, classes
from .frame import OPPOSITE, Frame


@dataclass(frozen=True)
class Chords:
    """All chords, numbered as they are met going through the cells and their three directions.

    Attributes
    ----------
    of_faces : (F,) int32
        Chord of each face.
    of_cells : (3, N) int32
        Chord that passes each cell in each direction.
    length : (K,) int32
        How often each passes a cell.
    closed, self_intersecting : (K,) bool
        It has no end on the boundary; it passes a cell more than once.
    """

    of_faces: Ids
    of_cells: Ids
    length: Ids
    closed: NDArray[np.bool_]
    self_intersecting: NDArray[np.bool_]

    @property
    def count(self) -> int:
        """Number of chords."""
        return len(self.length)


def find_chords(frame: Frame) -> Chords:
    """Trace all chords."""
    rows = frame.cell_faces
    raw, count = classes(frame.face_count, lambda: _links(rows))
    passing = np.stack([raw[rows[begin]] for begin, _ in OPPOSITE])
    number = by_appearance(passing.T, count)
    of_cells = number[passing]
    closed = np.ones(count, dtype=bool)
    of_faces = number[raw]
    closed[of_faces[frame.paired :]] = False
    a, b, c = of_cells
    again = np.zeros(count, dtype=bool)
    again[a[(a == b) | (a == c)]] = True
    again[b[b == c]] = True
    length = tally(of_cells, count)
    return Chords(of_faces, of_cells, length, closed, again)


def _links(rows: Ids) -> Iterator[tuple[Ids, Ids]]:
    """Opposite faces of cells."""
    for start in range(0, rows.shape[1], CHUNK):
        part = rows[:, start : start + CHUNK]
        for begin, end in OPPOSITE:
            yield part[begin], part[end]
