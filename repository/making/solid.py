"""Solids of hexahedra: grids, polycubes, O-grid balls, extrusions and sweeps."""

import numpy as np

from .flat import join, rectangle


def extrude(pattern, heights):
    """Stack a flat pattern at the given heights."""
    points, quads = pattern
    heights = np.asarray(heights, dtype=float)
    layers = [np.column_stack([points, np.full(len(points), height)]) for height in heights]
    return np.concatenate(layers), _stack(quads, len(points), len(heights) - 1)


def box(columns, rows, layers, size=(1.0, 1.0, 1.0)):
    """A regular grid over [0, size]."""
    return extrude(rectangle(columns, rows, size[0], size[1]), np.linspace(0, size[2], layers + 1))


def polycube(blocks, steps):
    """steps^3 cells in each unit cube of a (nx, ny, nz) table of zeros and ones."""
    blocks = np.asarray(blocks, dtype=bool)
    points, cells = box(*(steps * n for n in blocks.shape), size=blocks.shape)
    middle = points[cells].mean(axis=1)
    kept = blocks[tuple(np.floor(middle).astype(int).T)]
    return join(points, cells[kept])


def ball(side, layers, core=0.5, bulge=0.4, centre_layers=0):
    """An O-grid of the unit ball: a core of side^3 cells and `layers` layers over each of its six sides.

    With `centre_layers` cells from the core's surface outwards left out, it is a shell.
    """
    points, cells = box(side, side, side, (2.0, 2.0, 2.0))
    parts = [] if centre_layers else [(core * _ball_point(points - 1.0, bulge), cells)]
    flat, quads = rectangle(side, side, 2.0, 2.0)
    u, v = (flat - 1.0).T
    one = np.ones_like(u)
    for axis in range(3):
        for sign in (-1.0, 1.0):
            surface = np.empty((len(u), 3))
            surface[:, axis] = sign * one
            surface[:, (axis + 1) % 3] = u * sign
            surface[:, (axis + 2) % 3] = v
            inside = core * _ball_point(surface, bulge)
            outside = np.tan(surface * np.pi / 4)
            outside /= np.linalg.norm(outside, axis=1, keepdims=True)
            steps = np.linspace(0, 1, layers + 1)[centre_layers:]
            points = np.concatenate([(1 - t) * inside + t * outside for t in steps])
            parts.append((points, _stack(quads, len(u), len(steps) - 1)))
    return unite(*parts)


def _ball_point(cube, amount):
    x, y, z = cube.T
    xx, yy, zz = x * x, y * y, z * z
    round_ = np.stack(
        [
            x * np.sqrt(1 - yy / 2 - zz / 2 + yy * zz / 3),
            y * np.sqrt(1 - zz / 2 - xx / 2 + zz * xx / 3),
            z * np.sqrt(1 - xx / 2 - yy / 2 + xx * yy / 3),
        ],
        axis=1,
    )
    return (1 - amount) * cube + amount * round_


def sweep(pattern, curve, closed=False, turns=0.0):
    """Carry a flat pattern along a curve (k, 3), without twist but for `turns` full turns over its length.

    A closed curve names its first point once; its pattern must fit itself when it comes round, which the frame is
    turned evenly to allow.
    """
    points, quads = pattern
    curve = np.asarray(curve, dtype=float)
    sections, sides = frames(curve, closed)
    count = len(curve)
    angles = 2 * np.pi * turns * np.arange(count) / (count if closed else count - 1)
    layers = []
    for centre, (first, second), angle in zip(sections, sides, angles, strict=True):
        c, s = np.cos(angle), np.sin(angle)
        u, v = points[:, :1], points[:, 1:]
        layers.append(centre + (c * u - s * v) * first + (s * u + c * v) * second)
    cells = _stack(quads, len(points), count if closed else count - 1)
    return outward(np.concatenate(layers), cells % (len(points) * count))


def frames(curve, closed):
    """Points of a curve, and at each two unit vectors across it that turn as little as can be."""
    ahead = np.roll(curve, -1, axis=0) - np.roll(curve, 1, axis=0)
    if not closed:
        ahead[0], ahead[-1] = curve[1] - curve[0], curve[-1] - curve[-2]
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    across = np.zeros(3)
    across[np.argmin(np.abs(ahead[0]))] = 1.0
    first = []
    for tangent in np.concatenate([ahead, ahead[:1]]) if closed else ahead:
        across = across - (across @ tangent) * tangent
        across = across / np.linalg.norm(across)
        first.append(across)
    if closed:
        start, end = first[0], first.pop()
        off = np.arctan2(np.cross(start, end) @ ahead[0], start @ end)
        parts = -off * np.arange(len(first)) / len(first)
        first = [
            np.cos(part) * one + np.sin(part) * np.cross(tangent, one)
            for part, one, tangent in zip(parts, first, ahead, strict=True)
        ]
    return curve, [(one, np.cross(tangent, one)) for one, tangent in zip(first, ahead, strict=True)]


def moved(points, *by):
    """Points moved by a vector."""
    return points + np.array(by, dtype=float)


def unite(*parts):
    """Put solids together and join the vertices that coincide."""
    points = np.concatenate([points for points, _ in parts])
    starts = np.cumsum([0] + [len(points) for points, _ in parts[:-1]])
    cells = np.concatenate([cells + start for (_, cells), start in zip(parts, starts, strict=True)])
    return outward(*join(points, cells))


def outward(points, cells):
    """Turn those cells round whose volume, taken from the middles of opposite faces, is negative."""
    corner = points[cells]
    along = [corner[:, b].mean(axis=1) - corner[:, a].mean(axis=1) for a, b in OPPOSITE]
    volume = (np.cross(along[0], along[1]) * along[2]).sum(axis=1)
    return points, np.where((volume < 0)[:, None], cells[:, TURNED], cells)


OPPOSITE = (([0, 3, 4, 7], [1, 2, 5, 6]), ([0, 1, 4, 5], [2, 3, 6, 7]), ([0, 1, 2, 3], [4, 5, 6, 7]))
TURNED = [4, 5, 6, 7, 0, 1, 2, 3]
"""A cell's corners with bottom and top exchanged: the same cell, numbered inside out."""


def _stack(quads, stride, layers):
    cells = [np.concatenate([quads + k * stride, quads + (k + 1) * stride], axis=1) for k in range(layers)]
    return np.concatenate(cells)
