"""Pictures that were taken, kept between builds."""

from __future__ import annotations

import struct
from pathlib import Path

from ..kept import is_kept, keep
from .shot import Shot


class Album:
    """The pictures there are, by mesh, status, size and style.

    Parameters
    ----------
    cache : Path
        Folder of the build's cache; pictures lie in `pictures/` in it.
    """

    def __init__(self, cache: Path) -> None:
        self._folder = cache / "pictures"

    def picture(self, shot: Shot) -> Path | None:
        """The PNG of a shot, or None if it hasn't been taken."""
        place = self._folder / f"{shot.key}.png"
        return place if shot.key and is_kept(place) else None

    def keep(self, shot: Shot, png: bytes) -> None:
        """Store the picture of a shot."""
        if not shot.key:
            raise ValueError(f"{shot.mesh.id} has not been measured: its content isn't known")
        keep(self._folder / f"{shot.key}.png", png)


def png_size(file: Path) -> tuple[int, int]:
    """Width and height of a PNG, from its first chunk."""
    with file.open("rb") as stream:
        width, height = struct.unpack(">II", stream.read(24)[16:])
    return width, height
