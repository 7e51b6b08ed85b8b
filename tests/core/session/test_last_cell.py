"""Cells are numbered from 0: a mesh's count is the first number that it has no cell for."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from hexalab import HexaLabError
from hexalab.session import Session


@pytest.fixture
def three(grid: Callable[..., bytes]) -> Session:
    session = Session()
    session.open("grid.mesh", grid(3, 1, 1))
    return session


@pytest.mark.parametrize("name", ["hidden", "shown"])
def test_S1_the_last_cell_may_be_picked_and_the_one_after_may_not(three: Session, name: str) -> None:
    checked = three.check({"filters": {"picking": {name: [0, 2]}}})
    assert checked["rejections"] == []
    assert checked["partial"]["filters"]["picking"][name] == [0, 2]
    checked = three.check({"filters": {"picking": {name: [0, 3, 2]}}})
    assert [rejection["path"] for rejection in checked["rejections"]] == [f"filters.picking.{name}"]
    assert checked["partial"]["filters"]["picking"][name] == [0, 2]


def test_S1_without_a_mesh_nothing_is_said_of_cells() -> None:
    checked = Session().check({"filters": {"picking": {"hidden": [3]}}})
    assert (checked["rejections"], checked["partial"]["filters"]["picking"]["hidden"]) == ([], [3])


def test_V8_the_last_cell_can_be_inspected_and_the_one_after_can_not(three: Session) -> None:
    assert three.inspect(2)["cell"] == 2
    assert three.cell_view(2)["centre"] is not None
    for call in (three.inspect, three.cell_view):
        for cell in (3, -1):
            with pytest.raises(HexaLabError, match="3 cells"):
                call(cell)
