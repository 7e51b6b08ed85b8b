"""Names of files: which are meshes, and what stands beside them is called."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...formats import FORMATS


def is_mesh(path: str) -> bool:
    """Whether a file is a mesh by its name."""
    return has_ending(path, (end for one in FORMATS for end in one.extensions))


def has_ending(path: str, endings: Iterable[str]) -> bool:
    """Whether a file that is not hidden has one of these endings, and may be .gz behind that."""
    file = path.rpartition("/")[2]
    plain = re.sub(r"\.gz$", "", file.lower())
    return not file.startswith(".") and not path.startswith("__MACOSX/") and plain.endswith(tuple(endings))


def stem_of(name: str) -> str:
    """A path without its ending, and without .gz behind that."""
    return re.sub(r"\.[^./]+$", "", re.sub(r"\.gz$", "", name, flags=re.I))


def free_name(stem: str, taken: set[str]) -> str:
    """The stem, or with a number added if a mesh of the same stem has it; notes it as taken."""
    free, number = stem, 2
    while free.lower() in taken:
        free, number = f"{stem}-{number}", number + 1
    taken.add(free.lower())
    return free
