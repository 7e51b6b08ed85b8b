"""What "keep offline" says and needs on the pages of sources and meshes."""

from __future__ import annotations

from collections.abc import Sequence
from urllib.parse import urlsplit

from ..model.catalogue import MeshEntry
from .words import file_size, plural


def weight(meshes: Sequence[MeshEntry]) -> str:
    """How many meshes, and how much they take: "3 meshes, 1.2 MB"."""
    number = "" if len(meshes) == 1 else f"{plural(len(meshes), 'mesh', 'meshes')}, "
    sizes = [mesh.facts.bytes for mesh in meshes if mesh.facts.bytes is not None]
    unknown = len(meshes) - len(sizes)
    if not sizes:
        return f"{number}size not known"
    return f"{number}{file_size(sum(sizes))}" + (f" and {unknown:,} of unknown size" if unknown else "")


def connections(meshes: Sequence[MeshEntry]) -> str:
    """Where a page may fetch from beside its own site, as its policy says it after 'self'.

    Hosts of meshes may send on to others, so https is allowed as a whole; http is allowed to the very hosts that the
    catalogue names.
    """
    remote = [mesh.remote for mesh in meshes if mesh.remote]
    plain = sorted({f"http://{urlsplit(one).netloc}" for one in remote if one.startswith("http:")})
    secure = ["https:"] if any(one.startswith("https:") for one in remote) else []
    return "".join(f" {one}" for one in secure + plain)
