"""The whole picture once more after a change of looks, without and with a cell that is inspected and outlined.

python -m benchmarks.resting
"""

from __future__ import annotations

import statistics
from pathlib import Path

from playwright.sync_api import Page

from .clock import table
from .grids import grid_file
from .page import viewer

NAMES = ("25k", "216k")
PICTURES = 16

REDRAW = """async (count) => {
    const gl = document.getElementById("canvas").getContext("webgl2");
    const times = [];
    for (let k = 0; k < count; k++) {
        const began = performance.now();
        await window.hexalab.setStatus({ separation: { line_width: 1 + 0.01 * (k % 2) } });
        await window.hexalab.settled();
        gl.finish();
        times.push(performance.now() - began);
    }
    return times;
}"""
"""Runs in the page: lines a hundredth wider, and narrower again, until the GPU is through with the picture."""


def run(folder: Path) -> None:
    """Print the times of pictures at rest."""
    rows = []
    for name in NAMES:
        path = grid_file(name, ".mesh", folder)
        with viewer(folder) as (page, address, errors):
            page.evaluate("url => window.hexalab.open(url)", f"{address}/bench/{path.name}")
            page.evaluate("() => window.hexalab.setStatus({ lighting: { mode: 'direct' } })")
            edges = page.evaluate("() => window.hexalab.drawn().edges")
            rows.append([name, f"{edges:,}", _median(page), _outlined(page)])
            if errors:
                raise RuntimeError(f"the console reported {errors[0]}")
    table(
        f"browser: picture at rest, lines, direct, median of {PICTURES} [ms]",
        ["mesh", "edges", "plain", "a cell outlined"],
        rows,
    )


def _median(page: Page) -> float:
    times: list[float] = page.evaluate(REDRAW, PICTURES)
    return statistics.median(times)


def _outlined(page: Page) -> float:
    box = page.locator("#canvas").bounding_box()
    assert box
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.locator(".cell-label").wait_for()
    return _median(page)


if __name__ == "__main__":
    run(Path("build/bench"))
