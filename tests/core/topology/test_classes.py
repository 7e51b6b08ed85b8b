"""Classes of linked things, against a walk from link to link (SPEC T2)."""

from __future__ import annotations

from collections import defaultdict

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from hexalab.arrays import CHUNK
from hexalab.topology.classes import by_appearance, classes, directed_classes

Link = tuple[int, int, bool]
Linked = tuple[int, list[Link], int]


@st.composite
def linked(draw: st.DrawFn) -> Linked:
    """So many things, links among them, and the length of a block."""
    count = draw(st.integers(1, 40))
    ends = st.integers(0, count - 1)
    links = draw(st.lists(st.tuples(ends, ends, st.booleans()), max_size=60))
    return count, links, draw(st.integers(1, 60))


def blocks(links: list[Link], length: int) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Links in blocks of that length, as arrays."""
    parts = [links[start : start + length] for start in range(0, len(links), length)]
    return [
        (
            np.array([left for left, _, _ in part], np.int32),
            np.array([right for _, right, _ in part], np.int32),
            np.array([against for _, _, against in part], bool),
        )
        for part in parts
    ]


def walked(count: int, links: list[Link]) -> tuple[list[int], list[bool], list[bool]]:
    """Class of each thing, whether it points against the first one along the way, and which classes are one-sided."""
    ways = defaultdict(list)
    for left, right, against in links:
        ways[left].append((right, against))
        ways[right].append((left, against))
    labels, turned, one_sided = [-1] * count, [False] * count, []
    for first in range(count):
        if labels[first] >= 0:
            continue
        labels[first] = len(one_sided)
        one_sided.append(False)
        todo = [first]
        while todo:
            here = todo.pop()
            for there, against in ways[here]:
                if labels[there] < 0:
                    labels[there], turned[there] = labels[here], turned[here] ^ against
                    todo.append(there)
                elif turned[there] != turned[here] ^ against:
                    one_sided[labels[here]] = True
    return labels, turned, one_sided


@given(linked())
def test_T2_classes_are_what_a_walk_reaches_numbered_by_their_first_members(case: Linked) -> None:
    count, links, length = case
    found = blocks(links, length)
    labels, number = classes(count, lambda: [(left, right) for left, right, _ in found])
    expected, _, one_sided = walked(count, links)
    assert labels.dtype == np.int32
    assert (labels.tolist(), number) == (expected, len(one_sided))


@given(linked())
@example((1, [(0, 0, True)], 1))
@example((3, [(0, 1, False), (1, 2, False), (2, 0, True)], 1))
@example((2, [(0, 1, False), (0, 1, True)], 2))
def test_T2_directed_classes_can_be_directed_alike_unless_a_walk_comes_back_turned(case: Linked) -> None:
    count, links, length = case
    found = directed_classes(count, lambda: blocks(links, length))
    labels, turned, one_sided = walked(count, links)
    assert (found.labels.tolist(), found.count) == (labels, len(one_sided))
    assert found.one_sided.tolist() == one_sided
    for thing, label in enumerate(labels):
        assert one_sided[label] or found.turned[thing] == turned[thing]


@pytest.mark.parametrize("turns", [0, 1, 2, 7])
def test_T2_a_long_ring_in_any_order_is_one_class_that_an_odd_number_of_turns_makes_one_sided(
    turns: int,
) -> None:
    """Longer than the pieces in which ways are shortened, and in several blocks."""
    count = 2 * CHUNK + 321
    random = np.random.default_rng(turns)
    ring = random.permutation(count).astype(np.int32)
    left, right = ring, np.roll(ring, 1)
    against = np.zeros(count, bool)
    against[random.choice(count, turns, replace=False)] = True
    order = random.permutation(count)
    parts = [(left[part], right[part], against[part]) for part in np.array_split(order, 5)]
    assert classes(count, lambda: [(one, other) for one, other, _ in parts])[1] == 1
    found = directed_classes(count, lambda: parts)
    assert found.count == 1 and found.one_sided.tolist() == [turns % 2 == 1]
    broken = parts[
        1:
    ]  # a ring that misses a fifth of its links falls into as many paths as links are missing
    assert classes(count, lambda: [(one, other) for one, other, _ in broken])[1] == len(parts[0][0])
    assert not directed_classes(count, lambda: broken).one_sided.any()


@given(st.lists(st.integers(0, 12), min_size=1, max_size=40))
def test_T2_labels_are_renumbered_in_the_order_in_which_they_come_first(drawn: list[int]) -> None:
    known = {label: row for row, label in enumerate(sorted(set(drawn)))}
    labels = np.array([known[label] for label in drawn], np.int32)
    expected: dict[int, int] = {}
    for label in labels.tolist():
        expected.setdefault(label, len(expected))
    number = by_appearance(labels, len(known))
    assert number[labels].tolist() == [expected[label] for label in labels.tolist()]
