"""The start, from the address of a catalogue mesh to where everything can be used (SPEC O4): cold and warm."""

from __future__ import annotations

import statistics
from pathlib import Path

from playwright.sync_api import BrowserContext

from hexalab.hosts.browser import browser

from .clock import table
from .page import WINDOW, serve

MESH = "shapes/cube"
ROUNDS = 5

STEPS = ("first byte", "script", "first picture", "interpreter", "numpy", "core", "usable")
"""Ends of the steps, in milliseconds since the address was given. The first picture can be turned at once."""

WATERFALL = """async () => {
    const until = async (done) => {
        while (!done()) await new Promise((resolve) => setTimeout(resolve, 5));
        return performance.now();
    };
    await until(() => window.hexalab);
    await window.hexalab.ready;
    const core = performance.now();
    const usable = await until(() => window.hexalab.timings().first_picture !== undefined);
    const [page] = performance.getEntriesByType("navigation");
    const script = performance.getEntriesByType("resource").find(({ name }) => /\\/main-[^/]*\\.js$/.test(name));
    const times = window.hexalab.timings();
    const numpy = core - times.core;
    return [page.responseStart, script.responseEnd, times.preview ?? NaN, numpy - times.numpy, numpy, core, usable];
}"""


def run(folder: Path) -> None:
    """Print the table: medians of five fresh browsers, each visited twice."""
    folder.mkdir(parents=True, exist_ok=True)
    cold, warm = [], []
    with serve(folder) as address:
        for _ in range(ROUNDS):
            with browser() as chromium:
                context = chromium.new_context(viewport=WINDOW, service_workers="block")
                cold.append(_visit(context, address))
                warm.append(_visit(context, address))
    rows = [
        [name, *(statistics.median(step) for step in zip(*rounds, strict=True))]
        for name, rounds in (("cold", cold), ("warm", warm))
    ]
    table(f"start: {MESH}, ends of the steps, median of {ROUNDS} [ms]", ["visit", *STEPS], rows)


def _visit(context: BrowserContext, address: str) -> list[float]:
    page = context.new_page()
    page.goto(f"{address}/viewer/?mesh={MESH}", wait_until="commit")
    times: list[float] = page.evaluate(WATERFALL)
    page.close()
    return times
