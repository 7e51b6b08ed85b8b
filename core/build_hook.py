"""Puts the built viewer into the wheel and into the sdist (hatchling calls it).

An sdist carries the viewer as it was built, so that whoever makes a wheel of it needs no Node.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

VIEWER = "build/viewer"
"""Where the viewer lies once it is built, in the clone and in the sdist."""

PACKAGED = {"wheel": "hexalab/viewer", "sdist": VIEWER}


class BuildHook(BuildHookInterface):  # type: ignore[type-arg]
    """Adds files that git doesn't know."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the viewer, or say how to build it; an editable install finds it in the clone."""
        if version == "editable":
            return
        viewer = Path(self.root) / VIEWER
        if not (viewer / "index.html").is_file():
            raise FileNotFoundError(f"{viewer} holds no built viewer: `make wheel` builds it, with Node")
        build_data["force_include"][str(viewer)] = PACKAGED[self.target_name]
