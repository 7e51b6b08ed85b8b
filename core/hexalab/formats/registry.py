"""The formats as rows of a table, and how a file finds its row."""

from __future__ import annotations

import re
from dataclasses import dataclass
from importlib import import_module

from ..mesh import Mesh
from .file import File
from .foreign import foreign

HEAD = 8192
"""Bytes from the file's start that the content is judged by."""

START = rb"(?:\s|\xef\xbb\xbf)*"
"""What may stand before a text file's first word: white space, a byte order mark."""

START_OR_COMMENT = rb"(?:\s|\xef\xbb\xbf|#[^\r\n]*[\r\n])*"


@dataclass(frozen=True)
class Format:
    """One file format.

    Parameters
    ----------
    id : str
        Short name, in `Mesh.format`.
    name : str
        What a user calls it.
    extensions : tuple of str
        Endings of file names, with the dot, in lower case.
    recognise : pattern
        What the first bytes of such a file match.
    module : str
        Module of this package that reads it.
    """

    id: str
    name: str
    extensions: tuple[str, ...]
    recognise: re.Pattern[bytes]
    module: str

    def read(self, file: File) -> Mesh:
        """Read a file of this format.

        Its module is imported when it is first needed: a browser's Python starts the sooner.

        Raises
        ------
        MeshReadError
            If it can't be read.
        """
        mesh: Mesh = import_module(f".{self.module}", __package__).read(file)
        return mesh


FORMATS: tuple[Format, ...] = (
    Format(
        "mesh",
        "Medit ASCII",
        (".mesh",),
        re.compile(START_OR_COMMENT + rb"MeshVersionFormatted\b", re.I),
        "medit",
    ),
    Format(
        "vtk",
        "VTK legacy",
        (".vtk",),
        re.compile(START + rb"#\s*vtk\s+DataFile", re.I),
        "vtk_legacy",
    ),
    Format(
        "vtu",
        "VTK XML",
        (".vtu",),
        re.compile(START + rb"<(?:\?xml|!--|VTKFile)"),
        "vtu",
    ),
    Format(
        "meshb",
        "Medit binary",
        (".meshb",),
        re.compile(rb"\x01\x00{3}[\x01-\x04]\x00{3}|\x00{3}\x01\x00{3}[\x01-\x04]"),
        "meditb",
    ),
    Format("msh", "Gmsh", (".msh",), re.compile(START + rb"\$(?:MeshFormat|Comments|NO[DE]\s)"), "gmsh"),
    Format("ovm", "OpenVolumeMesh", (".ovm",), re.compile(START + rb"OVM\s", re.I), "openvolumemesh"),
    Format(
        "inp",
        "Abaqus",
        (".inp",),
        re.compile(START + rb"\*(?:\*|HEADING|NODE\b|PART|INCLUDE)", re.I),
        "abaqus",
    ),
    Format("mfem", "MFEM", (".mesh",), re.compile(START_OR_COMMENT + rb"MFEM\s"), "mfem"),
    Format(
        "ucd",
        "AVS UCD",
        (".inp", ".ucd"),
        re.compile(START_OR_COMMENT + rb"\d+[ \t]+\d+[ \t]+\d+[ \t]+\d+[ \t]+\d+[ \t]*[\r\n]|\x07\x00"),
        "ucd",
    ),
)
"""The formats that are read, as rows with `id`, `name`, `extensions` and more."""


def choose(file: File) -> Format:
    """The format of a file: by its content, else by its name's ending.

    Raises
    ------
    MeshReadError
        Neither tells, or the content is of a format that is known and not read.
    """
    head = file.data[:HEAD]
    for row in FORMATS:
        if row.recognise.match(head):
            return row
    known = ", ".join(dict.fromkeys(extension for row in FORMATS for extension in row.extensions))
    if other := foreign(head, file.name, len(file.data)):
        raise file.error(f"this is {other.name}, which is not read: {other.advice} {known}")
    name = file.name.lower().removesuffix(".gz")
    for row in FORMATS:
        if name.endswith(row.extensions):
            return row
    raise file.error(f"neither the content nor the name tells of a known format, expected one of {known}")
