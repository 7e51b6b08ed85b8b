"""Flat patterns of quadrilaterals, to be extruded or swept into solids."""

import numpy as np


def rectangle(columns, rows, width=1.0, height=1.0):
    """A grid of columns x rows quads over [0, width] x [0, height]."""
    x, y = np.meshgrid(np.linspace(0, width, columns + 1), np.linspace(0, height, rows + 1))
    ids = np.arange((columns + 1) * (rows + 1)).reshape(rows + 1, columns + 1)
    quads = np.stack([ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]], axis=-1)
    return np.stack([x.ravel(), y.ravel()], axis=1), quads.reshape(-1, 4)


def annulus(around, across, inner=0.5, outer=1.0):
    """A ring of around x across quads between two circles."""
    angle = 2 * np.pi * np.arange(around) / around
    radius = np.linspace(inner, outer, across + 1)
    points = np.stack(
        [np.outer(radius, np.cos(angle)).ravel(), np.outer(radius, np.sin(angle)).ravel()], axis=1
    )
    ids = np.arange(around * (across + 1)).reshape(across + 1, around)
    right = np.roll(ids, -1, axis=1)
    quads = np.stack([ids[:-1], ids[1:], right[1:], right[:-1]], axis=-1)
    return points, quads.reshape(-1, 4)


def disc(side, rings, core=0.5, bulge=0.4):
    """An O-grid of the unit disc: a core of side x side quads, and rings of 4 * side quads around it."""
    square, core_quads = rectangle(side, side, 2.0, 2.0)
    core_points = core * rounded(square - 1.0, bulge)
    step = np.arange(side)
    row = side + 1
    rim = np.concatenate(
        [step, step * row + side, side * row + side - step, (side - step) * row]
    )  # counter-clockwise from the lower left corner
    angle = 2 * np.pi * (np.arange(4 * side) / (4 * side)) - 3 * np.pi / 4
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points, quads = [core_points], [core_quads]
    below = rim
    for ring in range(1, rings + 1):
        part = ring / rings
        above = len(core_points) + (ring - 1) * 4 * side + np.arange(4 * side)
        points.append((1 - part) * core_points[rim] + part * circle)
        quads.append(np.stack([below, above, np.roll(above, -1), np.roll(below, -1)], axis=1))
        below = above
    return np.concatenate(points), np.concatenate(quads)


def rounded(square, amount):
    """The square [-1, 1]^2 blown towards the unit disc; amount 1 is all the way."""
    u, v = square.T
    round_ = np.stack([u * np.sqrt(1 - v * v / 2), v * np.sqrt(1 - u * u / 2)], axis=1)
    return (1 - amount) * square + amount * round_


def fan(blades, steps):
    """Steps x steps quads in each of `blades` blades around one vertex, which gets that valence."""
    points, quads = [], []
    grid, cells = rectangle(steps, steps)
    for blade in range(blades):
        start, end = 2 * np.pi * blade / blades, 2 * np.pi * (blade + 1) / blades
        first = np.array([np.cos(start), np.sin(start)])
        last = np.array([np.cos(end), np.sin(end)])
        middle = (first + last) / np.linalg.norm(first + last)
        u, v = grid[:, :1], grid[:, 1:]
        points.append(u * (1 - v) * first + v * (1 - u) * last + u * v * middle)
        quads.append(cells + blade * len(grid))
    return join(np.concatenate(points), np.concatenate(quads))


def join(points, cells, digits=9):
    """Make one vertex of those that coincide to so many digits; unused vertices are dropped."""
    keys = np.round(points, digits) + 0.0
    _, first, same = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    cells = rank[same.reshape(-1)][cells]
    return drop_unused(points[first[order]], cells)


def drop_unused(points, cells):
    """Keep only the vertices that cells use."""
    used = np.unique(cells)
    number = np.full(len(points), -1)
    number[used] = np.arange(len(used))
    return points[used], number[cells]
