"""Groups, features and numbers of a large mesh (SPEC R11 to R13): in this Python, and in the browser."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from hexalab import Features, Group, Mesh, read, write
from hexalab.session import Session

from .clock import median_ms, table
from .grids import grid_file
from .page import viewer

NAME = "1M"
SETS = 50
MATERIALS = 12

STEPS: tuple[tuple[str, str, tuple[Any, ...]], ...] = (
    ("list groups and features", "describe", ("groups",)),
    ("numbers", "numbers", ()),
    ("go to an element", "find", ("cell", 1_000_003, [0, 0, 1])),
    ("go to a node", "find", ("vertex", 100_005)),
    ("hide a group", "update", ({"filters": {"groups": {"hidden": ["material:M3"]}}},)),
    ("show it", "update", ({"filters": {"groups": {"hidden": []}}},)),
    ("colour by group", "update", ({"colour": {"by": "group", "grouping": "material"}},)),
    ("colour by sets that overlap", "update", ({"colour": {"by": "group", "grouping": "elset"}},)),
    ("statistics of all groups", "group_table", ()),
    ("where groups meet", "interfaces", ("material",)),
    ("draw where they meet", "update", ({"marks": {"interfaces": "material"}},)),
    ("sharp edges", "update", ({"marks": {"interfaces": "", "sharp_angle": 40}},)),
    ("another angle", "update", ({"marks": {"sharp_angle": 50}},)),
    ("a cell, with its groups", "inspect", (5,)),
)
"""What is done, the session's method, its arguments."""


def run(folder: Path) -> None:
    """Print both tables."""
    path = grouped_file(folder)
    whole = read(path)
    session = Session({"grid": lambda: whole})
    session.open_offered("grid")
    session.update()
    rows = []
    for what, method, arguments in STEPS:
        first = median_ms(partial(getattr(session, method), *arguments), 1)
        rows.append([what, first, median_ms(partial(getattr(session, method), *arguments), 3)])
    table(
        f"native: {SETS} sets and {MATERIALS} materials of a million cells [ms]", ["", "first", "again"], rows
    )
    with viewer(folder) as (page, address, errors):
        page.evaluate("(address) => window.hexalab.open(address)", f"{address}/bench/{path.name}")
        page.evaluate("() => window.hexalab.settled()")
        rows = [[what, *page.evaluate(TIMED, [name, list(args)])] for what, name, args in IN_PAGE]
        if errors:
            raise RuntimeError(f"the console reported {errors[0]}")
    table(
        "browser: the same [ms]; the core with the way to it, and to the picture that a software GPU draws",
        ["", "core", "to picture"],
        rows,
    )


TIMED = """async ([name, args]) => {
    const began = performance.now();
    await window.hexalab[name](...args);
    const took = performance.now() - began;
    return name === "setStatus" ? [window.hexalab.timings().slice, took] : [took, null];
}"""

IN_PAGE: tuple[tuple[str, str, tuple[Any, ...]], ...] = (
    ("list groups and features", "groups", ()),
    ("hide a group", "setStatus", ({"filters": {"groups": {"hidden": ["material:M3"]}}},)),
    ("show it", "setStatus", ({"filters": {"groups": {"hidden": []}}},)),
    ("colour by group", "setStatus", ({"colour": {"by": "group", "grouping": "material"}},)),
    ("colour by sets that overlap", "setStatus", ({"colour": {"by": "group", "grouping": "elset"}},)),
    ("statistics of all groups", "groupStatistics", ()),
    ("where groups meet", "interfaces", ("material",)),
    ("draw where they meet", "setStatus", ({"marks": {"interfaces": "material"}},)),
    ("sharp edges", "setStatus", ({"marks": {"interfaces": "", "sharp_angle": 40}},)),
    ("another angle", "setStatus", ({"marks": {"sharp_angle": 50}},)),
)
"""What is done, the method of `window.hexalab`, its arguments."""


def grouped_file(folder: Path) -> Path:
    """A grid of a million cells with groups, faces with references, and numbers in no order, as `.vtu`."""
    path = folder / "groups-1M.vtu"
    if not path.is_file():
        write(grouped(read(grid_file(NAME, ".vtk", folder))), path)
    return path


def grouped(grid: Mesh) -> Mesh:
    """The grid with materials in slabs, sets that overlap, the faces of its boundary, and numbers."""
    cells = np.arange(grid.cell_count)
    slab = cells * MATERIALS // grid.cell_count
    random = np.random.default_rng(3)
    topology = grid.topology
    rows = topology.faces.boundary
    skin = topology.corners_of(topology.face_cells[0, rows], topology.face_locals[0, rows])
    return replace(
        grid,
        cell_numbers=random.permutation(cells) * 2 + 1_000_001,
        vertex_numbers=np.arange(grid.vertex_count)[::-1] + 5,
        groups=(
            *(Group(f"M{n}", "material", np.flatnonzero(slab == n)) for n in range(MATERIALS)),
            *(Group(f"S{n}", "elset", cells[n :: n + 2]) for n in range(SETS)),
            Group("FIXED", "nset", np.arange(0, grid.vertex_count, 101), "vertex"),
        ),
        features=(Features(2, skin, {"reference": np.arange(skin.shape[1]) % 6 + 1}),),
    )
