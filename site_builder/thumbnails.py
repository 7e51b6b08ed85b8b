"""Thumbnails of meshes: pictures that the viewer has rendered, kept by the mesh's content.

Rendering needs the finished site in a browser, so it comes after a build: `wanted` lists what has no picture yet,
`keep` stores one, and the next build shows it. A page without a picture is complete too.
"""

from __future__ import annotations

from pathlib import Path

from .model import Catalogue, MeshEntry

WIDTH, HEIGHT = 720, 480
"""Pixels: twice what a card shows."""

STYLE = 1
"""Raise it to have all thumbnails rendered anew."""


class Thumbnails:
    """The pictures there are.

    Parameters
    ----------
    cache : Path
        Folder of the build's cache; pictures lie in `thumbnails/` in it.
    """

    def __init__(self, cache: Path) -> None:
        self._folder = cache / "thumbnails"

    def thumbnail(self, mesh: MeshEntry) -> Path | None:
        """The picture of a mesh as it is now, a PNG of WIDTH x HEIGHT, or None."""
        place = self._place(mesh)
        return place if place and place.exists() else None

    def wanted(self, catalogue: Catalogue) -> list[MeshEntry]:
        """Meshes that lie in the site and have no picture yet."""
        return [
            mesh for mesh in catalogue.meshes if mesh.local and self._place(mesh) and not self.thumbnail(mesh)
        ]

    def keep(self, mesh: MeshEntry, png: bytes) -> None:
        """Store the picture of a mesh."""
        place = self._place(mesh)
        if place is None:
            raise ValueError(f"{mesh.id} has not been measured: its content isn't known")
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(png)

    def _place(self, mesh: MeshEntry) -> Path | None:
        return self._folder / f"{mesh.sha256[:32]}-{STYLE}.png" if mesh.sha256 else None
