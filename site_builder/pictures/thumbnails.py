"""Thumbnails of meshes: pictures that the viewer takes at build, kept by the mesh's content and the status shown.

Taking them needs the viewer in the site and a browser; a page without a picture is complete too.
"""

from __future__ import annotations

from pathlib import Path

from ..model.catalogue import Catalogue, MeshEntry
from . import Album, Shot
from .portrait import portrait
from .shot import HEIGHT, WIDTH

__all__ = ["HEIGHT", "WIDTH", "Thumbnails"]


class Thumbnails:
    """The pictures of meshes.

    Parameters
    ----------
    cache : Path
        Folder of the build's cache.
    """

    def __init__(self, cache: Path) -> None:
        self._album = Album(cache)

    def shot(self, mesh: MeshEntry) -> Shot:
        """How the mesh is shown."""
        return Shot(mesh, portrait(mesh.facts))

    def thumbnail(self, mesh: MeshEntry) -> Path | None:
        """The picture of a mesh as it is now, a PNG of WIDTH x HEIGHT, or None."""
        return self._album.picture(self.shot(mesh))

    def wanted(self, catalogue: Catalogue) -> list[MeshEntry]:
        """Meshes that lie in the site and have no picture yet."""
        return [mesh for mesh in catalogue.meshes if mesh.local and mesh.sha256 and not self.thumbnail(mesh)]

    def keep(self, mesh: MeshEntry, png: bytes) -> None:
        """Store the picture of a mesh."""
        self._album.keep(self.shot(mesh), png)
