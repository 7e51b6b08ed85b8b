"""Small meshes of our own, as files, for the tests of session and command line; what a browser's Python is asked."""

from __future__ import annotations

import sys
from collections import defaultdict
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

VARIANTS = 10
"""Most variants of one test that run inside Pyodide: it differs in its numpy and its word size, not in each mesh."""


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Inside Pyodide, which takes ten times as long, run a spread of each test's variants; natively all run."""
    if sys.platform != "emscripten":
        return
    variants: dict[tuple[Path, str], list[pytest.Item]] = defaultdict(list)
    for item in items:
        variants[item.path, getattr(item, "originalname", item.name)].append(item)
    chosen = {
        alike[k * len(alike) // min(len(alike), VARIANTS)]
        for alike in variants.values()
        for k in range(min(len(alike), VARIANTS))
    }
    config.hook.pytest_deselected(items=[item for item in items if item not in chosen])
    items[:] = [item for item in items if item in chosen]


def grid_points(shape: tuple[int, int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Points (V, 3) and cells (C, 8) of a grid of unit cubes, x fastest."""
    nx, ny, nz = shape
    z, y, x = np.meshgrid(np.arange(nz + 1), np.arange(ny + 1), np.arange(nx + 1), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1).astype(float)
    k, j, i = np.meshgrid(np.arange(nz), np.arange(ny), np.arange(nx), indexing="ij")
    first = (i + (nx + 1) * (j + (ny + 1) * k)).ravel()
    right, back, up = 1, nx + 1, (nx + 1) * (ny + 1)
    steps = [0, right, right + back, back, up, up + right, up + right + back, up + back]
    return points, first[:, None] + np.array(steps)


def medit(points: np.ndarray, cells: np.ndarray) -> bytes:
    """The mesh as a Medit file."""
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    lines += [" ".join(map(repr, map(float, point))) + " 0" for point in points]
    lines += ["Hexahedra", str(len(cells))]
    lines += [" ".join(map(str, cell + 1)) + " 0" for cell in cells]
    return "\n".join([*lines, "End", ""]).encode()


def legacy_vtk(points: np.ndarray, cells: np.ndarray, *data: str) -> bytes:
    """The mesh as a legacy VTK file, with sections of attributes."""
    lines = ["# vtk DataFile Version 3.0", "made by a test", "ASCII", "DATASET UNSTRUCTURED_GRID"]
    lines += [f"POINTS {len(points)} double", *(" ".join(map(repr, map(float, point))) for point in points)]
    lines += [f"CELLS {len(cells)} {9 * len(cells)}", *("8 " + " ".join(map(str, cell)) for cell in cells)]
    lines += [f"CELL_TYPES {len(cells)}", *["12"] * len(cells), *data, ""]
    return "\n".join(lines).encode()


@pytest.fixture(scope="session")
def grid() -> Callable[..., bytes]:
    """Call with a shape to get the bytes of a Medit file of a grid of unit cubes."""

    def make(*shape: int, inverted: bool = False) -> bytes:
        points, cells = grid_points(shape)  # type: ignore[arg-type]
        return medit(points, cells[:, [4, 5, 6, 7, 0, 1, 2, 3]] if inverted else cells)

    return make


@pytest.fixture(scope="session")
def attributed() -> bytes:
    """A 3 x 2 x 1 grid as VTK: cell array "load" 0..5, point arrays "height" (x) and "flow" (x, y, z)."""
    points, cells = grid_points((3, 2, 1))
    flow = [" ".join(map(str, point)) for point in points]
    sections = ["CELL_DATA 6", "SCALARS load double 1", "LOOKUP_TABLE default", *map(str, range(6))]
    sections += [f"POINT_DATA {len(points)}", "SCALARS height double 1", "LOOKUP_TABLE default"]
    sections += [*(str(point[0]) for point in points), "VECTORS flow double", *flow]
    return legacy_vtk(points, cells, *sections)


@pytest.fixture
def twisted() -> bytes:
    """Two unit cubes, of which the second is inverted at one corner."""
    points, cells = grid_points((2, 1, 1))
    points = np.array(points)
    points[11] = [0.2, 0.2, 0.2]
    return medit(points, cells)


@pytest.fixture
def mesh_file(tmp_path: Path, grid: Callable[..., bytes]) -> Path:
    """A file of 2 x 3 x 4 unit cubes."""
    path = tmp_path / "grid.mesh"
    path.write_bytes(grid(2, 3, 4))
    return path
