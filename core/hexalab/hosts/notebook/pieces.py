"""Messages of the page that come in pieces: hosts lose in silence what is larger than some ten megabytes."""

from __future__ import annotations

from typing import Any


class Pieces:
    """Puts pieces together, each message's by itself."""

    def __init__(self) -> None:
        self._waiting: dict[tuple[str, int], bytearray] = {}

    def add(self, message: dict[str, Any], buffers: list[Any]) -> bytes | bytearray | None:
        """Take a piece; gives the whole once the last one has come, None before.

        Parameters
        ----------
        message : dict
            `view` and `number` say of what it is a piece, `part` which, counted from 0, and `parts` of how many.
        buffers : list of bytes
            One block, or none.
        """
        block = bytes(buffers[0]) if buffers else b""
        part, parts = int(message.get("part", 0)), int(message.get("parts", 1))
        if parts == 1:
            return block
        key = str(message["view"]), int(message["number"])
        whole = self._waiting.setdefault(key, bytearray())
        whole.extend(block)
        return self._waiting.pop(key) if part == parts - 1 else None

    def forget(self, view: str) -> None:
        """Let go what a view has begun and not ended."""
        for key in [key for key in self._waiting if key[0] == view]:
            del self._waiting[key]
