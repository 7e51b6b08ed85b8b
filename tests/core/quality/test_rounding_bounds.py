"""Cells so close to zero that only the bound of rounding errors keeps a wrong answer from being certified."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from hexalab.quality.bezier import BezierBlock, octants
from hexalab.quality.validity import INVALID, VALID
from tests.core.quality.test_validity import PLACES, exact_state, jacobian, states
from tests.core.quality.verdict import CUBE, mesh_of


def coefficients(cells: np.ndarray) -> np.ndarray:
    """The Bezier coefficients as floating point has them, (3, 3, 3, C)."""
    mesh, block = mesh_of(cells), BezierBlock()
    block.load(mesh.coordinates, mesh.corners)
    return block.coefficients(block.corners()).copy()


def test_Q6_a_corner_whose_sign_floating_point_gets_wrong_is_told_exactly() -> None:
    """Corner 6 in the plane of its neighbours, but for the last digits of its coordinates."""
    random = np.random.default_rng(21)
    cells = CUBE + random.uniform(-0.02, 0.02, (1500, 8, 3))
    cells[:, 6] = 0.4 * cells[:, 2] + 0.35 * cells[:, 5] + 0.25 * cells[:, 7]
    cells = cells[coefficients(cells).min(axis=(0, 1, 2)) > 0]
    exact = [jacobian([[Fraction(float(x)) for x in p] for p in cell], PLACES[6]) for cell in cells]
    wrong = np.array([value <= 0 for value in exact])
    assert 20 < wrong.sum() < len(cells) - 20
    assert (states(cells[wrong]) == INVALID).all()
    assert (states(cells[~wrong]) == VALID).all()
    assert exact_state(cells[wrong][0]) == INVALID
    assert exact_state(cells[~wrong][0]) == VALID


def test_Q6_a_zero_inside_that_floating_point_takes_for_positive_is_told_exactly() -> None:
    """The top turned by half and three times as large: (1 - 4 w)^2 times a constant, zero at w = 1/4.

    Coordinates have 46 binary places, so that the top is exactly minus three times the bottom.
    """
    random = np.random.default_rng(3)
    shapes = np.round((np.eye(3) + random.uniform(-0.3, 0.3, (1000, 3, 3))) * 2**46) / 2**46
    bottom = np.einsum("nij,kj->nki", shapes, CUBE[:4] * 2 - 1)
    cells = np.concatenate([bottom, -3 * bottom], axis=1)
    pieces = octants(octants(coefficients(cells), exact=False), exact=False).min(axis=(0, 1, 2))
    positive = (pieces.reshape(64, -1) > 0).all(axis=0)
    assert positive.sum() > 20
    exact = [[Fraction(float(x)) for x in corner] for corner in cells[positive][0]]
    assert jacobian(exact, (Fraction(1, 2), Fraction(1, 2), Fraction(1, 4))) == 0
    assert (states(cells) == INVALID).all()
