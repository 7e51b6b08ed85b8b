"""Facts about a mesh: what is known of a file, whether measured here or published elsewhere.

Every field may be unknown (None): a remote file that nobody here has measured has only its address. Nothing is guessed.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypedDict

Counts = dict[int, int]


class Statistics(TypedDict):
    """A metric's values over a mesh; numbers are None where no cell has a finite value.

    Attributes
    ----------
    min, max, mean, median, variance : float or None
        In the metric's unit; the variance is the population's, in the unit's square.
    not_finite, outside_acceptable : int
        Cells without a finite value, and with one outside the acceptable range.
    """

    min: float | None
    max: float | None
    mean: float | None
    median: float | None
    variance: float | None
    not_finite: int
    outside_acceptable: int


class Binned(TypedDict):
    """How often values fall into bins of equal width from `low` to `high`; what lies outside isn't counted."""

    low: float
    high: float
    counts: list[int]


class Finding(TypedDict):
    """What is wrong with a mesh: the diagnosis's name for it, a sentence, and how many it speaks of."""

    id: str
    count: int
    message: str


class Looked(TypedDict):
    """Where a mesh is looked at from, and the normal of a plane that faces the eye (`hexalab.status.views.View`)."""

    direction: list[float]
    up: list[float]
    facing: list[float]


class Validity(TypedDict):
    """Cells by what could be certified of their Jacobian."""

    valid: int
    invalid: int
    undecided: int


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
    quality : dict of str to Statistics
        By metric id.
    histogram : Binned
        Of the Scaled Jacobian.
    findings : list of Finding
        The worst first.
    structure : dict
        What `hexalab structure --json` tells (`hexalab.structure.facts.facts_of`).
    groups, features : list, dict
        What the file groups and marks (`hexalab.group_facts`): of features those that there are.
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
    view: Looked | None = None
    cells_per_depth: list[int] | None = None
    interior_edge_valence: Counts | None = None
    boundary_edge_valence: Counts | None = None
    sj_min: float | None = None
    sj_mean: float | None = None
    sj_max: float | None = None
    sj_not_positive: int | None = None
    sj_not_finite: int | None = None
    validity: Validity | None = None
    quality: dict[str, Statistics] | None = None
    histogram: Binned | None = None
    findings: list[Finding] | None = None
    notes: list[str] | None = None
    structure: dict[str, Any] | None = None
    groups: list[dict[str, Any]] | None = None
    features: dict[str, Any] | None = None

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Facts:
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
    def arcs(self) -> int | None:
        """Arcs and loops of irregular interior edges."""
        arcs, loops = self._traced("irregular", "arcs"), self._traced("irregular", "loops")
        return None if arcs is None or loops is None else arcs + loops

    @property
    def sheets(self) -> int | None:
        """Sheets."""
        return self._traced("sheets", "count")

    @property
    def self_intersecting_sheets(self) -> int | None:
        """Sheets that cross a cell more than once."""
        return self._traced("sheets", "self_intersecting")

    @property
    def blocks(self) -> int | None:
        """Blocks of the base complex."""
        return self._traced("base_complex", "blocks")

    def _traced(self, part: str, name: str) -> int | None:
        """A figure of the structure; None if nobody traced it, or if there was no cell to trace it through."""
        if not self.structure or not self.structure["base_complex"]["blocks"]:
            return None
        figure: int = self.structure[part][name]
        return figure

    @property
    def invalid_cells(self) -> int | None:
        """Cells certified invalid; where nobody certified, those with a Scaled Jacobian that isn't positive."""
        if self.validity is not None:
            return self.validity["invalid"]
        return self.sj_not_positive
