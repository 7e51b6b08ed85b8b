"""Where values stand on the colour map when the status fixes its ends: 0 the best, or the lowest of an attribute."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.session.mapping import map_positions
from hexalab.session.opened import Opened
from tests.core.filters.boxes import box

VALUES = np.array([0.0, 0.25, 0.5, 0.75, 1.0, -3.0, 9.0, np.nan])


@pytest.mark.parametrize(
    ("metric", "expected"),
    [
        # what is beyond the range lies beyond the map, by half of it at the most
        ("scaled_jacobian", [1.5, 1, 0.5, 0, -0.5, 1.5, -0.5, np.nan]),
        ("skew", [-0.5, 0, 0.5, 1, 1.5, -0.5, 1.5, np.nan]),
    ],
)
@pytest.mark.parametrize("limits", [(0.25, 0.75), (0.75, 0.25)])
def test_V3_the_best_stands_first_whichever_end_of_the_range_is_named_first(
    metric: str, expected: list[float], limits: tuple[float, float]
) -> None:
    found = map_positions(Opened(box(2, 1, 1)), metric, VALUES, limits)
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_V3_a_range_of_one_value_parts_what_is_above_it_from_the_rest() -> None:
    found = map_positions(Opened(box(2, 1, 1)), "skew", VALUES, (0.5, 0.5))
    np.testing.assert_array_equal(found, [0, 0, 0, 1, 1, 0, 1, np.nan])
