"""Dragging the slice with the mouse: from each move of the pointer to the picture that answers it.

python -m benchmarks.dragging
"""

from __future__ import annotations

import os
import statistics
from pathlib import Path
from typing import TypedDict

from playwright.sync_api import Page

from .clock import table
from .grids import grid_file
from .page import viewer

MOVES = 40
ALLOWED = 50
"""Milliseconds from a move to its picture on a quiet machine."""

WATCH = """() => {
    const gl = document.getElementById("canvas").getContext("webgl2");
    const { hexalab } = window;
    const drag = (window.drag = { moved: 0, times: [], core: [] });
    let shown = hexalab.summary().shown;
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
        gl.finish();
        drag.times.push(performance.now() - drag.moved);
        drag.core.push(hexalab.timings().slice);
        drag.moved = 0;
    };
    addEventListener("pointermove", (event) => (drag.moved ||= event.timeStamp), { capture: true });
    const watch = () => {
        requestAnimationFrame(watch);
        const now = hexalab.summary().shown;
        if (now !== shown && drag.moved) port2.postMessage(null);
        shown = now;
    };
    watch();
}"""
"""Runs in the page. An answer of the core is drawn in the animation frame that follows it, after this watch has looked;
the message comes after that frame and waits until the GPU is through with it."""


class Drag(TypedDict):
    """What the page has noted of a drag, in milliseconds.

    Attributes
    ----------
    moved : float
        Time stamp of the move that waits for its picture; 0 if none does.
    times, core : list of float
        For each move: until its picture, and of that what the core took.
    """

    moved: float
    times: list[float]
    core: list[float]


def run(folder: Path, light: str = "object_space_ao") -> list[float]:
    """Drag the slice through the grid of 216,000 cells, print the times, return them in milliseconds."""
    path = grid_file("216k", ".mesh", folder)
    with viewer(folder) as (page, address, errors):
        page.evaluate("url => window.hexalab.open(url)", f"{address}/bench/{path.name}")
        page.evaluate("mode => window.hexalab.setStatus({ lighting: { mode } })", light)
        times, core = _drag(page)
        if errors:
            raise RuntimeError(f"the console reported {errors[0]}")
    load = os.getloadavg()[0]
    table(
        f"browser: slice dragged by the mouse, 216k cells, lines, {light}, load {load:.1f} [ms from move to picture]",
        ["moves", "core, median", "median", "95 %", "worst", "allowed"],
        [[len(times), statistics.median(core), statistics.median(times), _late(times), max(times), ALLOWED]],
    )
    return times


def _drag(page: Page) -> tuple[list[float], list[float]]:
    box = page.locator("#slice").bounding_box()
    assert box
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + 0.3 * box["width"], y)
    page.mouse.down()
    page.wait_for_timeout(1000)
    page.evaluate(WATCH)
    for move in range(1, MOVES + 1):
        page.mouse.move(box["x"] + (0.3 + 0.4 * move / MOVES) * box["width"], y)
        _wait(page, move)
    page.mouse.up()
    found: Drag = page.evaluate("() => window.drag")
    return found["times"], found["core"]


def _wait(page: Page, move: int) -> None:
    """Until the move is answered; one that changes nothing is not."""
    for _ in range(100):
        if page.evaluate("() => window.drag.times.length") >= move:
            return
        page.wait_for_timeout(20)


def _late(times: list[float]) -> float:
    return sorted(times)[int(0.95 * (len(times) - 1))]


if __name__ == "__main__":
    for mode in ("object_space_ao", "direct"):
        run(Path("build/bench"), mode)
