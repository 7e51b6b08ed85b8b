"""The core's tables that the viewer's page carries, so that its panels stand before Python runs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from hexalab import __version__
from hexalab.formats import FORMATS
from hexalab.quality import METRICS
from hexalab.session import DESCRIBED
from hexalab.status import CORE_PATHS, DEFAULTS, SCHEMA
from hexalab.summary import STATISTICS


def viewer_tables() -> dict[str, Any]:
    """Return version, status defaults, metrics, formats and what else the core alone knows, as JSON values.

    An open end of a range is None; settings are named by their paths, such as ``separation.mode``.
    """
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
                "better": metric.better,
                "full_range": _ends(metric.full_range),
                "acceptable_range": metric.acceptable_range and _ends(metric.acceptable_range),
            }
            for metric in METRICS.values()
        ],
        "formats": [{"id": one.id, "name": one.name, "extensions": list(one.extensions)} for one in FORMATS],
    }


def _settings(schema: dict[str, Any], path: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    """The schema of each setting by its path; lists are settings, and what is in their items is not told."""
    for name, rule in schema["properties"].items():
        place = f"{path}.{name}" if path else name
        if "properties" in rule:
            yield from _settings(rule, place)
        else:
            yield place, rule


def _ends(ends: tuple[float, float]) -> list[float | None]:
    return [end if math.isfinite(end) else None for end in ends]
