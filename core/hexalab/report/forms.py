"""The forms in which a report is written, as rows of a table."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import PurePath
from typing import Any, NamedTuple

from ..errors import HexaLabError
from .html import html_of
from .junit import junit_of
from .markdown import markdown_of
from .pictures import ReportPicture

Facts = dict[str, Any]


class Form(NamedTuple):
    """One form: its id, which is the ending of its files too, what a user calls it, and what writes it.

    Attributes
    ----------
    id, name : str
    pictured : bool
        Whether it has room for pictures.
    write : callable
        Facts and pictures in, text out.
    """

    id: str
    name: str
    pictured: bool
    write: Callable[[Facts, Sequence[ReportPicture]], str]


def _json(facts: Facts, _pictures: Sequence[ReportPicture]) -> str:
    return json.dumps(facts, ensure_ascii=False, allow_nan=False, indent=1) + "\n"


FORMS = (
    Form("html", "a page", True, html_of),
    Form("md", "Markdown", True, markdown_of),
    Form("json", "JSON", False, _json),
    Form("xml", "JUnit XML", False, junit_of),
)
"""The forms, as rows with `id`, `name` and more."""


def form_of(id: str) -> Form:
    """The row of a form, by its id or a file that ends so.

    Raises
    ------
    HexaLabError
        There is none.
    """
    wanted = PurePath(id).suffix[1:].lower() or id
    for row in FORMS:
        if row.id == wanted:
            return row
    known = ", ".join(f".{row.id} ({row.name})" for row in FORMS)
    raise HexaLabError(f"{id}: found no form of a report, expected one of {known}")


def written(facts: Facts, form: str, pictures: Sequence[ReportPicture] = ()) -> str:
    """Write a report.

    Parameters
    ----------
    facts : dict
        As `collect` gives them.
    form : str
        Id of a row of `FORMS`.
    pictures : sequence of ReportPicture
        Left out where the form has no room for them.

    Raises
    ------
    HexaLabError
        There is no such form.
    """
    return clean(form_of(form).write(facts, pictures))


def clean(text: str) -> str:
    r"""Replace what neither XML nor HTML can hold: control characters, and halves of characters out of odd file names.

    >>> clean("part\x00.inp\tSTEEL\n")
    'part�.inp\tSTEEL\n'
    """
    return text.translate(UNFIT)


UNFIT = dict.fromkeys(
    [
        code
        for code in (*range(0x20), 0x7F, 0xFFFE, 0xFFFF, *range(0xD800, 0xE000))
        if chr(code) not in "\t\n"
    ],
    "\ufffd",
)
"""Characters that are replaced."""
