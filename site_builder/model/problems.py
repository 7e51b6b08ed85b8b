"""What is wrong with a mesh's row of source.yaml, as problems."""

from __future__ import annotations

from .catalogue import MeshEntry, Problem


def problem_of(mesh: MeshEntry, message: str, field_name: str = "") -> Problem:
    """An error in a mesh's row of source.yaml."""
    file = f"{mesh.source.folder.name}/source.yaml"
    field_name = field_name or mesh.kind
    name = f"meshes[{mesh.source.meshes.index(mesh)}].{field_name}"
    return Problem("error", file, mesh.lines.get(field_name, mesh.line), name, message)


def disagreements(mesh: MeshEntry) -> list[Problem]:
    """Where source.yaml says something else than the file."""
    found = []
    if mesh.declared_cells is not None and mesh.declared_cells != mesh.facts.cells:
        found.append(
            problem_of(mesh, f"{mesh.declared_cells:,} here, {mesh.facts.cells:,} in the file", "cells")
        )
    if mesh.declared_sha256 is not None and mesh.declared_sha256 != mesh.facts.sha256:
        found.append(
            problem_of(mesh, f"{mesh.declared_sha256} here, the file's is {mesh.facts.sha256}", "sha256")
        )
    return found
