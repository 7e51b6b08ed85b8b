"""How a mesh is shown on its card: the status that brings out what it is about, chosen by its facts."""

from __future__ import annotations

from hexalab.status.views import Vector, View, three_quarters

from ..model.facts import Facts
from .shot import Status

FEW, MANY = 1_600, 20_000
"""Cells up to which each is drawn with rounded edges, and from which on with thin lines."""

HALF = 0.5

BAD_CELLS: Status = {
    "quality": {"items": [{"quantity": "scaled_jacobian", "keep": "inside", "maximum": 0.3}]}
}
"""Filters that leave what is inverted, or nearly."""

BODY: Status = {"cells": "quality", "opacity": 0.14}
"""The cells that these filters hide, faintly."""

CROWDED = 1 / 20
"""Part of the interior edges that is irregular, from which on their wires would cover all else."""

JACOBIAN: Status = {"by": "quality", "metric": "scaled_jacobian", "map": "red_blue"}


def portrait(facts: Facts) -> Status:
    """The status of a mesh's thumbnail.

    Seen from the front, the side and above, cut in half by a plane that faces the eye; what is hidden stays as a
    faint silhouette. The plane is turned a little, so that steps show the cells; where they are too small for that,
    it stands along an axis. Wires show the irregular edges, unless there are so many that nothing else would be seen,
    as in meshes out of an octree. A mesh of several kinds of cells is coloured by kind. Of a mesh with inverted or
    flat cells the picture shows these and the next worst, coloured by the Scaled Jacobian, within a faint body.
    """
    cells, found = facts.cells or 0, {finding["id"] for finding in facts.findings or ()}
    view = view_of(facts)
    status: Status = {"camera": view.camera, "separation": separation(cells), "filters": view.slice(0)}
    if found or is_crowded(facts):
        status["irregular"] = {"mode": 0}
    if len(facts.kinds or ()) > 1:
        status["colour"] = {"by": "kind"}
    elif facts.sj_not_positive or "degenerate_cells" in found:
        edges = {"mode": "darkness_coded_edges"}
        filters = view.slice(0) | BAD_CELLS
        return status | {"filters": filters, "colour": JACOBIAN, "separation": edges, "see_through": BODY}
    if worth_cutting(cells, found):
        status["filters"] = view.slice(HALF)
    return status


def view_of(facts: Facts) -> View:
    """Where a mesh is looked at from: as it was measured, or as its extent asks for."""
    if facts.view:
        return View(
            *(_vector(part) for part in (facts.view["direction"], facts.view["up"], facts.view["facing"]))
        )
    low, high = facts.extent or [[-1, -1, -1], [1, 1, 1]]
    return three_quarters([b - a for a, b in zip(low, high, strict=True)], facts.cells or 0)


def is_crowded(facts: Facts) -> bool:
    """Whether irregular edges are so many that their wires would cover all else."""
    return (facts.irregular_edges or 0) > CROWDED * (facts.interior_edges or 1)


def worth_cutting(cells: int, found: set[str]) -> bool:
    """Whether half of a mesh tells more than the whole: not of a few cells, nor of parts that lie side by side."""
    apart = "components" in found and "coincident_vertices" not in found
    return cells > 3 and not apart


def separation(cells: int) -> Status:
    """How cells are told apart, by how many there are."""
    if cells <= FEW:
        return {"mode": "rounded", "radius": 0.09}
    if cells <= MANY:
        return {"mode": "darkness_coded_edges"}
    return {"mode": "lines", "line_opacity": 0.2 if cells < 500_000 else 0.12}


def _vector(parts: list[float]) -> Vector:
    x, y, z = parts
    return x, y, z
