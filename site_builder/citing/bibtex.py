"""Reading BibTeX: enough of it for the entry that a paper's page offers."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from ..model.catalogue import Author
from ..model.names import normal_doi


class BibtexError(Exception):
    """The text holds no BibTeX entry that can be read."""


@dataclass
class Entry:
    """One entry: its type, its key, its fields by lower-case name, without TeX's mark-up, and its authors."""

    kind: str
    key: str
    fields: dict[str, str]
    authors: list[Author]


ACCENTS = {
    '"': "\u0308", "'": "\u0301", "`": "\u0300", "^": "\u0302", "~": "\u0303", "=": "\u0304", ".": "\u0307",
    "c": "\u0327", "v": "\u030c", "u": "\u0306", "H": "\u030b", "k": "\u0328", "r": "\u030a",
}  # fmt: skip
LETTERS = {
    "ss": "ß",
    "o": "ø",
    "O": "Ø",
    "l": "ł",
    "L": "Ł",
    "ae": "æ",
    "AE": "Æ",
    "aa": "å",
    "AA": "Å",
    "i": "ı",
}
_MONTHS = ("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec")
_TYPES = {
    "article": "article-journal", "inproceedings": "paper-conference", "conference": "paper-conference",
    "incollection": "chapter", "book": "book", "phdthesis": "thesis", "mastersthesis": "thesis",
    "techreport": "report", "dataset": "dataset", "misc": "article", "unpublished": "article", "online": "article",
    "software": "software",
}  # fmt: skip
_PUBLISHERS = ("publisher", "school", "institution", "organization")
_HTML = re.compile(r"</?(?:i|b|em|strong|sub|sup|scp|span|tt)(?:\s[^<>]*)?>", re.IGNORECASE)
"""Mark-up that publishers' pages leave in the titles of their BibTeX."""


def read_bibtex(text: str) -> Entry:
    """The first entry of a BibTeX file.

    Raises
    ------
    BibtexError
        There is none, or it doesn't end.
    """
    text = re.sub(r"(?m)^\s*%.*$", "", text)
    macros: dict[str, str] = {}
    place = 0
    while start := re.compile(r"@(\w+)\s*\{").search(text, place):
        kind, body = start[1].lower(), _braced(text, start.end())
        place = start.end() + len(body)
        if kind == "string":
            macros.update(_fields(body, macros))
        elif kind not in ("comment", "preamble"):
            key, _, rest = body.partition(",")
            raw = dict(_fields(rest, macros))
            authors = [_name(name) for name in _split_names(raw.get("author", ""))]
            return Entry(kind, key.strip(), {name: _untex(value) for name, value in raw.items()}, authors)
    raise BibtexError("no entry like @article{key, title = {...}} in it")


def csl_reference(entry: Entry) -> dict[str, Any]:
    """The entry as the `reference` of a source.yaml.

    Raises
    ------
    BibtexError
        Title, author or year is missing.
    """
    fields = entry.fields
    missing = [name for name in ("title", "author", "year") if not fields.get(name)]
    if missing:
        raise BibtexError(f"the entry {entry.key!r} lacks {', '.join(missing)}")
    pages = re.sub(r"\s*[-–—]+\s*", "-", fields.get("pages", ""))
    article = fields.get("articleno") or fields.get("article-number", "")
    arxiv = (
        fields.get("eprint", "")
        if "arxiv" in fields.get("archiveprefix", fields.get("eprinttype", "")).lower()
        else ""
    )
    doi = normal_doi(fields.get("doi", "")) or normal_doi(fields.get("url", ""))
    kind = _TYPES.get(entry.kind, "article")
    reference: dict[str, Any] = {
        "type": kind,
        "title": fields["title"],
        "author": entry.authors,
        "issued": _issued(fields),
        "container-title": fields.get("journal") or fields.get("booktitle") or "",
        "publisher": next((fields[name] for name in _PUBLISHERS if fields.get(name)), "")
        if kind in ("book", "chapter", "report", "thesis", "dataset")
        else "",
        "volume": fields.get("volume", ""),
        "issue": fields.get("number", "") if kind == "article-journal" else "",
        "page": "" if article and ":" in pages else pages,
        "number": article,
        "DOI": doi,
        "arXiv": re.sub(r"^arxiv:", "", arxiv, flags=re.IGNORECASE),
    }
    return {key: value for key, value in reference.items() if value}


def _braced(text: str, start: int) -> str:
    """The text up to the brace that closes the one before `start`."""
    depth = 1
    for place in range(start, len(text)):
        if text[place] in "{}" and text[place - 1] != "\\":
            depth += 1 if text[place] == "{" else -1
            if not depth:
                return text[start:place]
    raise BibtexError("the entry's last brace is missing")


def _fields(text: str, macros: dict[str, str]) -> Iterator[tuple[str, str]]:
    place = 0
    while found := re.compile(r"[\s,]*([\w-]+)\s*=\s*").match(text, place):
        value, place = _value(text, found.end(), macros)
        yield found[1].lower(), value


def _value(text: str, start: int, macros: dict[str, str]) -> tuple[str, int]:
    parts = []
    place = start
    while True:
        if text[place : place + 1] == "{":
            part = _braced(text, place + 1)
            place += len(part) + 2
        elif text[place : place + 1] == '"':
            end = _closing_quote(text, place + 1)
            part, place = text[place + 1 : end], end + 1
        else:
            word = re.compile(r"[^\s,#}]*").match(text, place)
            part = word[0] if word else ""
            place += len(part)
            part = macros.get(part.lower(), part)
        parts.append(part)
        more = re.compile(r"\s*#\s*").match(text, place)
        if not more:
            return "".join(parts), place
        place = more.end()


def _closing_quote(text: str, start: int) -> int:
    depth = 0
    for place in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if text[place] == '"' and not depth:
            return place
    raise BibtexError("a quotation mark isn't closed")


def _untex(text: str) -> str:
    """Text without TeX: accents composed, commands and braces gone, one space between words."""
    text = re.sub(r"\\([\"'`^~=.])\s*\{?\\?([A-Za-z])\}?", _accented, text)
    text = re.sub(r"\\([cvuHkr])(?:\s+|\s*\{)\\?([A-Za-z])\}?", _accented, text)
    text = re.sub(r"\\(ss|ae|AE|aa|AA|[oOlLi])(?![A-Za-z])(\{\})?\s?", lambda found: LETTERS[found[1]], text)
    text = re.sub(r"\\text(?:it|bf|sc|rm)\b|\\(?:emph|mathrm|url)\b", "", text)
    text = re.sub(r"\\([&%$#_{}])", r"\1", text).replace("~", " ").replace("---", "—").replace("--", "–")
    text = text.replace("``", "“").replace("''", "”")
    text = re.sub(r"\$\\times\s*\$", "×", text)
    text = re.sub(r"\$\\ell\s*_?\{?(\w?)\}?\$", r"ℓ\1", text)
    return " ".join(re.sub(r"[{}$]|\\(?=\s)", "", _HTML.sub("", text)).split())


def _accented(found: re.Match[str]) -> str:
    return unicodedata.normalize("NFC", found[2] + ACCENTS[found[1]])


def _split_names(text: str) -> list[str]:
    """Names as TeX has them; an "and" inside braces is part of a name, "others" is nobody."""
    names = [part.strip() for part in _split_outside_braces(text, r"\s+and\s+")]
    return [name for name in names if name and name != "others"]


def _split_outside_braces(text: str, separator: str) -> list[str]:
    parts = [""]
    for part in re.split(f"({separator})", text):
        inside = parts[-1].count("{") > parts[-1].count("}")
        if re.fullmatch(separator, part) and not inside:
            parts.append("")
        else:
            parts[-1] += part
    return parts


def _name(name: str) -> Author:
    """A CSL name from TeX's "von Last, Jr, First" or "First von Last"; a group is all in braces."""
    if name.startswith("{") and len(_braced(name, 1)) == len(name) - 2 and not name.startswith("{\\"):
        return {"literal": _untex(name)}
    family, *rest = (_untex(part) for part in _split_outside_braces(name, ","))
    if rest:
        *suffix, given = rest
        family = " ".join([family, *suffix])
    else:
        words = [_untex(word) for word in _split_outside_braces(name, r"\s+")]
        start = next((i for i, word in enumerate(words[1:-1], 1) if word[:1].islower()), len(words) - 1)
        given, family = " ".join(words[:start]), " ".join(words[start:])
    return {"family": family, "given": given} if given else {"literal": family}


def _issued(fields: dict[str, str]) -> int | str:
    year = re.search(r"\d{4}", fields["year"])
    if not year:
        raise BibtexError(f"the year {fields['year']!r} is no year")
    month = fields.get("month", "").lower()[:3]
    if month in _MONTHS:
        return f"{year[0]}-{_MONTHS.index(month) + 1:02d}"
    if month.isdigit() and 1 <= int(month) <= 12:
        return f"{year[0]}-{int(month):02d}"
    return int(year[0])
