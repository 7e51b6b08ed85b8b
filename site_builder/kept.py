"""What is remembered between builds: files below the cache's folder; what nobody has used for long goes."""

from __future__ import annotations

import os
from pathlib import Path

MOST_BYTES = 300_000_000
"""What may stay of what a build has not used; one of the whole repository uses half of that."""

FOLDERS = ("made", "facts", "preview", "pictures", "pages", "plots", "tables")
"""Below the cache's folder, what is remembered by content."""


def is_kept(file: Path) -> bool:
    """Whether a file is remembered; from now on it is one that was used."""
    try:
        os.utime(file)
    except FileNotFoundError:
        return False
    return file.is_file()


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
