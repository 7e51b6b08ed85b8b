"""A file's bytes with its name, the errors that point into it, and the files that it refers to."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import dataclass, field

from ..errors import MeshReadError

Companions = Callable[[str], "tuple[str, bytes] | None"]
"""Finds the name and bytes of another file by what a file calls it; None if it is not there."""


def alone(_name: str) -> None:
    """No file lies beside."""


@dataclass(frozen=True)
class File:
    """What a reader reads.

    Parameters
    ----------
    data : bytes
        The whole file, decompressed.
    name : str
        Its name, for messages.
    companions : callable
        Finds the files that this one refers to (`hexalab.formats.companions`).
    included : dict of str to str
        Those that were asked for and found: name, and SHA-256 in hexadecimal. One for a file and all that it leads to.
    """

    data: bytes
    name: str = ""
    companions: Companions = field(default=alone, repr=False, compare=False)
    included: dict[str, str] = field(default_factory=dict, repr=False, compare=False)

    def companion(self, name: str) -> File | None:
        """The file that this one calls by a name, such as the one that a line includes; None if it is not there.

        The name is meant from the main file's folder on, else from this one's.
        """
        found = self.companions(name)
        folder = self.name.replace("\\", "/").rpartition("/")[0]
        if found is None and folder:
            found = self.companions(f"{folder}/{name.strip()}")
        if found is None:
            return None
        self.included[found[0]] = hashlib.sha256(found[1]).hexdigest()
        return File(found[1], found[0], self.companions, self.included)

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
