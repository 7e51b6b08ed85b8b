"""Cube roots, against whole numbers and the C library's."""

from __future__ import annotations

import numpy as np

from hexalab.quality.cube_root import cube_root


def test_cubes_have_whole_roots() -> None:
    roots = np.arange(-200.0, 200)
    np.testing.assert_allclose(cube_root(roots**3), roots, rtol=2.3e-16)


def test_roots_are_those_of_the_c_library_but_for_the_last_bit() -> None:
    values = np.random.default_rng(5).uniform(-3, 3, 10_000) * 2.0 ** np.arange(-5000, 5000).clip(-1000, 1000)
    np.testing.assert_allclose(cube_root(values), np.cbrt(values), rtol=4.5e-16)
    values = np.array([0.0, -0.0, np.inf, -np.inf, np.nan, 5e-324, -1e308])
    np.testing.assert_allclose(cube_root(values), np.cbrt(values), rtol=4.5e-16)
    np.testing.assert_array_equal(np.signbit(cube_root(values[:2])), [False, True])


def test_Q7_eight_times_a_number_has_twice_its_root() -> None:
    values = np.random.default_rng(5).uniform(-3, 3, 10_000)
    np.testing.assert_array_equal(cube_root(8 * values), 2 * cube_root(values))
    np.testing.assert_array_equal(cube_root(values * 2.0**300), cube_root(values) * 2.0**100)


def test_it_may_be_written_over_what_it_is_of() -> None:
    values = np.array([27.0, -8.0, 1e-3])
    out = values.copy()
    assert cube_root(out, out=out) is out
    np.testing.assert_array_equal(out, cube_root(values))
