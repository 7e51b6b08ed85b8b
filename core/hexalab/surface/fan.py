"""Walks round an edge, from cell to cell, through what is shown.

The shown cells around an edge of the surface form fans: from one quad of the surface through cells and the
faces between them to another. A walk begins at a quad's side, crosses its cell to the other face there, and
steps through that face until it comes out. All walks take a step together; most come out after one or two.

Two cubes side by side, seen from above, and a walk around the edge from vertex 1 up to vertex 7. It begins in cell 0
at its front face 2, the ring 0 1 7 6, of which side 1 lies on that edge::

      3----4----5            9---10---11
      | c0 | c1 |            |    |    |
      0----1----2 below      6----7----8 above

>>> corners = np.array([[0, 1, 4, 3, 6, 7, 10, 9], [1, 2, 5, 4, 7, 8, 11, 10]], np.int32).T
>>> topology = Topology(np.ascontiguousarray(corners), vertex_count=12)
>>> def ids(*numbers):
...     return np.array(numbers, np.int32)
>>> walks = Walks(cells=ids(0), local=np.array([2]), place=np.array([1]), start=ids(1), end=ids(7))

Across cell 0 lies its right face 3, in row 0, which leads to cell 1:

>>> local, rows = _cross_cell(topology, walks)
>>> local.tolist(), rows.tolist(), topology.face_cells[:, rows].T.tolist()
([3], [0], [[0, 1]])

There the walk stands at face 5 and crosses to cell 1's front face, which has nothing behind it: two cells. With cell
1 hidden the fan ends at face 3: one cell.

>>> [fan_sizes(topology, np.array([True, there]), walks, ids(-1)).tolist() for there in (True, False)]
[[2], [1]]
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Ids
from ..cells import FACES
from ..topology import Topology
from .edges import Indices

MOST_STEPS = 256
"""No fan is followed further: `Surface.edge_cells` ends at 255."""


def _across() -> tuple[Indices, Indices]:
    """For side `place` of face `local` of a cell: the other face there, and which of its sides it is.

    Both are tables by `4 * local + place`. Face 2 is the ring 0 1 5 4, so its side 1 goes from corner 1 to corner 5.
    Face 3, the ring 1 2 6 5, has the same edge the other way round, from 5 to 1, as its side 3.

    >>> int(_OTHER_FACE[4 * 2 + 1]), int(_OTHER_PLACE[4 * 2 + 1])
    (3, 3)
    """
    sides = {(ring[i], ring[(i + 1) % 4]): (f, i) for f, ring in enumerate(FACES) for i in range(4)}
    face = np.empty((6, 4), np.intp)
    place = np.empty((6, 4), np.intp)
    for (start, end), (f, i) in sides.items():
        face[f, i], place[f, i] = sides[end, start]
    return face.reshape(-1), place.reshape(-1)


_OTHER_FACE, _OTHER_PLACE = _across()
_PLACES = np.array(FACES, np.intp)


class Walks(NamedTuple):
    """Where walks stand: at a side of a face, within the cell.

    Attributes
    ----------
    cells : (N,) int32
    local : (N,) intp
        Which of the cell's faces.
    place : (N,) intp
        Which side of the face, the one from its corner `place` to the next; -1 where it must be looked up.
    start, end : (N,) int32
        Vertices of the edge that is walked around.
    """

    cells: Ids
    local: Indices
    place: Indices
    start: Ids
    end: Ids

    def part(self, which: Indices) -> Walks:
        """Some of the walks."""
        return Walks(
            self.cells[which], self.local[which], self.place[which], self.start[which], self.end[which]
        )


def fan_sizes(topology: Topology, shown: NDArray[np.bool_], walks: Walks, last: Ids) -> Ids:
    """Number of cells in each fan.

    Parameters
    ----------
    topology : Topology
    shown : (C,) bool
    walks : Walks
        They begin at quads of the surface, in shown cells.
    last : (N,) int32
        The cell where each is known to end, or -1.
    """
    sizes = np.ones(len(walks.cells), np.int32)
    number: Indices = np.arange(len(sizes))
    unknown = np.flatnonzero(walks.place < 0)
    if len(unknown):
        walks = walks._replace(place=walks.place.copy())
        walks.place[unknown] = _find_side(topology, walks.part(unknown))
    for _ in range(MOST_STEPS):
        local, rows = _cross_cell(topology, walks)
        left, right = topology.face_cells[0][rows], topology.face_cells[1][rows]
        # Of a face's two cells the other one; at the boundary `right` is -1, and what comes out is not used.
        after = left + right - walks.cells
        going = (right >= 0) & shown[after]
        sizes[number[np.flatnonzero(going)]] += 1
        on = np.flatnonzero(going & (after != last))
        if not len(on):
            break
        side = np.where(left[on] == after[on], 0, 1)
        local = topology.face_locals.reshape(-1)[rows[on] + side * topology.face_locals.shape[1]].astype(
            np.intp
        )
        number, last = number[on], last[on]
        walks = walks.part(on)._replace(cells=after[on], local=local)
        walks = walks._replace(place=_find_side(topology, walks))
    return sizes


def _cross_cell(topology: Topology, walks: Walks) -> tuple[Indices, Ids]:
    """The cell's other face at each side, and its row; over faces that have vanished."""
    flat = topology.cell_faces.reshape(-1)
    side = walks.local * 4 + walks.place
    local = _OTHER_FACE[side]
    rows = flat[local * topology.cell_count + walks.cells]
    gone = np.flatnonzero(rows < 0)
    here = walks.part(gone)._replace(local=local[gone], place=_OTHER_PLACE[side[gone]])
    for _ in FACES:
        if not len(gone):
            break
        side = here.local * 4 + _find_side(topology, here, but=here.place)
        here = here._replace(local=_OTHER_FACE[side], place=_OTHER_PLACE[side])
        local[gone] = here.local
        rows[gone] = flat[here.local * topology.cell_count + here.cells]
        still = np.flatnonzero(rows[gone] < 0)
        gone, here = gone[still], here.part(still)
    return local, rows


def _find_side(topology: Topology, walks: Walks, but: Indices | None = None) -> Indices:
    """Which side of each face lies between the edge's vertices, and is not the one excepted."""
    flat = topology.corners.reshape(-1)
    ring = [flat[_PLACES[walks.local, i] * topology.cell_count + walks.cells] for i in range(4)]
    found = np.zeros(len(walks.cells), np.intp)
    for i in range(4):
        a, b = ring[i], ring[(i + 1) % 4]
        here = ((a == walks.start) & (b == walks.end)) | ((a == walks.end) & (b == walks.start))
        if but is not None:
            here &= but != i
        found[here] = i
    return found
