"""Two meshes in one page, and a mesh beside a reference surface (SPEC S6, S7)."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from hexalab import Mesh, compare, read, write
from hexalab.arrays import Floats, Ids

from .clock import median_ms, table
from .distance import bumpy_sphere
from .grids import grid_file
from .page import viewer

NAME = "1M"
MEBIBYTE = 2**20

SLAB = 220
"""Cells along two sides of a plate one cell thick: its boundary has some 98,000 vertices."""

TRIANGLES = 100_000

OPEN = "(address) => window.hexalab.open(address)"

TIMED = """async ([what, ...given]) => {
    const began = performance.now();
    await window.hexalab[what](...given);
    return performance.now() - began;
}"""

SLICE = {"filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.5}]}}}
COLOURS = {"colour": {"by": "attribute", "attribute": "change:shape"}}

STEPS: tuple[tuple[str, tuple[Any, ...]], ...] = (
    ("distances of both boundaries, both ways", ("distances",)),
    ("cells that got worse by the Scaled Jacobian", ("changes", "scaled_jacobian")),
    ("cells that got worse by Shape", ("changes", "shape")),
    ("a slice through both", ("setStatus", SLICE)),
    ("colours of a change", ("setStatus", COLOURS)),
    ("each in the other's place", ("swap",)),
)
"""What is done with two meshes, one after the other, until it is drawn."""


def run(folder: Path) -> None:
    """Print the tables."""
    before = grid_file(NAME, ".vtk", folder)
    after = pushed(before, folder)
    first, second = read(before), read(after)
    took = median_ms(partial(compare, first, second), 1)
    chosen = median_ms(partial(compare, first, second, ["scaled_jacobian"]), 1)
    table(
        "native: two meshes of a million cells and the same cells [ms]",
        ["what is compared", ""],
        [["all metrics, all facts of both", took], ["Scaled Jacobian alone", chosen]],
    )
    plate, surface = plate_file(folder), surface_file(folder)
    with viewer(folder) as (page, address, errors):
        page.evaluate(OPEN, f"{address}/bench/{plate.name}")
        rows = [["read", page.evaluate(TIMED, ["compare", f"{address}/bench/{surface.name}"])]]
        rows.append(["distances, both ways", page.evaluate(TIMED, ["distances"])])
        vertices = page.evaluate("() => window.hexalab.distances().then((apart) => apart.a_to_b.vertices)")
        page.evaluate("() => window.hexalab.endComparison()")
        title = f"browser: {vertices:,} vertices beside a surface of {TRIANGLES:,} triangles [ms]"
        table(title, ["", ""], rows)
        page.evaluate(OPEN, f"{address}/bench/{before.name}")
        page.evaluate("() => window.hexalab.settled()")
        compared = page.evaluate(TIMED, ["compare", f"{address}/bench/{after.name}"])
        page.evaluate("() => window.hexalab.settled()")
        rows = [["the second core starts, reads, both know of each other, both are drawn", compared]]
        rows += [[what, page.evaluate(TIMED, list(asked))] for what, asked in STEPS]
        memory = page.evaluate("() => window.hexalab.memories()")
        rows += [
            [f"memory of core {name} [MiB]", size / MEBIBYTE] for name, size in zip("AB", memory, strict=True)
        ]
        table("browser: two meshes of a million cells in one page [ms]", ["", ""], rows)
        for error in errors:
            print(f"console: {error}")


def pushed(path: Path, folder: Path) -> Path:
    """The same cells, each vertex a little elsewhere."""
    file = folder / "pushed.vtk"
    if not file.is_file():
        mesh = read(path)
        moved = mesh.coordinates + np.random.default_rng(5).uniform(-0.1, 0.1, mesh.coordinates.shape)
        write(Mesh(moved, mesh.corners, mesh.kinds), file)
    return file


def plate_file(folder: Path) -> Path:
    """A plate of 220 x 220 x 1 cells."""
    file = folder / "plate.vtk"
    side = np.arange(SLAB + 1)
    z, y, x = np.meshgrid([0.0, 1.0], side, side, indexing="ij")
    ids = np.arange(x.size).reshape(x.shape)
    low, high = slice(None, -1), slice(1, None)
    ring = ((low, low), (low, high), (high, high), (high, low))
    cells = np.stack([ids[layer][j, i].reshape(-1) for layer in (0, 1) for j, i in ring], axis=1)
    write(Mesh.from_cells(np.stack([x, y, z], axis=-1).reshape(-1, 3), cells), file)
    return file


def surface_file(folder: Path) -> Path:
    """A bumpy sphere of so many triangles around the plate, as OFF."""
    file = folder / "sphere.off"
    points: Floats
    triangles: Ids
    points, triangles = bumpy_sphere(TRIANGLES, 0.03)
    with open(file, "w", encoding="ascii") as out:
        out.write(f"OFF\n{points.shape[1]} {triangles.shape[1]} 0\n")
        np.savetxt(out, SLAB / 2 * (points.T + 1), "%.9g")
        np.savetxt(out, np.insert(triangles.T, 0, 3, axis=1), "%d")
    return file
