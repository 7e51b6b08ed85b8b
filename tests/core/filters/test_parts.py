"""Parts that share no face, the largest first: hidden, or shown alone."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from hexalab.filters import FilterStack
from hexalab.mesh import Mesh
from tests.core.filters.boxes import box


def three_parts() -> Mesh:
    """Boxes of 2, 12 and 4 cells, side by side."""
    cells, points, first = [], [], 0
    for at, size in enumerate([(2, 1, 1), (3, 2, 2), (4, 1, 1)]):
        one = box(*size)
        points.append(one.points + np.array([10 * at, 0, 0]))
        cells.append(one.cells + first)
        first += one.vertex_count
    return Mesh.from_cells(np.concatenate(points), np.concatenate(cells))


MESH = three_parts()


def test_parts_are_numbered_by_their_size() -> None:
    part, sizes = MESH.topology.parts
    assert part.tolist() == [2] * 2 + [0] * 12 + [1] * 4
    assert sizes.tolist() == [12, 4, 2]


@pytest.mark.parametrize(
    ("parts", "shown"),
    [
        ({}, 18),
        ({"hidden": [0]}, 6),
        ({"hidden": [0, 2]}, 4),
        ({"isolated": True, "shown": [1]}, 4),
        ({"isolated": True, "shown": [1, 2, 77]}, 6),
        ({"isolated": True}, 0),
        ({"hidden": [0], "enabled": False}, 18),
        ({"hidden": [0], "shown": [0]}, 18),
    ],
)
def test_parts_are_hidden_and_shown_alone(parts: dict[str, Any], shown: int) -> None:
    stack = FilterStack(MESH, lambda _: np.zeros(18))
    assert int(stack.apply({"parts": parts}).sum()) == shown
    assert int(stack.apply({}).sum()) == 18


def test_a_picked_cell_is_shown_though_its_part_is_hidden() -> None:
    stack = FilterStack(MESH, lambda _: np.zeros(18))
    shown = stack.apply({"parts": {"isolated": True}, "picking": {"shown": [3]}})
    assert np.flatnonzero(shown).tolist() == [3]
