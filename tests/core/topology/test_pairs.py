"""Pairs that occur again, and how often, against a counter (SPEC T2)."""

from __future__ import annotations

from collections import Counter

import numpy as np
from hypothesis import example, given
from hypothesis import strategies as st

from hexalab.topology.pairs import counted_pairs, repeated_pairs

LARGEST = 2**31 - 1

numbers = st.integers(0, 5) | st.integers(LARGEST - 2, LARGEST)
pairs = st.lists(st.tuples(numbers, numbers), max_size=60)


def columns(rows: list[tuple[int, int]]) -> tuple[np.ndarray, np.ndarray]:
    """Pairs as two arrays."""
    table = np.array(rows, np.int32).reshape(-1, 2)
    return np.ascontiguousarray(table[:, 0]), np.ascontiguousarray(table[:, 1])


def check_repeated(rows: list[tuple[int, int]]) -> None:
    """All but at most one of equal pairs are told, and none that is alone."""
    told = repeated_pairs(*columns(rows)).tolist()
    assert len(set(told)) == len(told)
    of_pair = Counter(rows[row] for row in told)
    for pair, times in Counter(rows).items():
        assert times == 1 or of_pair[pair] >= times - 1, pair
        assert times > 1 or not of_pair[pair], pair


@given(pairs)
@example([])
@example([(LARGEST, LARGEST)] * 3)
@example([(1, 2), (2, 1)])
def test_T2_of_equal_pairs_all_but_one_are_told(rows: list[tuple[int, int]]) -> None:
    check_repeated(rows)


def test_T2_among_many_pairs_few_that_occur_again_are_found() -> None:
    """More pairs than slots that stay apart: those that meet in a slot without being equal are no repetition."""
    random = np.random.default_rng(11)
    rows = list({(int(a), int(b)) for a, b in random.integers(0, 3000, (50_000, 2))})
    again = [rows[k] for k in random.choice(len(rows), 500, replace=False)]
    check_repeated(rows + again + again[:100])


@given(pairs.map(lambda rows: [(one, other % 6) for one, other in rows]))
@example([])
def test_T2_different_pairs_come_in_order_each_with_how_often(rows: list[tuple[int, int]]) -> None:
    one, other, counts = counted_pairs(*columns(rows), 6)
    found = list(zip(one.tolist(), other.tolist(), counts.tolist(), strict=True))
    assert found == [(*pair, times) for pair, times in sorted(Counter(rows).items())]


def test_T2_no_pair_of_nothing() -> None:
    assert [part.tolist() for part in counted_pairs(*columns([]), 0)] == [[], [], []]
