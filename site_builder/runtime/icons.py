"""The icons of the installed application, drawn from the site's one icon."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from ..kept import remembered

SCRIPT = Path(__file__).with_name("icons.mjs")

SAFE = 0.7
"""Part of a maskable icon's side that the drawing takes. A circle of 0.8 of the side is never cut off
(https://www.w3.org/TR/appmanifest/#icon-masks); this drawing lies in a circle of 0.92 of its own side."""


def icon(svg: str, side: int, background: str = "", cache: Path | None = None) -> bytes:
    """A PNG of the icon.

    Parameters
    ----------
    svg : str
        The drawing, with a viewBox.
    side : int
        Pixels.
    background : str
        Colour of the ground up to the edges, the drawing within what no mask cuts off; "" for the drawing alone.
    cache : Path, optional
        Folder of what is remembered between builds.

    Raises
    ------
    RuntimeError
        If it can't be drawn.
    """
    if background:
        svg = _padded(svg, background)
    made_of = (svg.encode(), str(side).encode(), SCRIPT.read_bytes())
    return remembered(cache, "icon", made_of, lambda: _drawn(svg, side))


def _drawn(svg: str, side: int) -> bytes:
    command = ["node", str(SCRIPT), str(side)]
    done = subprocess.run(command, input=svg.encode(), capture_output=True)
    if done.returncode:
        raise RuntimeError(f"an icon can't be drawn:\n{done.stderr.decode(errors='replace').strip()}")
    return done.stdout


def _padded(svg: str, background: str) -> str:
    inner = re.sub(r"<svg\b", f'<svg x="{(1 - SAFE) * 50:g}" y="{(1 - SAFE) * 50:g}" width="{SAFE * 100:g}" '
                   f'height="{SAFE * 100:g}"', svg, count=1)  # fmt: skip
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">'
        f'<rect width="100" height="100" fill="{background}"/>{inner}</svg>'
    )
