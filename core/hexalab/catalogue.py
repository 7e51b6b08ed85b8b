"""The field's catalogue of published meshes: what there is, each as it was published, and how it is cited (SPEC C9).

>>> import hexalab.catalogue
>>> mesh = hexalab.catalogue.load("bukenberger-2022-at-most-hexa/cylinder-g")     # doctest: +SKIP
>>> print(hexalab.catalogue.cite("bukenberger-2022-at-most-hexa/cylinder-g"))     # doctest: +SKIP

The index comes with the package: sources, citations, and of each mesh all that was measured (`Entry.facts`). Meshes
are fetched from where their authors put them, once, and kept in the user's cache; their SHA-256 is checked each time.
A site of one's own is another catalogue, if its address stands in the environment variable ``HEXALAB_CATALOGUE``;
``HEXALAB_CACHE`` names another folder for what is kept.
"""

from __future__ import annotations

import gzip
import hashlib
import json
import os
import shutil
import sys
import tempfile
import urllib.error
import urllib.request
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, NoReturn
from urllib.parse import unquote, urljoin, urlsplit

from . import __version__, read
from .errors import HexaLabError
from .mesh import Mesh

__all__ = ["Entry", "Source", "cite", "fetch", "load", "sources"]

VERSION = 2
"""Of the index's form (site_builder.pages.indexes)."""

ADDRESS_VARIABLE, CACHE_VARIABLE = "HEXALAB_CATALOGUE", "HEXALAB_CACHE"
INDEX = "index.json"
PACKAGE = Path(__file__).resolve().parent
PLACES = (PACKAGE / "catalogue.json.gz", PACKAGE.parents[1] / "build" / "catalogue.json.gz")
"""The index in the wheel, and in a clone in which it was built; gzipped."""

PATIENCE = 60
"""Seconds without a byte after which fetching is given up."""

SHARE = 2**20


class Known(dict[str, Any]):
    """An object of the index: a dict that can't be changed, since all who ask get the same one."""

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise TypeError("what the catalogue knows can't be changed; dict(...) makes a copy")

    __setitem__ = __delitem__ = __ior__ = _refuse
    clear = pop = popitem = setdefault = update = _refuse

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (dict(self),)


@dataclass(frozen=True)
class Entry:
    """A mesh of the catalogue.

    Attributes
    ----------
    id : str
        "source/mesh".
    name : str
        As its source calls it.
    address : str
        Where its file is.
    cells, bytes : int or None
        None where nobody has told.
    sha256 : str or None
        Of the file, in hexadecimal.
    picture : str
        Where there is a picture of it; "" if there is none.
    method, model : str
        Family of the method that made it, and the model that it shows; "" where nobody has told.
    same_as : str
        Id of the entry that is this mesh in another file format; "" if it is no other's copy.
    facts : mapping of str to object
        What was measured of it, as the catalogue's index.json has it: "vertices", "quality" (metric to its
        statistics), "structure", "findings" and others; empty if nobody has. It can't be changed.
    """

    id: str
    name: str
    address: str
    cells: int | None = None
    bytes: int | None = None
    sha256: str | None = None
    picture: str = ""
    method: str = ""
    model: str = ""
    same_as: str = ""
    facts: Mapping[str, Any] = field(default_factory=Known, repr=False, compare=False)


@dataclass(frozen=True)
class Source:
    """A publication, or a collection, with its meshes.

    Attributes
    ----------
    slug : str
        What it is called by.
    title : str
    authors : tuple of str
    year : int
    venue, doi, licence : str
        "" where there is none.
    citations : mapping of str to str
        By style: "text" (APA), "bibtex", "csl" (CSL-JSON).
    meshes : tuple of Entry
    """

    slug: str
    title: str
    authors: tuple[str, ...]
    year: int
    venue: str
    doi: str
    licence: str
    citations: Mapping[str, str] = field(repr=False)
    meshes: tuple[Entry, ...] = field(repr=False)


def sources() -> list[Source]:
    """Return every source of the catalogue, in its order.

    Raises
    ------
    HexaLabError
        There is no index, or it can't be read.
    """
    return list(_listed(os.environ.get(ADDRESS_VARIABLE, "")))


def load(mesh: str) -> Mesh:
    """Return a mesh of the catalogue, fetched once.

    Parameters
    ----------
    mesh : str
        "source/mesh".

    Raises
    ------
    HexaLabError
        There is no such mesh, it can't be fetched, or what comes is another file than the catalogue names.
    MeshReadError
        It can't be read.
    """
    return read(fetch(mesh))


def fetch(mesh: str) -> Path:
    """Return the path of a mesh's file in the cache, fetched if need be; errors as for `load`."""
    entry = _entry(mesh)
    place = _place(entry)
    known = entry.sha256 or _noted(place)
    if place.is_file() and (not known or _sha256(place) == known):
        return place
    _download(entry, place, entry.sha256)
    return place


def cite(mesh: str, style: str = "text") -> str:
    """Return the reference of a mesh's source.

    Parameters
    ----------
    mesh : str
        "source/mesh", or the source alone.
    style : "text", "bibtex" or "csl"
        In words, as the APA has it; as BibTeX; as CSL-JSON.

    Raises
    ------
    HexaLabError
        There is no such source, mesh or style.
    """
    slug, _, name = mesh.partition("/")
    if name:
        _entry(mesh)
    citations = _source(slug).citations
    if style not in citations:
        raise HexaLabError(f"there is no style {style!r}, but {', '.join(citations)}")
    return citations[style]


def identified(sha256: str) -> tuple[Source, Entry] | None:
    """Return the mesh whose file has this SHA-256, in hexadecimal, and its source; None if there is none."""
    for source in sources():
        for entry in source.meshes:
            if sha256 and entry.sha256 == sha256:
                return source, entry
    return None


def _source(slug: str) -> Source:
    for source in sources():
        if source.slug == slug:
            return source
    raise HexaLabError(f"the catalogue has no source {slug!r}; `sources()` lists them")


def _entry(mesh: str) -> Entry:
    slug, _, name = mesh.partition("/")
    source = _source(slug)
    for entry in source.meshes:
        if entry.id == mesh:
            return entry
    names = ", ".join(entry.id.partition("/")[2] for entry in source.meshes[:8])
    more = ", ..." if len(source.meshes) > 8 else ""
    raise HexaLabError(f"{slug} has no mesh {name!r}, but {names}{more}")


@cache
def _listed(address: str) -> tuple[Source, ...]:
    """What the package's index has, or that of the site at an address."""
    if address:
        root = address if address.endswith("/") else f"{address}/"
        return _parsed(_bytes_at(root + INDEX), root + INDEX, root)
    for place in PLACES:
        if place.is_file():
            return _parsed(gzip.decompress(place.read_bytes()), str(place), "")
    raise HexaLabError(
        f"this package has no catalogue: it was not built; or name a site's address in {ADDRESS_VARIABLE}"
    )


def _parsed(data: bytes, place: str, root: str) -> tuple[Source, ...]:
    try:
        document = json.loads(data, object_hook=Known)
        if document["version"] != VERSION:
            raise HexaLabError(
                f"{place}: found an index of version {document['version']}, expected {VERSION}"
            )
        return tuple(_source_of(row, root or document["url"]) for row in document["sources"])
    except (ValueError, KeyError, TypeError) as error:
        raise HexaLabError(
            f"{place}: found no index of a catalogue: {type(error).__name__}: {error}"
        ) from None


def _source_of(row: dict[str, Any], root: str) -> Source:
    told = {name: row[name] for name in ("slug", "title", "year", "venue", "licence", "citations")}
    meshes = tuple(_entry_of(mesh, row["slug"], root) for mesh in row["meshes"])
    return Source(**told, doi=row["doi"] or "", authors=tuple(row["authors"]), meshes=meshes)


def _entry_of(row: dict[str, Any], source: str, root: str) -> Entry:
    """A mesh; of a catalogue that is nowhere on the web there are addresses of files elsewhere alone."""
    told = {name: row[name] or "" for name in ("method", "model", "same_as")}
    return Entry(
        id=f"{source}/{row['slug']}",
        name=row["name"],
        address=urljoin(root, row["url"]),
        cells=row["cells"],
        bytes=row["facts"].get("bytes"),
        sha256=row["sha256"],
        picture=urljoin(root, row["picture"]) if root and row["picture"] else "",
        facts=row["facts"],
        **told,
    )


def _place(entry: Entry) -> Path:
    """Where the file is kept: by its content's hash where that is known, else by its address."""
    key = entry.sha256 or hashlib.sha256(entry.address.encode()).hexdigest()
    name = unquote(urlsplit(entry.address).path).rsplit("/", 1)[-1] or "mesh"
    return _cache() / key[:32] / name


def _cache() -> Path:
    """The user's folder for what can be fetched again."""
    given = os.environ.get(CACHE_VARIABLE)
    if given:
        return Path(given)
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "hexalab"
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local") / "hexalab" / "cache"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "hexalab"


def _download(entry: Entry, place: Path, sha256: str | None) -> None:
    """Fetch a file whole or not at all; its hash is written down beside it."""
    if urlsplit(entry.address).scheme not in ("http", "https"):
        raise HexaLabError(
            f"{entry.id} is a file of its site alone: name the site's address in {ADDRESS_VARIABLE}"
        )
    place.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile(dir=place.parent, delete=False) as half:
        try:
            with _opened(entry.address) as answer:
                shutil.copyfileobj(answer, half, SHARE)
            half.close()
            found = _sha256(Path(half.name))
            if sha256 and found != sha256:
                raise HexaLabError(
                    f"{entry.address} is another file than the catalogue names: found SHA-256 {found}, "
                    f"expected {sha256}"
                )
            os.replace(half.name, place)
            _note(place).write_text(found)
        except OSError as error:
            raise HexaLabError(f"{entry.address} could not be fetched: {_reason(error)}") from None
        finally:
            half.close()
            Path(half.name).unlink(missing_ok=True)


def _bytes_at(address: str) -> bytes:
    try:
        with _opened(address) as answer:
            data: bytes = answer.read()
            return data
    except OSError as error:
        raise HexaLabError(f"{address} could not be fetched: {_reason(error)}") from None


def _opened(address: str) -> Any:
    if urlsplit(address).scheme not in ("http", "https"):
        raise HexaLabError(f"{address}: expected an address that begins with http:// or https://")
    request = urllib.request.Request(address, headers={"User-Agent": f"hexalab/{__version__}"})
    return urllib.request.urlopen(request, timeout=PATIENCE)


def _reason(error: OSError) -> str:
    if isinstance(error, urllib.error.HTTPError):
        return f"the server answered {error.code}"
    return str(getattr(error, "reason", error) or type(error).__name__)


def _note(place: Path) -> Path:
    return place.with_name(f"{place.name}.sha256")


def _noted(place: Path) -> str:
    note = _note(place)
    return note.read_text().strip() if note.is_file() else ""


def _sha256(place: Path) -> str:
    with open(place, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
