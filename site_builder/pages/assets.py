"""Styles and scripts of the pages, under addresses that carry their content's hash.

A page that a browser has kept asks for the very files that it was made for, and a new one for new ones.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from .styles import INLINE, style_sheets

STATIC = Path(__file__).resolve().parents[2] / "static"
SHARED = ("catalogue", "offline")
"""Folders of scripts that pages load as they are."""


@dataclass(frozen=True)
class Assets:
    """What pages link.

    Attributes
    ----------
    files : dict of str to bytes
        Address below the site's root to content.
    styles : dict of str to str
        Name of each style sheet to its address.
    scripts : str
        Address of the folder of scripts, ending in a slash.
    """

    files: dict[str, bytes]
    styles: dict[str, str]
    scripts: str


@cache
def assets() -> Assets:
    """Read `static/` once."""
    sheets = {name: sheet.encode() for name, sheet in style_sheets().items() if name not in INLINE}
    styles = {name: f"styles/{name}-{_hash(sheet)}.css" for name, sheet in sheets.items()}
    names = [path for folder in SHARED for path in sorted((STATIC / folder).glob("*.js"))]
    scripts = {path.relative_to(STATIC).as_posix(): path.read_bytes() for path in names}
    folder = f"scripts/{_hash(b''.join(name.encode() + content for name, content in scripts.items()))}/"
    files = {styles[name]: sheet for name, sheet in sheets.items()}
    files |= {folder + name: content for name, content in scripts.items()}
    return Assets(files, styles, folder)


def _hash(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:8]
