"""The core's tables that the viewer's page carries, so that its panels stand before Python runs."""

from __future__ import annotations

import math
from typing import Any, TypedDict

from hexalab import __version__
from hexalab.formats import FORMATS
from hexalab.quality import METRICS
from hexalab.status import DEFAULTS

Ends = list[float | None]
"""A range: low and high, None where it is open."""


class MetricEntry(TypedDict):
    """What the viewer's panels know of a metric; `best` says which end is: "high" or "low"."""

    id: str
    name: str
    symbol: str
    best: str
    full_range: Ends
    acceptable_range: Ends | None


class FormatEntry(TypedDict):
    """What the viewer knows of a file format; extensions start with a dot."""

    id: str
    name: str
    extensions: list[str]


class ViewerTables(TypedDict):
    """The program's version, the settings' defaults, metrics and formats, in the core's order."""

    version: str
    defaults: dict[str, Any]
    metrics: list[MetricEntry]
    formats: list[FormatEntry]


def viewer_tables() -> ViewerTables:
    """The core's tables as JSON values."""
    return {
        "version": __version__,
        "defaults": DEFAULTS,
        "metrics": [
            {
                "id": metric.id,
                "name": metric.name,
                "symbol": metric.symbol,
                "best": metric.direction,
                "full_range": _ends(metric.full_range),
                "acceptable_range": _ends(metric.acceptable_range) if metric.acceptable_range else None,
            }
            for metric in METRICS.values()
        ],
        "formats": [{"id": one.id, "name": one.name, "extensions": list(one.extensions)} for one in FORMATS],
    }


def _ends(ends: tuple[float, float]) -> Ends:
    return [end if math.isfinite(end) else None for end in ends]
