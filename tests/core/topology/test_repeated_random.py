"""Cells that repeat another, against sets of vertices: of random meshes, and of those without any face."""

from __future__ import annotations

import numpy as np
from hypothesis import example, given
from numpy.typing import NDArray

from tests.core.topology.brute_force import FACES
from tests.core.topology.checks import topology
from tests.core.topology.strategies import meshes


def faces_of(row: list[int]) -> list[frozenset[int]]:
    """Faces of a cell by their vertices, without those that have vanished."""
    faces = (frozenset(row[place] for place in places) for places in FACES)
    return [face for face in faces if len(face) >= 3]


@given(meshes)
@example(np.array([[1, 1, 0, 0, 0, 0, 0, 0]], np.int32))
@example(np.array([[1, 1, 0, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0, 0, 0]], np.int32))
@example(np.empty((0, 8), np.int32))
def test_R9_cells_repeat_another_if_vertices_and_faces_are_the_same(cells: NDArray[np.int32]) -> None:
    """Of folded cells, which have a face several times, not all are looked at; none is called so that is not."""
    t = topology(cells)
    seen, repeated, folded = set(), set(), set()
    for cell, row in enumerate(t.corners.T.tolist()):
        faces = faces_of(row)
        key = frozenset(row), frozenset(faces)
        if key in seen:
            repeated.add(cell)
        if len(faces) > len(set(faces)):
            folded.add(cell)
        seen.add(key)
    found = t.repeated_cells.tolist()
    assert found == sorted(found)
    assert repeated - folded <= set(found) <= repeated
