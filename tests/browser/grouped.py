"""A deck with materials, sets and numbers of its own, and a mesh with features, for the tests of groups."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np

import hexalab
from hexalab import Features, Group, Mesh

from .conftest import grid

SIDES = (8, 4, 4)
LONG = "A_VERY_LONG_NAME_OF_AN_ELEMENT_SET_THAT_GOES_ON_AND_ON"
MARKUP = "<script>window.broken = 1</script><img src=x onerror='window.broken = 2'>"

SECTIONS = "".join(
    f"*SOLID SECTION, ELSET={name}_CELLS, MATERIAL={name}\n" for name in ("STEEL", "RUBBER", "GLASS")
)


def solid() -> Mesh:
    """A box of 8 x 4 x 4 cells whose numbers have gaps and no order; one cell is inverted."""
    mesh = grid(*SIDES, noise=0.15)
    points = mesh.points.copy()
    inner = np.flatnonzero((points - [1, 1, 1]).round().any(axis=1) == 0)
    points[inner] += [0.9, 0.9, 0.9]
    random = np.random.default_rng(5)
    return dataclasses.replace(
        Mesh.from_cells(points, mesh.cells),
        cell_numbers=random.permutation(mesh.cell_count) * 3 + 1001,
        vertex_numbers=np.arange(mesh.vertex_count) * 2 + 10,
        first_number=1,
    )


def places(mesh: Mesh) -> np.ndarray:
    """Column, row and layer of each cell, (3, C)."""
    return np.stack(np.unravel_index(np.arange(mesh.cell_count), SIDES))


def sets(mesh: Mesh) -> dict[str, np.ndarray]:
    """Rows of the deck's sets of elements."""
    x, y, z = places(mesh)
    return {
        "STEEL_CELLS": np.flatnonzero(x < 3),
        "RUBBER_CELLS": np.flatnonzero((x >= 3) & (x < 6)),
        "GLASS_CELLS": np.flatnonzero(x >= 6),
        "FLANGE": np.flatnonzero(z == 3),
        LONG: np.flatnonzero(y == 3),
    }


def deck(path: Path) -> Mesh:
    """Write the box as an Abaqus deck; returns the mesh that was written."""
    mesh = solid()
    groups = [Group(name, "elset", rows) for name, rows in sets(mesh).items()]
    fixed = Group("FIXED", "nset", np.flatnonzero(mesh.points[:, 0] == 0), "vertex")
    mesh = dataclasses.replace(mesh, groups=(*groups, fixed))
    hexalab.write(mesh, path)
    path.write_text(path.read_text() + SECTIONS)
    return mesh


def featured(path: Path) -> Mesh:
    """Write a box with corners, edges and faces that have references; one edge is none of the mesh."""
    mesh = grid(*SIDES)
    ids = np.arange(mesh.vertex_count).reshape([side + 1 for side in SIDES])
    rims = [np.stack([line[:-1], line[1:]]) for line in (ids[:, 0, 0], ids[:, -1, 0])]
    edges = np.concatenate([*rims, [[ids[0, 0, 0]], [ids[-1, -1, -1]]]], axis=1)
    topology = mesh.topology
    rows = topology.faces.boundary
    skin = topology.corners_of(topology.face_cells[0, rows], topology.face_locals[0, rows])
    top = skin[:, (mesh.coordinates[2][skin] == SIDES[2]).all(axis=0)]
    features = (
        Features(0, [[ids[0, 0, 0], ids[-1, 0, 0]]]),
        Features(1, edges, {"reference": np.array([1] * 8 + [2] * 8 + [3])}),
        Features(2, top, {"reference": np.full(top.shape[1], 7)}),
    )
    groups = (Group(MARKUP, "elset", [1, 2, 3]), Group("EMPTY", "elset", []))
    mesh = dataclasses.replace(mesh, features=features, groups=groups)
    hexalab.write(mesh, path)
    return mesh
