"""Faces as rows of arrays: which cells they part, by which side, and the row of each side."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..mesh import Array, Ids
from .keys import face_keys
from .matching import SINGLE, Pairing, match, unfold


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


def find_faces(corners: Ids, vertex_count: int) -> Faces:
    """Match the faces of (8, C) corners."""
    cell_count = corners.shape[1]
    pairing = match(face_keys(corners, vertex_count), cell_count, vertex_count)
    cells, local, folded = _pairs(pairing.partner, cell_count)
    if len(folded):
        pairing = unfold(pairing, folded)
        cells, local, folded = _pairs(pairing.partner, cell_count)
    return _rows(pairing, cells, local, cell_count)


def _pairs(partner: Ids, cell_count: int) -> tuple[list[list[Ids]], list[list[NDArray[np.uint8]]], Array]:
    """Cells and local faces of each pair, by the first local face; first sides of folded pairs."""
    cells: list[list[Ids]] = [[], []]
    local: list[list[NDArray[np.uint8]]] = [[], []]
    folded: list[Array] = []
    own = np.arange(cell_count, dtype=np.int32)
    for face in range(6):
        mates = partner[face * cell_count : (face + 1) * cell_count]
        left = np.flatnonzero(mates > own).astype(np.int32)
        own += cell_count
        mate = mates[left]
        mate_face = mate // max(cell_count, 1)
        right = mate - mate_face * cell_count
        same = left == right
        if same.any():
            folded.append(left[same] + face * cell_count)
        cells[0].append(left)
        cells[1].append(right)
        local[0].append(np.full(len(left), face, np.uint8))
        local[1].append(mate_face.astype(np.uint8))
    return cells, local, np.concatenate(folded) if folded else np.empty(0, np.intp)


def _rows(
    pairing: Pairing, cells: list[list[Ids]], local: list[list[NDArray[np.uint8]]], cell_count: int
) -> Faces:
    """Number the pairs, then the boundary, then what is left over."""
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

    paired = sum(len(part) for part in cells[0])
    total = paired + len(outer)
    face_cells = np.empty((2, total), np.int32)
    face_locals = np.empty((2, total), np.uint8)
    for side in range(2):
        np.concatenate(
            [*cells[side], outer_cells if side == 0 else np.full(len(outer), -1, np.int32)],
            out=face_cells[side],
        )
        np.concatenate(
            [*local[side], (outer // max(cell_count, 1)).astype(np.uint8) * (side == 0)],
            out=face_locals[side],
            casting="unsafe",
        )
    rows = np.full(6 * cell_count, -1, np.int32)
    start = 0
    for face in range(6):
        left, right = cells[0][face], cells[1][face]
        numbers = np.arange(start, start + len(left), dtype=np.int32)
        rows[face * cell_count : (face + 1) * cell_count][left] = numbers
        rows[local[1][face] * np.intp(cell_count) + right] = numbers
        start += len(left)
    rows[outer] = np.arange(paired, total, dtype=np.int32)

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
