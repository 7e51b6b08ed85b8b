"""Faces as rows of arrays: which cells they part, by which side, and the row of each side."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from .keys import face_keys
from .matching import SINGLE, Pairing, match, unfold

_BLOCK = 1 << 16


@dataclass(frozen=True)
class Faces:
    """One row for each face; a face of more than two cells has several.

    Rows stand in this order: faces between two cells; faces of the boundary; what is left over of faces that
    three, five, ... cells share.

    Attributes
    ----------
    cells : (2, F) int32
        Cells of each side, -1 outside.
    locals : (2, F) uint8
        Which of the cell's six faces it is; 0 outside.
    rows : (6, C) int32
        Row of each side of each cell, -1 where the side has vanished.
    paired, boundary_end : int
        Rows below `paired` have two cells; rows from there to `boundary_end` are the boundary.
    count, boundary_count, nonmanifold_count : int
        Faces by their set of vertices; those of one cell; those of more than two.
    crowd_cells, crowd_faces : (K,) intp
        The cells of each non-manifold face, and a number of the face.
    nonmanifold_rows : (M,) int32
        Rows that belong to non-manifold faces.

    Examples
    --------
    Two cubes side by side, cell 0 on the left; 3 and 5 are the local numbers of a cell's right and left face::

          3----4----5      9---10---11
          | c0 | c1 |      |    |    |
          0----1----2      6----7----8       below: 0 to 5, above: 6 to 11

    >>> corners = np.array([[0, 1, 4, 3, 6, 7, 10, 9], [1, 2, 5, 4, 7, 8, 11, 10]], np.int32).T
    >>> faces = find_faces(corners, vertex_count=12)
    >>> faces.count, faces.paired, faces.boundary_end
    (11, 1, 11)

    Row 0 is the face between them: face 3 of cell 0 and face 5 of cell 1. Rows 1 to 10 are the boundary, by
    local face first: row 1 is face 0 of cell 0, row 2 face 0 of cell 1.

    >>> print(faces.cells)
    [[ 0  0  1  0  1  0  1  1  0  1  0]
     [ 1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1]]
    >>> print(faces.locals)
    [[3 0 0 1 1 2 2 3 4 4 5]
     [5 0 0 0 0 0 0 0 0 0 0]]

    From a cell to its faces: a line for each of the six faces, a column for each cell.

    >>> print(faces.rows.T)
    [[ 1  3  5  0  8 10]
     [ 2  4  6  7  9  0]]

    Three cells at one face, 0 1 2 3: a pair in row 0, and what is left over, cell 1, in the last row, past
    `boundary_end`. `rows` leads each cell to the row in which it stands.

    >>> corners = np.array([[0, 1, 2, 3, *range(4 * n, 4 * n + 4)] for n in (1, 2, 3)], np.int32).T
    >>> faces = find_faces(corners, vertex_count=16)
    >>> faces.cells[:, 0].tolist(), faces.cells[:, -1].tolist(), faces.rows[0].tolist()
    ([0, 2], [1, -1], [0, 16, 0])
    >>> faces.boundary_end, faces.count, faces.nonmanifold_count, faces.nonmanifold_rows.tolist()
    (16, 16, 1, [0, 16])
    """

    cells: Ids
    locals: NDArray[np.uint8]
    rows: Ids
    paired: int
    boundary_end: int
    count: int
    boundary_count: int
    nonmanifold_count: int
    crowd_cells: NDArray[np.intp]
    crowd_faces: NDArray[np.intp]
    nonmanifold_rows: Ids

    @property
    def boundary(self) -> slice:
        """Rows of the faces that exactly one cell has.

        The odd one of three cells at a non-manifold face has a row without second cell too, which is drawn but
        is not the boundary. A cell that has the same face twice, and no other cell has it, has two rows here.
        """
        return slice(self.paired, self.boundary_end)


def find_faces(corners: Ids, vertex_count: int) -> Faces:
    """Match the faces of (8, C) corners."""
    cell_count = corners.shape[1]
    pairing = match(face_keys(corners, vertex_count), cell_count, vertex_count)
    joints = _joints(pairing.partner, cell_count)
    folded = [joint.left[joint.left == joint.right] + joint.face * cell_count for joint in joints]
    if any(len(sides) for sides in folded):
        pairing = unfold(pairing, np.concatenate(folded))
        joints = _joints(pairing.partner, cell_count)
    return _rows(pairing, joints, cell_count)


class _Joint(NamedTuple):
    """Pairs of which the first side is one and the same of a cell's six faces.

    Of two cubes side by side there is one pair, sides 6 and 11, and one joint that is not empty: `face` 3,
    `left` [0], `right` [1], `right_face` [5].
    """

    face: int
    left: Ids
    right: Ids
    right_face: NDArray[np.uint8]


def _joints(partner: Ids, cell_count: int) -> list[_Joint]:
    """All pairs, face by face and block by block."""
    joints = []
    for face in range(6):
        for start in range(0, cell_count, _BLOCK):
            stop = min(start + _BLOCK, cell_count)
            base = face * cell_count
            mates = partner[base + start : base + stop]
            first = np.flatnonzero(mates > np.arange(base + start, base + stop, dtype=np.int32))
            mate = mates[first]
            mate_face = mate // cell_count
            right = mate - mate_face * cell_count
            left = first.astype(np.int32)
            left += start
            joints.append(_Joint(face, left, right, mate_face.astype(np.uint8)))
    return joints


def _rows(pairing: Pairing, joints: list[_Joint], cell_count: int) -> Faces:
    """Number the pairs, then the boundary, then what is left over.

    A crowd is a face of more than two sides, which are not always more than two cells: a cell that is folded
    onto itself has one face twice. So three numbers of one face differ: its rows, its cells, and itself, one.
    """
    single = np.flatnonzero(pairing.partner == SINGLE)
    crowd_cells = pairing.crowd % max(cell_count, 1)
    groups = int(pairing.group[-1]) + 1 if len(pairing.group) else 0
    left_over = single[:0]
    cells_around = _distinct_cells(pairing.group, crowd_cells, groups)
    if groups:
        shared = pairing.crowd[cells_around[pairing.group] > 1]
        odd = np.isin(single, shared)
        left_over, single = single[odd], single[~odd]
    outer = np.concatenate([single, left_over])
    outer_cells = (outer % max(cell_count, 1)).astype(np.int32)

    paired = sum(len(joint.left) for joint in joints)
    total = paired + len(outer)
    face_cells = np.full((2, total), -1, np.int32)
    face_locals = np.zeros((2, total), np.uint8)
    rows = np.full(6 * cell_count, -1, np.int32)
    start = 0
    for joint in joints:
        part = slice(start, start + len(joint.left))
        numbers = np.arange(start, part.stop, dtype=np.int32)
        face_cells[0, part], face_cells[1, part] = joint.left, joint.right
        face_locals[0, part], face_locals[1, part] = joint.face, joint.right_face
        rows[joint.face * cell_count : (joint.face + 1) * cell_count][joint.left] = numbers
        rows[joint.right_face * np.intp(cell_count) + joint.right] = numbers
        start = part.stop
    face_cells[0, paired:] = outer_cells
    face_locals[0, paired:] = outer // max(cell_count, 1)
    rows[outer] = np.arange(paired, total, dtype=np.int32)

    # From rows to faces: a crowd's rows count as one; and a boundary face that one cell has twice, as one.
    plain = total
    if groups:
        plain -= len(np.unique(rows[pairing.crowd]))
    boundary = len(single)
    lone = int((cells_around == 1).sum())
    if lone:
        boundary -= int((cells_around[pairing.group] == 1).sum()) - lone
    many = cells_around[pairing.group] > 2
    return Faces(
        cells=face_cells,
        locals=face_locals,
        rows=rows.reshape(6, cell_count),
        paired=paired,
        boundary_end=paired + len(single),
        count=plain + groups,
        boundary_count=boundary,
        nonmanifold_count=int((cells_around > 2).sum()),
        crowd_cells=crowd_cells[many],
        crowd_faces=pairing.group[many],
        nonmanifold_rows=np.unique(rows[pairing.crowd[many]]),
    )


def _distinct_cells(group: Array, cells: Array, groups: int) -> Array:
    """How many different cells each group has."""
    if not groups:
        return np.empty(0, np.intp)
    order = np.lexsort((cells, group))
    group, cells = group[order], cells[order]
    new = np.ones(len(group), dtype=bool)
    new[1:] = (group[1:] != group[:-1]) | (cells[1:] != cells[:-1])
    return np.bincount(group[new], minlength=groups)
