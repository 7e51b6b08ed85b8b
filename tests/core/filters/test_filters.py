"""Peel, regularisation, quality and hand-picking, each against its rule word for word."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from hexalab.filters import FilterStack, PickedCells, Regulariser, band, peel, pick
from tests.core.filters.boxes import box
from tests.core.topology.checks import topology
from tests.core.topology.strategies import meshes

Hidden = NDArray[np.bool_]


def test_F2_peel_removes_layer_by_layer() -> None:
    mesh = box(5, 5, 5)
    depth = mesh.topology.depth
    rings = np.minimum(np.indices((5, 5, 5)), 4 - np.indices((5, 5, 5))).min(axis=0).ravel()
    assert depth.tolist() == rings.tolist()
    assert [int((~peel(depth, layers)).sum()) for layers in range(5)] == [125, 27, 1, 0, 0]


def test_F2_cells_without_a_way_to_the_boundary_go_last() -> None:
    depth = np.array([0, 1, -1], np.int32)
    assert peel(depth, 1).tolist() == [True, False, False]
    assert peel(depth, 2).all()
    assert not peel(depth, 0).any()
    assert peel(np.array([-1, -1], np.int32), 1).all()


def regularised(cells: NDArray[np.int32], hidden: Hidden, strength: int) -> list[bool]:
    """SPEC F5 with sets; the interface is made of interior faces with exactly one visible side."""
    around = defaultdict(set)
    for cell, ids in enumerate(cells.tolist()):
        for face in ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
            if len({ids[place] for place in face}) >= 3:
                around[frozenset(ids[place] for place in face)].add(cell)
    out = set(np.flatnonzero(hidden).tolist())

    def touching() -> set[int]:
        interface = [face for face, both in around.items() if len(both) == 2 and len(both & out) == 1]
        flagged = set().union(*interface) if interface else set()
        return {cell for cell, ids in enumerate(cells.tolist()) if flagged & set(ids)}

    for _ in range(strength):
        out |= touching()
    for _ in range(strength):
        out -= touching()
    return [cell in out for cell in range(len(cells))]


@given(meshes, st.integers(0, 5), st.integers(0, 2**32 - 1))
@settings(max_examples=120, deadline=None)
def test_F5_dilates_then_erodes(cells: NDArray[np.int32], strength: int, seed: int) -> None:
    t = topology(cells)
    if t.nonmanifold_face_count:
        return
    regulariser = Regulariser(t)
    random = np.random.default_rng(seed)
    for _ in range(3):
        hidden = random.random(len(cells)) < random.random()
        before = hidden.copy()
        assert regulariser.regularise(hidden, strength).tolist() == regularised(cells, hidden, strength)
        assert hidden.tolist() == before.tolist()


def test_F5_strength_0_changes_nothing_and_the_outside_does_not_wear_away() -> None:
    mesh = box(6, 6, 6)
    regulariser = Regulariser(mesh.topology)
    x = mesh.barycentres[0]
    straight = x < 2.6
    for strength in range(3):
        assert (regulariser.regularise(straight, strength) == straight).all()
    assert not regulariser.regularise(np.zeros(216, bool), 5).any()
    assert regulariser.regularise(np.ones(216, bool), 5).all()


def test_F5_fills_a_notch_in_the_cut() -> None:
    mesh = box(8, 8, 8)
    x, y, z = mesh.barycentres
    hidden = x < 3
    notch = hidden & (x > 2) & (y > 3) & (y < 4) & (z > 3) & (z < 4)
    found = Regulariser(mesh.topology).regularise(hidden & ~notch, 1)
    assert (found == hidden).all()


def test_F3_hides_cells_not_worse_than_the_threshold() -> None:
    scaled_jacobian = np.array([1.0, 0.5, 0.0, -0.2, np.nan, -np.inf])
    hidden = [band(scaled_jacobian, "inside", None, top, -np.inf).tolist() for top in (1, 0.4, 0)]
    assert hidden[0] == [False] * 6
    assert hidden[1] == [True, True, False, False, False, False]
    assert hidden[2] == hidden[1], "the right end: only inverted and degenerate cells stay"


def test_F3_hides_the_bad_too() -> None:
    edge_ratio = np.array([1.0, 3.0, np.inf, np.nan])
    assert band(edge_ratio, "inside", None, 2.0, np.inf).tolist() == [False, True, True, True]
    assert band(edge_ratio, "inside", 2.0, None, np.inf).tolist() == [True, False, False, False]


@pytest.mark.parametrize("low", [None, -0.5, 0.25])
@pytest.mark.parametrize("high", [None, 0.25, 0.75])
@pytest.mark.parametrize("keep", ["inside", "outside"])
@pytest.mark.parametrize("worst", [-np.inf, np.inf])
def test_F3_band_word_for_word(low: float | None, high: float | None, keep: str, worst: float) -> None:
    values = np.array([-np.inf, -1, -0.5, 0, 0.25, 0.5, 0.75, 2, np.inf, np.nan])
    hidden = band(values, keep, low, high, worst)  # type: ignore[arg-type]
    for value, found in zip(np.where(np.isnan(values), worst, values), hidden, strict=True):
        above, below = low is None or value >= low, high is None or value <= high
        between = (low is None or value > low) and (high is None or value < high)
        kept = (above and below) if keep == "inside" else not between
        if low is None and high is None:
            kept = True
        assert bool(found) == (not kept), value


def test_F3_a_cell_without_a_value_lies_outside_of_every_band_of_an_attribute() -> None:
    values = np.array([1.0, np.nan])
    assert band(values, "inside", 0, None).tolist() == [False, True]
    assert band(values, "outside", 0, None).tolist() == [True, False]
    assert band(values, "inside").tolist() == [False, False]


def picked(hidden: NDArray[np.bool_], isolated: bool, dug: list[int], undug: list[int]) -> list[bool]:
    cells = [PickedCells(len(hidden)).of(cells) for cells in (dug, undug)]
    return pick(hidden, isolated, *cells).tolist()


def test_F4_picks_over_what_other_filters_hide() -> None:
    hidden = np.array([True, True, False, False])
    assert picked(hidden, False, [2], [0]) == [False, True, True, False]
    assert picked(hidden, True, [], [0]) == [False, True, True, True]
    assert picked(hidden, False, [9, -1], [400]) == hidden.tolist()
    assert picked(hidden, False, [1], [1]) == [True, False, False, False]


class Counted(list[int]):
    """A list that counts how often it is walked through."""

    walks = 0

    def __iter__(self) -> Iterator[int]:
        self.walks += 1
        return super().__iter__()


def test_P2_a_list_of_picked_cells_is_walked_through_once() -> None:
    cells = Counted(range(100_000))
    stack = FilterStack(box(50, 50, 50), lambda quantity: np.zeros(125_000))
    for offset in (0.1, 0.2, 0.3):
        plane = {"normal": [0, 0, 1], "offset": offset}
        shown = stack.apply({"planes": {"items": [plane]}, "picking": {"hidden": cells}})
        assert not shown[:100_000].any()
    assert cells.walks == 1
    assert stack.apply({"picking": {"hidden": [3], "shown": cells}}).sum() == 125_000
