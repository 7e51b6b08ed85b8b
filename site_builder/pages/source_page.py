"""What a source's page is filled with."""

from __future__ import annotations

from typing import Any

from ..model.catalogue import MeshEntry, Source
from .keeping import connections
from .mesh_page import twins

STRIP = 12
"""Pictures in the strip at the top, each of another model."""

ROW = 5
"""Cards that stand side by side: where all are seen at once, there is no strip."""


def source_values(source: Source, pictures: set[str]) -> dict[str, Any]:
    """Values of a source's template."""
    listed = source.listed
    pictured = [mesh for mesh in listed if mesh.picture_address in pictures]
    return {
        "listed": listed,
        "strip": strip(pictured) if len(pictured) > ROW else [],
        "show_cards": bool(pictured),
        "copies": len(source.meshes) - len(listed),
        "formats": lambda mesh: [mesh, *twins(mesh)],
        "connect": connections(source.meshes),
        "some_traced": any(mesh.facts.blocks is not None for mesh in listed),
        "some_unknown": any(mesh.facts.sj_min is None for mesh in listed),
        "some_measured": any(mesh.remote and mesh.facts.sj_min is not None for mesh in listed),
    }


def strip(meshes: list[MeshEntry]) -> list[MeshEntry]:
    """The first mesh of each model, and those of none, in order: what differs most comes into view."""
    first = {mesh.model or mesh.id: mesh for mesh in reversed(meshes)}
    chosen = [mesh for mesh in meshes if first[mesh.model or mesh.id] is mesh]
    return chosen[:STRIP]
