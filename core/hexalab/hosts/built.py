"""Where the built viewer lies: in the installed package, or in the clone."""

from __future__ import annotations

from pathlib import Path

from ..errors import HexaLabError

PACKAGE = Path(__file__).resolve().parents[1]

PLACES = (PACKAGE / "viewer", PACKAGE.parents[1] / "build" / "viewer")
"""In the wheel, and in a clone, where `make wheel` and `make build` put it."""

PAGE, FRAME, SHEET = "index.html", "frame.html", "sheet.txt"
SCRIPT, NOTEBOOK = "viewer.js", "notebook.js"


def built_viewer() -> Path:
    """Folder of the viewer's files.

    Raises
    ------
    HexaLabError
        There is none: a clone in which nothing was built.
    """
    for place in PLACES:
        if (place / PAGE).is_file():
            return place
    raise HexaLabError("the viewer is not built: run `make wheel` in the clone, which needs Node")
