"""Which of many files are parts of others: an Abaqus deck may include files of any name.

The same rules as in the page (`static/viewer/files/decks.js`).
"""

from __future__ import annotations

import gzip
import re
import zlib
from collections.abc import Callable, Sequence
from typing import NamedTuple

INPUT = re.compile(
    r"^[ \t]*\*(?!\*)(?:[^\r\n]*,[ \t]*\r?\n[ \t]*(?=[A-Z]))*[^\r\n]*?\bINPUT[ \t]*=[ \t]*"
    r"(\"[^\"\r\n]*\"|'[^'\r\n]*'|[^,\r\n]*)",
    re.IGNORECASE | re.MULTILINE,
)
"""A keyword with INPUT, on one line or on more, each of which goes on after a comma."""


class Whole(NamedTuple):
    """A mesh, and the files that it may include."""

    mesh: str
    parts: tuple[str, ...]


def wholes(names: Sequence[str], is_mesh: Callable[[str], bool], read: Callable[[str], bytes]) -> list[Whole]:
    """Tell meshes from their parts.

    Parameters
    ----------
    names : sequence of str
        Paths of all files.
    is_mesh : callable
        Whether a file is a mesh by its name.
    read : callable
        A file's bytes.

    Returns
    -------
    list of Whole
        In the order of the names; no mesh is a part of another, unless they all are.
    """
    meshes = [name for name in names if is_mesh(name)]
    waiting = [name for name in meshes if re.search(r"\.inp(\.gz)?$", name, re.I)] if len(names) > 1 else []
    links: dict[str, list[str]] = {}
    for name in waiting:
        if name in links:
            continue
        found = [part for one in included(name, read) for part in meant(one, name, names)]
        links[name] = [part for part in dict.fromkeys(found) if part != name]
        waiting.extend(links[name])
    parts = {part for found in links.values() for part in found}
    whole = [mesh for mesh in meshes if mesh not in parts]
    return [Whole(mesh, reached(mesh, links)) for mesh in whole or meshes]


def reached(name: str, links: dict[str, list[str]]) -> tuple[str, ...]:
    """All that a file includes, and what that includes."""
    found = [name]
    for one in found:
        found.extend(part for part in links.get(one, ()) if part not in found)
    return tuple(found[1:])


def included(name: str, read: Callable[[str], bytes]) -> list[str]:
    """Names in a file that it includes; none of one that can't be read, which is told when it is opened."""
    try:
        data = read(name)
        data = gzip.decompress(data) if name.lower().endswith(".gz") else data
    except (OSError, EOFError, ValueError, zlib.error):
        return []
    try:
        text = data.decode()
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    return [one.strip("\"' \t") for one in INPUT.findall(text)]


def meant(name: str, by: str, names: Sequence[str]) -> list[str]:
    """The file at the path that a name tells, beside the file that names it; else all of that last name."""
    alike = [one for one in names if last(one) == last(name)]
    folder = slashed(by).rpartition("/")[0]
    wanted = f"{folder}/{slashed(name)}" if folder else slashed(name)
    return [one for one in alike if slashed(one) == wanted] or alike


def slashed(path: str) -> str:
    """A path for comparison: separators of one kind, small letters, no dot for the folder itself."""
    return re.sub(r"^(?:\./+)+", "", path.replace("\\", "/")).lower()


def last(path: str) -> str:
    """The last name of a path, for comparison."""
    return slashed(path).rpartition("/")[2]
