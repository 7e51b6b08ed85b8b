"""Pages that need not be rendered again, since nothing that they are made of has changed."""

from __future__ import annotations

import hashlib
import json
import sys
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from pathlib import Path

import hexalab

from ..kept import remember
from ..model.catalogue import Catalogue, Source
from ..model.published import FACTS_FILE
from .assets import assets

ROOT = Path(__file__).resolve().parents[1]
"""Of the builder: what pages are made by."""

Made = tuple[str, str]
"""A page's folder below the site's root, and its HTML."""


class Memory:
    """Remembers pages by all that they are made of.

    Parameters
    ----------
    catalogue : Catalogue
        Measured already.
    pictures : set of str
        Addresses of the thumbnails that the site has.
    folder : Path or None
        Where pages are kept; without it nothing is remembered.
    more : str
        What else pages depend on.
    """

    def __init__(self, catalogue: Catalogue, pictures: set[str], folder: Path | None, more: str) -> None:
        self._folder = folder
        self._whole = hash_of(program(), more, *_site(catalogue), *sorted(pictures)) if folder else ""
        self._sources = catalogue.sources

    @property
    def interface(self) -> str:
        """What the page of the Python interface is made of, as a hash."""
        return hash_of("interface", self._whole)

    @property
    def bodies(self) -> str:
        """What the pages of models are made of, as a hash."""
        return hash_of("models", *map(self.of, self._sources))

    def of(self, source: Source) -> str:
        """What the pages of a source are made of, as a hash: whatever is said of other sources in it is in `_site`."""
        if not self._folder:
            return ""
        files = (source.folder / name for name in ("source.yaml", FACTS_FILE))
        here = (f"{mesh.slug} {mesh.sha256}" for mesh in source.meshes if not mesh.remote)
        texts = (file.read_text("utf-8") if file.is_file() else "" for file in files)
        return hash_of(self._whole, source.slug, *texts, *here)

    def pages(self, key: str, make: Callable[[], Iterable[Made]]) -> Iterator[Made]:
        """Pages that were made before of the same, or are made now."""
        if not self._folder:
            yield from make()
            return
        file = remember(self._folder / f"{key}.json", lambda: json.dumps(list(make())).encode())
        yield from map(tuple, json.loads(file.read_bytes()))


def hash_of(*texts: str) -> str:
    """A hash of several texts."""
    return hashlib.sha256(json.dumps(texts).encode()).hexdigest()[:32]


@cache
def program() -> str:
    """A hash of the programs that make pages: the builder, and the core with its tables."""
    digest = hashlib.sha256(sys.version.encode())
    for root in (ROOT, Path(hexalab.__file__).parent):
        for file in sorted(file for file in root.rglob("*") if file.suffix in (".py", ".jinja", ".json")):
            digest.update(file.relative_to(root).as_posix().encode() + b"\0" + file.read_bytes())
    digest.update(json.dumps([assets().styles, assets().scripts]).encode())
    return digest.hexdigest()[:32]


def _site(catalogue: Catalogue) -> Iterator[str]:
    """What pages say of the catalogue as a whole: its name and address, all meshes, and whose bodies these are."""
    yield from (catalogue.title, catalogue.description, catalogue.address, catalogue.publisher)
    models = catalogue.root / "models.yaml"
    yield models.read_text("utf-8") if models.is_file() else ""
    for mesh in catalogue.meshes:
        yield f"{mesh.id} {mesh.model} {mesh.method} {mesh.same_as} {mesh.facts.sj_min is not None}"
