"""Shapes: the bodies that everybody meshes first."""

import numpy as np
from making.flat import annulus, disc, join, rectangle, rounded
from making.solid import ball, box, extrude, moved, outward, polycube, sweep
from making.writing import medit


def cube():
    return box(8, 8, 8)


def bar():
    return box(24, 4, 4, (6.0, 1.0, 1.0))


def twisted_bar():
    points, cells = box(24, 6, 6, (4.0, 1.0, 1.0))
    x, y, z = points[:, 0], points[:, 1] - 0.5, points[:, 2] - 0.5
    angle = np.pi * x / 4
    return np.stack(
        [x, np.cos(angle) * y - np.sin(angle) * z, np.sin(angle) * y + np.cos(angle) * z], 1
    ), cells


def cylinder():
    return extrude(disc(4, 3), np.linspace(0, 2.5, 13))


def sphere():
    return ball(6, 4)


def torus():
    angle = 2 * np.pi * np.arange(36) / 36
    section, quads = disc(4, 2)
    return sweep((0.4 * section, quads), np.stack([np.cos(angle), np.sin(angle), 0 * angle], 1), closed=True)


def pipe():
    return extrude(annulus(24, 3, 0.7, 1.0), np.linspace(0, 4, 17))


def elbow():
    angle = np.linspace(0, np.pi / 2, 15)
    arc = np.stack([2.5 * np.cos(angle), 2.5 * np.sin(angle), 0 * angle], 1)
    before = [(2.5, y, 0) for y in (-1.0, -0.75, -0.5, -0.25)]
    after = [(x, 2.5, 0) for x in (-0.25, -0.5, -0.75, -1.0)]
    return sweep(annulus(24, 2, 0.65, 0.9), np.concatenate([before, arc, after]))


def bent_pipe():
    angle = np.linspace(0, 3 * np.pi / 2, 31)
    curve = np.stack([1.6 * np.cos(angle), 1.6 * np.sin(angle), 0.35 * angle], 1)
    return sweep(tuple_scaled(disc(3, 2), 0.5), curve)


def t_junction():
    blocks = np.zeros((5, 1, 3))
    blocks[:, :, 0] = 1
    blocks[2, :, :] = 1
    points, cells = polycube(blocks, 5)
    p = 2 * (points - [2.5, 0.5, 0.5])
    x, y, z = p.T
    along_x = np.column_stack([x, rounded(np.stack([y, np.clip(z, -1, 1)], 1), 0.8)])
    along_z = np.column_stack([rounded(np.stack([np.clip(x, -1, 1), y], 1), 0.8), z])
    up = np.clip((z - 0.2) / 0.8, 0, 1)[:, None] * (np.abs(x) <= 1 + 1e-9)[:, None]
    up = up * (1 - np.clip((np.abs(x) - 0.4) / 0.6, 0, 1) * (z <= 1 + 1e-9))[:, None]
    return (1 - up) * along_x + up * along_z, cells


def gear():
    teeth, across = 12, 3
    around = 4 * teeth
    wheel, quads = annulus(around, across, 0.45, 1.0)
    angle = 2 * np.pi * np.arange(around) / around
    parts = [(wheel, quads)]
    tooth, tooth_quads = rectangle(2, 2)
    for number in range(teeth):
        at = angle[4 * number + 1] + tooth[:, 0] * 2 * (angle[1] - angle[0])
        middle = angle[4 * number + 2]
        radius = 1.0 + 0.25 * tooth[:, 1]
        at = middle + (at - middle) * (1 - 0.35 * tooth[:, 1])
        parts.append((np.stack([radius * np.cos(at), radius * np.sin(at)], 1), tooth_quads[:, ::-1]))
    starts = np.cumsum([0] + [len(points) for points, _ in parts[:-1]])
    flat = join(
        np.concatenate([points for points, _ in parts]),
        np.concatenate([cells + start for (_, cells), start in zip(parts, starts, strict=True)]),
    )
    return outward(*extrude(flat, np.linspace(0, 0.4, 5)))


def bracket():
    """A plate of four square tiles, two with a hole, bent up by a right angle between the pairs."""
    tiles = []
    for column in range(2):
        tiles.append(_tile_with_hole(column, 0.0))
        tiles.append(_tile_with_hole(column, 2.4))
        points, quads = rectangle(4, 4)
        tiles.append((points * [1.0, 1.4] + [column, 1.0], quads))
    starts = np.cumsum([0] + [len(points) for points, _ in tiles[:-1]])
    flat = join(
        np.concatenate([points for points, _ in tiles]),
        np.concatenate([quads + start for (_, quads), start in zip(tiles, starts, strict=True)]),
    )
    points, cells = extrude(flat, np.linspace(-0.1, 0.1, 4))
    u, along, off = points.T
    length, begin = 1.4, 1.0
    radius = length / (np.pi / 2)
    angle = np.clip((along - begin) / radius, 0, np.pi / 2)
    past = np.clip(along - begin - length, 0, None)
    before = np.minimum(along, begin)
    y = before + (radius - off) * np.sin(angle)
    z = radius - (radius - off) * np.cos(angle) + past
    return outward(np.stack([u, y, z], 1), cells)


def _tile_with_hole(column, row):
    """A unit square with a round hole: 16 quads around, 3 across."""
    step = np.arange(4) / 4
    rim = np.concatenate(
        [
            np.stack(side, 1)
            for side in (
                (step, 0 * step),
                (1 + 0 * step, step),
                (1 - step, 1 + 0 * step),
                (0 * step, 1 - step),
            )
        ]
    )
    angle = 2 * np.pi * np.arange(16) / 16 - 3 * np.pi / 4
    hole = 0.5 + 0.28 * np.stack([np.cos(angle), np.sin(angle)], 1)
    points = np.concatenate([(1 - t) * hole + t * rim for t in np.linspace(0, 1, 4)])
    ids = np.arange(64).reshape(4, 16)
    right = np.roll(ids, -1, axis=1)
    quads = np.stack([ids[:-1], ids[1:], right[1:], right[:-1]], axis=-1).reshape(-1, 4)
    return moved(points, column, row), quads


def knot():
    t = 2 * np.pi * np.arange(96) / 96
    curve = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], 1)
    return sweep(tuple_scaled(disc(2, 1), 0.42), curve, closed=True)


def spring():
    t = np.linspace(0, 8 * np.pi, 129)
    return sweep(tuple_scaled(disc(2, 1), 0.22), np.stack([np.cos(t), np.sin(t), t / 9], 1))


def thick_shell():
    points, cells = ball(10, 6, core=0.5, bulge=1.0, centre_layers=4)
    return join(points, cells[points[cells].mean(axis=1)[:, 2] > 0])


def nozzle():
    points, cells = extrude(disc(4, 3), np.linspace(0, 1, 25))
    z = points[:, 2]
    radius = 0.35 + 0.65 * (1 - np.sin(np.pi * np.clip(z / 0.8, 0, 1)) ** 2) * (1 - 0.35 * z)
    return np.stack([points[:, 0] * radius, points[:, 1] * radius, 3 * z], 1), cells


def lattice():
    """A frame of bars along the edges of a 2 x 2 x 2 grid of cubes."""
    table = np.zeros((5, 5, 5))
    even = np.arange(5) % 2 == 0
    table[np.add.outer(np.add.outer(even * 1, even * 1), even * 1) >= 2] = 1
    return polycube(table, 2)


def tuple_scaled(pattern, factor):
    points, quads = pattern
    return factor * points, quads


SOLIDS = {
    "cube": cube, "bar": bar, "twisted-bar": twisted_bar, "cylinder": cylinder, "sphere": sphere, "torus": torus,
    "pipe": pipe, "elbow": elbow, "bent-pipe": bent_pipe, "t-junction": t_junction, "gear": gear, "bracket": bracket,
    "knot": knot, "spring": spring, "thick-shell": thick_shell, "nozzle": nozzle, "lattice": lattice,
}  # fmt: skip

FILES = {f"{name}.mesh": lambda solid=solid: medit(*solid()) for name, solid in SOLIDS.items()}
