"""The formats of surfaces as rows of a table, and how a file finds its row."""

from __future__ import annotations

import re
import zlib
from dataclasses import dataclass
from importlib import import_module

from ..formats import registry as meshes
from ..formats.container import GZIP
from ..formats.file import File
from ..formats.foreign import is_binary_stl
from ..formats.registry import HEAD, START, START_OR_COMMENT
from .surface import TriangleSurface


@dataclass(frozen=True)
class ReferenceFormat:
    """One file format of surfaces.

    Parameters
    ----------
    id : str
        Short name, in `TriangleSurface.format`.
    name : str
        What a user calls it.
    extensions : tuple of str
        Endings of file names, with the dot, in lower case, that tell the format where the content does not.
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

    def read(self, file: File) -> TriangleSurface:
        """Read a file of this format; raises MeshReadError. Its module is imported when it is first needed."""
        surface: TriangleSurface = import_module(f".{self.module}", __package__).read(file)
        return surface


REFERENCE_FORMATS: tuple[ReferenceFormat, ...] = (
    ReferenceFormat("stl", "STL", (".stl",), re.compile(START + rb"solid\b", re.I), "stl"),
    ReferenceFormat(
        "obj",
        "Wavefront OBJ",
        (".obj",),
        re.compile(
            rb"(?:\s|\xef\xbb\xbf|#[^\r\n]*[\r\n]|(?:mtllib|usemtl|[ogs]|v[nt])[ \t][^\r\n]*[\r\n])*+"
            rb"v[ \t]+(?:[-+.\d]\S*[ \t]+){2}[-+.\d]"
        ),
        "obj",
    ),
    ReferenceFormat(
        "off",
        "OFF",
        (".off",),
        re.compile(START_OR_COMMENT + rb"(?:ST)?[CN]*4?n?(?:OFF|off)(?=[\s\d])"),
        "off",
    ),
    ReferenceFormat("ply", "PLY", (".ply",), re.compile(rb"(?:\xef\xbb\xbf)?ply[ \t]*[\r\n]"), "ply"),
    ReferenceFormat(
        "polydata",
        "VTK legacy, polygons",
        (),
        re.compile(
            START
            + rb"#\s*vtk\s+DataFile[^\r\n]*(?:\r?\n[^\r\n]*){1,4}?\s+(?:ASCII|BINARY)\s+DATASET\s+POLYDATA\b",
            re.I,
        ),
        "vtk_polydata",
    ),
    ReferenceFormat(
        "vtp",
        "VTK XML, polygons",
        (".vtp",),
        re.compile(
            START
            + rb"(?:<\?[^>]*>\s*|<!--(?:(?!-->)[\s\S])*-->\s*)*<VTKFile\b[^>]*\btype\s*=\s*[\"']PolyData[\"']"
        ),
        "vtp",
    ),
)
"""The formats of surfaces, as rows with `id`, `name`, `extensions` and more."""


def endings() -> str:
    """The endings of all files that can be a reference, for messages."""
    known = [row.extensions for row in REFERENCE_FORMATS] + [row.extensions for row in meshes.FORMATS]
    return ", ".join(dict.fromkeys(ending for some in known for ending in some))


def format_of(data: bytes, name: str) -> ReferenceFormat | None:
    """The format of the bytes of a file, not gzipped: by their content, else by the name's ending.

    None if it is none of this table: a mesh, or unknown.
    """
    head = data[:HEAD]
    for row in REFERENCE_FORMATS:
        if row.recognise.match(head):
            return row
    name = name.lower().removesuffix(".gz")
    by_name = next(
        (row for row in REFERENCE_FORMATS if row.extensions and name.endswith(row.extensions)), None
    )
    if any(row.recognise.match(head) for row in meshes.FORMATS):
        return None
    if is_binary_stl(head, len(data)):
        return REFERENCE_FORMATS[0]
    return by_name


def is_surface(data: bytes, name: str) -> bool:
    """Tell cheaply, from a file's first bytes and its name, whether it is of a format of surfaces.

    That is STL, OBJ, OFF, PLY, or VTK's polygons. Any other file may be a mesh, or a surface in a format of meshes,
    which only reading tells.

    Parameters
    ----------
    data : bytes
        The file, gzipped or not; or only its first `HEAD` bytes, from which a binary STL file with another ending than
        .stl is not told.
    name : str
        Its name.
    """
    head = bytes(data[:HEAD])
    if head.startswith(GZIP):
        try:
            head = zlib.decompressobj(wbits=31).decompress(head, HEAD)
        except zlib.error:
            return False
        return format_of(head, name) is not None
    return format_of(head, name) is not None or is_binary_stl(head, len(data))
