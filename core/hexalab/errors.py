"""The exceptions that the core raises for a user's input."""

from __future__ import annotations

from typing import Any


class HexaLabError(Exception):
    """Something that a user can be told in one sentence."""


class MeshReadError(HexaLabError):
    """A file is not a mesh that can be read.

    Parameters
    ----------
    message : str
        What was found and what was expected, in the user's words.
    file : str
        Name of the file.
    line : int or None
        1-based line, for text.
    offset : int or None
        Byte offset from the start of the (decompressed) file, for binary.
    """

    def __init__(
        self, message: str, *, file: str = "", line: int | None = None, offset: int | None = None
    ) -> None:
        super().__init__(message)
        self.message = message
        self.file = file
        self.line = line
        self.offset = offset

    def __str__(self) -> str:
        place = [self.file] if self.file else []
        if self.line is not None:
            place.append(f"line {self.line}")
        elif self.offset is not None:
            place.append(f"byte {self.offset}")
        return f"{', '.join(place)}: {self.message}" if place else self.message


class NoCellsError(MeshReadError):
    """A file is read as far as it goes and has no volumetric cells; what else it has comes along.

    Parameters
    ----------
    message, file
        As for `MeshReadError`.
    coordinates : (3, V) float64
        The file's vertices.
    features : tuple of Features
        Its elements of lower dimension, as a mesh has them; none if there are none.
    notes : list of str
        What reading had to assume or leave out.
    format : str
        Id of the format, a row of `hexalab.formats.FORMATS`.
    """

    def __init__(
        self,
        message: str,
        *,
        file: str,
        coordinates: Any,
        features: tuple[Any, ...],
        notes: list[str],
        format: str,
    ) -> None:
        super().__init__(message, file=file)
        self.coordinates = coordinates
        self.features = features
        self.notes = notes
        self.format = format


class MeshWriteError(HexaLabError):
    """A mesh can't be written in the form asked for."""
