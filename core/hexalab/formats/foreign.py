"""Formats that are not read but are known by their content: what a file is, and what to do about it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

START = rb"(?:\s|\xef\xbb\xbf)*"
INTEGERS = rb"[ \t]*\d+[ \t]+\d+[ \t]+\d+[ \t]*"

MESHIO = "convert it, for example by ‘meshio convert’, to one of"
EXPORT = "save or export it as one of"
SURFACE = (
    "a surface has no cells to look into, but it can be opened as a reference to measure a mesh against; "
    "expected a volumetric mesh, one of"
)


@dataclass(frozen=True)
class Foreign:
    """One format that is not read.

    Parameters
    ----------
    name : str
        What a user calls it, with its article.
    content : bytes
        Regular expression that the file's start matches.
    advice : str
        What to do; the endings of the formats that are read follow it.
    endings : tuple of str
        Endings of names that the file must have, where the content alone does not tell; all if empty.
    fits : callable, optional
        What must hold of the first bytes and the file's size, too.
    """

    name: str
    content: bytes
    advice: str
    endings: tuple[str, ...] = ()
    fits: Callable[[bytes, int], bool] | None = None

    def matches(self, head: bytes, name: str, size: int) -> bool:
        """Whether the first bytes, the name in lower case, and the file's size are of this format."""
        return (
            (not self.endings or name.endswith(self.endings))
            and bool(re.match(self.content, head, re.I | re.M))
            and (self.fits is None or self.fits(head, size))
        )


def is_binary_stl(head: bytes, size: int) -> bool:
    """Whether a file of that size is as long as binary STL says in its first 84 bytes: 50 bytes for each triangle.

    The words in front are no help: many such files begin with "solid", as those in text do.
    """
    return len(head) >= 84 and 84 + 50 * int.from_bytes(head[80:84], "little") == size


FOREIGN = (
    Foreign("a Fluent mesh", START + rb"\(\s*(?:0|1|2|10|12|13|37|39|45)\s", MESHIO),
    Foreign(
        "a GiD mesh",
        rb"(?:\s|#[^\r\n]*$)*MESH\s+(?:\S+\s+)?dimension\b[^\r\n]*\bElemType\b",
        EXPORT,
    ),
    Foreign(
        "a FreeFem mesh",
        START + INTEGERS + rb"(?:\r?\n|\r)[ \t]*[-+.\d]\S*[ \t]+[-+.\d]",
        'let FreeFem save it by savemesh(Th, "NAME.mesh"), which is one of',
        (".msh",),
    ),
    Foreign("a Netgen mesh", START + rb"mesh3d\b", MESHIO),
    Foreign(
        "a Nastran bulk data file", rb"(?:\s|\$[^\r\n]*$)*(?:SOL\s|CEND|BEGIN\s+BULK|GRID[\s*,])", MESHIO
    ),
    Foreign("an I-deas universal file", rb"\s*-1\s*\n\s*(?:151|164|2411|2412|2420)\s*$", EXPORT),
    Foreign("an LS-DYNA deck", rb"(?:\s|\$[^\r\n]*$)*\*KEYWORD\b", EXPORT),
    Foreign(
        "an OpenFOAM file",
        rb"(?:\s|/\*[\s\S]*?\*/|//[^\r\n]*$)*FoamFile\b",
        "write it by foamToVTK, as one of",
    ),
    Foreign("an STL surface", START + rb"solid\b[^\r\n]*\s+facet\b", SURFACE),
    Foreign("a PLY file", rb"ply\r?\n\s*format\b", SURFACE),
    Foreign("an OFF surface", rb"(?:\s|\xef\xbb\xbf|#[^\r\n]*$)*(?:ST)?[CN]*OFF(?:\s|\d)", SURFACE),
    Foreign("a binary STL surface", rb"", SURFACE, (".stl",), is_binary_stl),
    Foreign("an OBJ surface", rb"", SURFACE, (".obj",)),
)
"""What is known and not read."""


def foreign(head: bytes, name: str, size: int = 0) -> Foreign | None:
    """The format of a file that is not read, by its first bytes, its name and its size; None if it is not known."""
    name = name.lower().removesuffix(".gz")
    return next((row for row in FOREIGN if row.matches(head, name, size)), None)
