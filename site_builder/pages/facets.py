"""What the search can filter by: one table of facets, for the page made at build and for the script that takes over."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..model.catalogue import MeshEntry
from ..model.methods import METHODS
from .words import short_verdict


@dataclass(frozen=True)
class Facet:
    """One row of chips.

    Parameters
    ----------
    options : tuple of (id, label)
    choose : callable
        Gives the index of a mesh's option.
    """

    id: str
    label: str
    options: tuple[tuple[str, str], ...]
    choose: Callable[[MeshEntry], int]


def _first(tests: list[bool]) -> int:
    return next((index for index, holds in enumerate(tests) if holds), len(tests))


def _origin(mesh: MeshEntry) -> int:
    return 0 if mesh.source.own else 1


def _cells(mesh: MeshEntry) -> int:
    cells = mesh.cells
    return 4 if cells is None else _first([cells < 1_000, cells < 10_000, cells < 100_000])


def _method(mesh: MeshEntry) -> int:
    return _METHODS.index(mesh.method)


def _domain(mesh: MeshEntry) -> int:
    return ["", "box", "polycube"].index(mesh.domain)


def _poor(mesh: MeshEntry) -> int:
    found = (mesh.facts.quality or {}).get("scaled_jacobian")
    if found is None or not mesh.facts.cells:
        return 4
    share = found["outside_acceptable"] / mesh.facts.cells
    return 0 if not share else 1 + _first([share < 0.01, share < 0.1])


def _jacobian(mesh: MeshEntry) -> int:
    low = mesh.facts.sj_min
    return 4 if low is None else _first([low > 0.5, low > 0.2, low > 0])


def _validity(mesh: MeshEntry) -> int:
    return ["good", "positive", "invalid", "warning", ""].index(short_verdict(mesh.facts)[0])


def _irregular(mesh: MeshEntry) -> int:
    irregular, arcs = mesh.facts.irregular_edges, mesh.facts.arcs
    if not irregular:
        return 5 if irregular is None else 0
    return 1 + _first([arcs < 10, arcs < 100]) if arcs else 4


def _sheets(mesh: MeshEntry) -> int:
    sheets = mesh.facts.sheets
    return 3 if sheets is None else _first([sheets < 50, sheets < 200])


def _self_intersecting(mesh: MeshEntry) -> int:
    sheets = mesh.facts.self_intersecting_sheets
    return 2 if sheets is None else 1 if sheets else 0


def _blocks(mesh: MeshEntry) -> int:
    blocks = mesh.facts.blocks
    return 5 if blocks is None else _first([blocks < 2, blocks < 10, blocks < 100, blocks < 1_000])


def _year(mesh: MeshEntry) -> int:
    year = mesh.source.year
    return _first([year <= 2015, year <= 2018, year <= 2021])


_METHODS = [*METHODS, ""]

FACETS = (
    Facet("origin", "Origin", (("own", "our own"), ("published", "published")), _origin),
    Facet(
        "method",
        "Method",
        (*((id, method.name) for id, method in METHODS.items()), ("unknown", "not said")),
        _method,
    ),
    Facet(
        "year",
        "Year",
        (("2015", "to 2015"), ("2018", "2016–18"), ("2021", "2019–21"), ("now", "since 2022")),
        _year,
    ),
    Facet(
        "domain",
        "What it fills",
        (("body", "the body"), ("box", "a box around it"), ("polycube", "its polycube")),
        _domain,
    ),
    Facet(
        "cells",
        "Cells",
        (
            ("s", "under 1,000"),
            ("m", "to 10,000"),
            ("l", "to 100,000"),
            ("xl", "more"),
            ("unknown", "not known"),
        ),
        _cells,
    ),
    Facet(
        "jacobian",
        "Minimum Scaled Jacobian",
        (
            ("high", "over 0.5"),
            ("middle", "0.2 to 0.5"),
            ("low", "0 to 0.2"),
            ("negative", "0 or less"),
            ("unknown", "not known"),
        ),
        _jacobian,
    ),
    Facet(
        "poor",
        "Cells with a Scaled Jacobian below 0.5",
        (
            ("none", "none"),
            ("few", "under 1 %"),
            ("some", "1 to 10 %"),
            ("many", "more"),
            ("unknown", "not known"),
        ),
        _poor,
    ),
    Facet(
        "validity",
        "Validity",
        (
            ("valid", "certified valid"),
            ("positive", "SJ positive"),
            ("invalid", "invalid"),
            ("undecided", "undecided"),
            ("unknown", "not known"),
        ),
        _validity,
    ),
    Facet(
        "irregular",
        "Irregular edges inside",
        (
            ("none", "none"),
            ("few", "1 to 9 arcs"),
            ("some", "10 to 99"),
            ("many", "more"),
            ("untraced", "some, not traced"),
            ("unknown", "not known"),
        ),
        _irregular,
    ),
    Facet(
        "sheets",
        "Sheets",
        (("few", "under 50"), ("some", "50 to 199"), ("many", "more"), ("unknown", "not known")),
        _sheets,
    ),
    Facet(
        "crossing",
        "Self-intersecting sheets",
        (("none", "none"), ("some", "some"), ("unknown", "not known")),
        _self_intersecting,
    ),
    Facet(
        "blocks",
        "Blocks",
        (
            ("one", "one"),
            ("few", "2 to 9"),
            ("tens", "10 to 99"),
            ("hundreds", "100 to 999"),
            ("thousands", "more"),
            ("unknown", "not known"),
        ),
        _blocks,
    ),
)

DIGITS = "0123456789abcdefghijklmnopqrstuvwxyz"
"""How a code is written, of any number of options that fits on a page."""


def codes(mesh: MeshEntry) -> str:
    """A mesh's option in each facet, a digit each, of base 36."""
    return "".join(DIGITS[facet.choose(mesh)] for facet in FACETS)


def counts(meshes: list[MeshEntry]) -> list[list[int]]:
    """Number of meshes by facet and option."""
    table = [[0] * len(facet.options) for facet in FACETS]
    for mesh in meshes:
        for row, facet in zip(table, FACETS, strict=True):
            row[facet.choose(mesh)] += 1
    return table
