"""Criteria that decide whether a mesh passes: read from a file, each entry checked.

A file of criteria, in YAML or JSON::

    criteria:
      - metric: scaled_jacobian     # a metric's id
        minimum: 0.2                # and/or maximum, in the file's unit
        share: 0.01                 # part of the cells that may miss it; 0 by default
        group: STEEL                # of a group's cells only, by its name or id
      - invalid: 0                  # cells whose Jacobian is certified to be not positive somewhere: at most so many
      - finding: nonmanifold_faces  # of the diagnosis: must not be there
        at_most: 0                  # or at most so often

A cell whose value is not finite misses every criterion of its metric; cells of a kind that has not got the metric are
not asked.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from math import isfinite
from pathlib import Path
from typing import Any, NamedTuple

from ..diagnosis import FINDINGS
from ..errors import HexaLabError
from ..quality import METRICS
from .documents import parsed


class CriteriaError(HexaLabError):
    """Criteria that can't be read: which file and entry, what was found, what was expected."""


@dataclass(frozen=True)
class MetricCriterion:
    """The values of a metric have bounds.

    Parameters
    ----------
    metric : str
        Id, a key of `METRICS`.
    minimum, maximum : float or None
        One of them at least.
    share : float
        Part of the cells, 0 to 1, that may miss it.
    group : str
        Name or id of the group of cells that is asked; all cells if it is empty.
    """

    metric: str
    minimum: float | None = None
    maximum: float | None = None
    share: float = 0.0
    group: str = ""


@dataclass(frozen=True)
class InvalidCriterion:
    """At most so many cells, of all or of a group, are certified invalid."""

    invalid: int
    group: str = ""


@dataclass(frozen=True)
class FindingCriterion:
    """The diagnosis has found something at most so often."""

    finding: str
    at_most: int = 0


Criterion = MetricCriterion | InvalidCriterion | FindingCriterion


class Field(NamedTuple):
    """What an entry may say: how it is checked, and what is expected.

    `check` gives the value that is kept, or None where it is none of those that are expected.
    """

    check: Callable[[Any], Any]
    expected: str


def _number(value: Any) -> float | None:
    sound = isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)
    return float(value) if sound else None


def _share(value: Any) -> float | None:
    number = _number(value)
    return number if number is not None and 0 <= number <= 1 else None


def _count(value: Any) -> int | None:
    return value if isinstance(value, int) and not isinstance(value, bool) and value >= 0 else None


def _name(value: Any) -> str | None:
    """A name; one of digits alone is a number in YAML."""
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value)
    return value if isinstance(value, str) and value else None


def _metric(value: Any) -> str | None:
    return value if isinstance(value, str) and value in METRICS else None


def _finding(value: Any) -> str | None:
    return value if isinstance(value, str) and value in FINDINGS else None


KNOWN: dict[str, tuple[str, ...]] = {
    "metric": tuple(METRICS),
    "difference": tuple(METRICS),
    "worse": tuple(METRICS),
    "finding": tuple(FINDINGS),
}
"""Names that a field takes, to tell the nearest of them."""

BOUND = Field(_number, "a number")
SHARE = Field(_share, "a number from 0 to 1")
METRIC = Field(_metric, "the id of a metric")
COUNT = Field(_count, "a number of 0 or more")
GROUP = Field(_name, "the name or the id of a group of cells")

Kinds = Mapping[str, tuple[Callable[..., Any], Mapping[str, Field]]]
"""The kinds of criteria, by the field that tells them: what each is made into, and its fields."""

KINDS: Kinds = {
    "metric": (
        MetricCriterion,
        {
            "metric": METRIC,
            "minimum": BOUND,
            "maximum": BOUND,
            "share": SHARE,
            "group": GROUP,
        },
    ),
    "invalid": (InvalidCriterion, {"invalid": COUNT, "group": GROUP}),
    "finding": (
        FindingCriterion,
        {"finding": Field(_finding, "the id of a finding"), "at_most": COUNT},
    ),
}
"""What a report asks of a mesh."""


def read_criteria(path: Path, kinds: Kinds = KINDS) -> list[Any]:
    """Read criteria from a file, `.yaml` and `.yml` as YAML, anything else as JSON.

    Parameters
    ----------
    path : Path
    kinds : mapping
        What may be asked; by default what a report asks of a mesh.

    Raises
    ------
    CriteriaError
        It holds none: file, entry, what was found, what was expected.
    HexaLabError
        It is YAML, and pyyaml is not installed.
    OSError
        It can't be read.
    """
    return checked(parsed(path), str(path), kinds)


def checked(document: Any, name: str = "criteria", kinds: Kinds = KINDS) -> list[Any]:
    """Make a parsed document of criteria a list of them.

    Parameters
    ----------
    document : object
        As JSON has it: a dict with the key `criteria`, or the list alone.
    name : str
        Of the file, for messages.
    kinds : mapping
        What may be asked.

    Raises
    ------
    CriteriaError
        Something is no criterion: where, what was found, what was expected.
    """
    if isinstance(document, dict):
        for key in document:
            if key != "criteria":
                raise _wrong(name, str(key), "a key that is not known", "criteria alone")
        document = document.get("criteria")
    if not isinstance(document, list):
        raise _wrong(name, "criteria", _told(document), "a list")
    if not document:
        raise _wrong(name, "criteria", "an empty list", "one criterion at least")
    return [_entry(entry, name, f"criteria[{place}]", kinds) for place, entry in enumerate(document)]


def _entry(entry: Any, name: str, place: str, kinds: Kinds) -> Any:
    if not isinstance(entry, dict):
        raise _wrong(name, place, _told(entry), f"an entry with one of {', '.join(kinds)}")
    named = [kind for kind in kinds if kind in entry]
    if len(named) != 1:
        found = f"{' and '.join(named)} in one entry" if named else f"the keys {_listed(entry)}"
        raise _wrong(name, place, found, f"one of {', '.join(kinds)}")
    make, fields = kinds[named[0]]
    values = {}
    for key, value in entry.items():
        if key not in fields:
            raise _wrong(name, f"{place}.{key}", "a key that is not known", f"one of {', '.join(fields)}")
        values[key] = fields[key].check(value)
        if values[key] is None:
            expected = fields[key].expected + _nearest(key, value)
            raise _wrong(name, f"{place}.{key}", _told(value), expected)
    criterion = make(**values)
    if {"minimum", "maximum"} <= fields.keys():
        _check_bounds(named[0], criterion.minimum, criterion.maximum, name, place)
    return criterion


def _check_bounds(kind: str, low: float | None, high: float | None, name: str, place: str) -> None:
    if low is None and high is None:
        raise _wrong(name, place, f"a {kind} without bounds", "minimum, maximum, or both")
    if low is not None and high is not None and low > high:
        raise _wrong(name, place, f"minimum {low:g} above maximum {high:g}", "a minimum below the maximum")


def _nearest(key: str, value: Any) -> str:
    known = KNOWN.get(key)
    if known is None:
        return ""
    try:
        near = import_module("difflib").get_close_matches(_plain(value), known, 1)
    except ModuleNotFoundError:  # in a browser
        near = [name for name in known if name == _plain(value)]
    return f"; did you mean {near[0]}?" if near else f", one of {', '.join(known)}"


def _plain(value: Any) -> str:
    return str(value).lower().replace(" ", "_").replace("-", "_")


def _told(value: Any) -> str:
    """A value as it is told in a message: short, and in the words of the file."""
    if value is None:
        return "nothing"
    text = str(value).lower() if isinstance(value, bool) else repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def _listed(entry: dict[Any, Any]) -> str:
    return ", ".join(map(str, entry)) or "of an empty entry"


def _wrong(name: str, place: str, found: str, expected: str) -> CriteriaError:
    return CriteriaError(f"{name}: {place}: found {found}, expected {expected}")
