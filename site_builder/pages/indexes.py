"""The site's indexes for machines: catalogue, search, the original's form, sitemap."""

from __future__ import annotations

import json
from collections.abc import Set
from typing import Any, NotRequired, TypedDict
from xml.sax.saxutils import escape

from ..citing.citations import citation, plain
from ..citing.exports import bibtex, csl_json
from ..model.catalogue import Catalogue, MeshEntry, Source
from ..pictures.portrait import portrait
from ..tables.families import family_names, method_of, model_of
from .facets import FACETS, codes
from .metadata import LICENCES

PICTURES = {"png": 1, "webp": 2}
"""What search.json says of a mesh's picture, by its ending; 0 where there is none."""

INDEX_VERSION = 2
"""Of the form of index.json: raised when a field changes its meaning or goes, or the Python package needs another."""

SEARCH_VERSION = 1
"""Of the form of search.json: raised when a field changes its meaning or goes."""


class MeshRow(TypedDict):
    """What the viewer knows of a mesh of the catalogue; addresses are below the site's root or absolute.

    Attributes
    ----------
    cells, bytes, sha256 : int, int, str or None
        None if nobody has measured or declared them.
    remote : bool
        Whether the file lies elsewhere on the web.
    preview : str
        Address of what is drawn before Python has started, where there is one.
    picture : str
        Address of the portrait that stands in for a remote mesh while it is fetched, where there is one.
    view : dict
        Partial status of the mesh's portrait, where it has been measured: the viewer opens with it.
    """

    slug: str
    name: str
    cells: int | None
    url: str
    remote: bool
    bytes: int | None
    sha256: str | None
    preview: NotRequired[str]
    picture: NotRequired[str]
    view: NotRequired[dict[str, Any]]


class SourceRow(TypedDict):
    """What the viewer knows of a source; "" for what it hasn't got."""

    slug: str
    title: str
    authors: list[str]
    year: int
    venue: str
    doi: str
    pdf: str
    web: str
    licence: str
    meshes: list[MeshRow]


def dump(data: Any) -> str:
    """JSON in few bytes, always the same."""
    return json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False) + "\n"


def catalogue_json(catalogue: Catalogue, previews: set[str], pictures: Set[str] = frozenset()) -> str:
    """What the viewer needs to know: sources, meshes, addresses; of previews and pictures those that there are."""
    there = previews | pictures
    return dump({"sources": [_for_viewer(source, there) for source in catalogue.sources]})


def _for_viewer(source: Source, there: Set[str]) -> SourceRow:
    return {
        "slug": source.slug,
        "title": source.title,
        "authors": source.authors,
        "year": source.year,
        "venue": source.venue,
        "doi": source.doi,
        "pdf": source.pdf,
        "web": source.web or source.reference.get("URL", ""),
        "licence": source.licence,
        "meshes": [_row_for_viewer(mesh, there) for mesh in source.meshes],
    }


def _row_for_viewer(mesh: MeshEntry, there: Set[str]) -> MeshRow:
    row: MeshRow = {
        "slug": mesh.slug,
        "name": mesh.name,
        "cells": mesh.cells,
        "url": mesh.file_address,
        "remote": bool(mesh.remote),
        "bytes": mesh.facts.bytes,
        "sha256": mesh.sha256,
    }
    if mesh.preview_address in there:
        row["preview"] = mesh.preview_address
    if mesh.remote and mesh.picture_address in there:
        row["picture"] = mesh.picture_address
    if mesh.facts.view:
        row["view"] = portrait(mesh.facts)
    return row


def index_json(catalogue: Catalogue, pictures: set[str]) -> str:
    """The whole catalogue with all that is known of each mesh: what programs read, `hexalab.catalogue` among them.

    Parameters
    ----------
    catalogue : Catalogue
    pictures : set of str
        Addresses of the pictures that the site has.
    """
    return dump(
        {
            "version": INDEX_VERSION,
            "name": catalogue.title,
            "description": catalogue.description,
            "url": catalogue.address,
            "methods": {name: called for name, called in family_names().items() if name},
            "sources": [_full_source(source, pictures) for source in catalogue.sources],
        }
    )


def _full_source(source: Source, pictures: set[str]) -> dict[str, Any]:
    return {
        "slug": source.slug,
        "page": source.page,
        "title": source.title,
        "authors": source.authors,
        "year": source.year,
        "venue": source.venue,
        "doi": source.doi or None,
        "reference": source.reference,
        "citations": {
            "text": plain(citation(source.reference, "APA")),
            "bibtex": bibtex([source.reference]),
            "csl": csl_json([source.reference]),
        },
        "licence": source.licence,
        "licence_url": LICENCES.get(source.licence),
        "pdf": source.pdf or None,
        "web": source.web or None,
        "description": source.description or None,
        "meshes": [_full_row(mesh, mesh.picture_address in pictures) for mesh in source.meshes],
    }


def _full_row(mesh: MeshEntry, pictured: bool) -> dict[str, Any]:
    return {
        "slug": mesh.slug,
        "name": mesh.name,
        "description": mesh.description or None,
        "page": mesh.page,
        "picture": mesh.picture_address if pictured else None,
        "url": mesh.file_address,
        "remote": bool(mesh.remote),
        "format": mesh.format,
        "method": method_of(mesh) or None,
        "model": model_of(mesh) or None,
        "same_as": f"{mesh.source.slug}/{mesh.same_as}" if mesh.same_as else None,
        "cells": mesh.cells,
        "sha256": mesh.sha256,
        "facts": {
            key: value for key, value in mesh.facts.to_dict().items() if key not in ("sha256", "format")
        },
    }


def search_json(catalogue: Catalogue, pictures: set[str]) -> str:
    """The small index that the search in the browser reads; a mesh in another format is found under its first."""
    numbers = {id(source): index for index, source in enumerate(catalogue.sources)}
    models = {model.id: index for index, model in enumerate(catalogue.models)}
    return dump(
        {
            "version": SEARCH_VERSION,
            "facets": [
                {"id": facet.id, "options": [option for option, _ in facet.options]} for facet in FACETS
            ],
            "sources": [
                [
                    source.slug,
                    source.title,
                    ", ".join(source.authors),
                    source.year,
                    source.venue,
                    source.doi,
                    source.short,
                ]
                for source in catalogue.sources
            ],
            "models": [model.title for model in catalogue.models],
            "meshes": [
                [
                    numbers[id(mesh.source)],
                    mesh.slug,
                    mesh.name,
                    mesh.cells,
                    *(_short(value) for value in (mesh.facts.sj_min, mesh.facts.sj_mean, mesh.facts.sj_max)),
                    mesh.facts.irregular_edges,
                    PICTURES[mesh.picture_address.rsplit(".", 1)[1]]
                    if mesh.picture_address in pictures
                    else 0,
                    codes(mesh),
                    mesh.description,
                    mesh.facts.sheets,
                    mesh.facts.blocks,
                    models.get(mesh.model),
                ]
                for mesh in catalogue.listed
            ],
        }
    )


def _short(value: float | None) -> float | None:
    return None if value is None else float(f"{value:.4g}")


def original_index(catalogue: Catalogue) -> str:
    """`datasets/index.json` in the form of the original HexaLab, for tools that read it.

    A published source keeps the path it has there; one of ours points to its files in this site, relative to
    `datasets/` as the form wants. `urls` is ours: the address of each file, below the site's root or absolute.
    """
    return (
        json.dumps({"sources": [_original(s) for s in catalogue.sources]}, ensure_ascii=False, indent=1)
        + "\n"
    )


def _original(source: Source) -> dict[str, Any]:
    row: dict[str, Any] = {
        "paper": {
            "title": source.title,
            "venue": source.venue,
            "authors": ", ".join(source.authors),
            "year": str(source.year),
            "PDF": source.pdf,
            "web": source.web or source.reference.get("URL", ""),
            "DOI": source.doi,
        },
        "path": source.index_path or f"../meshes/{source.slug}",
        "label": f"{source.year} - {source.title}",
        "data": [mesh.path for mesh in source.meshes],
        "urls": [mesh.file_address for mesh in source.meshes],
    }
    if all(mesh.cells is not None for mesh in source.meshes):
        row["datasize"] = [mesh.cells for mesh in source.meshes]
    return row


def sitemap(catalogue: Catalogue, pages: list[str]) -> str:
    """The addresses of all pages."""
    rows = "".join(f"<url><loc>{escape(catalogue.address + page)}</loc></url>\n" for page in pages)
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">\n{rows}</urlset>\n'
    )
