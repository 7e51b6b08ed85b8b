"""What tests of the session share: all settings, the records, and what may leave through the door."""

from __future__ import annotations

from typing import Any

import numpy as np

from hexalab.status import DEFAULTS, core_part, merge

ALL = core_part(DEFAULTS)
RECORDS = {"surface", "silhouette", "see_through", "irregular", "arrows", "colour"}


def plain(value: Any) -> bool:
    """Whether a result holds only what the worker can hand over."""
    if isinstance(value, dict):
        return all(isinstance(name, str) and plain(part) for name, part in value.items())
    if isinstance(value, list | tuple):
        return all(map(plain, value))
    if isinstance(value, np.ndarray):
        return (
            value.dtype.kind in "iuf" and value.dtype.itemsize < 9 and value.dtype not in ("int64", "uint64")
        )
    return value is None or type(value) in (bool, int, float, str, bytes)


def core_settings(partial: dict[str, Any]) -> dict[str, Any]:
    """The settings of a checked document under which the core draws, as the page would tell them."""
    return core_part(merge(DEFAULTS, partial))


def shown_of(update: dict[str, Any]) -> set[int]:
    return set((update["surface"]["faces"] // 8).tolist())
