"""All that is known of a body's meshes, as a table for programs: a row for each mesh, numbers in full."""

from __future__ import annotations

import csv
import io
from typing import Any

from hexalab.quality import METRICS

from ..model.catalogue import MeshEntry
from .bodies import Body

ABOUT = ("mesh", "name", "source", "year", "doi", "method", "domain", "file", "sha256", "bytes")
COUNTED = ("cells", "vertices", "irregular_edges", "arcs", "sheets", "blocks")
CERTIFIED = ("valid", "invalid", "undecided")
STATISTICS = ("min", "mean", "max", "outside_acceptable")
"""Of each metric, after its id and a dot."""

DIGITS = 6
"""Significant digits of a metric's statistics."""

HEADS = (*ABOUT, *COUNTED, *CERTIFIED, *(f"{metric}.{name}" for metric in METRICS for name in STATISTICS))


def model_csv(body: Body, address: str) -> str:
    """The table; what isn't known is empty.

    Parameters
    ----------
    address : str
        Of the site, before addresses of its own files.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADS)
    writer.writerows(_row(mesh, address) for mesh in body.meshes)
    return text.getvalue()


def _row(mesh: MeshEntry, address: str) -> list[Any]:
    facts, source = mesh.facts, mesh.source
    file = mesh.remote or address + mesh.file_address
    about = [
        mesh.id,
        mesh.name,
        source.short,
        source.year,
        source.doi,
        mesh.method,
        mesh.domain,
        file,
        mesh.sha256,
    ]
    counted = [mesh.cells, facts.vertices, facts.irregular_edges, facts.arcs, facts.sheets, facts.blocks]
    certified = [facts.validity[name] if facts.validity else None for name in CERTIFIED]  # type: ignore[literal-required]
    measured = [_number(mesh, metric, name) for metric in METRICS for name in STATISTICS]
    return [*about, facts.bytes, *counted, *certified, *measured]


def _number(mesh: MeshEntry, metric: str, name: str) -> float | str | None:
    found: dict[str, Any] = dict((mesh.facts.quality or {}).get(metric, {}))
    value = found.get(name)
    return f"{value:.{DIGITS}g}" if isinstance(value, float) else value
