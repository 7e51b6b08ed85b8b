"""Layouts: sheets, singular vertices and base complexes that are rare elsewhere."""

import numpy as np
from making.flat import disc, drop_unused, rectangle
from making.nodes import SPHERES, SPHERES_OF_SIX, node
from making.solid import extrude, moved, outward, sweep
from making.writing import medit


def row(spheres, steps=2, gap=3.4, most=5):
    """One node beside another, in rows."""
    points, cells, start = [], [], 0
    for place, sphere in enumerate(spheres.values()):
        one, one_cells = node(sphere, steps)
        points.append(moved(one, gap * (place % most), -gap * (place // most), 0))
        cells.append(one_cells + start)
        start += len(one)
    return np.concatenate(points), np.concatenate(cells)


def half_turned(layers, count=48):
    """A bar turned by half round and closed; with an odd number of layers the middle one meets itself, reversed."""
    section, quads = rectangle(layers, layers, 1.0, 1.0)
    rings = []
    for angle in 2 * np.pi * np.arange(count) / count:
        u, v = (section - 0.5).T * np.array([[0.9], [0.35]])
        c, s = np.cos(angle / 2), np.sin(angle / 2)
        radius, height = 1.6 + c * u - s * v, s * u + c * v
        rings.append(np.stack([radius * np.cos(angle), radius * np.sin(angle), height], 1))
    stride = len(section)
    cells = [np.concatenate([quads + k * stride, quads + (k + 1) * stride], 1) for k in range(count - 1)]
    cells.append(np.concatenate([quads + (count - 1) * stride, np.arange(stride)[::-1][quads]], 1))
    return outward(np.concatenate(rings), np.concatenate(cells))


def roll(turns=3, per_turn=24, width=6):
    """A single layer of cells rolled up: it lies on itself, and touches itself all along."""
    count = turns * per_turn
    angle = 2 * np.pi * np.arange(count + per_turn + 1) / per_turn
    radius = 0.5 + 0.22 * angle / (2 * np.pi)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle)], 1)
    k = np.arange(count)
    quads = np.stack([k, k + per_turn, k + per_turn + 1, k + 1], 1)
    return outward(*extrude((points, quads), np.linspace(0, 1.2, width + 1)))


def hoops(count=30):
    """A ring whose section is an O-grid: its four irregular edges close upon themselves, without a node."""
    angle = 2 * np.pi * np.arange(count) / count
    curve = 2 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], 1)
    return sweep(disc(3, 2), curve, closed=True)


def thick_torus(shift, long=40, round_=15, layers=2):
    """A thick-walled torus with a notch, whose rows of cells come round so many rows further on.

    The walls that start at the notch run along the rows. Where these close they are few; where the rows wind
    round the torus they pass every row before they end.
    """
    u, v = np.meshgrid(np.arange(long), np.arange(round_), indexing="ij")
    turned = 2 * np.pi * (v / round_ + shift * u / (round_ * long))
    angle = 2 * np.pi * u / long
    rings = []
    for radius in np.linspace(0.55, 0.9, layers + 1):
        out = 2 + radius * np.cos(turned)
        rings.append(
            np.stack([out * np.cos(angle), out * np.sin(angle), radius * np.sin(turned)], -1).reshape(-1, 3)
        )
    ids = np.arange(long * round_).reshape(long, round_)
    ahead = np.concatenate([ids[1:], np.roll(ids[:1], -shift, axis=1)])
    beside = np.roll(ids, -1, axis=1), np.roll(ahead, -1, axis=1)
    faces = np.stack([ids, ahead, beside[1], beside[0]], -1)
    stride = long * round_
    cells = [np.concatenate([faces + k * stride, faces + (k + 1) * stride], -1) for k in range(layers)]
    kept = np.ones((long, round_), dtype=bool)
    kept[:3, :3] = False
    cells = [cells[0].reshape(-1, 8), *(one[kept] for one in cells[1:])]
    return outward(*drop_unused(np.concatenate(rings), np.concatenate(cells)))


SOLIDS = {
    "nodes": lambda: row(SPHERES),
    "nodes-of-six": lambda: row(SPHERES_OF_SIX),
    "one-sided": lambda: half_turned(3),
    "self-touching": roll,
    "hoops": hoops,
    "winding-walls": lambda: thick_torus(1),
    "straight-walls": lambda: thick_torus(0),
}

FILES = {f"{name}.mesh": lambda solid=solid: medit(*solid()) for name, solid in SOLIDS.items()}
