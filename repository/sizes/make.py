"""Sizes: grids from one cell to a million, their inner vertices moved by a seeded noise so that quality varies."""

import numpy as np
from making.solid import box
from making.writing import medit, packed

SIZES = {
    1: (1, 1, 1),
    10: (5, 2, 1),
    100: (5, 5, 4),
    1_000: (10, 10, 10),
    10_000: (25, 20, 20),
    97_336: (46, 46, 46),
    216_000: (60, 60, 60),
    1_000_000: (100, 100, 100),
}


def noisy_grid(columns, rows, layers, amount=0.15):
    """A grid of unit cells; each inner vertex is moved by up to `amount` of a cell's side along each axis."""
    points, cells = box(columns, rows, layers, (columns, rows, layers))
    inner = ((points > 0) & (points < (columns, rows, layers))).all(axis=1)
    noise = np.random.default_rng(columns * rows * layers).uniform(-amount, amount, points.shape)
    return np.round(points + noise * inner[:, None], 3), cells


def file_name(count):
    """``grid-1000.mesh``; files that aren't committed are gzipped."""
    return f"grid-{count}.mesh" + (".gz" if count > 1_000 else "")


def _bytes(count):
    data = medit(*noisy_grid(*SIZES[count]))
    return packed(data) if count > 1_000 else data


FILES = {file_name(count): lambda count=count: _bytes(count) for count in SIZES}
