"""Faults: one mesh for each thing that a diagnosis must find, otherwise as plain as can be."""

import numpy as np
from making.solid import TURNED, box, moved, polycube, unite
from making.writing import medit


def negative_volume():
    """Two inner vertices pushed through their cells."""
    points, cells = box(4, 4, 4, (4.0, 4.0, 4.0))
    for x, y, z in ((1, 1, 1), (3, 2, 3)):
        here = np.flatnonzero((points == (x, y, z)).all(axis=1))
        points[here] += (1.9, 1.9, 1.9) if x == 1 else (-1.9, 0.0, 0.0)
    return points, cells


def zero_volume():
    """One layer squeezed flat."""
    points, cells = box(4, 4, 4, (4.0, 4.0, 4.0))
    points[:, 2] = np.array([0.0, 1.0, 1.0, 2.0, 3.0])[points[:, 2].astype(int)]
    return points, cells


def invalid_corner():
    """Cells of positive volume with a reflex corner."""
    points, cells = box(4, 4, 1, (4.0, 4.0, 1.0))
    for x, y in ((1, 1), (3, 3)):
        here = (points[:, 0] == x) & (points[:, 1] == y)
        points[here, :2] += 0.6 if x == 1 else -0.6
    return points, cells


def invalid_inside():
    """A cell that is right at its eight corners and turns over between them."""
    points = [
        (-0.5, 0.6, -0.7), (0.4, -0.4, 0.1), (1.8, 0.4, -0.2), (-0.1, 1.5, 0.0),
        (-0.8, -0.6, 0.4), (1.7, 0.3, 0.9), (0.4, 1.8, 0.2), (0.6, 1.2, 1.7),
    ]  # fmt: skip
    return np.array(points), np.arange(8)[None]


def repeated_vertex():
    """Cells along one side that name a vertex twice."""
    points, cells = box(4, 4, 2, (4.0, 4.0, 2.0))
    cells = cells.copy()
    beside = np.flatnonzero(points[cells].mean(axis=1)[:, 0] > 3)
    cells[beside, 2] = cells[beside, 1]
    return points, cells


def unreferenced_vertices():
    """Vertices that no cell uses, some of them far away."""
    points, cells = box(3, 3, 3)
    stray = [(0.5, 0.5, 0.4), (0.2, 0.3, 0.9), (40.0, 0.0, 0.0), (0.0, -75.0, 10.0), (5.0, 5.0, 120.0)]
    return np.concatenate([points, stray]), cells


def coincident_vertices():
    """Two blocks that touch but don't share the vertices between them."""
    left, left_cells = box(3, 4, 4, (3.0, 4.0, 4.0))
    right, right_cells = box(3, 4, 4, (3.0, 4.0, 4.0))
    crossing = np.concatenate([left, moved(right, 3.0, 0.0, 0.0)])
    return crossing, np.concatenate([left_cells, right_cells + len(left)])


def shared_faces():
    """A third block that grows out of the face between two others."""
    points, cells = box(2, 1, 1, (2.0, 1.0, 1.0))
    middle = [
        np.flatnonzero((points == corner).all(axis=1))[0]
        for corner in ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1))
    ]
    outside = np.array([(1.8, -0.9, 0.0), (1.8, 0.1, -0.9), (2.6, 0.1, 1.9), (2.6, -0.9, 1.0)])
    cell = [middle[0], middle[1], middle[2], middle[3], *(len(points) + np.arange(4))]
    return np.concatenate([points, outside]), np.concatenate([cells, [cell]])


def duplicate_cell():
    """The same cell twice."""
    points, cells = box(3, 3, 3)
    return points, np.concatenate([cells, cells[13:14]])


def opposite_orientation():
    """Every second cell numbered inside out."""
    points, cells = box(4, 4, 4)
    cells = cells.copy()
    cells[::2] = cells[::2][:, TURNED]
    return points, cells


def all_inverted():
    """Every cell numbered inside out, as some programs write them."""
    points, cells = box(5, 4, 3, (5.0, 4.0, 3.0))
    return points, cells[:, TURNED]


def components():
    """Three bodies in one file."""
    return unite(*((moved(p, 1.5 * k, 0.0, 0.2 * k), c) for k, (p, c) in enumerate([box(3, 3, 3)] * 3)))


def touching_edge():
    """Two blocks that meet along an edge, and a third that meets them at a vertex."""
    blocks = np.zeros((3, 3, 2))
    blocks[0, 0, 0] = blocks[1, 1, 0] = blocks[2, 2, 1] = 1
    return polycube(blocks, 3)


SOLIDS = {
    "negative-volume": negative_volume, "zero-volume": zero_volume, "invalid-corner": invalid_corner,
    "invalid-inside": invalid_inside, "repeated-vertex": repeated_vertex,
    "unreferenced-vertices": unreferenced_vertices, "coincident-vertices": coincident_vertices,
    "shared-faces": shared_faces, "duplicate-cell": duplicate_cell, "opposite-orientation": opposite_orientation,
    "all-inverted": all_inverted, "components": components, "touching-edge": touching_edge,
}  # fmt: skip

FILES = {f"{name}.mesh": lambda solid=solid: medit(*solid()) for name, solid in SOLIDS.items()}
