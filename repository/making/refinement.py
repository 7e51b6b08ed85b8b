"""Transitions between coarse and fine grids, made of flat templates applied in one direction after the other.

A template fills the unit square over a coarse edge: its lower side is cut into parts, its upper side is not (or into
fewer). Swept across and applied again in the other direction to the cells that carry the lower side, it gives the
solid template: 13 cells between one and 3 x 3 faces (Schneiders 1996), 28 between 2 x 2 and 4 x 4 (Ito et al. 2009).
"""

from itertools import pairwise

import numpy as np

from .solid import unite

THIRDS = (
    np.array([[0, 0], [1 / 3, 0], [2 / 3, 0], [1, 0], [0, 1], [1, 1], [1 / 3, 0.5], [2 / 3, 0.5]]),
    np.array([[0, 1, 6, 4], [1, 2, 7, 6], [2, 3, 5, 7], [6, 7, 5, 4]]),
)
"""One edge above, three below; the last quad doesn't touch the lower side."""

HALVES = (
    np.array(
        [
            [0, 0],
            [0.25, 0],
            [0.5, 0],
            [0.75, 0],
            [1, 0],
            [0, 1],
            [0.5, 1],
            [1, 1],
            [0.25, 0.5],
            [0.5, 0.5],
            [0.75, 0.5],
        ]
    ),
    np.array([[0, 1, 8, 5], [1, 2, 9, 8], [2, 3, 10, 9], [3, 4, 7, 10], [5, 8, 9, 6], [6, 9, 10, 7]]),
)
"""Two edges above, four below; the last two quads don't touch the lower side."""

LOWER = {id(THIRDS): 3, id(HALVES): 4}


def transition(template):
    """The solid template over the unit square, refined below in both directions: points and cells."""
    points, quads = template
    lower = LOWER[id(template)]
    upper_cuts = np.unique(points[points[:, 1] == 1][:, 0])
    parts = []
    for quad in quads[:lower]:
        parts.append(_refined(points[quad], template))
    for quad in quads[lower:]:
        for start, end in pairwise(upper_cuts):
            parts.append(_plain(points[quad], start, end))
    return unite(*parts)


def edge_transition(template, steps=1):
    """The flat template swept along y: refined in one direction only."""
    points, quads = template
    cuts = np.linspace(0, 1, steps + 1)
    rows = pairwise(cuts)
    return unite(*(_plain(points[quad], start, end) for start, end in rows for quad in quads))


def tiled(template, columns, rows, size=1.0, corner=(0.0, 0.0, 0.0)):
    """Copies of a solid over a grid of squares."""
    points, cells = template
    scaled = points * size + corner
    moves = [(size * i, size * j, 0.0) for i in range(columns) for j in range(rows)]
    return unite(*((scaled + move, cells) for move in moves))


def _plain(quad, start, end):
    front = np.column_stack([quad[:, 0], np.full(4, start), quad[:, 1]])
    back = np.column_stack([quad[:, 0], np.full(4, end), quad[:, 1]])
    return np.concatenate([front, back]), np.arange(8)[None]


def _refined(quad, template):
    """The template applied across y inside a quad whose first edge is the lower one."""
    points, quads = template
    y, up = points.T
    sides = []
    for low, high in ((quad[0], quad[3]), (quad[1], quad[2])):
        x, z = (np.outer(1 - up, low) + np.outer(up, high)).T
        sides.append(np.stack([x, y, z], 1))
    count = len(points)
    return np.concatenate(sides), np.concatenate([quads, quads + count], axis=1)
