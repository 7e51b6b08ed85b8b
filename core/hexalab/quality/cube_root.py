"""Cube roots that do not depend on the unit of length."""

from __future__ import annotations

import numpy as np

from ..arrays import Floats


def cube_root(values: Floats, out: Floats | None = None) -> Floats:
    """Cube roots, for which that of 8 v is exactly twice that of v.

    C libraries differ in the last bit of `cbrt`, and some round v and 8 v differently. So the root is that of a number
    from 0.5 to 4, and the power of two is added afterwards: 40 = 0.625 * 2^6 has the root of 0.625, times 2^2;
    5 = 0.625 * 2^3 has the same, times 2.

    Parameters
    ----------
    values : (...) float64
    out : (...) float64, optional
        Where the roots are written; may be `values`.

    Returns
    -------
    (...) float64
        0, infinity and NaN as they are.
    """
    fractions, exponents = np.frexp(values)
    thirds = exponents // 3
    np.ldexp(fractions, exponents - 3 * thirds, out=fractions)
    np.cbrt(fractions, out=fractions)
    return np.asarray(np.ldexp(fractions, thirds, out=out))
