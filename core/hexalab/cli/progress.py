"""A progress bar on the terminal, in one line that rewrites itself."""

from __future__ import annotations

import shutil
import sys
from types import TracebackType
from typing import TextIO

WIDTH = 24
CLEAR = "\r\x1b[K"


class Progress:
    """Call it with what is being done and how much of all is done, 0 to 1; shows on a terminal only.

    >>> with Progress() as tell:                                                 # doctest: +SKIP
    ...     tell("reading", 0.5)
    """

    def __init__(self, stream: TextIO | None = None) -> None:
        self._stream = stream or sys.stderr
        self._visible = self._stream.isatty()

    def __call__(self, what: str, part: float) -> None:
        """Show a step."""
        if not self._visible:
            return
        filled = round(WIDTH * min(max(part, 0.0), 1.0))
        text = f"{'█' * filled}{'░' * (WIDTH - filled)} {what}"
        self._stream.write(CLEAR + text[: shutil.get_terminal_size().columns - 1])
        self._stream.flush()

    def __enter__(self) -> Progress:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        """Wipe the bar away."""
        if self._visible:
            self._stream.write(CLEAR)
            self._stream.flush()
