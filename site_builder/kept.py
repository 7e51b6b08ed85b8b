"""What is remembered between builds: files below the cache's folder; what nobody has used for long goes."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Iterable
from pathlib import Path

MOST_BYTES = 300_000_000
"""What may stay of what a build has not used; one of the whole repository uses half of that."""

FOLDERS = ("made", "facts", "preview", "pictures", "pages", "plots", "tables", "built")
"""Below the cache's folder, what is remembered by content."""


def is_kept(file: Path) -> bool:
    """Whether a file is remembered; from now on it is one that was used."""
    try:
        os.utime(file)
    except FileNotFoundError:
        return False
    return file.is_file()


def keep(file: Path, data: bytes) -> None:
    """Write a file that is remembered: as a whole or not at all, whatever interrupts the build."""
    file.parent.mkdir(parents=True, exist_ok=True)
    half = file.with_name(f"{file.name}.{os.getpid()}.half")
    half.write_bytes(data)
    half.replace(file)


def remember(file: Path, make: Callable[[], bytes]) -> Path:
    """A file that is remembered; what is in it is made if it isn't there."""
    if not is_kept(file):
        keep(file, make())
    return file


def remembered(cache: Path | None, name: str, made_of: Iterable[bytes], make: Callable[[], bytes]) -> bytes:
    """What was made before of the same, or is made now.

    Parameters
    ----------
    cache : Path or None
        Without it nothing is remembered.
    name : str
        What it is: the kept file's name begins with it.
    made_of : iterable of bytes
        All that it depends on.
    make : callable
    """
    if cache is None:
        return make()
    digest = hashlib.sha256()
    for part in made_of:
        digest.update(len(part).to_bytes(8, "little") + part)
    return remember(cache / "built" / f"{name}-{digest.hexdigest()[:32]}", make).read_bytes()


def prune(cache: Path, since: float, most: int = MOST_BYTES) -> int:
    """Forget what was not used for longest, until the rest takes no more than so many bytes.

    Parameters
    ----------
    cache : Path
    since : float
        Seconds since the epoch; what was used later stays in any case.
    most : int
        Bytes.

    Returns
    -------
    int
        How many files are gone.
    """
    files = [file for name in FOLDERS for file in (cache / name).rglob("*") if file.is_file()]
    stated = sorted(((file.stat().st_mtime, file.stat().st_size, file) for file in files), reverse=True)
    total = gone = 0
    for used, size, file in stated:
        total += size
        if total > most and used < since:
            file.unlink()
            gone += 1
    return gone
