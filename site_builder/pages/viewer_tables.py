"""The core's tables that the viewer's page carries, so that its panels stand before Python runs."""

from __future__ import annotations

import math
from typing import Any, TypedDict

from hexalab import __version__
from hexalab.formats import FORMATS
from hexalab.quality import METRICS
from hexalab.session import DESCRIBED
from hexalab.status import CORE_PATHS, DEFAULTS

Ends = list[float | None]
"""A range: low and high, None where it is open."""


class MetricEntry(TypedDict):
    """What the viewer's panels know of a metric; `better` says which of two values is: "high" or "low"."""

    id: str
    name: str
    symbol: str
    better: str
    full_range: Ends
    acceptable_range: Ends | None


class FormatEntry(TypedDict):
    """What the viewer knows of a file format; extensions start with a dot."""

    id: str
    name: str
    extensions: list[str]


class ViewerTables(TypedDict):
    """What the page carries of the core's tables, in the core's order.

    `defaults` are the settings', `core_paths` those of them that concern the core, `described` the parts of a
    description.
    """

    version: str
    defaults: dict[str, Any]
    core_paths: tuple[str, ...]
    described: tuple[str, ...]
    metrics: list[MetricEntry]
    formats: list[FormatEntry]


def viewer_tables() -> ViewerTables:
    """The core's tables as JSON values."""
    return {
        "version": __version__,
        "defaults": DEFAULTS,
        "core_paths": CORE_PATHS,
        "described": DESCRIBED,
        "metrics": [
            {
                "id": metric.id,
                "name": metric.name,
                "symbol": metric.symbol,
                "better": metric.better,
                "full_range": _ends(metric.full_range),
                "acceptable_range": _ends(metric.acceptable_range) if metric.acceptable_range else None,
            }
            for metric in METRICS.values()
        ],
        "formats": [{"id": one.id, "name": one.name, "extensions": list(one.extensions)} for one in FORMATS],
    }


def _ends(ends: tuple[float, float]) -> Ends:
    return [end if math.isfinite(end) else None for end in ends]
