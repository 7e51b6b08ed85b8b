"""A folder that holds copies of remote files under the same paths: found by the end of a file's address."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import unquote, urlsplit

FEWEST = 2
"""Last parts of an address that a copy must agree with: a name alone says too little."""


class Mirror:
    """Finds copies of remote files.

    Parameters
    ----------
    root : Path
        Folder below which they lie, as `wget --mirror` leaves them, or a clone of the repository that is fetched from.
    """

    def __init__(self, root: Path) -> None:
        self._root = root

    def find(self, address: str) -> Path | None:
        """The copy of a file, the one whose path agrees with most of the address; None if there is none."""
        parsed = urlsplit(address)
        parts = [parsed.hostname or "", *(part for part in unquote(parsed.path).split("/") if part)]
        if ".." in parts:
            return None
        for first in range(len(parts) - FEWEST + 1):
            place = self._root.joinpath(*parts[first:])
            if place.is_file():
                return place
        return None
