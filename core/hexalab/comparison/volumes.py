"""The volumes of two bodies that are compared."""

from __future__ import annotations

import numpy as np

from ..mesh import Mesh
from ..quality import quality
from ..reference import TriangleSurface


def volume_of(body: Mesh | TriangleSurface) -> float | None:
    """The volume of a mesh's cells together; what a closed surface encloses; None for an open one."""
    if isinstance(body, TriangleSurface):
        return abs(body.volume) if body.closed else None
    volumes = quality(body, "volume")
    total = float(volumes[np.isfinite(volumes)].sum())
    return total if np.isfinite(total) else None


def volume_ratio(first: float | None, second: float | None) -> float | None:
    """The second volume over the first; None where one is not known, or the first is 0."""
    if first is None or second is None or not first:
        return None
    ratio = second / first
    return ratio if np.isfinite(ratio) else None
