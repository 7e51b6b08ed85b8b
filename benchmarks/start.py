"""The start, from the address of a catalogue mesh to where everything can be used (SPEC O4): cold and warm."""

from __future__ import annotations

import statistics
from pathlib import Path
from tempfile import TemporaryDirectory

from playwright.sync_api import BrowserContext

from hexalab.hosts.browser import kept_browser

from .clock import table
from .page import WINDOW, serve

MESH = "shapes/cube"
ROUNDS = 5
VISITS = ("first", "second", "third", "fourth")
SETTLE = 1500
"""Milliseconds after which a browser that was started is at rest."""
STAY = 5000
"""Milliseconds that a visit goes on once all can be used: what the browser keeps, it keeps after a while."""

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
    """Print the table: medians over fresh profiles, each of which comes back, with service worker and all caches."""
    folder.mkdir(parents=True, exist_ok=True)
    rounds: list[list[list[float]]] = []
    with serve(folder) as address:
        for _ in range(ROUNDS):
            with TemporaryDirectory() as profile, kept_browser(Path(profile), WINDOW) as context:
                context.pages[0].wait_for_timeout(SETTLE)
                rounds.append([_visit(context, address) for _ in VISITS])
    rows = [
        [name, *map(statistics.median, zip(*visits, strict=True))]
        for name, visits in zip(VISITS, zip(*rounds, strict=True), strict=True)
    ]
    table(f"start: {MESH}, ends of the steps, median of {ROUNDS} [ms]", ["visit", *STEPS], rows)


def _visit(context: BrowserContext, address: str) -> list[float]:
    page = context.new_page()
    page.goto(f"{address}/viewer/?mesh={MESH}", wait_until="commit")
    times: list[float] = page.evaluate(WATERFALL)
    page.wait_for_timeout(STAY)
    page.close()
    return times
