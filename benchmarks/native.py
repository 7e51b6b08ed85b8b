"""The core in this Python: reading beside meshio and VTK, topology, quality, surfaces, slices."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import count
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import vtk

import hexalab
from hexalab.filters.stack import FilterStack
from hexalab.formats import WRITERS, write_bytes
from hexalab.quality import METRICS
from hexalab.quality.validity import certify
from hexalab.session import Session
from hexalab.topology.repeats import repeated_cells

from .clock import median_ms, table
from .grids import PICKED, SIZES, grid_file

STEPS = (
    "faces", "edges", "depth", "scaled Jacobian", "all metrics", "validity", "filter", "slice",
    "slice, picked", "fissure", "rounded", "repeats", "one value",
)  # fmt: skip


def run(folder: Path) -> None:
    """Print the native tables."""
    table(
        "native: read a file [ms]",
        ["file", "hexalab", "meshio", "VTK"],
        [_reading(name, suffix, folder) for name in SIZES for suffix in (".mesh", ".vtk")],
    )
    table(
        "native: what opening, measuring and slicing take [ms]",
        ["mesh", *STEPS],
        [[name, *_step_times(name, folder)] for name in SIZES],
    )
    grids = [hexalab.read(grid_file(name, ".mesh", folder)) for name in SIZES]
    table(
        "native: each metric of all cells [ms]",
        ["metric", *SIZES],
        [[metric, *_metric_times(grids, metric)] for metric in METRICS],
    )
    table(
        "native: write a file, into memory [ms]",
        ["format", *SIZES],
        [[row.id, *(median_ms(partial(write_bytes, mesh, row.id), 1) for mesh in grids)] for row in WRITERS],
    )


def _metric_times(grids: list[hexalab.Mesh], metric: str) -> list[float]:
    return [median_ms(partial(hexalab.quality, mesh, metric)) for mesh in grids]


def _reading(name: str, suffix: str, folder: Path) -> list[object]:
    path = grid_file(name, suffix, folder)
    runs = 1 if name == "1M" else 3
    peers: list[float | None] = [median_ms(lambda: meshio.read(path), runs), None]
    if suffix == ".vtk":
        peers[1] = median_ms(lambda: _read_vtk(path), runs)
    return [path.name, median_ms(lambda: hexalab.read(path), runs), *peers]


def _read_vtk(path: Path) -> None:
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()


def _steps(path: Path, mesh: hexalab.Mesh, session: Session) -> dict[str, Callable[[], Any]]:
    """Name of a step to what does it, each on a mesh that knows nothing yet but what the step before made."""

    def fresh() -> hexalab.Mesh:
        return hexalab.Mesh(mesh.coordinates, mesh.corners, mesh.kinds)

    stack = FilterStack(mesh, lambda quantity: hexalab.quality(mesh, quantity))
    offsets = iter(np.tile(np.linspace(0.3, 0.7, 41), 50))
    pointed = count(mesh.cell_count // 2)
    faces = mesh.topology.faces

    def plane(offset: float) -> dict[str, Any]:
        return {"filters": {"planes": {"items": [{"enabled": True, "normal": [1, 0, 0], "offset": offset}]}}}

    picked = Session()
    picked.open(path.name, path.read_bytes())
    picked.update({"filters": {"picking": {"hidden": list(range(min(PICKED, mesh.cell_count // 4)))}}})

    def separation(mode: str) -> Callable[[], Any]:
        def change() -> None:
            session.update({"separation": {"mode": "lines"}} | plane(0.5))
            session.update({"separation": {"mode": mode}})

        return change

    return {
        "faces": lambda: fresh().topology.face_cells,
        "edges": lambda: fresh().topology.edge_cells,
        "depth": lambda: fresh().topology.depth,
        "scaled Jacobian": lambda: hexalab.quality(mesh, "scaled_jacobian"),
        "all metrics": lambda: [hexalab.quality(mesh, metric) for metric in METRICS],
        "validity": lambda: certify(mesh),
        "filter": lambda: stack.apply(plane(float(next(offsets)))["filters"]),
        "slice": lambda: session.update(plane(float(next(offsets)))),
        "slice, picked": lambda: picked.update(plane(float(next(offsets)))),
        "fissure": separation("fissure"),
        "rounded": separation("rounded"),
        "repeats": lambda: repeated_cells(mesh.corners, faces),
        "one value": lambda: session.value(next(pointed), "shape_and_size"),
    }


def _step_times(name: str, folder: Path) -> list[float]:
    path = grid_file(name, ".mesh", folder)
    mesh, session = hexalab.read(path), Session()
    session.open(path.name, path.read_bytes())
    session.update({})
    while not session.measure_sizes():
        pass
    runs = {"filter": 21, "slice": 21, "slice, picked": 21, "one value": 21}
    return [
        median_ms(step, runs.get(label, 1 if name == "1M" else 3))
        for label, step in _steps(path, mesh, session).items()
    ]
