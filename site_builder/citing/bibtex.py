"""Reading BibTeX and biblatex: the entry that a paper's page offers, by pybtex; its TeX made text by pylatexenc."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from pybtex.database import BibliographyData, Person
from pybtex.database import Entry as Parsed
from pybtex.database.input.bibtex import Parser, UndefinedMacro
from pybtex.errors import capture
from pybtex.scanner import PybtexSyntaxError
from pylatexenc.latex2text import LatexNodes2Text, MacroTextSpec, get_default_latex_context_db

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


MONTHS = ("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec")
TYPES = {
    "article": "article-journal", "inproceedings": "paper-conference", "conference": "paper-conference",
    "incollection": "chapter", "inbook": "chapter", "book": "book", "phdthesis": "thesis", "mastersthesis": "thesis",
    "thesis": "thesis", "techreport": "report", "report": "report", "dataset": "dataset", "software": "software",
}  # fmt: skip
"""CSL's types of BibTeX's and biblatex's; of others it is "article", a preprint."""

NAMES = {
    "container": ("journal", "journaltitle", "booktitle", "eventtitle"),
    "publisher": ("publisher", "school", "institution", "organization"),
    "number": ("articleno", "article-number", "eid"),
    "year": ("year", "date"),
    "month": ("month",),
}
"""What a thing is called in BibTeX, in biblatex and by publishers; the first that an entry has counts."""

PUBLISHED = ("book", "chapter", "report", "thesis", "dataset")
"""Types of CSL whose publisher is cited."""

_HTML = re.compile(r"</?(?:i|b|em|strong|sub|sup|scp|span|tt)(?:\s[^<>]*)?>", re.IGNORECASE)
"""Mark-up that publishers' pages leave in the titles of their BibTeX."""

_VERBATIM = ("doi", "url", "eprint", "file")
"""Fields that hold no TeX but what protects their signs."""


def read_bibtex(text: str) -> Entry:
    """The first entry of a BibTeX or biblatex file.

    Raises
    ------
    BibtexError
        There is none, or it can't be read: which line, and why.
    """
    found = _parsed(_without_comments(text))
    first = next(iter(found.entries.items()), None)
    if first is None:
        raise BibtexError("no entry like @article{key, title = {...}} in it")
    key, entry = first
    fields = {name.lower(): _plain(name.lower(), value) for name, value in _with_parent(entry, found).items()}
    authors = [_author(person) for person in entry.persons.get("author", []) if str(person) != "others"]
    return Entry(entry.type.lower(), key, fields, authors)


def csl_reference(entry: Entry) -> dict[str, Any]:
    """The entry as the `reference` of a source.yaml.

    Raises
    ------
    BibtexError
        Title, author or year is missing.
    """
    fields = entry.fields
    having = {"title": fields.get("title"), "author": entry.authors, "year": _first(fields, "year")}
    missing = [name for name, value in having.items() if not value]
    if missing:
        raise BibtexError(f"the entry {entry.key!r} lacks {', '.join(missing)}")
    pages = re.sub(r"\s*[-–—]+\s*", "-", fields.get("pages", ""))
    article = _first(fields, "number")
    kind = TYPES.get(entry.kind, "article")
    title = ": ".join(part for part in (fields["title"], fields.get("subtitle", "")) if part)
    reference: dict[str, Any] = {
        "type": kind,
        "title": title,
        "author": entry.authors,
        "issued": _issued(fields),
        "container-title": _first(fields, "container"),
        "publisher": _first(fields, "publisher") if kind in PUBLISHED else "",
        "volume": fields.get("volume", ""),
        "issue": (fields.get("number") or fields.get("issue", "")) if kind == "article-journal" else "",
        "page": "" if article and ":" in pages else pages,
        "number": article,
        "DOI": normal_doi(fields.get("doi", "")) or normal_doi(fields.get("url", "")),
        "arXiv": _arxiv(fields),
    }
    return {key: value for key, value in reference.items() if value}


def untex(text: str) -> str:
    r"""Text without TeX: accents composed, commands and braces gone, one space between words.

    >>> untex(r"{M}esh\"oberfl\"ache {\L}ukasz, 3 $\times$ 3")
    'Meshöberfläche Łukasz, 3 × 3'
    """
    plain = " ".join(_TO_TEXT.latex_to_text(_HTML.sub("", text)).split())
    return re.sub(r"(?<=\d)× (?=\d)", "×", plain)  # the blank ends the command


def _text_of_tex() -> LatexNodes2Text:
    """Converts as pylatexenc does, but for commands whose argument is all that counts."""
    context = get_default_latex_context_db()
    plain = [MacroTextSpec(name, "%s") for name in ("url", "emph")]
    context.add_context_category("plain", prepend=True, macros=plain)
    return LatexNodes2Text(latex_context=context, math_mode="text", keep_comments=True)


_TO_TEXT = _text_of_tex()


def _plain(name: str, value: str) -> str:
    if name in _VERBATIM:
        return re.sub(r"\\([%&#_~])", r"\1", value).replace("{", "").replace("}", "").strip()
    # A % that stands alone is no comment of TeX's here: lines of comments are gone.
    return untex(re.sub(r"(?<!\\)%", r"\\%", value))


def _parsed(text: str) -> BibliographyData:
    """All entries; a bare word that is no macro stands for itself, as months do.

    Raises
    ------
    BibtexError
        Something in it can't be read.
    """
    macros = dict(zip(MONTHS, MONTHS, strict=True))
    while True:
        with capture() as problems:
            found = Parser(macros=dict(macros)).parse_string(text)
        unknown = {str(problem.args[0]) for problem in problems if isinstance(problem, UndefinedMacro)}
        if not unknown - macros.keys():
            break
        macros.update((word, word) for word in unknown)
    for problem in problems:
        if isinstance(problem, PybtexSyntaxError) and not isinstance(problem, UndefinedMacro):
            raise BibtexError(_sentence(problem))
    return found


def _without_comments(text: str) -> str:
    """The text with lines of comments and @comment{...} blanked, so that lines keep their numbers."""
    text = re.sub(r"(?m)^[ \t]*%.*$", "", text)
    while start := re.search(r"@comment\s*\{", text, re.IGNORECASE):
        depth, end = 1, start.end()
        while depth and end < len(text):
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        text = text[: start.start()] + "\n" * text.count("\n", start.start(), end) + text[end:]
    return text


def _with_parent(entry: Parsed, found: Any) -> dict[str, str]:
    """The fields, with those of the entry that `crossref` names where it has none of its own."""
    own = dict(entry.fields)
    parent = found.entries.get(own.get("crossref", ""))
    if parent is None:
        return own
    inherited = {name: value for name, value in parent.fields.items() if name.lower() not in entry.fields}
    if "title" in parent.fields and "booktitle" not in entry.fields:
        inherited["booktitle"] = parent.fields["title"]
    return {**inherited, **own}


def _author(person: Person) -> Author:
    """A CSL name; a group is all in braces."""
    parts = {
        "given": [*person.first_names, *person.middle_names],
        "family": [*person.prelast_names, *person.last_names, *person.lineage_names],
    }
    given, family = (untex(" ".join(parts[part])) for part in ("given", "family"))
    return {"family": family, "given": given} if given else {"literal": family}


def _first(fields: dict[str, str], what: str) -> str:
    return next((fields[name] for name in NAMES[what] if fields.get(name)), "")


def _arxiv(fields: dict[str, str]) -> str:
    archive = fields.get("archiveprefix") or fields.get("eprinttype", "")
    number = fields.get("eprint", "") if "arxiv" in archive.lower() else ""
    return re.sub(r"^arxiv:", "", number, flags=re.IGNORECASE)


def _issued(fields: dict[str, str]) -> int | str:
    date = _first(fields, "year")
    found = re.search(r"(\d{4})(?:-(\d{2}))?", date)
    if not found:
        raise BibtexError(f"the year {date!r} is no year")
    month = found[2] or _month(fields.get("month", "").lower())
    return f"{found[1]}-{month}" if month else int(found[1])


def _month(text: str) -> str:
    """The month's two digits, out of its name or number; empty where there is none."""
    for number, name in enumerate(MONTHS, 1):
        if text.startswith(name) or (text.isdigit() and int(text) == number):
            return f"{number:02d}"
    return ""


def _sentence(error: Exception) -> str:
    """What pybtex says, as a part of our sentence."""
    line = getattr(error, "lineno", None)
    said = " ".join(str(error.args[0] if error.args else error).split())
    return f"the BibTeX can't be read{f', line {line}' if line else ''}: {said}"
