"""The core's tables that the viewer's page carries, so that its panels stand before Python runs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, TypedDict

from hexalab import LIST_FORMS, __version__
from hexalab.comparison import QUANTITIES as COMPARED
from hexalab.formats import FORMATS, WRITERS
from hexalab.quality import METRICS
from hexalab.reference import REFERENCE_FORMATS
from hexalab.session import DESCRIBED
from hexalab.session.looking import MOST_AT_ONCE
from hexalab.status import CORE_PATHS, DEFAULTS, SCHEMA
from hexalab.structure.quantities import QUANTITIES
from hexalab.summary import STATISTICS

Ends = list[float | None]
"""A range: low and high, None where it is open."""


class MetricEntry(TypedDict):
    """What the viewer's panels know of a metric.

    `better` says which of two values is: "high" or "low". `length_power` is the power of a length that values carry.
    """

    id: str
    name: str
    symbol: str
    variant: str
    better: str
    length_power: int
    full_range: Ends
    acceptable_range: Ends | None


class FormatEntry(TypedDict):
    """What the viewer knows of a file format; extensions start with a dot."""

    id: str
    name: str
    extensions: list[str]


class WriterEntry(TypedDict):
    """What the viewer knows of a format that meshes are written in; the extension starts with a dot."""

    id: str
    name: str
    extension: str


class TracedEntry(TypedDict):
    """What the viewer knows of a number per cell that comes out of the structure."""

    id: str
    name: str


class ComparedEntry(TypedDict):
    """What the viewer knows of a number per cell that comes out of a comparison."""

    id: str
    name: str
    better: str
    length_power: int
    metric: str
    cellwise: bool


class ListFormEntry(TypedDict):
    """What the viewer knows of a form that cells are copied in."""

    id: str
    name: str


class ViewerTables(TypedDict):
    """What the page carries of the core's tables, in the core's order.

    `defaults` are the settings', `core_paths` those of them that concern the core, `described` the parts of a
    description; settings are named by their paths, such as ``separation.mode``: `choices` are the words of one,
    `limits` its smallest and largest number. `statistics` are those that the core tells of a quantity. `most_at_once`
    are the shown cells up to which all sheets are drawn as surfaces, and all chords as curves, where none is chosen.
    """

    version: str
    defaults: dict[str, Any]
    core_paths: tuple[str, ...]
    choices: dict[str, list[str]]
    limits: dict[str, list[float]]
    described: tuple[str, ...]
    statistics: tuple[str, ...]
    metrics: list[MetricEntry]
    traced: list[TracedEntry]
    compared: list[ComparedEntry]
    formats: list[FormatEntry]
    surfaces: list[FormatEntry]
    writers: list[WriterEntry]
    list_forms: list[ListFormEntry]
    most_at_once: int


def viewer_tables() -> ViewerTables:
    """The core's tables as JSON values."""
    settings = dict(_settings(SCHEMA))
    return {
        "version": __version__,
        "defaults": DEFAULTS,
        "core_paths": CORE_PATHS,
        "choices": {path: rule["enum"] for path, rule in settings.items() if "enum" in rule},
        "limits": {
            path: [rule["minimum"], rule["maximum"]]
            for path, rule in settings.items()
            if {"minimum", "maximum"} <= rule.keys()
        },
        "described": DESCRIBED,
        "statistics": STATISTICS,
        "metrics": [
            {
                "id": metric.id,
                "name": metric.name,
                "symbol": metric.symbol,
                "variant": metric.variant,
                "better": metric.better,
                "length_power": metric.length_power,
                "full_range": _ends(metric.full_range),
                "acceptable_range": _ends(metric.acceptable_range) if metric.acceptable_range else None,
            }
            for metric in METRICS.values()
        ],
        "traced": [{"id": id, "name": one.name} for id, one in QUANTITIES.items()],
        "compared": [
            {
                "id": id,
                "name": row.name,
                "better": row.better,
                "length_power": row.length_power,
                "metric": row.metric,
                "cellwise": row.cellwise,
            }
            for id, row in COMPARED.items()
        ],
        "surfaces": [
            {"id": one.id, "name": one.name, "extensions": list(one.extensions)} for one in REFERENCE_FORMATS
        ],
        "formats": [{"id": one.id, "name": one.name, "extensions": list(one.extensions)} for one in FORMATS],
        "writers": [{"id": one.id, "name": one.name, "extension": one.extension} for one in WRITERS],
        "list_forms": [{"id": one.id, "name": one.name} for one in LIST_FORMS],
        "most_at_once": MOST_AT_ONCE,
    }


def _settings(schema: dict[str, Any], path: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    """The schema of each setting by its path; lists are settings, and what is in their items is not told."""
    for name, rule in schema["properties"].items():
        place = f"{path}.{name}" if path else name
        if "properties" in rule:
            yield from _settings(rule, place)
        else:
            yield place, rule


def _ends(ends: tuple[float, float]) -> Ends:
    return [end if math.isfinite(end) else None for end in ends]
