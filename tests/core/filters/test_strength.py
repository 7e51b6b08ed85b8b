"""Regularisation has a strongest setting, which more does not pass."""

from __future__ import annotations

import numpy as np

from hexalab.filters import FilterStack, Regulariser
from tests.core.filters.boxes import box


def test_F5_more_than_the_strongest_is_the_strongest() -> None:
    """Of a bar two planes leave eleven cells: five dilations leave one, from which they grow back; six none."""
    mesh = box(40, 1, 1)
    left = np.arange(15, 26)
    hidden = ~np.isin(np.arange(40), left)
    assert np.flatnonzero(~Regulariser(mesh.topology).regularise(hidden, 5)).tolist() == left.tolist()
    assert Regulariser(mesh.topology).regularise(hidden, 6).all()
    planes = [{"normal": [1, 0, 0], "offset": 14.5 / 39}, {"normal": [-1, 0, 0], "offset": 13.5 / 39}]
    stack = FilterStack(mesh, {}.__getitem__)

    def shown(strength: int) -> list[int]:
        filters = {"planes": {"items": planes}, "regularisation": {"strength": strength}}
        return np.flatnonzero(stack.apply(filters)).tolist()

    assert [shown(strength) for strength in (0, 5, 6, 9)] == [left.tolist()] * 4
    planes[1]["offset"] = 15.5 / 39
    assert len(shown(0)) == 9
    assert (len(shown(4)), len(shown(5))) == (9, 0), "the strongest is five"
