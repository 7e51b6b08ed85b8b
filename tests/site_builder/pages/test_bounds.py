"""Values that stand on a bound: which option, which word, which bar they belong to."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from site_builder.pages.facets import FACETS
from site_builder.pages.histogram import draw
from site_builder.pages.words import number


def test_C2_a_bar_is_bad_only_if_all_its_values_are_zero_or_less() -> None:
    """Eight bins from -1 to 1; of the Scaled Jacobian those that end at 0 hold nothing positive."""
    bars = draw({"low": -1, "high": 1, "counts": [1] * 8}).bars
    assert [bar.bad for bar in bars] == [True] * 4 + [False] * 4
    assert bars[3].title.startswith("−0.250 to 0.000") and bars[4].title.startswith("0.000 to 0.250")
    bars = draw({"low": -1, "high": 1, "counts": [1] * 5}).bars
    assert [bar.bad for bar in bars] == [True, True, False, False, False], "the third straddles 0"


@pytest.mark.parametrize(
    ("facet", "values"),
    [
        ("cells", {999: "s", 1000: "m", 9999: "m", 10_000: "l", 99_999: "l", 100_000: "xl", None: "unknown"}),
        ("jacobian", {0.6: "high", 0.5: "middle", 0.2: "low", 0.0: "negative", -1.0: "negative"}),
        (
            "blocks",
            {
                1: "one",
                2: "few",
                9: "few",
                10: "tens",
                99: "tens",
                100: "hundreds",
                999: "hundreds",
                1000: "thousands",
                None: "unknown",
            },
        ),
        ("sheets", {49: "few", 50: "some", 199: "some", 200: "many", None: "unknown"}),
        ("crossing", {0: "none", 1: "some", None: "unknown"}),
        ("year", {2015: "2015", 2016: "2018", 2018: "2018", 2019: "2021", 2021: "2021", 2022: "now"}),
    ],
)
def test_C1_each_bound_belongs_to_the_option_that_its_label_says(facet: str, values: dict) -> None:
    row = next(row for row in FACETS if row.id == facet)
    for value, option in values.items():
        facts = SimpleNamespace(sj_min=value, blocks=value, sheets=value, self_intersecting_sheets=value)
        source = SimpleNamespace(year=value)
        mesh = SimpleNamespace(cells=value, facts=facts, source=source)
        assert row.options[row.choose(mesh)][0] == option, value


@pytest.mark.parametrize(
    ("edges", "arcs", "option"),
    [
        (None, None, "unknown"),
        (0, None, "none"),
        (0, 0, "none"),
        (8, 1, "few"),
        (90, 9, "few"),
        (90, 10, "some"),
        (990, 99, "some"),
        (990, 100, "many"),
        (8, None, "untraced"),
        (8, 0, "untraced"),  # at cells that are no hexahedra
    ],
)
def test_T6_irregular_edges_inside_count_by_their_arcs_where_these_are_known(
    edges: int | None, arcs: int | None, option: str
) -> None:
    row = next(row for row in FACETS if row.id == "irregular")
    mesh = SimpleNamespace(facts=SimpleNamespace(irregular_edges=edges, arcs=arcs))
    assert row.options[row.choose(mesh)][0] == option


def test_C2_words_at_their_bounds() -> None:
    assert [number(value) for value in (999_999, 1e6, 0.0005, 0.00049)] == [
        "999,999",
        "1.000e6",
        "0.001",
        "4.900e−4",
    ]
