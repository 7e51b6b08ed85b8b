"""What a mesh's page is filled with: all that is known of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from hexalab.group_facts import called
from hexalab.quality import METRICS

from ..model.catalogue import MeshEntry
from ..model.domains import DOMAINS
from ..model.facts import Facts, Statistics
from . import words
from .histogram import draw
from .structure import Tally, figures, tallies


class _QualityRow(Statistics):
    """A row of the table of metrics: the metric's name and acceptable range in words, and its statistics."""

    name: str
    acceptable: str


def mesh_values(mesh: MeshEntry) -> dict[str, Any]:
    """Values of a mesh's template."""
    facts = mesh.facts
    rows = list(_quality_rows(facts))
    return {
        "domains": DOMAINS,
        "fact_rows": list(_fact_rows(facts)),
        "twins": twins(mesh),
        "histogram": draw(facts.histogram) if facts.histogram else None,
        "quality_rows": rows,
        "some_not_finite": any(row["not_finite"] for row in rows),
        "groups": list(group_tallies(facts)),
        "figures": figures(facts),
        "tallies": tallies(facts),
    }


def twins(mesh: MeshEntry) -> list[MeshEntry]:
    """Files of the same source that hold the same mesh in another format, the one that is listed first."""
    first = mesh.same_as or mesh.slug
    return [
        other for other in mesh.source.meshes if other is not mesh and (other.same_as or other.slug) == first
    ]


def group_tallies(facts: Facts) -> Iterator[Tally]:
    """What the file groups and marks, as tables that count."""
    for kind in ("cells", "vertices"):
        listed = [group for group in facts.groups or [] if group["kind"] == kind]
        if listed:
            yield Tally(f"Groups of {kind}", ("Group", kind.capitalize()), _sizes(listed))
    marked = facts.features or {}
    if marked:
        rows: list[tuple[str, list[int | None]]] = [
            (name, [row["count"], row["lost"]]) for name, row in marked.items()
        ]
        yield Tally("Marked as features", ("Kind", "Number", "None of a cell"), rows)
    for name, row in marked.items():
        if row["groups"]:
            yield Tally(f"Groups of marked {name}", ("Group", name.capitalize()), _sizes(row["groups"]))


def _sizes(groups: list[dict[str, Any]]) -> list[tuple[str, list[int | None]]]:
    return [(called(group), [group["count"]]) for group in groups]


def _fact_rows(facts: Facts) -> Iterator[tuple[str, str]]:
    yield "Vertices", words.count(facts.vertices)
    rows = [
        ("Unreferenced vertices", facts.unreferenced_vertices or None),
        ("Cells that repeat a vertex", facts.cells_repeating_a_vertex or None),
        ("Boundary faces", facts.boundary_faces),
        ("Faces of more than two cells", facts.nonmanifold_faces or None),
        ("Edges", facts.edges),
        ("Components", facts.components),
    ]
    for label, value in rows:
        if value is not None:
            yield label, words.count(value)
    if facts.extent:
        low, high = facts.extent
        yield "Extent", " × ".join(words.number(b - a) for a, b in zip(low, high, strict=True))


def _quality_rows(facts: Facts) -> Iterator[_QualityRow]:
    for metric_id, found in (facts.quality or {}).items():
        metric = METRICS[metric_id]
        yield {"name": metric.name, "acceptable": _range(metric.acceptable_range), **found}


def _range(ends: tuple[float, float] | None) -> str:
    if ends is None:
        return ""
    low, high = ends
    if math.isinf(high):
        return f"from {low:g}"
    return f"{low:g} to {high:g}".replace("-", "−")
