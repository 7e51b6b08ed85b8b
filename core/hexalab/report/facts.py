"""Everything that a report tells, in one dict that is ready for JSON."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .. import __version__
from ..arrays import Floats
from ..diagnosis import Finding, diagnose
from ..formats import FORMATS
from ..group_facts import group_measures, listed_features, listed_groups
from ..grouping import groups_of
from ..groups import Group
from ..mesh import Mesh
from ..numbering import cell_numbers
from ..packing import jsonable
from ..quality import METRICS, Metric, Validity, certify, histogram, quality_many, statistics
from ..quality.measures import LARGEST
from ..quality.validity import INVALID, STATES
from ..summary import topology_facts
from ..words import NO_UNIT
from .criteria import Criterion, FindingCriterion, InvalidCriterion, MetricCriterion
from .judging import (
    MISSED,
    NUMBERS_TOLD,
    Check,
    concerned,
    judged_finding,
    judged_invalid,
    judged_metric,
    own_checks,
)

VERSION = 1
"""Of the dict's form: it grows when a key changes its meaning or goes."""

BINS = 40
"""Of the histograms."""

TOGETHER = 9
"""Metrics that are measured at a time: what they share is found once, and no more values are held than needed."""

Known = Callable[[str], Floats | None]
"""The values of a metric, (C,) float64, if they are there already."""


@dataclass(frozen=True)
class About:
    """What the mesh itself does not know of its file.

    Parameters
    ----------
    name : str
        Of the file; the mesh's own, without a path, if it is empty.
    bytes : int or None
        Size of the file as it lies on the disk.
    sha256 : str
        Of the same, in hexadecimal; "" if it is not known.
    unit : str
        Of length, one of `hexalab.status.LENGTH_UNITS`.
    notes : tuple of str
        What the report lacks, one sentence each.
    """

    name: str = ""
    bytes: int | None = None
    sha256: str = ""
    unit: str = NO_UNIT
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Found:
    """What is known of a mesh before its metrics are measured."""

    findings: Sequence[Finding]
    validity: Validity
    groups: Sequence[Group]
    known: Known = lambda _: None

    @classmethod
    def of(cls, mesh: Mesh) -> Found:
        """Look a mesh through."""
        return cls(diagnose(mesh), certify(mesh), groups_of(mesh))


def collect(
    mesh: Mesh,
    about: About | None = None,
    criteria: Sequence[Criterion] = (),
    *,
    strict: bool = False,
    found: Found | None = None,
) -> dict[str, Any]:
    """Collect what a report tells.

    Parameters
    ----------
    mesh : Mesh
    about : About, optional
    criteria : sequence of Criterion
        They give the verdict; without any, the diagnosis' errors and certified validity do.
    strict : bool
        Whether these count beside the criteria.
    found : Found, optional
        What is known already.

    Returns
    -------
    dict
        Ready for JSON, the same for the same input: `version`, `made_by` (versions), `file`, `verdict` (`passed`, `by`,
        `checks`), `notes`, `counts`, `extent`, `validity`, `findings`, `groups`, `features`, `metrics`. Cells and
        vertices are told by the file's own numbers. Numbers that are not finite are None.

    Raises
    ------
    HexaLabError
        A criterion names a group that the mesh has not got.
    """
    about, found = about or About(), found or Found.of(mesh)
    metrics, held, checks = [], {}, {}
    for metric, values in _measured(mesh, found.known):
        metrics.append(_metric(mesh, metric, values))
        for place, one in enumerate(criteria):
            if isinstance(one, MetricCriterion) and one.metric == metric.id:
                checks[place] = judged_metric(mesh, found.groups, one, values, about.unit)
        if metric.id in ("volume", "scaled_jacobian"):
            held[metric.id] = values
    for place, one in enumerate(criteria):
        if isinstance(one, InvalidCriterion):
            checks[place] = judged_invalid(mesh, found.groups, one, found.validity)
        elif isinstance(one, FindingCriterion):
            checks[place] = judged_finding(mesh, one, found.findings)
    facts = {
        "version": VERSION,
        "made_by": {
            "hexalab": __version__,
            "python": sys.version.split()[0],
            "numpy": np.__version__,
        },
        "file": _file(mesh, about),
        "verdict": _verdict(mesh, [checks[place] for place in range(len(criteria))], strict, found),
        "notes": list(about.notes),
        "counts": {
            "vertices": mesh.vertex_count,
            "cells": mesh.cell_count,
            "kinds": mesh.kind_counts,
            **topology_facts(mesh),
        },
        "extent": mesh.extent,
        "validity": _validity(mesh, found.validity),
        "findings": [_finding(mesh, one) for one in found.findings],
        "groups": _groups(found, held),
        "features": listed_features(mesh),
        "metrics": metrics,
    }
    told: dict[str, Any] = jsonable(facts)
    return told


def _measured(mesh: Mesh, known: Known) -> Iterator[tuple[Metric, Floats]]:
    """Each metric with its values, some measured together."""
    rows = list(METRICS.values())
    for start in range(0, len(rows), TOGETHER):
        some = rows[start : start + TOGETHER]
        values = {row.id: there for row in some if (there := known(row.id)) is not None}
        values |= quality_many(mesh, [row.id for row in some if row.id not in values])
        for row in some:
            yield row, values.pop(row.id)


def _file(mesh: Mesh, about: About) -> dict[str, Any]:
    names = {row.id: row.name for row in FORMATS}
    return {
        "name": about.name or mesh.name.rpartition("/")[2],
        "format": mesh.format,
        "format_name": names.get(mesh.format, mesh.format),
        "bytes": about.bytes,
        "sha256": about.sha256,
        "included": [{"name": name, "sha256": sha256} for name, sha256 in mesh.included.items()],
        "unit": about.unit,
    }


def _verdict(mesh: Mesh, asked: list[Check], strict: bool, found: Found) -> dict[str, Any]:
    """Whether the mesh passes, who says so, and all that was asked."""
    by = ["criteria"] if asked else []
    if strict or not asked:
        by.append("diagnosis")
        asked = asked + own_checks(mesh, found.findings, found.validity)
    return {"passed": all(check["state"] != MISSED for check in asked), "by": by, "checks": asked}


def _validity(mesh: Mesh, validity: Validity) -> dict[str, Any]:
    first = {
        f"{name}_cells": cell_numbers(mesh, np.flatnonzero(validity.state == state)[:NUMBERS_TOLD])
        for state, name in enumerate(STATES)
        if name != "valid"
    }
    return {**validity.counts, **first}


def _finding(mesh: Mesh, finding: Finding) -> dict[str, Any]:
    on, numbers = concerned(mesh, finding)
    return {
        "id": finding.id,
        "severity": finding.severity,
        "message": finding.message,
        "count": finding.count,
        "on": on,
        "concerned": len(finding.cells) or len(finding.vertices),
        "numbers": numbers,
    }


def _groups(found: Found, held: dict[str, Floats]) -> list[dict[str, Any]]:
    """The groups; those of cells with what was measured of them."""
    cells = [group for group in found.groups if group.on == "cell"]
    invalid = found.validity.state == INVALID
    measured = iter(group_measures(cells, held["volume"], held["scaled_jacobian"], invalid))
    return [
        {**row, **(next(measured) if group.on == "cell" else {})}
        for row, group in zip(listed_groups(found.groups), found.groups, strict=True)
    ]


def _metric(mesh: Mesh, metric: Metric, values: Floats) -> dict[str, Any]:
    """The row of a metric: what it is, statistics, worst cells, histogram."""
    numbers = statistics(values, metric, mesh.kinds)
    bad = np.flatnonzero(~np.isfinite(values) & np.isin(mesh.kinds, metric.kinds))[:NUMBERS_TOLD]
    worst = numbers.pop("worst")
    return {
        "id": metric.id,
        "name": metric.name,
        "symbol": metric.symbol,
        "better": metric.better,
        "length_power": metric.length_power,
        "acceptable_range": metric.acceptable_range,
        "full_range": metric.full_range,
        **numbers,
        "worst": [
            {"number": one, "value": value}
            for one, value in zip(
                cell_numbers(mesh, worst).tolist(), values[np.array(worst, np.intp)].tolist(), strict=True
            )
        ],
        "not_finite_cells": cell_numbers(mesh, bad),
        "histogram": _histogram(metric, values, numbers["min"], numbers["max"]),
    }


def _histogram(
    metric: Metric, values: Floats, low: float | None, high: float | None
) -> dict[str, Any] | None:
    """Counts of the finite values, from the least or the worst known value to the largest or the best."""
    if low is None or high is None:
        return None
    ends = [low, high, *metric.denormalise(np.array([0.0, 1.0]), low, high).tolist()]
    sound = [end for end in ends if np.isfinite(end) and abs(end) < LARGEST]
    edges, counts = histogram(values, min(sound), max(sound), BINS)
    return {"low": float(edges[0]), "high": float(edges[-1]), "counts": counts}
