"""What the field has published: each mesh once, and nothing of our own making."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ..model.catalogue import MeshEntry


@dataclass(frozen=True)
class Field:
    """The meshes that numbers of the field speak of.

    Parameters
    ----------
    meshes : tuple of MeshEntry
        Published ones, each once.
    own, doubled : int
        Meshes of our own making, and files that hold a mesh in another format, which are left out.
    """

    meshes: tuple[MeshEntry, ...]
    own: int
    doubled: int


def field_of(meshes: Iterable[MeshEntry]) -> Field:
    """Part what the field has published from the rest."""
    published, own, doubled = [], 0, 0
    for mesh in meshes:
        if mesh.source.own:
            own += 1
        elif mesh.same_as:
            doubled += 1
        else:
            published.append(mesh)
    return Field(tuple(published), own, doubled)
