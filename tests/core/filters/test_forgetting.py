"""Places along planes that are kept are bounded, and those used longest ago leave first."""

from __future__ import annotations

from hexalab.filters import FilterStack
from tests.core.filters.boxes import box

MOST = 32
"""As many normals as a status may have planes."""


def test_P7_the_plane_that_was_not_touched_for_longest_is_forgotten() -> None:
    stack = FilterStack(box(3, 2, 1), {}.__getitem__)
    normals = [(1.0, 0.0, float(turn)) for turn in range(MOST)]
    kept = [stack.places(normal) for normal in normals]
    assert stack.places(normals[0]) is kept[0], "the oldest is used once more"
    stack.places((0.0, 1.0, 0.0))
    for place in (0, *range(2, MOST)):
        assert stack.places(normals[place]) is kept[place]
    assert stack.places(normals[1]) is not kept[1]
