"""Where a mesh is looked at from, by one rule (SPEC C2, V6)."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hexalab.status import DEFAULTS, check
from hexalab.status.views import MANY, UPRIGHT, three_quarters

side = st.floats(0.01, 100)


@given(side, side, side, st.sampled_from([1, MANY + 1]))
def test_C2_a_mesh_is_seen_from_the_front_the_side_and_above_and_a_cut_faces_the_eye(x, y, z, cells):
    view = three_quarters([x, y, z], cells)
    direction, facing = np.array(view.direction), np.array(view.facing)
    assert np.linalg.norm(direction) == pytest.approx(1, abs=1e-3)
    assert direction[2] < -0.3
    assert direction @ facing > 0.4 * np.linalg.norm(facing)
    long = 0 if x >= y else 1
    assert abs(direction[long]) < abs(direction[1 - long])  # the longer side runs across the picture


def test_F1_the_cut_of_a_mesh_of_many_cells_stands_along_an_axis():
    assert three_quarters([3, 2, 1], MANY).facing == (-0.28, 1.0, -0.2)
    assert three_quarters([3, 2, 1], MANY + 1).facing == (0.0, 1.0, 0.0)


def test_V6_a_needle_is_not_seen_end_on():
    for sides in ([1, 1, 1], [1, 2, 1]):
        end_on = np.array(three_quarters(sides).direction)
        view = three_quarters(sides, long_axis=end_on)
        assert abs(np.dot(view.direction, end_on)) < 0.6
        assert np.dot(view.direction, view.facing) > 0.4


def test_S1_camera_and_slice_are_parts_of_a_status():
    view = three_quarters([1, 2, 3])
    assert check({"camera": view.camera, "filters": view.slice(0.5)})[1] == []
    assert DEFAULTS["camera"]["fit"] is True


@pytest.mark.parametrize("up", UPRIGHT)
def test_C8_a_body_that_stands_otherwise_is_seen_as_if_it_were_turned_upright(up):
    turn = np.zeros((3, 3))
    for row, (axis, sign) in enumerate(UPRIGHT[up]):
        turn[row, axis] = sign
    assert np.linalg.det(turn) == 1  # turned, not mirrored
    sides, along = np.array([4.0, 2.0, 3.0]), np.array([0.6, 0.0, 0.8])
    view = three_quarters(sides, long_axis=along, up=up)
    upright = three_quarters(np.abs(turn @ sides), long_axis=turn @ along)
    for part in ("direction", "up", "facing"):
        assert turn @ getattr(view, part) == pytest.approx(getattr(upright, part))
    axis = np.zeros(3)
    axis["xyz".index(up[-1])] = -1 if up.startswith("-") else 1
    assert view.up == tuple(axis)
