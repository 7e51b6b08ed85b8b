"""Walks round an edge, from cell to cell, through what is shown.

The shown cells around an edge of the surface form fans: from one quad of the surface through cells and the
faces between them to another. A walk begins at a quad's side, crosses its cell to the cell's other face
there, and steps through that face until it comes out. All walks take a step together, and most come out
after one or two.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..mesh import FACES, Ids
from ..topology import Topology
from .edges import Indices

MOST_STEPS = 256
"""No fan is followed further: `Surface.edge_cells` ends at 255."""


def _across() -> tuple[Indices, Indices]:
    """For side `place` of face `local` of a cell: the other face there, and which of its sides it is."""
    sides = {(ring[i], ring[(i + 1) % 4]): (f, i) for f, ring in enumerate(FACES) for i in range(4)}
    face = np.empty((6, 4), np.intp)
    place = np.empty((6, 4), np.intp)
    for (start, end), (f, i) in sides.items():
        face[f, i], place[f, i] = sides[end, start]
    return face.reshape(-1), place.reshape(-1)


_OTHER_FACE, _OTHER_PLACE = _across()
_PLACES = np.array(FACES, np.intp)


def fan_sizes(
    topology: Topology,
    shown: NDArray[np.bool_],
    cells: Ids,
    local: Indices,
    place: Indices,
    start: Ids,
    end: Ids,
    last: Ids,
) -> Ids:
    """Number of cells in each fan.

    Parameters
    ----------
    topology : Topology
    shown : (C,) bool
    cells, local : (N,) int
        The quad where each walk begins: a shown cell and which of its faces.
    place : (N,) int
        Which side of that face, the one from its corner `place` to the next; -1 where it must be looked up.
    start, end : (N,) int32
        The edge's vertices.
    last : (N,) int32
        The cell where the walk is known to end, or -1.
    """
    sizes = np.ones(len(cells), np.int32)
    walks: Indices = np.arange(len(cells))
    unknown = np.flatnonzero(place < 0)
    if len(unknown):
        place = place.copy()
        place[unknown] = _find_side(topology, cells[unknown], local[unknown], start[unknown], end[unknown])
    for _ in range(MOST_STEPS):
        local, place, rows = _cross_cell(topology, cells, local, place, start, end)
        left, right = topology.face_cells[0][rows], topology.face_cells[1][rows]
        after = left + right - cells
        going = (right >= 0) & shown[after]
        sizes[walks[np.flatnonzero(going)]] += 1
        going &= after != last
        on = np.flatnonzero(going)
        if not len(on):
            break
        side = np.where(left[on] == after[on], 0, 1)
        local = topology.face_locals.reshape(-1)[rows[on] + side * topology.face_locals.shape[1]].astype(
            np.intp
        )
        walks, cells, start, end, last = walks[on], after[on], start[on], end[on], last[on]
        place = _find_side(topology, cells, local, start, end)
    return sizes


def _cross_cell(
    topology: Topology, cells: Ids, local: Indices, place: Indices, start: Ids, end: Ids
) -> tuple[Indices, Indices, Ids]:
    """From a side of a face to the cell's other face there, over vanished faces; with that face's row."""
    flat = topology.cell_faces.reshape(-1)
    side = local * 4 + place
    local, place = _OTHER_FACE[side], _OTHER_PLACE[side]
    rows = flat[local * topology.cell_count + cells]
    gone = np.flatnonzero(rows < 0)
    for _ in range(6):
        if not len(gone):
            break
        place[gone] = _find_side(topology, cells[gone], local[gone], start[gone], end[gone], place[gone])
        side = local[gone] * 4 + place[gone]
        local[gone], place[gone] = _OTHER_FACE[side], _OTHER_PLACE[side]
        rows[gone] = flat[local[gone] * topology.cell_count + cells[gone]]
        gone = gone[rows[gone] < 0]
    return local, place, rows


def _find_side(
    topology: Topology, cells: Ids, local: Indices, start: Ids, end: Ids, but: Indices | None = None
) -> Indices:
    """Which side of each face lies between two vertices, in either direction, and is not the one excepted."""
    flat = topology.corners.reshape(-1)
    ring = [flat[_PLACES[local, i] * topology.cell_count + cells] for i in range(4)]
    found = np.zeros(len(cells), np.intp)
    for i in range(4):
        a, b = ring[i], ring[(i + 1) % 4]
        here = ((a == start) & (b == end)) | ((a == end) & (b == start))
        if but is not None:
            here &= but != i
        found[here] = i
    return found
