"""Labels that meet again, and how often pairs occur, against a counter (SPEC T2)."""

from __future__ import annotations

from collections import Counter

import numpy as np
from hypothesis import example, given
from hypothesis import strategies as st

from hexalab.topology.pairs import counted_pairs, repeated_labels

LARGEST = 2**31 - 1

numbers = st.integers(0, 5) | st.integers(LARGEST - 2, LARGEST)
pairs = st.lists(st.tuples(numbers, numbers), max_size=60)


def columns(rows: list[tuple[int, int]]) -> tuple[np.ndarray, np.ndarray]:
    """Pairs as two arrays."""
    table = np.array(rows, np.int32).reshape(-1, 2)
    return np.ascontiguousarray(table[:, 0]), np.ascontiguousarray(table[:, 1])


edges = st.lists(
    st.tuples(st.integers(0, 9), st.integers(0, 9), numbers).filter(lambda edge: edge[0] != edge[1]),
    max_size=60,
)


def check_repeated(rows: list[tuple[int, int, int]], span: int) -> None:
    """The labels of which an end has two are told, and no others."""
    table = np.array(rows, np.int32).reshape(-1, 3).T
    met = Counter((end, label) for one, other, label in rows for end in (one, other))
    expected = sorted({label for (_, label), times in met.items() if times > 1})
    assert repeated_labels(table[:2], table[2], span).tolist() == expected


@given(edges)
@example([])
@example([(0, 1, LARGEST), (1, 2, LARGEST)])
@example([(0, 1, 5), (0, 1, 5)])
def test_T2_labels_of_which_two_rows_share_an_end_are_told(rows: list[tuple[int, int, int]]) -> None:
    check_repeated(rows, 10)


def test_T2_among_many_rows_the_few_labels_that_meet_are_found() -> None:
    """Different labels that meet in a slot are no repetition, and equal ones that never share an end aren't either."""
    random = np.random.default_rng(11)
    ends = random.permutation(40_000).reshape(-1, 2)
    rows = [
        (int(a), int(b), int(label))
        for (a, b), label in zip(ends, random.integers(0, 3000, 20_000), strict=True)
    ]
    rows += [(int(a), int(b) + 40_000, 3000 + k) for k, (a, b) in enumerate(ends[:5_000])]
    rows += [(int(b), int(a) + 80_000, label) for a, b, label in rows[:50]]
    check_repeated(rows, 120_000)


def test_T2_a_hub_at_which_more_rows_meet_than_there_are_slots() -> None:
    rows = [(0, 1 + k, k % 900) for k in range(1000)]
    check_repeated(rows, 1001)
    check_repeated([(0, 1 + k, k) for k in range(1000)], 1001)


@given(pairs.map(lambda rows: [(one, other % 6) for one, other in rows]))
@example([])
def test_T2_different_pairs_come_in_order_each_with_how_often(rows: list[tuple[int, int]]) -> None:
    one, other, counts = counted_pairs(*columns(rows), 6)
    found = list(zip(one.tolist(), other.tolist(), counts.tolist(), strict=True))
    assert found == [(*pair, times) for pair, times in sorted(Counter(rows).items())]


def test_T2_no_pair_of_nothing() -> None:
    assert [part.tolist() for part in counted_pairs(*columns([]), 0)] == [[], [], []]
