"""A report as a page of one file: no scripts, no requests, to be read, printed, and attached."""

from __future__ import annotations

import base64
import hashlib
import re
from collections.abc import Sequence
from typing import Any, NamedTuple

from ..words import count
from . import told
from .escaping import escape
from .histogram_svg import histogram_svg
from .pictures import ReportPicture
from .style import STYLE

Facts = dict[str, Any]


class Column(NamedTuple):
    """A column of a table: its heading, and the class of its cells."""

    heading: str
    kind: str = "words"


STATE = "state"
"""A column whose cells are coloured by their last word."""

CHECKS = (Column("State", STATE), Column("Asked"), Column("Found"), Column("Where"))
VALIDITY = (Column("State", STATE), Column("Cells", "number"), Column("Which"))
FINDINGS = (Column("Severity", STATE), Column("Found"), Column("Where"))
GROUPS = (
    Column("Group", "name"), Column("Of", "name"), Column("Members", "number"), Column("Volume", "number"),
    Column("SJ min", "number"), Column("SJ mean", "number"), Column("Invalid", "number"),
)  # fmt: skip
FEATURES = (
    Column("Elements", "name"), Column("Number", "number"), Column("Not of the mesh", "number"), Column("Groups"),
)  # fmt: skip
METRICS = (
    Column("Metric", "name"), Column("Acceptable", "number"), Column("Min", "number"), Column("Mean", "number"),
    Column("Max", "number"), Column("Outside", "number"), Column("Not finite", "number"),
)  # fmt: skip
WORST = (Column("Metric", "name"), Column("Worst cells (value)"), Column("Not finite"))


def html_of(facts: Facts, pictures: Sequence[ReportPicture]) -> str:
    """Write a report as a page."""
    word, sentence = told.verdict_of(facts)
    state = "passed" if facts["verdict"]["passed"] else "missed"
    title = escape(told.title_of(facts))
    parts = [
        f"<header><h1>{title}</h1>"
        f'<p class="verdict {state}"><strong>{told.SIGNS[state]} {word}</strong> <span>{escape(sentence)}</span></p>',
        *(f'<p class="quiet">{escape(note)}</p>' for note in facts["notes"]),
        "</header><main>",
        *(_section(id, heading, body) for id, heading, body in _sections(facts, pictures) if body),
        f"</main><footer><p>{escape(told.made_by(facts))}</p></footer>",
    ]
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
        + "\n".join(parts)
        + "\n</body>\n</html>\n"
    )


def _sections(facts: Facts, pictures: Sequence[ReportPicture]) -> list[tuple[str, str, str]]:
    """Id, heading and content of each section; one without content is left out."""
    return [
        ("file", "File", _list(told.file_rows(facts))),
        ("checks", "Checks", _table("checks", CHECKS, told.check_rows(facts))),
        ("pictures", "Pictures", _pictures(pictures)),
        ("counts", "Counts", _list(told.count_rows(facts))),
        ("validity", "Certified validity", _validity(facts)),
        ("findings", "Findings", _findings(facts)),
        ("groups", "Groups", _groups(facts)),
        ("features", "Features", _table("features", FEATURES, told.feature_rows(facts))),
        ("quality", "Quality", _quality(facts)),
        ("worst", "Worst cells", _table("worst", WORST, told.worst_rows(facts))),
        ("histograms", "Histograms", _histograms(facts)),
    ]


def _section(id: str, heading: str, body: str) -> str:
    return f'<section aria-labelledby="{id}"><h2 id="{id}">{heading}</h2>\n{body}</section>'


def _list(rows: told.Rows) -> str:
    return "<dl>" + "".join(f"<dt>{escape(name)}</dt>{_value(name, value)}" for name, value in rows) + "</dl>"


def _value(name: str, value: str) -> str:
    kind = ' class="hash"' if name == "SHA-256" else ""
    return f"<dd{kind}>{escape(value)}</dd>"


def _table(id: str, columns: Sequence[Column], rows: Sequence[Sequence[str]]) -> str:
    """A table in a region that scrolls where the window is narrow; "" without rows."""
    if not rows:
        return ""
    head = "".join(f'<th scope="col" class="{column.kind}">{column.heading}</th>' for column in columns)
    body = "".join(f"<tr>{_cells(columns, row)}</tr>\n" for row in rows)
    return (
        f'<div class="scroll" tabindex="0" role="group" aria-labelledby="{id}"><table><thead><tr>{head}</tr></thead>\n'
        f"<tbody>{body}</tbody></table></div>"
    )


def _cells(columns: Sequence[Column], row: Sequence[str]) -> str:
    """The cells of a row; the first column that is no state heads it."""
    out, headed = [], False
    for column, text in zip(columns, row, strict=True):
        kind = f"state {_state(text, row)}".rstrip() if column.kind == STATE else column.kind
        if column.kind != STATE and not headed:
            headed = True
            out.append(f'<th scope="row" class="{kind}">{escape(text)}</th>')
        else:
            out.append(f'<td class="{kind}">{TOGETHER.sub(WHOLE, escape(text))}</td>')
    return "".join(out)


TOGETHER = re.compile(r"-?\d+ \([^()]*\)")
WHOLE = r'<span class="whole">\g<0></span>'
"""A cell's number and its value stay in one line."""


def _state(text: str, row: Sequence[str]) -> str:
    """The class of a state; none where no cell is in it."""
    return "" if row[1] == "0" else STATES.get(text.split()[-1], "")


STATES = {
    "passed": "passed", "missed": "missed", "valid": "passed", "invalid": "missed", "undecided": "warning",
    "error": "error", "warning": "warning",
}  # fmt: skip
"""Words of states that have a class of their own."""


def _pictures(pictures: Sequence[ReportPicture]) -> str:
    figures = "\n".join(
        f'<figure><img src="{escape(one.address)}" alt="{escape(one.alt)}">'
        f"<figcaption>{escape(one.title)}</figcaption></figure>"
        for one in pictures
    )
    return f'<div class="pictures">{figures}</div>' if figures else ""


def _validity(facts: Facts) -> str:
    words = (
        "The sign of the Jacobian determinant over the whole of each cell, proven: valid if it is positive everywhere, "
        "invalid if it is not positive somewhere. Of other kinds than hexahedra, at their nodes."
    )
    return f'<p class="quiet">{words}</p>' + _table("validity", VALIDITY, told.validity_rows(facts))


def _findings(facts: Facts) -> str:
    return _table("findings", FINDINGS, told.finding_rows(facts)) or "<p>The diagnosis found nothing.</p>"


def _groups(facts: Facts) -> str:
    rest = len(facts["groups"]) - told.GROUPS_TOLD
    more = (
        f'<p class="quiet">And {count(rest)} groups more, which the report in JSON lists.</p>'
        if rest > 0
        else ""
    )
    return _table("groups", GROUPS, told.group_rows(facts)) + more


def _quality(facts: Facts) -> str:
    words = f"{told.NUMBERED} {told.unmeasured(facts)}".rstrip()
    table = _table("quality", METRICS, told.metric_rows(facts))
    return f'{table}<p class="quiet">{escape(words)}</p>' if table else ""


def _histograms(facts: Facts) -> str:
    figures = "\n".join(
        f"<figure>{drawn}<figcaption>{escape(name)}</figcaption></figure>"
        for row, (name, *_) in zip(told.measured(facts), told.metric_rows(facts), strict=True)
        if (drawn := histogram_svg(row))
    )
    words = (
        "Cells by value; at the top stands the number of cells in the highest bar. The bracket below the axis is the "
        "acceptable range; bars outside of it are red."
    )
    return f'<p class="quiet">{words}</p><div class="histograms">{figures}</div>' if figures else ""


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


POLICY = f"default-src 'none'; style-src '{_hash(STYLE)}'; img-src data:"
"""Nothing is loaded, and nothing runs, whatever is in the file's names."""
