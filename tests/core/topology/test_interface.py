"""The interface against a loop over faces, along sequences of small and large changes; stars of vertices."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from hexalab.topology import Topology
from hexalab.topology.stars import Stars
from tests.core.topology.checks import topology
from tests.core.topology.grids import grid_cells
from tests.core.topology.strategies import meshes


def truth(t: Topology, shown: NDArray[np.bool_]) -> dict[int, tuple[int, int, int]]:
    """Row to shown side, cell, local face."""
    found = {}
    for row, (left, right) in enumerate(t.face_cells.T.tolist()):
        sides = [bool(shown[left]), right >= 0 and bool(shown[right])]
        if sum(sides) == 1:
            side = sides.index(True)
            found[row] = (side, (left, right)[side], int(t.face_locals[side, row]))
    return found


def check(t: Topology, shown: NDArray[np.bool_]) -> None:
    found = t.interface(shown)
    side = (t.face_cells[0][found.rows] != found.cells).astype(int)
    rows = zip(side.tolist(), found.cells.tolist(), found.locals.tolist(), strict=True)
    assert dict(zip(found.rows.tolist(), rows, strict=True)) == truth(t, shown)
    inside = np.count_nonzero(found.rows < t.faces.paired)
    assert (found.rows[:inside] < t.faces.paired).all()
    assert (found.rows[inside:] >= t.faces.paired).all()


@given(meshes, st.integers(0, 2**32 - 1), st.sampled_from([1, 24, 10**9]))
@settings(max_examples=80, deadline=None)
def test_F6_interface_equals_a_loop_whatever_changed(cells: NDArray[np.int32], seed: int, small: int) -> None:
    t = topology(cells)
    random = np.random.default_rng(seed)
    shown = np.ones(len(cells), dtype=bool)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("hexalab.topology.interface.SMALL_CHANGE", small)
        check(t, shown)
        for share in (0.5, 0.1, 0.0, 0.1, 1.0):
            shown = shown ^ (random.random(len(cells)) < share)
            check(t, shown)
        check(t, np.zeros(len(cells), dtype=bool))


def test_F6_interface_keeps_nothing_of_the_callers_array() -> None:
    t = topology(grid_cells(5, 5, 5))
    shown = np.ones(125, dtype=bool)
    t.interface(shown)
    shown[62] = False
    check(t, shown)
    shown[63] = False
    check(t, shown)


def test_F6_the_same_cells_give_the_same_interface_at_no_cost() -> None:
    t = topology(grid_cells(4, 4, 4))
    shown = np.arange(64) > 20
    assert t.interface(shown) is t.interface(shown.copy())
    assert t.interface(shown) is not t.interface(~shown)


@given(meshes, st.integers(0, 2**32 - 1), st.sampled_from([1, 16]))
@settings(max_examples=80, deadline=None)
def test_F5_stars_equal_a_search(cells: NDArray[np.int32], seed: int, layers: int) -> None:
    count = int(cells.max(initial=-1)) + 3
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("hexalab.topology.stars.LAYERS", layers)
        stars = Stars(np.ascontiguousarray(cells[:, :layers].T), count)
    vertices = np.flatnonzero(np.random.default_rng(seed).random(count) < 0.3)
    found = set(stars.cells_of(vertices).tolist())
    assert found == set(np.flatnonzero(np.isin(cells[:, :layers], vertices).any(axis=1)).tolist())
