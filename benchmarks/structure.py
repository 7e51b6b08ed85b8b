"""The structure of a million cells (SPEC T1 to T5): traced in this Python and in the browser, and looked at."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from hexalab import Mesh, read, write
from hexalab.session import Session
from hexalab.session.preparing import prepared
from hexalab.session.traced import STEPS

from .clock import median_ms, table
from .grids import grid_file
from .page import viewer

NAME = "1M"
LAYOUT = Path("repository/layouts/winding-walls.mesh")
FINER = 10
"""The layout's 1,191 cells are cut into so many along each edge."""

LOOKS: tuple[tuple[str, dict[str, Any]], ...] = (
    ("blocks in colours", {"structure": {"kind": "blocks"}, "colour": {"by": "block"}}),
    ("two blocks, the rest faint", {"structure": {"chosen": [0, 1]}}),
    ("blocks apart", {"structure": {"chosen": [], "explode": 0.3}}),
    ("further apart", {"structure": {"explode": 0.4}}),
    ("walls between blocks", {"structure": {"explode": 0, "form": "surfaces"}}),
    (
        "two dual surfaces",
        {"structure": {"kind": "sheets", "chosen": [0, 1], "form": "surfaces"}, "colour": {"by": "chosen"}},
    ),
    ("their cells", {"structure": {"form": "cells"}}),
    ("arcs of the boundary", {"structure": {"kind": "arcs", "chosen": [], "boundary": True}}),
    ("nothing any more", {"structure": {"kind": "none"}, "colour": {"by": "sides"}}),
    ("two sheets alone", {"filters": {"structure": {"sheets": [0, 1]}}}),
    ("all", {"filters": {"structure": {"sheets": []}}}),
    ("distance in colours", {"colour": {"by": "attribute", "attribute": "structure:smallest_sheet"}}),
)
"""What is looked at, one after the other."""


TRACED = """async () => {
    const began = performance.now();
    await window.hexalab.structure();
    return [performance.now() - began, window.hexalab.memory() / 2 ** 20];
}"""

LOOKED = """async (status) => {
    const began = performance.now();
    await window.hexalab.setStatus(status);
    return [window.hexalab.timings().slice, performance.now() - began];
}"""


def run(folder: Path) -> None:
    """Print the tables."""
    paths = {"grid": grid_file(NAME, ".vtk", folder), "57 blocks": layout_file(folder)}
    sessions = {name: _session(path) for name, path in paths.items()}
    times = {name: _traced(session) for name, session in sessions.items()}
    rows: list[list[Any]] = [[step, *(of[step] for of in times.values())] for step in STEPS]
    rows.append(["all of it", *(sum(of.values()) for of in times.values())])
    rows.append(
        [
            "facts, with hashes",
            *(median_ms(partial(one.structure_facts, True), 1) for one in sessions.values()),
        ]
    )
    table("native: tracing the structure of a million cells [ms]", ["", *paths], rows)
    session = sessions["57 blocks"]
    session.update()
    rows = [[what, median_ms(partial(session.update, status), 1)] for what, status in LOOKS]
    table("native: looking at it, the first time [ms]", ["", "57 blocks"], rows)
    with viewer(folder) as (page, address, errors):
        rows = []
        for name, path in paths.items():
            page.evaluate("(address) => window.hexalab.open(address)", f"{address}/bench/{path.name}")
            page.evaluate("() => window.hexalab.settled()")
            rows.append([name, *page.evaluate(TRACED)])
        table(
            "browser: tracing it, with facts and hashes [ms]; memory of the core then [MB]",
            ["", "ms", "MB"],
            rows,
        )
        rows = [[what, *page.evaluate(LOOKED, status)] for what, status in LOOKS]
        if errors:
            raise RuntimeError(f"the console reported {errors[0]}")
    table(
        "browser: looking at it [ms]; the core with the way to it, and to the picture that a software GPU draws",
        ["57 blocks", "core", "to picture"],
        rows,
    )


def _session(path: Path) -> Session:
    session = Session({"mesh": lambda: prepared(read(path))})
    session.open_offered("mesh")
    return session


def _traced(session: Session) -> dict[str, float]:
    """Milliseconds of each step."""
    return {step: median_ms(session.trace, 1) for step in STEPS}


def layout_file(folder: Path) -> Path:
    """A layout of 57 blocks as a mesh of a million cells, as `.vtk`."""
    path = folder / "layout-1M.vtk"
    if not path.is_file():
        folder.mkdir(parents=True, exist_ok=True)
        write(refined(read(LAYOUT), FINER), path)
    return path


def refined(mesh: Mesh, parts: int) -> Mesh:
    """Cut each hexahedron into parts x parts x parts; corners at one place are one vertex."""
    line = np.linspace(0, 1, parts + 1)
    u, v, w = (axis.reshape(-1) for axis in np.meshgrid(line, line, line, indexing="ij"))
    weights = np.stack(
        [a * b * c for c in (1 - w, w) for a, b in (((1 - u), (1 - v)), (u, (1 - v)), (u, v), ((1 - u), v))]
    )
    points = np.round(mesh.points[mesh.cells].transpose(0, 2, 1) @ weights, 9)  # (C, 3, n)
    vertices, place = np.unique(points.transpose(0, 2, 1).reshape(-1, 3), axis=0, return_inverse=True)
    ids = np.arange((parts + 1) ** 3).reshape(parts + 1, parts + 1, parts + 1)
    low, high = slice(None, -1), slice(1, None)
    ring = ((low, low), (high, low), (high, high), (low, high))
    corners = np.stack([ids[i, j, k].reshape(-1) for k in (low, high) for i, j in ring], axis=1)
    of_cells = place.reshape(mesh.cell_count, -1)[:, corners].reshape(-1, 8)
    return Mesh.from_cells(vertices, of_cells.astype(np.int32))
