"""The viewer as the wheel carries it: pages, scripts, a style sheet; no Python, which is there already."""

from __future__ import annotations

from pathlib import Path

from ..output import Output
from ..pages.styles import style_sheets
from ..pages.viewer_page import viewer_page
from .bundle import bundled
from .sheet import SHEET, sheet

SCRIPT, STYLE, ICON, NOTEBOOK = "viewer.js", "viewer.css", "icon.svg", "notebook.js"


def write_viewer(root: Path, out: Path) -> None:
    """Write the viewer's files; those that are the same already stay untouched.

    Parameters
    ----------
    root : Path
        The checkout, with node_modules.
    out : Path
        Folder that the wheel takes them from.

    Raises
    ------
    RuntimeError
        If bundling fails.
    """
    style = style_sheets()["viewer"]
    files = {
        "index.html": viewer_page("server", style=STYLE, script=SCRIPT, icon=ICON),
        "frame.html": viewer_page("frame", style_text=style),
        SCRIPT: bundled(root, "static/viewer/main.js"),
        NOTEBOOK: bundled(root, "static/viewer/notebook/widget.js"),
        STYLE: style,
        SHEET: sheet(root),
        ICON: (root / "static" / "icon.svg").read_text("utf-8"),
    }
    output = Output(out)
    for name, text in files.items():
        output.write(name, text)
    for file in out.iterdir():
        if file.name not in files:
            file.unlink()
