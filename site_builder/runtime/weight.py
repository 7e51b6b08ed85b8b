"""What a first visit brings over the wire (SPEC P8): viewer and Python, gzipped as hosts of static pages send them."""

from __future__ import annotations

import gzip
from collections.abc import Iterable
from pathlib import Path

from ..kept import remembered

MOST = 8_000_000
"""Bytes that a first visit may weigh; the build fails above."""


def gzipped(files: Iterable[Path], cache: Path | None = None) -> int:
    """Bytes of these files together, each gzipped at level 6, or as it is where that is smaller."""
    contents = [file.read_bytes() for file in files]
    return int(remembered(cache, "weight", contents, lambda: str(sum(map(_gzipped, contents))).encode()))


def _gzipped(data: bytes) -> int:
    return min(len(data), len(gzip.compress(data, 6)))


def first_visit(site: Path, style: str, scripts: Iterable[str], runtime: str) -> list[Path]:
    """The files that the viewer fetches before a mesh is opened.

    Parameters
    ----------
    site : Path
        The site's root.
    style : str
        Address of the style sheet, relative to the root.
    scripts : iterable of str
        Addresses of the viewer's scripts: those that start, and what these import.
    runtime : str
        Address of the interpreter's folder.
    """
    page = [site / "viewer" / "index.html", site / style, site / "catalogue.json"]
    return [*page, *(site / script for script in scripts), *sorted((site / runtime).iterdir())]
