"""Object-space ambient occlusion in Chromium on a software GPU: 1024 directions after a change."""

from __future__ import annotations

import os
from pathlib import Path

from playwright.sync_api import Page

from .clock import table
from .grids import grid_file
from .page import viewer

MESHES = Path(os.environ.get("HEXALAB_MESHES", "../shared/meshes"))
GARGOYLE = "2014-l1-based-construction--gargoyle-hex.mesh"
ORIGINAL = {"lines": 17_900, "rounded": 67_000}
"""What the original takes for its 1024 directions on that mesh, half cut [ms]: SPEC, section P."""

LIGHT = """async (mode) => {
    await window.hexalab.setStatus({
        lighting: { mode: "object_space_ao" },
        separation: { mode },
        filters: { planes: { items: [{ enabled: true, normal: [1, 0, 0], offset: 0.5 }] } },
    });
    await window.hexalab.settled();
    return window.hexalab.timings();
}"""


def run(folder: Path) -> None:
    """Print the table of lighting times."""
    published = MESHES / GARGOYLE
    path = published if published.is_file() else grid_file("25k", ".mesh", folder)
    original = ORIGINAL if path == published else {}
    with viewer(path.parent) as (page, address, errors):
        page.evaluate("url => window.hexalab.open(url)", f"{address}/bench/{path.name}")
        rows = [[mode, _light(page, mode), original.get(mode)] for mode in ("lines", "fissure", "rounded")]
        if errors:
            raise RuntimeError(f"the console reported {errors[0]}")
    table(
        f"browser: 1024 directions of light on {path.name}, half cut [ms]",
        ["mode", "1024 directions", "original"],
        rows,
    )


def _light(page: Page, mode: str) -> float:
    timings: dict[str, float] = page.evaluate(LIGHT, mode)
    return timings["lighting"]
