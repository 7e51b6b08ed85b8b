"""The pictures that guard each separation mode under each light.

python -m tests.browser.guards

takes them again into tests/browser/pictures/, from the built site: after a change that is meant to be seen, and only
once the new ones have been looked at.
"""

from __future__ import annotations

import base64
import io
from pathlib import Path
from typing import Any

from PIL import Image
from playwright.sync_api import Page

from benchmarks.modes import LIGHTS
from benchmarks.page import viewer
from hexalab.hosts.page_scripts import PICTURE
from hexalab.surface import MODES

FOLDER = Path(__file__).parent / "pictures"
MESH = Path(__file__).resolve().parents[2] / "repository" / "structures" / "tunnels.mesh"
SIZE = {"width": 240, "height": 180}
COLOURS = 96
"""Of the files, which keeps them small; the comparison does not see the difference."""

VIEW: dict[str, Any] = {
    "camera": {"direction": [-0.5, -0.45, -0.75], "up": [0, 1, 0], "distance": 1.7},
    "filters": {"planes": {"items": [{"enabled": True, "normal": [-0.6, -0.1, -0.3], "offset": 0.45}]}},
    "separation": {"line_opacity": 0.35},
    "silhouette": 1,
    "irregular": {"mode": 1, "boundary": False},
}

NAMES = [f"{mode}-{light}" for mode in MODES for light in LIGHTS]


def status(name: str) -> dict[str, Any]:
    """The settings of a picture."""
    mode, light = name.split("-")
    return {**VIEW, "separation": {**VIEW["separation"], "mode": mode}, "lighting": {"mode": light}}


def take(page: Page, settings: dict[str, Any]) -> Image.Image:
    """Apply settings and take the picture."""
    assert page.evaluate("status => window.hexalab.setStatus(status)", settings) == []
    png = base64.b64decode(page.evaluate(PICTURE, {"format": "", "size": SIZE})["data"])
    return Image.open(io.BytesIO(png)).convert("RGB")


def model(name: str) -> Image.Image:
    """The kept picture."""
    return Image.open(FOLDER / f"{name}.png").convert("RGB")


def main() -> None:
    """Take all pictures and keep them."""
    FOLDER.mkdir(exist_ok=True)
    with viewer(MESH.parent) as (page, address, errors):
        page.evaluate("url => window.hexalab.open(url)", f"{address}/bench/{MESH.name}")
        for name in NAMES:
            picture = take(page, status(name))
            small = picture.quantize(COLOURS, dither=Image.Dither.NONE)
            small.save(FOLDER / f"{name}.png", optimize=True)
        assert not errors, errors


if __name__ == "__main__":
    main()
