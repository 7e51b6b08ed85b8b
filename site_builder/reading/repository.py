"""Reading `repository/`: every source.yaml, checked against its schema and against the files beside it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, cast
from urllib.parse import quote, unquote, urljoin

from ..model.catalogue import Catalogue, MeshEntry, Problem, Reference, Source
from ..model.methods import METHODS
from ..model.names import ending, mesh_name, on_this_machine, slug
from ..model.published import FACTS_FILE, PICTURES, Collected, read_published
from .checking import matches, schema, schema_problems
from .documents import Document, DocumentError, FieldPath, field_name, read_yaml

LARGEST_FILE = 25_000_000
"""Bytes of a mesh file in the repository; what a browser may upload to the code host."""

LONGEST_NAME = 200
"""Bytes of a file's or a folder's name."""

PAPERS = ("article-journal", "article", "paper-conference", "thesis", "report")
"""Types of references that present a method."""

_SLUG = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")


def read_repository(root: Path) -> Catalogue:
    """Read all sources below a folder; what is wrong with them is in the catalogue's ``problems``."""
    catalogue = Catalogue(root)
    if not root.is_dir():
        catalogue.problems.append(Problem("error", str(root), 0, "", "no such folder"))
        return catalogue
    _read_front(catalogue)
    for folder in sorted(entry for entry in root.iterdir() if entry.is_dir()):
        if folder.name.startswith((".", "_")) or (folder / "__init__.py").exists():
            continue
        if folder.is_symlink():
            catalogue.problems.append(Problem("error", folder.name, 0, "", "a symbolic link, not a folder"))
            continue
        source = read_source(folder, catalogue.problems, root)
        if source:
            catalogue.sources.append(source)
    _check_unique(catalogue)
    first = {name: number - len(catalogue.first) for number, name in enumerate(catalogue.first)}
    last = {name: number + 1 for number, name in enumerate(catalogue.last)}
    place = first | last
    catalogue.sources.sort(key=lambda s: (place.get(s.slug, 0), -s.year, s.title.lower()))
    return catalogue


def _read_front(catalogue: Catalogue) -> None:
    file = catalogue.root / "catalogue.yaml"
    if not file.exists():
        return
    document = checked(file, "catalogue", catalogue.problems, catalogue.root)
    if document:
        for key, value in document.data.items():
            setattr(catalogue, key, value)


def read_source(folder: Path, problems: list[Problem], root: Path | None = None) -> Source | None:
    """Read one source's folder; None, and problems, if source.yaml can't be understood."""
    root = root or folder.parent
    file = folder / "source.yaml"
    if not _SLUG.fullmatch(folder.name):
        message = (
            f"the folder's name must be lower-case letters, digits and hyphens, as {slug(folder.name)!r}"
        )
        problems.append(Problem("error", _shown(folder, root), 0, "", message))
    if file.is_symlink() or not file.is_file():
        what = "source.yaml is no plain file" if file.is_symlink() or file.exists() else "no source.yaml"
        problems.append(Problem("error", _shown(folder, root), 0, "", f"{what} in this folder"))
        return None
    document = checked(file, "source", problems, root)
    if document is None:
        return None
    data = document.data
    source = Source(
        slug=slug(folder.name),
        folder=folder,
        reference=_csl_item(slug(folder.name), data["reference"]),
        licence=data["licence"],
        method=data.get("method", ""),
        licence_note=data.get("licence_note", ""),
        description=data.get("description", ""),
        arxiv=data["reference"].get("arXiv", ""),
        pdf=data.get("links", {}).get("pdf", ""),
        web=data.get("links", {}).get("web", ""),
        index_path=data.get("index_path", ""),
        contributors=data.get("contributors", []),
        doi_line=document.line(("reference", "DOI")),
    )
    published = _published_facts(folder, problems, root)
    for index, row in enumerate(data["meshes"]):
        mesh = _mesh(source, row, data)
        mesh.line = document.line(("meshes", index))
        mesh.lines = {name: document.line(("meshes", index, name)) for name in row}
        for path, message in _mesh_problems(mesh, index):
            problems.append(_problem("error", document, path, message, root))
            mesh.local = None
        if mesh.key in published:
            mesh.collected = published.pop(mesh.key)
            mesh.facts = mesh.collected.facts
        if mesh.facts.sha256 and mesh.declared_sha256 not in (None, mesh.facts.sha256):
            message = f"{mesh.declared_sha256} here, but {mesh.facts.sha256} in {FACTS_FILE}"
            problems.append(_problem("error", document, ("meshes", index, "sha256"), message, root))
        source.meshes.append(mesh)
    for key in published:
        message = f"{key!r} is no url of a mesh in source.yaml"
        problems.append(Problem("error", _shown(folder / FACTS_FILE, root), 0, "meshes", message))
    _check_slugs(source, document, problems, root)
    for path, message in _link_copies(source):
        problems.append(_problem("error", document, path, message, root))
    for path, message in _doubts(source):
        problems.append(_problem("warning", document, path, message, root))
    return source


def checked(file: Path, kind: str, problems: list[Problem], root: Path) -> Document | None:
    """Read a YAML file and check it against its schema; None if it can't be used."""
    try:
        document = read_yaml(file)
    except DocumentError as error:
        problems.append(Problem("error", _shown(file, root), error.line, error.field, error.message))
        return None
    found = list(schema_problems(document, kind))
    problems.extend(_problem("error", document, path, message, root) for path, message in found)
    return None if found else document


def _csl_item(source_slug: str, reference: Mapping[str, Any]) -> Reference:
    """The reference as CSL-JSON: dates in parts, numbers as text, arXiv's id in CSL's own fields."""
    item: dict[str, Any] = {"id": source_slug, **reference}
    item["issued"] = {"date-parts": [[int(part) for part in str(reference["issued"]).split("-")]]}
    for key in ("volume", "issue", "page", "number", "version"):
        if key in item:
            item[key] = str(item[key])
    arxiv = item.pop("arXiv", "")
    if arxiv and "DOI" not in item:
        item.setdefault("publisher", "arXiv")
        item.setdefault("number", f"arXiv:{arxiv}")
        item.setdefault("URL", f"https://arxiv.org/abs/{arxiv}")
    return cast("Reference", item)


def _mesh(source: Source, row: Mapping[str, Any], whole: Mapping[str, Any]) -> MeshEntry:
    kind = next(kind for kind in ("file", "url", "made") if kind in row)
    key = row[kind]
    path = unquote(key.split("?")[0]) if kind == "url" else key
    if kind == "url" and "://" in key:
        path = path.rsplit("/", 1)[-1]
    remote = _address(whole.get("base_url", ""), key) if kind == "url" else ""
    called = row.get("slug") or slug(mesh_name(path)) or "mesh"
    picture = source.folder / PICTURES / f"{called}.webp"
    return MeshEntry(
        source=source,
        slug=called,
        name=row.get("name") or mesh_name(path),
        kind=kind,
        path=path,
        key=key,
        description=row.get("description", ""),
        remote=remote,
        local=source.folder / path if kind == "file" else None,
        declared_sha256=row.get("sha256"),
        declared_cells=row.get("cells"),
        up=row.get("up", whole.get("up", "")),
        same_as=row.get("same_as", ""),
        method=row.get("method", source.method),
        domain=row.get("domain", whole.get("domain", "")),
        own_model=row.get("model"),
        picture=picture if kind == "url" and picture.is_file() else None,
    )


def _address(base: str, key: str) -> str:
    """The address of a remote file; "" if there is none."""
    try:
        address = urljoin(base, quote(key, safe="/%:?&=#+,;@!$()*~-._"))
    except ValueError:
        return ""
    return address if matches(schema("source")["$defs"]["address"]["pattern"], address) else ""


def _mesh_problems(mesh: MeshEntry, index: int) -> Iterator[tuple[FieldPath, str]]:
    """What is wrong with one row of `meshes`, beyond its schema."""
    here: FieldPath = ("meshes", index, mesh.kind)
    if not ending(mesh.path):
        yield here, f"{mesh.path!r} doesn't end as a mesh format that is read here"
    if mesh.kind == "url":
        if not mesh.remote:
            yield here, f"{mesh.key!r} is no web address, nor is it one with base_url before it"
        elif not mesh.remote.startswith("https:") and not on_this_machine(mesh.remote):
            yield (
                here,
                f"{mesh.remote} begins with http:, from where no page may fetch a mesh; give an https: address",
            )
        return
    parts = mesh.path.split("/")
    if mesh.path.startswith("/") or "\\" in mesh.path or any(part in ("", ".", "..") for part in parts):
        yield here, f"{mesh.path!r} must be a plain path inside the source's folder"
        return
    if mesh.kind == "made":
        if not (mesh.source.folder / "make.py").exists():
            yield here, "there is no make.py beside source.yaml that could make it"
        return
    if any(len(part.encode()) > LONGEST_NAME for part in parts):
        yield here, f"a name of more than {LONGEST_NAME} bytes: many systems can't store it"
        return
    file = mesh.source.folder / mesh.path
    if any(place.is_symlink() for place in (file, *file.parents[: len(parts) - 1])):
        yield here, f"{mesh.path!r} is a symbolic link"
    elif not file.is_file():
        yield here, f"there is no file {mesh.path!r} beside source.yaml"
    elif file.stat().st_size > LARGEST_FILE:
        size = file.stat().st_size
        yield (
            here,
            f"{size:,} bytes, but at most {LARGEST_FILE:,} may lie in the repository; compress it with gzip",
        )


def _doubts(source: Source) -> Iterator[tuple[FieldPath, str]]:
    """What isn't wrong but should be better."""
    if source.reference["type"] == "article-journal" and not source.doi and not source.arxiv:
        yield ("reference",), "neither a DOI nor an arXiv id: readers can't get at the paper"
    if source.reference["type"] in PAPERS and not source.method:
        yield ("method",), f"missing: the family of methods that made the meshes, one of {', '.join(METHODS)}"
    if source.index_path:
        return  # of the original's index, which knows no more than addresses
    for index, mesh in enumerate(source.meshes):
        missing = [name for name, value in (("sha256", mesh.sha256), ("cells", mesh.cells)) if not value]
        if mesh.kind == "url" and missing:
            yield ("meshes", index, "url"), f"a remote file should be given with its {' and '.join(missing)}"


def _published_facts(folder: Path, problems: list[Problem], root: Path) -> dict[str, Collected]:
    file = folder / FACTS_FILE
    if not file.exists():
        return {}
    try:
        return read_published(file)
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        problems.append(Problem("error", _shown(file, root), 0, "", f"not a table of facts: {error}"))
        return {}


def _link_copies(source: Source) -> Iterator[tuple[FieldPath, str]]:
    """Give a file in another format what its original has; what is wrong with such rows.

    The original stands above it, and is no such row itself.
    """
    originals: dict[str, MeshEntry] = {}
    for index, mesh in enumerate(source.meshes):
        if not mesh.same_as:
            originals[mesh.slug] = mesh
            continue
        original = originals.get(mesh.same_as)
        if original is None:
            yield ("meshes", index, "same_as"), f"no row above it has the slug {mesh.same_as!r}"
            continue
        mesh.up = mesh.up or original.up
        if None not in (mesh.cells, original.cells) and mesh.cells != original.cells:
            message = f"{mesh.cells:,} cells, but {original.slug!r} has {original.cells:,}"
            yield ("meshes", index, "same_as"), message


def _check_slugs(source: Source, document: Document, problems: list[Problem], root: Path) -> None:
    first: dict[str, MeshEntry] = {}
    for index, mesh in enumerate(source.meshes):
        other = first.setdefault(mesh.slug, mesh)
        if other is not mesh:
            message = (
                f"the slug {mesh.slug!r} is taken by {other.path!r} (line {other.line}); give it a `slug`"
            )
            problems.append(_problem("error", document, ("meshes", index), message, root))


def _check_unique(catalogue: Catalogue) -> None:
    first: dict[str, Source] = {}
    for source in catalogue.sources:
        other = first.setdefault(source.doi.lower() or source.slug, source)
        if other is not source:
            message = f"the DOI {source.doi} is taken by {other.slug}"
            file = _shown(source.folder / "source.yaml", catalogue.root)
            catalogue.problems.append(Problem("error", file, source.doi_line, "reference.DOI", message))


def _problem(severity: str, document: Document, path: FieldPath, message: str, root: Path) -> Problem:
    return Problem(severity, _shown(document.file, root), document.line(path), field_name(path), message)


def _shown(file: Path, root: Path) -> str:
    """A file as it is named in messages: below the repository's folder."""
    try:
        return file.relative_to(root).as_posix()
    except ValueError:
        return str(file)
