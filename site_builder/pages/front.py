"""What the front page is filled with."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, zip_longest
from typing import Any

from ..model.catalogue import Catalogue, MeshEntry, Source
from ..pictures.collection import Collection, Figure
from .facets import FACETS, counts

FIRST = 24
"""Cards that the front page shows before anybody searches."""


def front_values(catalogue: Catalogue, collection: Collection, pictures: set[str]) -> dict[str, Any]:
    """Values of the front page's template."""
    listed = catalogue.listed
    table = zip(FACETS, counts(listed), strict=True)
    return {
        "heading": catalogue.title,
        "description": catalogue.description or catalogue.title,
        "hero": hero(catalogue, collection),
        "listed": listed,
        "left_out": len(catalogue.meshes) - len(listed),
        "first_meshes": first_meshes(catalogue.sources, pictures)[:FIRST],
        "facets": [
            {
                "id": facet.id,
                "label": facet.label,
                "options": [(*option, number) for option, number in zip(facet.options, row, strict=True)],
            }
            for facet, row in table
        ],
        "parts_of_list": parts_of_list(catalogue.sources),
    }


def hero(catalogue: Catalogue, collection: Collection) -> list[Figure]:
    """The gallery's pictures that the page opens with: such as lie in the repository, so that they are always there."""
    stills = {
        figure.still.name: figure
        for section in collection.gallery
        for figure in section.figures
        if figure.still
    }
    return [stills[name] for name in catalogue.hero if name in stills]


def first_meshes(sources: Sequence[Source], pictures: set[str]) -> list[MeshEntry]:
    """One mesh of each source after the other, those with a picture first."""
    by_source = [
        sorted(source.listed, key=lambda mesh: mesh.picture_address not in pictures) for source in sources
    ]
    dealt = [mesh for mesh in chain(*zip_longest(*by_source)) if mesh is not None]
    return sorted(dealt, key=lambda mesh: mesh.picture_address not in pictures)


def parts_of_list(sources: Sequence[Source]) -> list[tuple[str, list[Source]]]:
    """The list of sources in two parts: papers, and collections of our own."""
    own = [source for source in sources if source.own]
    published = [source for source in sources if not source.own]
    return [part for part in (("Published sources", published), ("Collections of our own", own)) if part[1]]
