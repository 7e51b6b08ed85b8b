"""Writing the site: only what differs is touched, and what no longer belongs there goes."""

from __future__ import annotations

import filecmp
import shutil
from pathlib import Path

OWNED = (
    "about", "catalogue", "datasets", "gallery", "guide", "icons", "meshes", "models", "numbers", "offline", "pictures",
    "screens", "scripts", "sources", "styles",
)  # fmt: skip
"""Folders in which nothing may lie that this build hasn't written."""


class Output:
    """The folder that the site is written to.

    Parameters
    ----------
    root : Path
    """

    def __init__(self, root: Path) -> None:
        self.root = root
        self.written: dict[str, int] = {}
        self.changed = 0
        root.mkdir(parents=True, exist_ok=True)

    def write(self, address: str, content: str | bytes) -> None:
        """Write a file below the root, unless it holds the same already."""
        data = content.encode() if isinstance(content, str) else content
        file = self._place(address, len(data))
        if not file.is_file() or file.stat().st_size != len(data) or file.read_bytes() != data:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(data)
            self.changed += 1

    def copy(self, address: str, source: Path) -> None:
        """Copy a file below the root, unless it is there already."""
        file = self._place(address, source.stat().st_size)
        if not file.is_file() or not filecmp.cmp(file, source, shallow=False):
            file.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, file)
            self.changed += 1

    def clean(self) -> None:
        """Remove files of earlier builds from the folders that belong to the catalogue."""
        for name in OWNED:
            folder = self.root / name
            for file in sorted(folder.rglob("*"), reverse=True):
                if file.is_dir():
                    if not any(file.iterdir()):
                        file.rmdir()
                elif file.relative_to(self.root).as_posix() not in self.written:
                    file.unlink()

    def _place(self, address: str, size: int) -> Path:
        self.written[address] = size
        return self.root / address
