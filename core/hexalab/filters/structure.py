"""By structure (SPEC T5): cells in some blocks, sheets and chords, or in none of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..structure import Structure
from ..structure.members import cells_of

KINDS = ("blocks", "sheets", "chords")


class Traced(NamedTuple):
    """What the filter goes by.

    Attributes
    ----------
    keep : "inside" or "outside"
    complex : "whole" or "interior"
    numbers : tuple of (kind, numbers)
    """

    keep: str
    complex: str
    numbers: tuple[tuple[str, tuple[int, ...]], ...]


def traced_of(settings: Mapping[str, Any]) -> Traced | None:
    """The filter that settings (the status' section `filters.structure`) ask for; None if it hides nothing."""
    numbers = tuple((kind, tuple(settings.get(kind, ()))) for kind in KINDS)
    if not settings.get("enabled", True) or not any(some for _, some in numbers):
        return None
    return Traced(settings.get("keep", "inside"), settings.get("complex", "whole"), numbers)


def hidden_by_structure(structure: Structure, wanted: Traced) -> NDArray[np.bool_]:
    """(C,) bool: which cells it hides."""
    within = np.zeros(structure.mesh.cell_count, dtype=bool)
    for kind, some in wanted.numbers:
        if some:
            within |= cells_of(structure, kind, some, wanted.complex)
    return within if wanted.keep == "outside" else ~within
