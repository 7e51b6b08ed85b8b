"""Where a batch's meshes come from: a folder with all below it, or a zip archive."""

from __future__ import annotations

import zipfile
from pathlib import Path

from ...errors import HexaLabError


class Source:
    """Files by their paths, with slashes, in the order in which they are told of.

    Parameters
    ----------
    place : Path
        A folder, a zip archive, or one mesh file.

    Raises
    ------
    HexaLabError
        It is none of these.
    """

    def __init__(self, place: Path) -> None:
        self.place = place
        try:
            self._archive = zipfile.ZipFile(place) if place.is_file() and zipfile.is_zipfile(place) else None
        except zipfile.BadZipFile as error:
            raise HexaLabError(f"{place}: the archive can't be read: {error}") from None
        if self._archive is None and not place.exists():
            raise HexaLabError(f"{place}: no such file or directory")

    @property
    def is_one_file(self) -> bool:
        """Whether it is a file of its own."""
        return self._archive is None and self.place.is_file()

    def names(self) -> list[str]:
        """The paths of all files."""
        if self._archive is not None:
            return [info.filename for info in self._archive.infolist() if not info.is_dir()]
        if self.is_one_file:
            return [self.place.name]
        files = (path for path in sorted(self.place.rglob("*")) if path.is_file())
        return [path.relative_to(self.place).as_posix() for path in files]

    def read(self, name: str) -> bytes:
        """A file's bytes.

        Raises
        ------
        OSError, zipfile.BadZipFile
            It can't be read.
        """
        if self._archive is not None:
            return self._archive.read(name)
        return (self.place if self.is_one_file else self.place / name).read_bytes()
