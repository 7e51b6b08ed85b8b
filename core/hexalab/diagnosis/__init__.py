"""Diagnosis (SPEC R9): what is wrong with a mesh, or worth knowing, as a list of findings.

Counts come with the ids of the cells or vertices concerned, so that a viewer can isolate them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from ..arrays import Array, Ids
from ..cells import CORNERS_OF_KIND, KINDS
from ..mesh import Mesh
from .coincidence import coincident_vertices
from .lost_features import Held, held_features
from .orientation import TURNED, all_inverted, signs, turn_round

__all__ = [
    "FINDINGS",
    "SEVERITIES",
    "TURNED",
    "Finding",
    "Held",
    "all_inverted",
    "diagnose",
    "held_features",
    "turn_round",
]

Severity = Literal["error", "warning", "note"]
SEVERITIES: tuple[Severity, ...] = ("error", "warning", "note")

FINDINGS = (
    "all_inverted", "inverted_cells", "degenerate_cells", "invalid_corner_cells", "repeated_cells",
    "nonmanifold_faces", "opposite_orientation", "coincident_vertices", "turned_round", "lost_corners", "lost_edges",
    "lost_faces", "repeated_vertices", "unreferenced_vertices", "components", "reading",
)  # fmt: skip
"""Ids of all findings that there can be."""

_BLOCK = 1 << 18


def _none() -> Ids:
    return np.empty(0, np.int32)


@dataclass(frozen=True)
class Finding:
    """One thing found.

    Attributes
    ----------
    id : str
        Name for programs.
    severity : {"error", "warning", "note"}
        An error makes finite elements fail; a warning may; a note is worth knowing.
    message : str
        One sentence for the user.
    count : int
        How many cells, faces or vertices the message speaks of.
    cells, vertices : (n,) int32
        Ids concerned, ascending; either may be empty.
    """

    id: str
    severity: Severity
    message: str
    count: int
    cells: Ids = field(default_factory=_none)
    vertices: Ids = field(default_factory=_none)


def diagnose(mesh: Mesh) -> list[Finding]:
    """Find what is wrong with a mesh, the worst first.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    list of Finding
        Empty if there is nothing to say. Ids are those of `FINDINGS`.
    """
    checks: tuple[Callable[[Mesh], Iterator[Finding]], ...] = (
        _shapes, _faces, _vertices, _features, _pieces, _notes,
    )  # fmt: skip
    found = [finding for check in checks for finding in check(mesh)]
    return sorted(found, key=lambda finding: SEVERITIES.index(finding.severity))


def _shapes(mesh: Mesh) -> Iterator[Finding]:
    """Cells that are inverted, flat, or bent inside out at a corner."""
    found = signs(mesh)
    inverted = _ids(found.volume < 0)
    if len(inverted) and not (found.volume > 0).any():
        yield Finding(
            "all_inverted",
            "error",
            "Every cell is inverted: the mesh is inside out.",
            len(inverted),
            inverted,
        )
    if len(inverted):
        yield Finding(
            "inverted_cells",
            "error",
            f"{_some(inverted, 'cell has', 'cells have')} negative volume.",
            len(inverted),
            inverted,
        )
    flat = _ids(found.volume == 0)
    if len(flat):
        yield Finding(
            "degenerate_cells",
            "error",
            f"{_some(flat, 'cell has', 'cells have')} no volume.",
            len(flat),
            flat,
        )
    bent = _ids(found.invalid_corner)
    if len(bent):
        words = (
            f"{_some(bent, 'cell is', 'cells are')} invalid at a corner: the Jacobian is not positive there."
        )
        yield Finding("invalid_corner_cells", "error", words, len(bent), bent)


def _faces(mesh: Mesh) -> Iterator[Finding]:
    """Cells that are there twice, faces of more than two cells, and neighbours of opposite orientation."""
    faces, again = mesh.topology.faces, mesh.topology.repeated_cells
    if len(again):
        words = f"{_some(again, 'cell repeats another', 'cells repeat others')}: the same vertices. Each is drawn once."
        yield Finding("repeated_cells", "error", words, len(again), again)
    if faces.nonmanifold_count:
        cells = np.unique(faces.crowd_cells).astype(np.int32)
        many = faces.nonmanifold_count
        words = f"{many:,} {'face is' if many == 1 else 'faces are'} shared by more than two cells."
        yield Finding("nonmanifold_faces", "error", words, many, cells)
    rows = _misfits(mesh)
    if len(rows):
        pairs = "pair of neighbours has" if len(rows) == 1 else "pairs of neighbours have"
        cells = np.unique(faces.cells[:, rows])
        yield Finding(
            "opposite_orientation", "error", f"{len(rows):,} {pairs} opposite orientation.", len(rows), cells
        )


def _misfits(mesh: Mesh) -> Array:
    """Rows of faces that both cells go round in one direction."""
    topology = mesh.topology
    cells, local = topology.face_cells, topology.face_locals
    found = []
    for start in range(0, topology.faces.paired, _BLOCK):
        rows = slice(start, min(start + _BLOCK, topology.faces.paired))
        a, b, _, _ = topology.corners_of(cells[0, rows], local[0, rows])
        ring = topology.corners_of(cells[1, rows], local[1, rows])
        same = np.zeros(len(a), dtype=bool)
        for place in range(4):
            same |= (ring[place] == a) & (ring[(place + 1) % 4] == b)
        found.append(np.flatnonzero(same) + start)
    return np.concatenate(found) if found else np.empty(0, np.intp)


def _vertices(mesh: Mesh) -> Iterator[Finding]:
    """Vertices at one place, vertices that a cell has twice or no cell has."""
    double = coincident_vertices(mesh)
    if len(double):
        words = f"{len(double):,} vertices lie where another lies: cells around them are not joined."
        yield Finding("coincident_vertices", "warning", words, len(double), vertices=double)
    repeating = _repeating(mesh)
    if len(repeating):
        words = f"{_some(repeating, 'cell has', 'cells have')} the same vertex at several corners."
        yield Finding("repeated_vertices", "note", words, len(repeating), repeating)
    unused = _ids(~mesh.referenced)
    if len(unused):
        words = f"{_some(unused, 'vertex belongs', 'vertices belong')} to no cell."
        yield Finding("unreferenced_vertices", "note", words, len(unused), vertices=unused)


def _repeating(mesh: Mesh) -> Ids:
    """Cells that name a vertex more often than their kind does."""
    cells = np.flatnonzero(mesh.topology.repeating_cells)
    corners = np.sort(mesh.corners[:, cells], axis=0)
    distinct = 1 + (corners[1:] != corners[:-1]).sum(axis=0)
    own = np.array([len(CORNERS_OF_KIND[kind]) for kind in range(len(KINDS))])
    return np.asarray(cells[distinct < own[mesh.kinds[cells]]], dtype=np.int32)


def _features(mesh: Mesh) -> Iterator[Finding]:
    """Elements of lower dimension that are those of no cell."""
    for part, there in held_features(mesh):
        lost = int(np.count_nonzero(~there))
        if lost:
            one, what = part.called[:-1], ("vertex", "edge", "face")[part.dimension]
            named = f"{lost:,} feature {one} is" if lost == 1 else f"{lost:,} feature {part.called} are"
            vertices = np.unique(part.corners[:, ~there])
            yield Finding(
                f"lost_{part.called}",
                "warning",
                f"{named} no {what} of the mesh.",
                lost,
                vertices=vertices[mesh.referenced[vertices]].astype(np.int32),
            )


def _pieces(mesh: Mesh) -> Iterator[Finding]:
    """Face-connected components."""
    count = mesh.topology.component_count
    if count > 1:
        labels = mesh.topology.components
        largest = np.bincount(labels).argmax()
        words = f"The mesh falls into {count:,} parts that share no face; marked are all but the largest."
        yield Finding("components", "note", words, count, _ids(labels != largest))


def _notes(mesh: Mesh) -> Iterator[Finding]:
    """What was noted on the way in."""
    for note in mesh.notes:
        if note == TURNED:
            yield Finding("turned_round", "warning", note, mesh.cell_count)
        else:
            yield Finding("reading", "note", note, 1)


def _ids(mask: Array) -> Ids:
    return np.flatnonzero(mask).astype(np.int32)


def _some(ids: Ids, one: str, many: str) -> str:
    return f"{len(ids):,} {one if len(ids) == 1 else many}"
