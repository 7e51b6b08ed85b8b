"""Watching files: which of them were written anew, and are whole again.

Files are looked at, not listened to: that works for atomic renames, for network drives, and for files that vanish and
come back. A file counts as whole when two looks in a row find the same version.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from pathlib import Path

from .offers import Stamp, stamp_of

INTERVAL = 0.25
"""Seconds between two looks."""

Tell = Callable[[str, bool], None]
"""Called with a file's name and whether it is there."""


class Looks:
    """What was seen of one file.

    Parameters
    ----------
    told : stamp or None
        The version that whoever watches knows of.
    """

    def __init__(self, told: Stamp | None) -> None:
        self._told = told
        self._last = told

    def news(self, stamp: Stamp | None) -> bool:
        """Take one look; whether the file is another than was told before, and has come to rest."""
        at_rest = stamp == self._last
        self._last = stamp
        if not at_rest or stamp == self._told:
            return False
        self._told = stamp
        return True


class Watch:
    """Looks at files until it is closed, in a thread of its own.

    Parameters
    ----------
    files : mapping of str to Path
        By the names that `tell` is called with.
    tell : callable
    interval : float
        Seconds between two looks.
    """

    def __init__(self, files: Mapping[str, Path], tell: Tell, interval: float = INTERVAL) -> None:
        self._files = dict(files)
        self._looks = {name: Looks(stamp_of(path)) for name, path in files.items()}
        self._tell = tell
        self._interval = interval
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._run, name="watching files", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop looking."""
        self._closed.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._closed.wait(self._interval):
            for name, path in self._files.items():
                stamp = stamp_of(path)
                if self._looks[name].news(stamp):
                    self._tell(name, stamp is not None)
