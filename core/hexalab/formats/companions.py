"""The files that a file refers to: out of its folder, or out of those that were opened together with it.

Names in a file may be written by another system than reads them: separators of both kinds, another letter case,
quotes. What lies outside of the folder is not reached: no absolute path, no `..`, no link that leads out.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path, PurePosixPath

from .file import Companions, alone

Found = tuple[str, bytes]


def beside(path: Path) -> Companions:
    """Companions out of the folder that a file lies in, and its folders."""
    folder = path.parent

    def find(name: str) -> Found | None:
        place = relative(name)
        if place is None:
            return None
        try:
            root = folder.resolve()
            path = spelled(root, place)
            whole = path.resolve()
            if not whole.is_relative_to(root) or not whole.is_file():
                return None
            return path.relative_to(root).as_posix(), whole.read_bytes()
        except (OSError, ValueError):
            return None

    return find


def spelled(root: Path, place: PurePosixPath) -> Path:
    """The path below a folder, each part as it is spelled there; letter case counts only where two differ by it."""
    whole = root
    for part in place.parts:
        below = whole / part
        if not below.exists() and whole.is_dir():
            alike = sorted(entry.name for entry in whole.iterdir() if entry.name.lower() == part.lower())
            below = whole / alike[0] if alike else below
        whole = below
    return whole


def together(files: Mapping[str, bytes | bytearray | memoryview], name: str = "") -> Companions:
    """Companions out of files that were opened together with one of some name, by their names.

    Names may be paths: then those in the file are meant from its folder on. A browser tells no folders of files that
    are dropped, so that where there is nothing at the whole path, the one file of the same last name is taken.
    """
    if not files:
        return alone
    by_path = {slashed(own): own for own in files}
    folder = slashed(name).rpartition("/")[0]

    def find(name: str) -> Found | None:
        wanted = slashed(unquoted(name))
        key = by_path.get(f"{folder}/{wanted}" if folder else wanted) or by_path.get(wanted)
        if key is None:
            last = wanted.rsplit("/", 1)[-1]
            same = [own for path, own in by_path.items() if path.rsplit("/", 1)[-1] == last]
            key = same[0] if len(same) == 1 else None
        return None if key is None else (key, bytes(files[key]))

    return find


def slashed(name: str) -> str:
    """The name for comparison: separators of one kind, in small letters, without a dot for the folder itself."""
    return re.sub(r"^(?:\./+)+", "", name.replace("\\", "/")).lower()


def unquoted(name: str) -> str:
    """The name without blanks and quotes around it."""
    return name.strip().strip("\"'").strip()


def relative(name: str) -> PurePosixPath | None:
    """The path below the folder that a name means; None if it leads out, or is none."""
    text = unquoted(name).replace("\\", "/")
    if not text or text.startswith("/") or re.match(r"[A-Za-z]:", text) or "\0" in text:
        return None
    path = PurePosixPath(text)
    return None if ".." in path.parts or not path.parts else path
