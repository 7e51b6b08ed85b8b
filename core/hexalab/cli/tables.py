"""Numbers and tables in plain text."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

SMALLEST_PLAIN = 0.0005
LARGEST_PLAIN = 1e6
NOTHING = "-"
PLURALS = (("hedron", "hedra"), ("vertex", "vertices"))


def number(value: float | None) -> str:
    """Write a number with three decimals, with an exponent where it would read 0 or be long."""
    if value is None:
        return NOTHING
    if value and not SMALLEST_PLAIN <= abs(value) < LARGEST_PLAIN:
        return f"{value:.2e}"
    return f"{value:,.3f}"


def count(value: int | None) -> str:
    """Write a count with its thousands apart."""
    return NOTHING if value is None else f"{value:,}"


def counted(value: int, noun: str) -> str:
    """Write a count and what is counted: "1 cell", "2 vertices", "1,000 hexahedra"."""
    if value != 1:
        noun = next((noun[: -len(one)] + many for one, many in PLURALS if noun.endswith(one)), f"{noun}s")
    return f"{count(value)} {noun}"


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
