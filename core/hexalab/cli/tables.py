"""Tables in plain text."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..words import count, number


def table(rows: Sequence[Sequence[str]], indent: int = 2) -> str:
    """Align columns: the first to the left, the others, which are numbers, to the right."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = []
    for first, *others in rows:
        cells = [first.ljust(widths[0])]
        cells += [cell.rjust(width) for cell, width in zip(others, widths[1:], strict=True)]
        lines.append(" " * indent + "  ".join(cells).rstrip())
    return "\n".join(lines)


def quality_table(measured: dict[str, dict[str, Any]], names: dict[str, str]) -> str:
    """Lay out statistics, one row per metric; `names` gives the metric's name for its id."""
    rows = [["", "min", "mean", "median", "max", "variance", "outside", "not finite"]]
    for metric, numbers in measured.items():
        row = [names[metric]]
        row += [number(numbers[name]) for name in ("min", "mean", "median", "max", "variance")]
        row += [count(numbers[name]) for name in ("outside_acceptable", "not_finite")]
        rows.append(row)
    return table(rows)
