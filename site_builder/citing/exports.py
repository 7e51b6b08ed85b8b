"""References as files for reference managers: BibTeX, RIS, CSL-JSON."""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Iterable
from typing import Any

from ..model.catalogue import Author, Reference
from ..model.names import doi_address

ACCENTS = {
    '"': "\u0308", "'": "\u0301", "`": "\u0300", "^": "\u0302", "~": "\u0303", "=": "\u0304", ".": "\u0307",
    "c": "\u0327", "v": "\u030c", "u": "\u0306", "H": "\u030b", "k": "\u0328", "r": "\u030a",
}  # fmt: skip
"""TeX's accents and the marks that they put on a letter."""

LETTERS = {
    "ss": "ß", "o": "ø", "O": "Ø", "l": "ł", "L": "Ł", "ae": "æ", "AE": "Æ", "aa": "å", "AA": "Å", "i": "ı",
}  # fmt: skip
"""TeX's letters that no accent makes."""

_BIBTEX_TYPES = {
    "article-journal": "article", "paper-conference": "inproceedings", "chapter": "incollection", "book": "book",
    "thesis": "phdthesis", "report": "techreport", "dataset": "misc", "software": "misc", "article": "misc",
}  # fmt: skip
_RIS_TYPES = {
    "article-journal": "JOUR", "paper-conference": "CPAPER", "chapter": "CHAP", "book": "BOOK", "thesis": "THES",
    "report": "RPRT", "dataset": "DATA", "software": "COMP", "article": "UNPB",
}  # fmt: skip
_BIBTEX_CONTAINER = {"inproceedings": "booktitle", "incollection": "booktitle", "article": "journal"}
_SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\textbraceleft{}", "}": r"\textbraceright{}", "$": r"\$", "&": r"\&",
    "#": r"\#", "%": r"\%", "_": r"\_", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
    "ℓ": r"{$\ell$}", "×": r"{$\times$}", "\u2010": "-", "–": "--", "—": "---", "“": "``", "”": "''", "‘": "`",
    "’": "'", **{letter: rf"{{\{command}}}" for command, letter in LETTERS.items()},
}  # fmt: skip
_MARKS = {mark: command for command, mark in ACCENTS.items()}
_BIBTEX_PUBLISHER = {"phdthesis": "school", "techreport": "institution", "misc": "howpublished"}


def csl_json(items: Iterable[Reference]) -> str:
    """CSL-JSON of some references."""
    return json.dumps(list(items), ensure_ascii=False, indent=2) + "\n"


def bibtex(items: Iterable[Reference]) -> str:
    """BibTeX of some references, accents as TeX writes them: classic BibTeX cuts UTF-8 in the middle of a letter."""
    return "\n".join(_bibtex_entry(item) for item in items)


def ris(items: Iterable[Reference]) -> str:
    """RIS of some references."""
    return "\n".join(_ris_entry(item) for item in items)


def _bibtex_entry(item: Reference) -> str:
    kind = _BIBTEX_TYPES[item["type"]]
    year, *month = item["issued"]["date-parts"][0]
    arxiv = str(item.get("number", "")).removeprefix("arXiv:") if item.get("publisher") == "arXiv" else ""
    fields = {
        "title": "{" + tex(item["title"]) + "}",
        "author": " and ".join(_bibtex_name(author) for author in item["author"]),
        _BIBTEX_CONTAINER.get(kind, "note"): tex(item.get("container-title", "")),
        "series": tex(item.get("collection-title", "")),
        "publisher" if arxiv else _BIBTEX_PUBLISHER.get(kind, "publisher"): tex(item.get("publisher", "")),
        "volume": tex(item.get("volume", "")),
        "number": tex(
            item.get("issue", "") or ("" if kind in ("article", "misc") else item.get("number", ""))
        ),
        "articleno": tex(item.get("number", "")) if kind == "article" else "",
        "pages": re.sub(r"[-–]+", "--", tex(item.get("page", ""))),
        "year": str(year),
        "month": str(month[0]) if month else "",
        "eprint": arxiv,
        "archiveprefix": "arXiv" if arxiv else "",
        "doi": _bare(item.get("DOI", "")),
        "url": _bare(item.get("URL", "")),
    }
    lines = [f"  {name} = {{{value}}}" for name, value in fields.items() if value]
    return f"@{kind}{{{item['id']},\n" + ",\n".join(lines) + "\n}\n"


def _bibtex_name(author: Author) -> str:
    if "literal" in author:
        return "{" + tex(author["literal"]) + "}"
    parts = [author["family"], author.get("given", "")]
    return ", ".join(tex(part) for part in parts if part)


def tex(text: Any) -> str:
    """Text in which TeX's special characters are escaped, on one line."""
    return "".join(_tex_letter(letter) for letter in " ".join(str(text).split()))


def _tex_letter(letter: str) -> str:
    if letter in _SPECIAL:
        return _SPECIAL[letter]
    base, *marks = list(unicodedata.normalize("NFD", letter))
    if len(marks) != 1 or not base.isascii() or marks[0] not in _MARKS:
        return letter
    command = _MARKS[marks[0]]
    return f"{{\\{command}{{{base}}}}}" if command.isalpha() else f"{{\\{command}{base}}}"


def _bare(text: Any) -> str:
    """A DOI or an address: TeX reads these letter by letter; only braces could end the field too soon."""
    return str(text).replace("{", "%7B").replace("}", "%7D").replace("\\", "%5C")


def _ris_entry(item: Reference) -> str:
    first, _, last = re.sub(r"[-–]+", "-", str(item.get("page", ""))).partition("-")
    year, *month = item["issued"]["date-parts"][0]
    rows: list[tuple[str, Any]] = [
        ("TY", _RIS_TYPES[item["type"]]),
        ("ID", item["id"]),
        ("TI", item["title"]),
    ]
    rows += [("AU", author.get("literal") or _ris_name(author)) for author in item["author"]]
    rows += [
        ("PY", year),
        ("DA", f"{year}/{month[0]:02d}//" if month else ""),
        ("T2", item.get("container-title", "")),
        ("T3", item.get("collection-title", "")),
        ("PB", item.get("publisher", "")),
        ("VL", item.get("volume", "")),
        ("IS", item.get("issue", "")),
        ("C7", item.get("number", "") if item["type"] == "article-journal" else ""),
        ("M1", item.get("number", "") if item["type"] != "article-journal" else ""),
        ("SP", first),
        ("EP", last),
        ("DO", item.get("DOI", "")),
        ("UR", doi_address(item["DOI"]) if "DOI" in item else item.get("URL", "")),
    ]
    lines = [f"{tag}  - {' '.join(str(value).split())}" for tag, value in rows if value not in ("", None)]
    return "\r\n".join([*lines, "ER  - ", ""])


def _ris_name(author: Author) -> str:
    return ", ".join(part for part in (author["family"], author.get("given", "")) if part)
