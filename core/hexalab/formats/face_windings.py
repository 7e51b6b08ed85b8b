"""From which side the faces of a cell are seen."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..cells import COLLAPSE, CORNERS_OF_KIND, FACES, KINDS


def turn_table(kind: int) -> tuple[NDArray[np.int8], NDArray[np.int8]]:
    """What three consecutive corners of a loop say, as tables over their places in the cell.

    Returns
    -------
    turns : (k, k, k) int8
        1 if a face of the kind, seen counter-clockwise from outside, has them so, -1 if it has them the other way
        round, 0 if no face has them. The last place stands for a vertex that is no corner.
    faces : (k, k, k) int8
        Which face that is.
    """
    size = len(CORNERS_OF_KIND[kind])
    turns, faces = np.zeros((size + 1,) * 3, np.int8), np.zeros((size + 1,) * 3, np.int8)
    for number, face in enumerate(FACES):
        loop = list(dict.fromkeys(COLLAPSE[kind][corner] for corner in face))
        for place in range(len(loop) if len(loop) > 2 else 0):
            a, b, c = (loop[(place + step) % len(loop)] for step in range(3))
            turns[a, b, c], turns[c, b, a] = 1, -1
            faces[a, b, c] = faces[c, b, a] = number
    return turns, faces


TURN_TABLES = tuple(turn_table(kind) for kind in range(len(KINDS)))


def windings(kind: int, own: Ids, loops: Array) -> tuple[NDArray[np.int8], NDArray[np.bool_]]:
    """How each loop runs, and whether the loops are the faces of the cell, each once.

    Parameters
    ----------
    kind : int
    own : (k, n) ids
        Corners of the cells.
    loops : (n, m, 4) ids
        Their faces.

    Returns
    -------
    turns : (n, m) int8
        1 for a loop that is seen counter-clockwise from outside, else -1 (0 if it is no face).
    whole : (n,) bool
    """
    place = np.full(loops.shape, len(own), dtype=np.intp)  # a vertex that is no corner of the cell
    for corner, ids in enumerate(own):
        place[loops == ids[:, None, None]] = corner
    turns, faces = TURN_TABLES[kind]
    a, b, c, d = np.moveaxis(place, 2, 0)
    turn = turns[a, b, c]
    fits = turn != 0
    quadrilateral = loops[..., 3] >= 0
    fits &= ~quadrilateral | (turns[b, c, d] == turn)
    found = np.bitwise_or.reduce(1 << faces[a, b, c].astype(np.intp), axis=1)
    return turn, fits.all(axis=1) & (np.bitwise_count(found) == loops.shape[1])
