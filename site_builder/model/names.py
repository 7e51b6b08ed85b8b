"""Names and addresses: slugs for people and machines, DOIs, web addresses."""

from __future__ import annotations

import re
import unicodedata
from urllib.parse import quote, unquote

from hexalab.formats import FORMATS

MESH_ENDINGS = tuple(ending for row in FORMATS for ending in row.extensions)
"""Endings of the mesh formats that the core reads; each may be followed by ``.gz``."""

DOI = re.compile(r"10\.\d{4,9}/\S+")
_DOI_PREFIX = re.compile(r"^(?:https?://(?:dx\.)?doi\.org/|doi:\s*)", re.IGNORECASE)
_THIS_MACHINE = re.compile(r"http://(localhost|127\.0\.0\.1)(:\d+)?(/|$)")


def slug(text: str) -> str:
    """Lower-case letters, digits and hyphens: a stable part of an address.

    >>> slug("double torus/Double_Torus (2)")
    'double-torus-double-torus-2'
    """
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode().lower()
    return re.sub(r"[^a-z0-9]+", "-", plain).strip("-")


def normal_doi(text: str) -> str:
    """A DOI without its resolver's address, or "" if the text holds none.

    >>> normal_doi("https://doi.org/10.1111/cgf.13617")
    '10.1111/cgf.13617'
    """
    bare = _DOI_PREFIX.sub("", unquote(text.strip()))
    return bare if DOI.fullmatch(bare) else ""


def doi_address(doi: str) -> str:
    """The address under which a DOI resolves."""
    return "https://doi.org/" + quote(doi, safe="/.()-_;:")


def without_ending(name: str) -> str:
    """A mesh file's path without the ending of its format and of compression."""
    stem = name[:-3] if name.lower().endswith(".gz") else name
    for ending in MESH_ENDINGS:
        if stem.lower().endswith(ending):
            return stem[: -len(ending)]
    return stem


def ending(name: str) -> str:
    """The ending of a mesh file's name, with ``.gz`` if it has it: ".mesh.gz"; "" if it isn't one of ours."""
    lower = name.lower()
    packed = ".gz" if lower.endswith(".gz") else ""
    stem = lower[: len(lower) - len(packed)]
    return next((known + packed for known in MESH_ENDINGS if stem.endswith(known)), "")


def mesh_name(path: str) -> str:
    """What to call a mesh that has only a file's path: ``hex_mesh/bunny/bunny_1.mesh`` is "bunny_1"."""
    parts = without_ending(path).split("/")
    return parts[-1] if len(parts) == 1 else " / ".join(parts)


def on_this_machine(address: str) -> bool:
    """Whether an address is one of the machine that asks, as that of a site which is tried before it is published.

    >>> on_this_machine("http://localhost:8000/"), on_this_machine("http://localhost.org/")
    (True, False)
    """
    return _THIS_MACHINE.match(address) is not None
