"""Messages of the page that come in pieces: hosts lose in silence what is larger than some ten megabytes.

The pieces come in any order: marimo sends each by a request of its own, and the last one, being small, overtakes.
"""

from __future__ import annotations

from typing import Any


class Pieces:
    """Puts pieces together, each message's by itself."""

    def __init__(self) -> None:
        self._waiting: dict[tuple[str, str, int], dict[int, bytes]] = {}

    def add(self, message: dict[str, Any], buffers: list[Any]) -> bytes | None:
        """Take a piece; gives the whole once all have come, None before.

        Parameters
        ----------
        message : dict
            `view`, `kind` and `number` say of what it is a piece; `part` which, counted from 0; `parts` of how many.
        buffers : list of bytes
            One block, or none.
        """
        block = bytes(buffers[0]) if buffers else b""
        part, parts = int(message.get("part", 0)), int(message.get("parts", 1))
        if parts == 1:
            return block
        key = str(message["view"]), str(message["kind"]), int(message["number"])
        found = self._waiting.setdefault(key, {})
        found[part] = block
        if len(found) < parts:
            return None
        del self._waiting[key]
        return b"".join(found[n] for n in range(parts))

    def forget(self, view: str) -> None:
        """Let go what a view has begun and not ended."""
        for key in [key for key in self._waiting if key[0] == view]:
            del self._waiting[key]
