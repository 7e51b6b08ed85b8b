"""The core's tables that the viewer's page carries, so that its panels stand before Python runs."""

from __future__ import annotations

import math
from typing import Any

from hexalab import __version__
from hexalab.formats import FORMATS
from hexalab.quality import METRICS
from hexalab.session import DESCRIBED
from hexalab.status import CORE_PATHS, DEFAULTS


def viewer_tables() -> dict[str, Any]:
    """Return version, status defaults, metrics, formats and what else the core alone knows, as JSON values.

    An open end of a range is None.
    """
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
                "acceptable_range": metric.acceptable_range and _ends(metric.acceptable_range),
            }
            for metric in METRICS.values()
        ],
        "formats": [{"id": one.id, "name": one.name, "extensions": list(one.extensions)} for one in FORMATS],
    }


def _ends(ends: tuple[float, float]) -> list[float | None]:
    return [end if math.isfinite(end) else None for end in ends]
