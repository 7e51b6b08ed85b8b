"""The faces of VTK's polyhedra (type 42) as a stream: `n, size, ids, size, ids, ...` for each.

Legacy files have it in place of the row of nodes, `.vtu` files before VTK 9.4 in an array of its own.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from .byte_order import native
from .half_faces import LARGEST_FACE, MOST_FACES
from .ids import LARGEST_ID, within_int32


def stream_loops(stream: Array, starts: Array, ends: Array) -> Array:
    """(n, 6, 4) loops of polyhedra whose streams of faces lie from `starts` to `ends`; -1 for those that don't fit."""
    count = len(starts)
    out = np.full((count, MOST_FACES, LARGEST_FACE), -1, dtype=np.int32)
    good = (starts >= 0) & (ends <= len(stream)) & (starts < ends)
    faces = np.zeros(count, dtype=np.intp)
    faces[good] = within_int32(native(stream[starts[good]]))
    good &= (faces >= 4) & (faces <= MOST_FACES)
    position = starts + 1
    for face in range(MOST_FACES):
        here = np.flatnonzero(good & (face < faces))
        here = here[within(good, here, position[here] < ends[here])]
        size = np.zeros(count, dtype=np.intp)
        size[here] = within_int32(native(stream[position[here]]))
        fits = ((size[here] == 3) | (size[here] == LARGEST_FACE)) & (position[here] + size[here] < ends[here])
        here = here[within(good, here, fits)]
        for place in range(LARGEST_FACE):
            own = here[place < size[here]]
            ids = within_int32(native(stream[position[own] + 1 + place]))
            out[own, face, place] = np.where(ids < 0, LARGEST_ID, ids)
        position[here] += size[here] + 1
    good &= position == ends
    out[~good] = -1
    return out


def within(good: Array, which: Array, fits: Array) -> Array:
    """`fits`, and it is noted in `good` which of the entries `which` do not."""
    good[which[~fits]] = False
    return fits
