"""Coincidence needs all its directions: pairs of vertices that two of them cannot tell apart."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from hexalab.diagnosis.coincidence import DIRECTIONS, coincident_vertices
from hexalab.mesh import Mesh
from tests.core.filters.boxes import box


def test_R9_vertices_level_along_two_directions_are_not_at_one_place() -> None:
    """Two boxes: a vertex of the second stands on the line through one of the first across two directions."""
    one, other = box(2, 2, 2), box(2, 2, 2)
    cells = np.concatenate([one.cells, other.cells + 27])
    pairs = list(combinations(np.array(DIRECTIONS), 2))
    assert pairs
    for pair in pairs:
        across = np.cross(*pair)
        points = np.concatenate([one.points, other.points + np.array([8, 0, 0])])
        points[40] = points[13] + 2.5 * across / np.linalg.norm(across)
        assert np.abs([(points[40] - points[13]) @ direction for direction in pair]).max() < 1e-12
        assert coincident_vertices(Mesh.from_cells(points, cells)).tolist() == []
        points[40] = points[13]
        assert coincident_vertices(Mesh.from_cells(points, cells)).tolist() == [13, 40]


def test_R9_vertices_of_different_groups_are_not_joined_by_the_next_direction() -> None:
    """A and B are level along the first direction, C and D too; B and C along the second and the third.

    Sorted along the second within the two groups, B and C are neighbours, and level.
    """
    first, second, third = np.array(DIRECTIONS)
    b = np.array([1.0, 1.0, 1.0])
    c = b + 2 * np.cross(second, third) * np.sign(np.cross(second, third) @ first)
    aside = np.cross(first, third)
    aside *= np.sign(aside @ second)
    one, other = box(1, 1, 1), box(1, 1, 1)
    points = np.concatenate([one.points, other.points + np.array([9, 5, 3])])
    points[[0, 7, 8, 15]] = b - aside, b, c, c + aside
    mesh = Mesh.from_cells(points, np.concatenate([one.cells, other.cells + 8]))
    assert coincident_vertices(mesh).tolist() == []
