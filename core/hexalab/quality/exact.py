"""Exact determinants and Bezier coefficients, as integers, for the few cells that rounding leaves open."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Floats
from .bezier import fill_middles

EXPONENT_OF_ZERO = 1 << 20


def integers(coordinates: Floats) -> Array:
    """Scale finite numbers to integers, by one power of two for each column.

    Parameters
    ----------
    coordinates : (..., n) float64

    Returns
    -------
    (..., n) object
        Python integers, column by column the coordinates times a power of two: signs of polynomials stay as they are.
    """
    fractions, exponents = np.frexp(coordinates)
    mantissas = np.ldexp(fractions, 53).astype(np.int64)
    exponents = np.where(mantissas == 0, EXPONENT_OF_ZERO, exponents.astype(np.int64))
    lowest = exponents.min(axis=tuple(range(exponents.ndim - 1)))
    shifts = np.where(mantissas == 0, 0, exponents - lowest)
    return np.asarray(mantissas.astype(object) << shifts.astype(object))


def determinant(u: Array, v: Array, w: Array) -> Array:
    """u.(v x w) over the first axis."""
    return np.asarray(
        u[0] * (v[1] * w[2] - v[2] * w[1])
        + u[1] * (v[2] * w[0] - v[0] * w[2])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
    )


def coefficients(points: Array) -> Array:
    """Eight times the Bezier coefficients of the Jacobian determinant.

    Parameters
    ----------
    points : (3, 2, 2, 2, n) object
        Integer coordinates of the corners, axes w, v, u second to fourth.

    Returns
    -------
    (3, 3, 3, n) object
    """
    u, v, w = (
        points[:, :, :, 1] - points[:, :, :, 0],
        points[:, :, 1] - points[:, :, 0],
        points[:, 1] - points[:, 0],
    )
    out = np.empty((3, 3, 3, points.shape[-1]), dtype=object)
    corners = determinant(u[:, :, :, None], v[:, :, None], w[:, None])
    along_u = determinant(u, v.sum(axis=2)[:, :, None], w.sum(axis=2)[:, None])
    along_v = determinant(v, w.sum(axis=1)[:, None], u.sum(axis=2)[:, :, None])
    along_w = determinant(w, u.sum(axis=1)[:, :, None], v.sum(axis=1)[:, None])
    out[::2, ::2, ::2] = corners * 8
    out[::2, ::2, 1] = (along_u - corners.sum(axis=2)) * 4
    out[::2, 1, ::2] = (along_v - corners.sum(axis=1)) * 4
    out[1, ::2, ::2] = (along_w - corners.sum(axis=0)) * 4
    fill_middles(out, exact=True)
    return out
