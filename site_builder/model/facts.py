"""Facts about a mesh: what is known of a file, whether measured here or published elsewhere.

Every field may be unknown (None): a remote file that nobody here has measured has only its address. Nothing is guessed.
"""

from __future__ import annotations

import dataclasses
import json
import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Counts = dict[int, int]


@dataclass
class Facts:
    """What is known of one mesh file.

    Parameters
    ----------
    sha256, bytes
        Of the file as it is stored (compressed, if it is).
    interior_edge_valence, boundary_edge_valence : dict of int to int
        Number of edges by number of cells around them.
    cells_per_depth : list of int
        Cells by hop distance from the boundary.
    sj_min, sj_mean, sj_max : float
        Scaled Jacobian, as Verdict defines it.
    sj_not_positive : int
        Cells whose Scaled Jacobian is zero or negative.
    validity : dict
        Cells certified ``valid``, ``invalid`` and ``undecided``.
    quality : dict of metric id to statistics
    histogram : dict
        ``low``, ``high`` and ``counts`` of the Scaled Jacobian.
    findings : list of {id, severity, message, count}
    """

    bytes: int | None = None
    sha256: str | None = None
    format: str | None = None
    vertices: int | None = None
    cells: int | None = None
    kinds: dict[str, int] | None = None
    faces: int | None = None
    boundary_faces: int | None = None
    nonmanifold_faces: int | None = None
    edges: int | None = None
    unreferenced_vertices: int | None = None
    cells_repeating_a_vertex: int | None = None
    components: int | None = None
    extent: list[list[float]] | None = None
    cells_per_depth: list[int] | None = None
    interior_edge_valence: Counts | None = None
    boundary_edge_valence: Counts | None = None
    sj_min: float | None = None
    sj_mean: float | None = None
    sj_max: float | None = None
    sj_not_positive: int | None = None
    sj_not_finite: int | None = None
    validity: dict[str, int] | None = None
    quality: dict[str, dict[str, Any]] | None = None
    histogram: dict[str, Any] | None = None
    findings: list[dict[str, Any]] | None = None
    notes: list[str] | None = None

    @classmethod
    def from_dict(cls, values: dict[str, Any]) -> Facts:
        """Facts from a JSON object; keys that aren't known are an error."""
        facts = cls(**values)
        for name in ("interior_edge_valence", "boundary_edge_valence"):
            counts = getattr(facts, name)
            if counts is not None:
                setattr(facts, name, {int(valence): int(count) for valence, count in counts.items()})
        return facts

    def to_dict(self) -> dict[str, Any]:
        """A JSON object of what is known."""
        known: dict[str, Any] = {}
        for field in dataclasses.fields(self):
            value = getattr(self, field.name)
            if value is not None:
                counts = field.name.endswith("_edge_valence")
                known[field.name] = {str(k): v for k, v in sorted(value.items())} if counts else value
        return known

    @property
    def irregular_edges(self) -> int | None:
        """Interior edges with other than four cells around them."""
        valence = self.interior_edge_valence
        return None if valence is None else sum(n for v, n in valence.items() if v != 4)

    @property
    def interior_edges(self) -> int | None:
        """Edges inside the mesh."""
        return None if self.interior_edge_valence is None else sum(self.interior_edge_valence.values())

    @property
    def invalid_cells(self) -> int | None:
        """Cells certified invalid; where nobody certified, those with a Scaled Jacobian that isn't positive."""
        if self.validity is not None:
            return self.validity["invalid"]
        return self.sj_not_positive


_WHOLE = ("bytes", "vertices", "cells", "boundary_faces", "nonmanifold_faces", "edges", "unreferenced_vertices",
          "components", "sj_not_positive", "sj_not_finite")  # fmt: skip
_REAL = ("sj_min", "sj_mean", "sj_max")
_TABLES = ("interior_edge_valence", "boundary_edge_valence")


def read_published(file: Path) -> dict[str, Facts]:
    """Facts of remote files, by the ``url`` of their row in source.yaml.

    Raises
    ------
    ValueError
        A fact isn't one that may be told of a remote file, or isn't what it should be.
    """
    rows = json.loads(file.read_text("utf-8"))
    for url, values in rows["meshes"].items():
        for name, value in values.items():
            if not _believable(name, value):
                raise ValueError(f"{name!r} of {url!r} is {json.dumps(value)[:60]}")
    return {url: Facts.from_dict(values) for url, values in rows["meshes"].items()}


def _believable(name: str, value: Any) -> bool:
    if name in _WHOLE:
        return type(value) is int and value >= 0
    if name in _REAL:
        return type(value) in (int, float) and math.isfinite(value)
    if name in _TABLES:
        return isinstance(value, dict) and all(
            key.isascii() and key.isdigit() and type(number) is int and number >= 0
            for key, number in value.items()
        )
    return name == "sha256" and isinstance(value, str) and re.fullmatch(r"[0-9a-f]{64}", value) is not None
