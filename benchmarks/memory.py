"""The core's memory in the browser (SPEC P7): what it holds never shrinks, so its end is its peak."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Page

from .clock import table
from .grids import SIZES, grid_file
from .page import viewer

THIRTY = 30
TURNED = "25k"
"""The size that is opened again and again."""

OPEN = """async (url) => {
    await window.hexalab.setStatus({ lighting: { mode: "direct" } });
    const bytes = await (await fetch(url)).arrayBuffer();
    await window.hexalab.open(new File([bytes], url.split("/").pop()));
    await window.hexalab.quality("scaled_jacobian");
    await window.hexalab.settled();
    return window.hexalab.memory();
}"""

CUT = """async (mode) => {
    await window.hexalab.setStatus({
        filters: { planes: { items: [{ enabled: true, normal: [1, 0, 0], offset: 0.5 }] } },
        separation: { mode },
    });
    await window.hexalab.settled();
    return window.hexalab.memory();
}"""


def run(folder: Path) -> None:
    """Print the tables."""
    rows = []
    for name in SIZES:
        grid_file(name, ".mesh", folder)
        with viewer(folder) as (page, address, _):
            opened = page.evaluate(OPEN, f"{address}/bench/grid-{name}.mesh")
            cut = [page.evaluate(CUT, mode) for mode in ("lines", "rounded")]
            rows.append([name, *(_megabytes(size) for size in (opened, *cut))])
    table("memory of the core, fresh page [MB]", ["mesh", "opened", "cut", "cut, rounded"], rows)
    with viewer(folder) as (page, address, _):
        sizes = thirty(page, f"{address}/bench/grid-{TURNED}.mesh")
    told = [_megabytes(sizes[number - 1]) for number in (1, 2, 10, THIRTY)]
    table(f"memory of the core, {TURNED} opened again and again [MB]", ["1st", "2nd", "10th", "30th"], [told])


def thirty(page: Page, address: str) -> list[int]:
    """Bytes that the core holds after each of thirty openings, each mesh cut and looked at."""
    sizes = []
    for _ in range(THIRTY):
        page.evaluate(OPEN, address)
        sizes.append(page.evaluate(CUT, "rounded"))
    return sizes


def _megabytes(size: int) -> float:
    return size / 1e6
