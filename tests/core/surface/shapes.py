"""Meshes to cut: grids of each kind of cell, conforming, with the cells turned at random."""

from __future__ import annotations

from itertools import permutations, product

import numpy as np
from numpy.typing import NDArray

from hexalab.mesh import Mesh

COLLAPSE = (
    (0, 1, 2, 3, 4, 5, 6, 7),
    (0, 1, 2, 2, 3, 4, 5, 5),
    (0, 1, 2, 3, 4, 4, 4, 4),
    (0, 1, 2, 2, 3, 3, 3, 3),
)
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
KINDS = ("hexahedron", "wedge", "pyramid", "tetrahedron")


def _rotations() -> list[list[int]]:
    """The 24 ways to renumber a hexahedron's corners that keep it right side out."""
    found = []
    places = np.array(CORNERS) * 2 - 1
    for axes, signs in product(permutations(range(3)), product((-1, 1), repeat=3)):
        turn = np.zeros((3, 3))
        turn[range(3), axes] = signs
        if np.linalg.det(turn) > 0:
            turned = (places @ turn.T).round().astype(int).tolist()
            found.append([places.tolist().index(place) for place in turned])
    return found


ROTATIONS = _rotations()


def mesh_of(points: NDArray[np.float64], cells: NDArray[np.int32], kind: int = 0) -> Mesh:
    """A mesh of (V, 3) points and (C, 8) cells."""
    cells = np.ascontiguousarray(np.asarray(cells, dtype=np.int32).reshape(-1, 8).T)
    return Mesh(np.ascontiguousarray(points.T), cells, np.full(cells.shape[1], kind, np.uint8))


def grid_points(nx: int, ny: int, nz: int, jitter: float = 0.0, seed: int = 0) -> NDArray[np.float64]:
    """Points of a grid of unit cubes, x fastest, each displaced by up to `jitter` along each axis."""
    z, y, x = np.meshgrid(np.arange(nz + 1), np.arange(ny + 1), np.arange(nx + 1), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1).astype(float)
    return points + np.random.default_rng(seed).uniform(-jitter, jitter, points.shape)


def grid_cells(nx: int, ny: int, nz: int) -> NDArray[np.int32]:
    """Cells (C, 8) of such a grid."""
    k, j, i = (axis.ravel() for axis in np.meshgrid(range(nz), range(ny), range(nx), indexing="ij"))
    return np.stack([((k + c) * (ny + 1) + j + b) * (nx + 1) + i + a for a, b, c in CORNERS], axis=1)


def grid(nx: int, ny: int, nz: int, jitter: float = 0.0, turned: bool = True) -> Mesh:
    """A grid of hexahedra."""
    cells = grid_cells(nx, ny, nz)
    return mesh_of(grid_points(nx, ny, nz, jitter), _turn(cells) if turned else cells)


def unit_cube() -> Mesh:
    """One cube of edge 1."""
    return grid(1, 1, 1, turned=False)


def split_grid(kind: str, n: int, jitter: float = 0.0) -> Mesh:
    """An n x n x n grid whose cubes are cut into cells of one kind that meet face to face.

    Two wedges each, six pyramids about the middle, six tetrahedra around the diagonal. The eight corners of
    each collapsed cell are turned at random, so that neighbours repeat different corners of a triangle.
    """
    cubes = grid_cells(n, n, n)
    points = grid_points(n, n, n, jitter)
    if kind == "hexahedron":
        parts = [cubes]
    elif kind == "wedge":
        parts = [cubes[:, [0, 1, 2, 4, 5, 6]], cubes[:, [0, 2, 3, 4, 6, 7]]]
    elif kind == "pyramid":
        middles = np.arange(len(cubes))[:, None] + len(points)
        points = np.concatenate([points, points[cubes].mean(axis=1)])
        faces = ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))
        parts = [np.concatenate([cubes[:, list(face)], middles], axis=1) for face in faces]
    else:
        parts = [cubes[:, [0, *path, 6]] for path in ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1))]
    number = KINDS.index(kind)
    cells = np.concatenate([part[:, list(COLLAPSE[number])] for part in parts])
    return mesh_of(points, _turn(cells), number)


def _turn(cells: NDArray[np.int32], seed: int = 1) -> NDArray[np.int32]:
    turns = np.array(ROTATIONS)[np.random.default_rng(seed).integers(24, size=len(cells))]
    return np.take_along_axis(cells, turns, axis=1)


def three_around_an_edge(layers: int) -> Mesh:
    """A prism of three columns of cells around its axis: an interior edge of three cells in each layer."""
    angles = np.arange(6) * np.pi / 3
    ring = np.stack([np.cos(angles), np.sin(angles)], axis=1) * np.array([1, 0.5, 1, 0.5, 1, 0.5])[:, None]
    flat = np.concatenate([[[0.0, 0.0]], ring])
    points = np.concatenate([np.column_stack([flat, np.full(7, float(z))]) for z in range(layers + 1)])
    bases = ((0, 6, 1, 2), (0, 2, 3, 4), (0, 4, 5, 6))
    cells = [
        [7 * z + v for v in base] + [7 * (z + 1) + v for v in base] for z in range(layers) for base in bases
    ]
    return mesh_of(points, np.array(cells))


def random_mask(count: int, seed: int, share: float = 0.5) -> NDArray[np.bool_]:
    """Which of some cells are shown."""
    return np.random.default_rng(seed).random(count) < share
