"""A file's bytes with its name, and the errors that point into it."""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import MeshReadError


@dataclass(frozen=True)
class File:
    """What a reader reads.

    Parameters
    ----------
    data : bytes
        The whole file, decompressed.
    name : str
        Its name, for messages.
    """

    data: bytes
    name: str = ""

    def error(self, message: str, *, line_at: int | None = None, offset: int | None = None) -> MeshReadError:
        """An error at a place of the file.

        Parameters
        ----------
        message : str
            What was found and what was expected.
        line_at : int, optional
            Byte offset of which the line is to be told (text).
        offset : int, optional
            Byte offset to be told (binary).
        """
        line = None if line_at is None else self.line_number(line_at)
        return MeshReadError(message, file=self.name, line=line, offset=offset)

    def line_number(self, offset: int) -> int:
        """1-based number of the line that the byte offset lies in; lines end in LF, CR LF or CR."""
        newline = b"\n" if b"\n" in self.data else b"\r"
        return self.data.count(newline, 0, offset) + 1
