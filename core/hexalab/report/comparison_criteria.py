"""Criteria that decide on a comparison, and what they find: read from a file as those of a report are.

A file of criteria, in YAML or JSON::

    criteria:
      - difference: scaled_jacobian  # what the second mesh has more
        of: min                      # of its min (by default), mean or max
        minimum: 0                   # and/or maximum
      - worse: scaled_jacobian       # cells at which the metric got worse; needs the same cells in both
        share: 0.01                  # part of the cells; 0 by default
      - distance: hausdorff          # or max, mean, rms: of the surfaces, the larger of both ways
        maximum: 0.5                 # in the file's unit
        percent: true                # or in percent of the first mesh's diagonal
      - volume: 0.01                 # part of the volume that may be gained or lost
      - same_cells: true             # whether the cells have to be the same
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

from ..quality import METRICS
from ..quality.measures import ROUNDING
from ..words import count, number
from .criteria import BOUND, METRIC, SHARE, Field, Kinds
from .judging import MISSED, PASSED, UNMEASURED

Facts = Mapping[str, Any]
"""As `hexalab.comparison.compare` gives them."""

STATISTICS = ("min", "mean", "max")
DISTANCES = ("hausdorff", "max", "mean", "rms")


@dataclass(frozen=True)
class Check:
    """What was asked, whether it holds, and what was found.

    Parameters
    ----------
    title : str
    state : "passed", "missed" or "not measured"
    found : str
        In words.
    """

    title: str
    state: str
    found: str


@dataclass(frozen=True)
class Difference:
    """What the second mesh has more of a metric has bounds."""

    difference: str
    of: str = "min"
    minimum: float | None = None
    maximum: float | None = None

    def judged(self, facts: Facts) -> Check:
        """Hold it against the facts of a comparison."""
        found = facts["difference"].get(self.difference, {}).get(self.of)
        title = f"{METRICS[self.difference].name}, {self.of}, B - A: {bounds(self.minimum, self.maximum)}"
        return _within(title, found, self.minimum, self.maximum)


@dataclass(frozen=True)
class Worse:
    """A part of the cells, at most, may have got worse by a metric."""

    worse: str
    share: float = 0.0

    def judged(self, facts: Facts) -> Check:
        """Hold it against the facts of a comparison."""
        title = f"{METRICS[self.worse].name} got worse: at most {100 * self.share:g} % of the cells"
        if facts["changes"] is None:
            return Check(title, UNMEASURED, "The cells are not the same in both.")
        counts = facts["changes"][self.worse]
        cells = counts["worse"] + counts["better"] + counts["same"]
        state = MISSED if counts["worse"] > self.share * cells + 1e-9 else PASSED
        return Check(title, state, f"{count(counts['worse'])} of {count(cells)} cells got worse.")


@dataclass(frozen=True)
class Distance:
    """The distance of the surfaces has bounds."""

    distance: str
    maximum: float | None = None
    minimum: float | None = None
    percent: bool = False

    def judged(self, facts: Facts) -> Check:
        """Hold it against the facts of a comparison."""
        apart, ending = facts["distance"], "_percent" if self.percent else ""
        name = self.distance + ending
        ways = (apart["a_to_b"], apart["b_to_a"])
        found = apart[name] if self.distance == "hausdorff" else max(way[name] for way in ways)
        unit = " % of the diagonal" if self.percent else ""
        title = f"Distance, {self.distance}: {bounds(self.minimum, self.maximum)}{unit}"
        return _within(title, found, self.minimum, self.maximum, unit)


@dataclass(frozen=True)
class Volume:
    """A part of the volume may be gained or lost."""

    volume: float

    def judged(self, facts: Facts) -> Check:
        """Hold it against the facts of a comparison."""
        title = f"Volume gained or lost: at most {100 * self.volume:g} %"
        ratio = facts["volume_ratio"]
        if ratio is None:
            return Check(title, UNMEASURED, "One of both has no volume: it is not closed, or flat.")
        state = MISSED if abs(ratio - 1) > self.volume + ROUNDING else PASSED
        return Check(title, state, f"The second has {100 * ratio:.6g} % of the first one's volume.")


@dataclass(frozen=True)
class SameCells:
    """The cells have to be the same, or must not be."""

    same_cells: bool

    def judged(self, facts: Facts) -> Check:
        """Hold it against the facts of a comparison."""
        same = facts["same_connectivity"]
        words = "" if same else f": {facts['connectivity'] or 'a surface has none'}"
        title = "The same cells in both" if self.same_cells else "Not the same cells"
        state = PASSED if same == self.same_cells else MISSED
        return Check(title, state, f"They are {'the same' if same else 'not'}{words}.")


def _boolean(value: Any) -> bool | None:
    return value if isinstance(value, bool) else None


def _word_of(words: Sequence[str]) -> Field:
    return Field(lambda value: value if value in words else None, f"one of {', '.join(words)}")


TRUTH = Field(_boolean, "true or false")

KINDS: Kinds = {
    "difference": (
        Difference,
        {"difference": METRIC, "of": _word_of(STATISTICS), "minimum": BOUND, "maximum": BOUND},
    ),
    "worse": (Worse, {"worse": METRIC, "share": SHARE}),
    "distance": (
        Distance,
        {"distance": _word_of(DISTANCES), "minimum": BOUND, "maximum": BOUND, "percent": TRUTH},
    ),
    "volume": (Volume, {"volume": SHARE}),
    "same_cells": (SameCells, {"same_cells": TRUTH}),
}
"""What may be asked of a comparison."""


def judged(criteria: Sequence[Any], facts: Facts) -> dict[str, Any]:
    """Hold criteria against the facts of a comparison.

    Returns
    -------
    dict
        `passed` (whether none is missed, and each was measured), `checks`: a list of `title`, `state`, `found`.
    """
    checks = [vars(criterion.judged(facts)) for criterion in criteria]
    return {"passed": all(check["state"] == PASSED for check in checks), "checks": checks}


def bounds(minimum: float | None, maximum: float | None) -> str:
    """Write bounds in words."""
    told = [("at least", minimum), ("at most", maximum)]
    return " and ".join(f"{words} {value:g}" for words, value in told if value is not None)


def _within(
    title: str, found: float | None, minimum: float | None, maximum: float | None, unit: str = ""
) -> Check:
    if found is None or not isfinite(found):
        return Check(title, UNMEASURED, "There is no such number.")
    slack = ROUNDING * abs(found)
    low, high = (
        (minimum is not None and found < minimum - slack),
        (maximum is not None and found > maximum + slack),
    )
    return Check(title, MISSED if low or high else PASSED, f"{number(found)}{unit}.")
