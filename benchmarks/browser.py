"""The program in Chromium: from a file to the picture, and from a slice to the picture."""

from __future__ import annotations

import statistics
from pathlib import Path

from playwright.sync_api import Page

from hexalab.surface import MODES

from . import dragging, resting
from .clock import table
from .grids import PICKED, SIZES, grid_file
from .page import viewer

ORIGINAL_OPEN = {"25k": 606, "216k": 1696, "1M": 7839}
"""What the original application takes, from file to picture [ms]: SPEC, section P."""

STEPS = ("read", "topology", "surface", "upload", "first_picture", "quality")

SLICE = """async (offset) => {
    const began = performance.now();
    await window.hexalab.setStatus({
        filters: { planes: { items: [{ enabled: true, normal: [1, 0, 0], offset }] } },
    });
    return [performance.now() - began, window.hexalab.timings().slice];
}"""

PICK = """async (count) => {
    const hidden = Array.from({ length: count }, (_, cell) => cell);
    await window.hexalab.setStatus({ filters: { picking: { hidden } } });
}"""

MODE = """async (mode) => {
    await window.hexalab.setStatus({ separation: { mode } });
    return window.hexalab.timings().surface;
}"""


def run(folder: Path) -> None:
    """Print the browser's tables."""
    for name in SIZES:
        grid_file(name, ".mesh", folder)
    rows, slices, picked, surfaces = [], [], [], []
    for name in SIZES:
        with viewer(folder) as (page, address, errors):
            rows.append([name, *_open(page, f"{address}/bench/grid-{name}.mesh"), ORIGINAL_OPEN[name]])
            slices.append([name, *_slice(page)])
            count = min(PICKED, page.evaluate("() => window.hexalab.summary().cells") // 4)
            page.evaluate(PICK, count)
            picked.append([name, f"{count:,}", *_slice(page)])
            page.evaluate(PICK, 0)
            surfaces.append([name, *_modes(page)])
            if errors:
                raise RuntimeError(f"the console reported {errors[0]}")
    table("browser: open a .mesh, file to picture [ms]", ["mesh", "open", *STEPS, "original"], rows)
    table(
        "browser: 41 slices [ms]",
        ["mesh", "core, median", "core, worst", "to picture, median", "worst"],
        slices,
    )
    table(
        "browser: the same with cells picked by hand [ms]",
        ["mesh", "picked", "core, median", "core, worst", "to picture, median", "worst"],
        picked,
    )
    table("browser: surface of the half cut, in the core, median of 5 [ms]", ["mesh", *MODES], surfaces)
    resting.run(folder)
    dragging.run(folder, "direct")
    dragging.run(folder)


def _open(page: Page, address: str) -> list[float | None]:
    whole: float = page.evaluate(
        """async (url) => {
            const bytes = await (await fetch(url)).arrayBuffer();
            const file = new File([bytes], url.split("/").pop());
            const began = performance.now();
            await window.hexalab.open(file);
            return performance.now() - began;
        }""",
        address,
    )
    page.evaluate("() => window.hexalab.quality('scaled_jacobian')")
    timings: dict[str, float | None] = page.evaluate("() => window.hexalab.timings()")
    return [whole, *(timings.get(step) for step in STEPS)]


def _slice(page: Page) -> list[float]:
    times = [page.evaluate(SLICE, 0.3 + 0.01 * step) for step in range(41)]
    picture, core = zip(*times, strict=True)
    return [statistics.median(core), max(core), statistics.median(picture), max(picture)]


def _modes(page: Page) -> list[float]:
    """What the surface of each separation mode takes in the core."""
    page.evaluate(SLICE, 0.5)
    page.evaluate("() => window.hexalab.setStatus({ lighting: { mode: 'direct' } })")
    rounds = [[page.evaluate(MODE, mode) for mode in MODES[1:] + MODES[:1]] for _ in range(5)]
    *others, lines = (statistics.median(times) for times in zip(*rounds, strict=True))
    return [lines, *others]
