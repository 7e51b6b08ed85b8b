"""A report in Markdown, with tables as GitHub and pandoc read them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from ..words import count
from . import told
from .pictures import ReportPicture

Facts = dict[str, Any]

MARKED = re.compile(r"([\\`*_\[\]<>#|~$&])")
"""Characters that Markdown may take for its own."""


def markdown_of(facts: Facts, pictures: Sequence[ReportPicture]) -> str:
    """Write a report in Markdown; pictures are linked."""
    word, sentence = told.verdict_of(facts)
    checks = [[state, *_plain(row)] for state, *row in told.check_rows(facts)]
    rest = len(facts["groups"]) - told.GROUPS_TOLD
    parts = [
        f"# {plain(told.title_of(facts))}",
        f"**{word}.** {plain(sentence)}",
        *(plain(note) for note in facts["notes"]),
        "## File",
        _table(("", ""), [[name, plain(value)] for name, value in told.file_rows(facts)]),
        "## Checks",
        _table(("State", "Asked", "Found", "Where"), checks),
        *(f"![{plain(one.alt)}](<{one.address}>)\n\n{plain(one.title)}" for one in pictures),
        "## Counts",
        _table(("", ""), [[name, plain(value)] for name, value in told.count_rows(facts)]),
        "## Certified validity",
        _table(("State", "Cells>", "Which"), told.validity_rows(facts)),
        "## Findings",
        _table(("Severity", "Found", "Where"), [_plain(row) for row in told.finding_rows(facts)])
        or "The diagnosis found nothing.",
        *_optional(
            "Groups",
            ("Group", "Of", "Members>", "Volume>", "SJ min>", "SJ mean>", "Invalid>"),
            told.group_rows(facts),
        ),
        *([f"And {count(rest)} groups more, which the report in JSON lists."] if rest > 0 else []),
        *_optional(
            "Features", ("Elements", "Number>", "Not of the mesh>", "Groups"), told.feature_rows(facts)
        ),
        *_optional(
            "Quality",
            ("Metric", "Acceptable>", "Min>", "Mean>", "Max>", "Outside>", "Not finite>"),
            told.metric_rows(facts),
        ),
        *_optional("Worst cells", ("Metric", "Worst cells (value)", "Not finite"), told.worst_rows(facts)),
        plain(f"{told.NUMBERED} {told.unmeasured(facts)}".rstrip()),
        plain(told.made_by(facts)),
    ]
    return "\n\n".join(parts) + "\n"


def plain(text: str) -> str:
    r"""A text whose characters stand for themselves.

    >>> plain("<script> a|b")
    '\\<script\\> a\\|b'
    """
    return MARKED.sub(r"\\\1", " ".join(text.split()))


def _plain(row: Sequence[str]) -> list[str]:
    return [plain(text) for text in row]


def _optional(heading: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    return [f"## {heading}", _table(columns, [_plain(row) for row in rows])] if rows else []


def _table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table; a heading that ends in > is of numbers, which stand to the right. "" without rows."""
    if not rows:
        return ""
    head = " | ".join(column.removesuffix(">") for column in columns)
    rule = " | ".join("--:" if column.endswith(">") else "---" for column in columns)
    body = "\n".join(f"| {' | '.join(row)} |" for row in rows)
    return f"| {head} |\n| {rule} |\n{body}"
