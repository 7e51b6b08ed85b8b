"""Long lists of cells are checked as a whole; a number out of bounds must not slip through with them."""

from __future__ import annotations

from typing import Any

import pytest

from hexalab import status
from tests.core.status.validator import validator


@pytest.mark.parametrize("name", ["hidden", "shown"])
@pytest.mark.parametrize(
    ("cells", "kept", "wrong"),
    [
        ([0, 3, 5], [0, 3, 5], []),
        ([3, -1, 5], [3, 5], [1]),
        ([-2], [], [0]),
        ([*range(1000), -7], [*range(1000)], [1000]),
        ([], [], []),
    ],
)
def test_S1_a_negative_cell_among_whole_numbers_is_left_out(
    name: str, cells: list[int], kept: list[int], wrong: list[int]
) -> None:
    document: dict[str, Any] = {"filters": {"picking": {name: cells}}}
    assert validator().is_valid(document) == (not wrong)
    clean, problems = status.check(document)
    assert clean["filters"]["picking"][name] == kept
    assert [problem.path for problem in problems] == [f"filters.picking.{name}[{place}]" for place in wrong]
