"""Starting a new source: a folder with its source.yaml, from BibTeX, a DOI or answers to questions."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ..citing.bibtex import csl_reference, read_bibtex
from ..model.catalogue import Author
from ..model.methods import METHODS
from ..model.names import ending, normal_doi, slug

Ask = Callable[[str], str]
"""Puts a question to the user and gives the answer."""

_STOP_WORDS = {"a", "an", "the", "of", "for", "and", "in", "on", "with", "via", "by", "to", "using", "from"}


class ScaffoldError(Exception):
    """The new source can't be started."""


def new_source(
    name: str, repository: Path = Path("repository"), *, meshes: Path | None = None, ask: Ask | None = None
) -> Path:
    """Start a source in the repository.

    Parameters
    ----------
    name : str
        A BibTeX file, a DOI (bare or as an address), or a name for the folder.
    repository : Path
        Folder of sources.
    meshes : Path, optional
        Folder whose mesh files are listed; they are not copied.
    ask : callable, optional
        Answers questions about what isn't known; without it, such fields get a text that `hexalab validate` refuses.

    Returns
    -------
    Path
        The source.yaml that was written.

    Raises
    ------
    ScaffoldError
        The folder is there already, or has no name to be called by.
    site_builder.bibtex.BibtexError
        The BibTeX file can't be read.
    """
    reference = _reference(name, ask)
    folder = repository / _folder_name(name, reference)
    if folder.exists():
        raise ScaffoldError(f"{folder} is there already")
    if meshes and not meshes.is_dir():
        raise ScaffoldError(f"there is no folder {meshes}")
    rows = _mesh_rows(meshes) if meshes else []
    folder.mkdir(parents=True)
    file = folder / "source.yaml"
    file.write_text(_yaml(reference, _method(reference, ask), _licence(ask), rows), "utf-8")
    return file


def _reference(name: str, ask: Ask | None) -> dict[str, Any]:
    if Path(name).suffix == ".bib" or Path(name).is_file():
        return csl_reference(read_bibtex(_text(Path(name))))
    reference: dict[str, Any] = {"type": "article-journal", "title": "", "author": [], "issued": ""}
    doi = normal_doi(name)
    if ask:
        reference["title"] = ask("Title of the paper or collection")
        authors = ask("Authors, as Family, Given; Family, Given")
        reference["author"] = [_author(part) for part in authors.split(";") if part.strip()]
        year = ask("Year of publication").strip()
        reference["issued"] = int(year) if year.isdigit() else year
        reference["container-title"] = ask("Journal or proceedings (nothing if none)")
        doi = doi or normal_doi(ask("DOI (nothing if none)"))
    if doi:
        reference["DOI"] = doi
    return {key: value for key, value in reference.items() if value or key in ("title", "author", "issued")}


def _text(file: Path) -> str:
    """BibTeX doesn't say how it is encoded: what isn't UTF-8 is taken for Latin-1, as older managers write it."""
    data = file.read_bytes()
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def _author(text: str) -> Author:
    family, _, given = (part.strip() for part in text.partition(","))
    return {"family": family, "given": given} if given else {"literal": family}


def _folder_name(name: str, reference: dict[str, Any]) -> str:
    """``livesu-2013-polycut-monotone-graph``: first author, year, first words of the title."""
    if not reference["title"]:
        made = slug(normal_doi(name) or name)
    else:
        author = reference["author"][0] if reference["author"] else {}
        words = [word for word in re.findall(r"\w+", reference["title"].lower()) if word not in _STOP_WORDS]
        year = str(reference["issued"])[:4]
        made = slug("-".join([author.get("family") or author.get("literal", ""), year, *words[:3]]))
    if not made:
        raise ScaffoldError(f"{name!r} gives no name for a folder")
    return made


def _licence(ask: Ask | None) -> str:
    answer = (
        ask("Licence of the meshes: an SPDX id as CC-BY-4.0, or nothing if they stay the authors'")
        if ask
        else ""
    )
    return answer.strip() or "authors"


def _method(reference: dict[str, Any], ask: Ask | None) -> str | None:
    """The family of methods, "" where it has to be filled in; None for a collection, which has none."""
    if reference["type"] == "dataset":
        return None
    return ask(f"Method of the paper: {', '.join(METHODS)}").strip() if ask else ""


def _mesh_rows(folder: Path) -> list[str]:
    return sorted(file.relative_to(folder).as_posix() for file in folder.rglob("*") if ending(file.name))


def _yaml(reference: dict[str, Any], method: str | None, licence: str, meshes: list[str]) -> str:
    """source.yaml as a person would write it; what isn't known is left empty, which validation points at."""
    lines = [
        "# CONTRIBUTING.md says what each field means; `hexalab validate` says what is missing.",
        "reference:",
    ]
    for key, value in reference.items():
        if key == "author":
            lines.append("  author:")
            for author in value or [{"family": "", "given": ""}]:
                fields = ", ".join(f"{name}: {_scalar(text)}" for name, text in author.items())
                lines.append(f"    - {{ {fields} }}")
        else:
            lines.append(f"  {key}: {_scalar(value)}")
    lines += ["# links:", '#   pdf: "https://..."', '#   web: "https://..."']
    lines += [] if method is None else [f"method: {_scalar(method)}  # {', '.join(METHODS)}"]
    lines += [f"licence: {_scalar(licence)}", "contributors:", '  - ""', "meshes:"]
    for path in meshes or [""]:
        lines += [f"  - file: {_scalar(path)}", '    description: ""']
    return "\n".join(lines) + "\n"


def _scalar(value: Any) -> str:
    """A YAML scalar: quoted unless it is plainly text or a whole number."""
    if isinstance(value, int):
        return str(value)
    if re.fullmatch(r"[A-Za-z][\w /.()-]*[\w)]", value) and value.lower() not in (
        "yes",
        "no",
        "true",
        "false",
        "null",
        "on",
        "off",
    ):
        return str(value)
    return json.dumps(value, ensure_ascii=False)
