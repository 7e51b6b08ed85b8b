"""Puts what was built, viewer and catalogue, into the wheel and into the sdist (hatchling calls it).

An sdist carries both as they were built, so that whoever makes a wheel of it needs no Node.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

VIEWER, CATALOGUE = "build/viewer", "build/catalogue.json.gz"
"""Where viewer and catalogue lie once they are built, in the clone and in the sdist."""

PACKAGED = {
    "wheel": {VIEWER: "hexalab/viewer", CATALOGUE: "hexalab/catalogue.json.gz"},
    "sdist": {VIEWER: VIEWER, CATALOGUE: CATALOGUE},
}


class BuildHook(BuildHookInterface):  # type: ignore[type-arg]
    """Adds files that git doesn't know."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the viewer, or say how to build it; an editable install finds it in the clone."""
        if version == "editable":
            return
        viewer = Path(self.root) / VIEWER
        if not (viewer / "index.html").is_file():
            raise FileNotFoundError(f"{viewer} holds no built viewer: `make wheel` builds it, with Node")
        for built, place in PACKAGED[self.target_name].items():
            build_data["force_include"][str(Path(self.root) / built)] = place
