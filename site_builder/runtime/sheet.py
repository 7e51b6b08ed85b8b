"""The frame of a page of one file, out of the viewer's sources."""

from __future__ import annotations

from pathlib import Path

from ..pages.sheet_page import sheet_page
from ..pages.styles import style_sheets
from .bundle import bundled

SHEET = "sheet.txt"
"""Name of the frame, beside the viewer's page: it is no page by itself."""


def sheet(root: Path) -> str:
    """The frame's text.

    Parameters
    ----------
    root : Path
        The checkout, with node_modules.

    Raises
    ------
    RuntimeError
        If bundling fails.
    """
    program, boot = (bundled(root, f"static/viewer/standalone/{name}.js") for name in ("main", "boot"))
    return sheet_page(program, boot.strip(), style_sheets()["standalone"])
