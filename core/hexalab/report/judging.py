"""Criteria held against a mesh: what was asked, whether it holds, and which cells miss it."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats
from ..diagnosis import TURNED, Finding
from ..grouping import group_of_cells
from ..groups import Group
from ..mesh import Mesh
from ..numbering import cell_numbers, vertex_numbers
from ..quality import METRICS, Validity
from ..quality.measures import ROUNDING
from ..quality.validity import INVALID
from ..words import count, counted, titled
from .criteria import FindingCriterion, InvalidCriterion, MetricCriterion

PASSED, MISSED, UNMEASURED = "passed", "missed", "not measured"
"""States of a check; there may be no cell that it could be asked of."""

NUMBERS_TOLD = 20
"""Elements of a finding, or of a check, that are told by number."""

Check = dict[str, Any]
"""One thing that was asked: `kind` ("metric", "invalid", "finding"), `of` (the metric's or the finding's id), `title`,
`state`, `found` (in words), `count` (how many miss it, or were found), `on` ("cells" or "vertices"), `numbers` (the
file's, of at most `NUMBERS_TOLD`), `values` (of these by the metric; empty for all but metrics)."""


def judged_metric(
    mesh: Mesh, groups: Sequence[Group], criterion: MetricCriterion, values: Floats, unit: str
) -> Check:
    """Hold the values of a metric against bounds.

    Raises
    ------
    HexaLabError
        The mesh has no such group.
    """
    metric = METRICS[criterion.metric]
    group = group_of_cells(groups, criterion.group) if criterion.group else None
    rows = np.flatnonzero(np.isin(mesh.kinds, metric.kinds)) if group is None else group.members
    if group is not None:
        rows = rows[np.isin(mesh.kinds[rows], metric.kinds)]
    over = beyond(values[rows], criterion.minimum, criterion.maximum)
    missing = np.flatnonzero(over > 0)
    allowed = floor(criterion.share * len(rows) + 1e-9)
    state = UNMEASURED if not len(rows) else MISSED if len(missing) > allowed else PASSED
    worst = missing[np.lexsort((missing, -over[missing]))[:NUMBERS_TOLD]]
    share = f" ({100 * len(missing) / len(rows):.3g} %)" if len(rows) else ""
    found = (
        "No cell has this metric: nothing was measured."
        if state == UNMEASURED
        else f"{count(len(missing))} of {counted(len(rows), 'cell')}{share} miss it."
    )
    return {
        "kind": "metric",
        "of": metric.id,
        "title": f"{titled(metric.name, metric.length_power, unit)}{_of(group)}: {_asked(criterion)}",
        "state": state,
        "found": found,
        "count": len(missing),
        "on": "cells",
        "numbers": cell_numbers(mesh, rows[worst]).tolist(),
        "values": values[rows][worst].tolist(),
    }


def beyond(values: Floats, minimum: float | None, maximum: float | None) -> Floats:
    """How far values are beyond bounds, (n,): 0 within them, but for rounding; infinite for what is not finite."""
    over = np.zeros(len(values))
    with np.errstate(invalid="ignore", over="ignore"):
        if minimum is not None:
            over = np.maximum(over, np.where(values < minimum - ROUNDING * abs(minimum), minimum - values, 0))
        if maximum is not None:
            over = np.maximum(over, np.where(values > maximum + ROUNDING * abs(maximum), values - maximum, 0))
    over[~np.isfinite(values)] = np.inf
    return over


def judged_invalid(
    mesh: Mesh, groups: Sequence[Group], criterion: InvalidCriterion, validity: Validity
) -> Check:
    """Count the cells that are certified invalid; errors as for `judged_metric`."""
    group = group_of_cells(groups, criterion.group) if criterion.group else None
    state = validity.state if group is None else validity.state[group.members]
    places = np.flatnonzero(state == INVALID)
    rows = places if group is None else group.members[places]
    undecided = int(np.count_nonzero(state == 2))
    also = f" {count(undecided)} could not be decided." if undecided else ""
    return {
        "kind": "invalid",
        "of": "invalid",
        "title": f"Cells certified invalid{_of(group)}: {_at_most(criterion.invalid)}",
        "state": UNMEASURED if not len(state) else MISSED if len(rows) > criterion.invalid else PASSED,
        "found": f"{count(len(rows))} of {counted(len(state), 'cell')}.{also}",
        "count": len(rows),
        "on": "cells",
        "numbers": cell_numbers(mesh, rows[:NUMBERS_TOLD]).tolist(),
        "values": [],
    }


def judged_finding(mesh: Mesh, criterion: FindingCriterion, findings: Sequence[Finding]) -> Check:
    """Look whether the diagnosis has found something."""
    found = [one for one in findings if one.id == criterion.finding]
    many = sum(one.count for one in found)
    on, numbers = ("cells", np.zeros(0, np.int64)) if not found else concerned(mesh, found[0])
    return {
        "kind": "finding",
        "of": criterion.finding,
        "title": f"Finding {criterion.finding}: {_at_most(criterion.at_most)}",
        "state": MISSED if many > criterion.at_most else PASSED,
        "found": " ".join(one.message for one in found) or "Not found.",
        "count": many,
        "on": on,
        "numbers": numbers[:NUMBERS_TOLD].tolist(),
        "values": [],
    }


def own_checks(mesh: Mesh, findings: Sequence[Finding], validity: Validity) -> list[Check]:
    """What is asked of every mesh: no invalid cell, and nothing that the diagnosis calls an error.

    A mesh that was turned round was inverted as a whole, which is an error of its file.
    """
    errors = [one for one in findings if one.severity == "error" or one.message == TURNED]
    return [
        judged_invalid(mesh, (), InvalidCriterion(0), validity),
        *(judged_finding(mesh, FindingCriterion(one.id), [one]) for one in errors),
    ]


def concerned(mesh: Mesh, finding: Finding) -> tuple[str, NDArray[np.int64]]:
    """What a finding concerns, "cells" or "vertices", and their numbers in the file."""
    if len(finding.vertices) and not len(finding.cells):
        return "vertices", vertex_numbers(mesh, _rows(finding.vertices))
    return "cells", cell_numbers(mesh, _rows(finding.cells))


def _rows(rows: Array) -> Array:
    """The first ones, of which some are told."""
    return rows[:NUMBERS_TOLD]


def _of(group: Group | None) -> str:
    return f" of {group.id}" if group else ""


def _at_most(most: int) -> str:
    return f"at most {count(most)}" if most else "none"


def _asked(criterion: MetricCriterion) -> str:
    low, high = criterion.minimum, criterion.maximum
    if low is not None and high is not None:
        words = f"from {low:g} to {high:g}"
    else:
        words = f"at least {low:g}" if low is not None else f"at most {high:g}"
    allowed = f"; {100 * criterion.share:g} % of the cells may miss it" if criterion.share else ""
    return words + allowed
