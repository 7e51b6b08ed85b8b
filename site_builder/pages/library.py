"""The catalogue as the Python package lists it (hexalab.catalogue): sources, citations, where each mesh is."""

from __future__ import annotations

from typing import Any

from ..citing.citations import citation, plain
from ..citing.exports import bibtex, csl_json
from ..model.catalogue import Catalogue, MeshEntry, Source
from ..model.names import on_this_machine
from .indexes import dump

VERSION = 1
"""Of the form: raised when a field changes its meaning or goes."""


def library_json(catalogue: Catalogue) -> str:
    """The list; addresses of files that lie on the site itself are below its root."""
    address = "" if on_this_machine(catalogue.address) else catalogue.address
    rows = [_source(source) for source in catalogue.sources]
    return dump({"version": VERSION, "address": address, "sources": rows})


def _source(source: Source) -> dict[str, Any]:
    return {
        "slug": source.slug,
        "title": source.title,
        "authors": source.authors,
        "year": source.year,
        "venue": source.venue,
        "doi": source.doi,
        "licence": source.licence,
        "citations": {
            "text": plain(citation(source.reference, "APA")),
            "bibtex": bibtex([source.reference]),
            "csl": csl_json([source.reference]),
        },
        "meshes": [_mesh(mesh) for mesh in source.meshes],
    }


def _mesh(mesh: MeshEntry) -> dict[str, Any]:
    return {
        "slug": mesh.slug,
        "name": mesh.name,
        "address": mesh.file_address,
        "cells": mesh.cells,
        "bytes": mesh.facts.bytes,
        "sha256": mesh.sha256,
    }
