"""Draws the views of other pictures with this program and lays each beside its model.

python -m benchmarks.pictures MESHES PICTURES OUT

PICTURES holds PNGs that carry their settings, ours or the original's, and a README.md whose table names the mesh of
each in MESHES: `| picture.png | mesh.vtk | ...`. OUT gets a PNG of the same name: the model left, ours right.
"""

from __future__ import annotations

import io
import re
import sys
from pathlib import Path

from PIL import Image

from hexalab.hosts.offers import FileOffer
from hexalab.hosts.rendering import Renderer
from hexalab.png_text import read_settings

ROW = re.compile(r"^\|\s*(\S+\.png)\s*\|\s*(\S+)\s*\|", re.MULTILINE)
RULE = 8
"""Pixels between the two pictures."""


def run(meshes: Path, pictures: Path, out: Path) -> None:
    """Draw each picture of the table again and write the pair."""
    out.mkdir(parents=True, exist_ok=True)
    with Renderer() as renderer:
        for picture, mesh in ROW.findall((pictures / "README.md").read_text()):
            model = (pictures / picture).read_bytes()
            size = Image.open(io.BytesIO(model)).size
            offer = FileOffer(meshes / mesh, mesh)
            rendering = renderer.render(offer, read_settings(model), width=size[0], height=size[1])
            side_by_side(model, rendering.data).save(out / picture)
            timings = renderer.page.evaluate("() => window.hexalab.timings()")
            print(f"{picture}: light {timings.get('lighting', 0) / 1000:.1f} s", *rendering.rejections)


def side_by_side(model: bytes, ours: bytes) -> Image.Image:
    """Two pictures of one size in a row."""
    left, right = (Image.open(io.BytesIO(png)).convert("RGB") for png in (model, ours))
    pair = Image.new("RGB", (left.width + RULE + right.width, left.height), "#888888")
    pair.paste(left, (0, 0))
    pair.paste(right, (left.width + RULE, 0))
    return pair


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    run(*(Path(argument) for argument in sys.argv[1:]))
