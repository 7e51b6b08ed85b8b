"""What the page "Numbers of the field" is filled with."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from hexalab.quality import METRICS

from ..model.catalogue import Catalogue
from ..plots.families import look_of
from ..plots.kept import Drawn
from ..plots.svg import marker
from ..tables.columns import MEANINGS, PLAIN, unit_of
from ..tables.families import family_names
from ..tables.field import Field
from ..tables.summary import by_family, by_year, of_all
from .croissant import CONFORMS_TO, RIGHTS, table_json_ld

DESCRIPTION = "How large, how good and how regular the published hexahedral meshes are, method by method."


@dataclass(frozen=True)
class Numbers:
    """What the page shows.

    Parameters
    ----------
    published : Field
        The meshes of which it speaks.
    files : dict of str to bytes
        The table of meshes by the addresses of its files.
    plots : list of Drawn
    """

    published: Field
    files: dict[str, bytes] = field(default_factory=dict)
    plots: list[Drawn] = field(default_factory=list)


@dataclass(frozen=True)
class Key:
    """An entry of a plot's legend.

    Parameters
    ----------
    number : int
        Of the family, as in the class of its points.
    outline, tone : str
        Id of the shape, and class of the colour.
    name : str
    meshes : int
    """

    number: int
    outline: str
    tone: str
    name: str
    meshes: int


def numbers_values(catalogue: Catalogue, numbers: Numbers) -> dict[str, Any]:
    """Values of the template."""
    return {
        "heading": "Numbers of the field",
        "description": DESCRIPTION,
        "field": numbers.published,
        "total": of_all(numbers.published),
        "files": {address: len(data) for address, data in numbers.files.items()},
        "families": [(row, _key(numbers, row.id)) for row in by_family(numbers.published)],
        "years": by_year(numbers.published),
        "plots": [(drawn, list(_legend(drawn))) for drawn in numbers.plots],
        "columns": PLAIN,
        "metrics": [(metric, unit_of(metric)) for metric in METRICS.values()],
        "statistics": MEANINGS,
        "rights": RIGHTS,
        "profile": CONFORMS_TO,
        "json_ld": table_json_ld(catalogue, numbers.files) if numbers.files else None,
    }


def _legend(drawn: Drawn) -> Iterator[Key]:
    """The families of a plot; none if they are all the same."""
    if len(drawn.families) > 1:
        for family, meshes in sorted(drawn.families.items(), key=lambda pair: look_of(pair[0]).number):
            look = look_of(family)
            yield Key(look.number, marker(drawn.name, look), look.tone, family_names()[family], meshes)


def _key(numbers: Numbers, family: str) -> Key | None:
    """How a family looks, in the first plot that has it."""
    number = look_of(family).number
    keys = (key for drawn in numbers.plots for key in _legend(drawn))
    return next((key for key in keys if key.number == number), None)
