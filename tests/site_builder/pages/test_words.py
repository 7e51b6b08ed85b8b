"""Numbers and verdicts in words."""

import pytest

from site_builder.model.facts import Facts
from site_builder.pages.words import count, file_size, number, share, structure_line, structure_word, verdict


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (None, "–"),
        (float("nan"), "–"),
        (float("inf"), "–"),
        (0, "0"),
        (0.12345, "0.123"),
        (-1, "−1.000"),
        (0.0001234, "1.234e−4"),
        (1234.5, "1,234"),
        (12345678, "1.235e7"),
    ],
)
def test_C2_numbers_have_three_significant_decimals(value, text):
    assert number(value) == text


def test_C2_sizes_counts_and_shares():
    assert [file_size(size) for size in (None, 0, 999, 1000, 71846, 232041, 21589544, 3 * 10**9)] == [
        "–",
        "0 B",
        "999 B",
        "1.0 kB",
        "71.8 kB",
        "232 kB",
        "21.6 MB",
        "3.0 GB",
    ]
    assert count(1000000) == "1,000,000"
    assert share(0, 10) == "0 %"
    assert share(1, 100000) == "under 0.1 %"
    assert share(1, 80) == "1.2 %"


def structure(word: str | None, blocks: int, **more: str) -> dict:
    """As much of a structure as words need."""
    return {"class": word, "base_complex": {"blocks": blocks}, **more}


@pytest.mark.parametrize(
    ("found", "word"),
    [
        (None, ""),
        (structure("regular", 1), "regular"),
        (structure("polycube", 3), "polycube"),
        (structure(None, 104), ""),
        (structure("regular", 1, skipped="44 cells that aren't hexahedra"), ""),
    ],
)
def test_T3_a_class_is_told_where_it_is_exact_and_of_the_whole_mesh(found, word):
    assert structure_word(Facts(structure=found)) == word


@pytest.mark.parametrize(
    ("valence", "found", "line"),
    [
        (None, None, ""),
        ({}, None, "No interior edge is irregular."),
        ({4: 10}, structure("regular", 1), "Regular: no interior edge is irregular, 1 block."),
        ({4: 10}, structure("polycube", 57), "Polycube: no interior edge is irregular, 57 blocks."),
        (
            {3: 24, 4: 1000, 5: 8, 6: 1},
            structure(None, 104),
            "33 of 1,033 interior edges (3.2 %) are irregular, 24 of valence 3, 8 of valence 5 and 1 of valence 6.",
        ),
        ({4: 96, 5: 4}, None, "4 of 100 interior edges (4.0 %) are irregular, all of valence 5."),
    ],
)
def test_C2_the_structure_in_a_line(valence, found, line):
    assert structure_line(Facts(interior_edge_valence=valence, structure=found)) == line


@pytest.mark.parametrize(
    ("facts", "state", "words"),
    [
        (Facts(), "", ""),
        (
            Facts(cells=9, validity={"valid": 9, "invalid": 0, "undecided": 0}),
            "good",
            "every cell certified valid",
        ),
        (
            Facts(cells=9, validity={"valid": 7, "invalid": 2, "undecided": 0}),
            "invalid",
            "2 of 9 cells certified invalid",
        ),
        (
            Facts(cells=9, validity={"valid": 8, "invalid": 0, "undecided": 1}),
            "warning",
            "validity of 1 cell undecided",
        ),
        (
            Facts(cells=9, sj_not_positive=0, sj_not_finite=0),
            "positive",
            "Scaled Jacobian positive in every cell, not certified",
        ),
        (
            Facts(cells=9, sj_not_positive=1, sj_not_finite=2),
            "invalid",
            "3 of 9 cells with a Scaled Jacobian that isn't positive",
        ),
    ],
)
def test_Q6_what_is_certified_and_what_is_not(facts, state, words):
    assert verdict(facts) == (state, words)
