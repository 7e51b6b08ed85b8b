"""Certified validity against exact rational subdivision, dense samples, and cells built to deceive."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from hexalab.cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from hexalab.mesh import Mesh
from hexalab.quality import certify, quality
from hexalab.quality.validity import INVALID, UNDECIDED, VALID
from tests.core.quality.verdict import CUBE, IDEAL, mesh_of, samples

PLACES = {corner: tuple(int(x) for x in CUBE[corner]) for corner in range(8)}
"""Parameters of each corner."""


def shape_gradients(point: tuple) -> list[list]:
    """Gradients of the eight trilinear shape functions at a point of the unit cube."""
    rows = []
    for corner in range(8):
        factors = [t if end else 1 - t for t, end in zip(point, PLACES[corner], strict=True)]
        slopes = [1 if end else -1 for end in PLACES[corner]]
        rows.append(
            [
                slopes[0] * factors[1] * factors[2],
                factors[0] * slopes[1] * factors[2],
                factors[0] * factors[1] * slopes[2],
            ]
        )
    return rows


def jacobian(corners: list, point: tuple) -> object:
    """Determinant of the trilinear map at a point, in whatever arithmetic the arguments bring."""
    rows = shape_gradients(point)
    m = [[sum(rows[c][j] * corners[c][i] for c in range(8)) for j in range(3)] for i in range(3)]
    return (
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    )


def bezier_1d(values: list) -> list:
    """Bezier coefficients of the quadratic through values at 0, 1/2, 1."""
    return [values[0], 2 * values[1] - (values[0] + values[2]) / 2, values[2]]


def exact_state(corners: np.ndarray, depth: int = 4) -> int:
    """Sign of the Jacobian by subdivision in rational arithmetic: its 27 values, no assumption on its monomials."""
    exact = [[Fraction(float(x)) for x in corner] for corner in corners]
    half = (Fraction(0), Fraction(1, 2), Fraction(1))
    boxes, open_boxes = [((Fraction(0),) * 3, Fraction(1))], []
    for _ in range(depth):
        open_boxes = []
        for origin, width in boxes:
            grid = {
                place: jacobian(exact, tuple(o + width * half[i] for o, i in zip(origin, place, strict=True)))
                for place in product(range(3), repeat=3)
            }
            if min(grid[place] for place in product((0, 2), repeat=3)) <= 0:
                return INVALID
            for axis in range(3):
                for rest in product(range(3), repeat=2):
                    places = [(*rest[:axis], i, *rest[axis:]) for i in range(3)]
                    for place, value in zip(places, bezier_1d([grid[p] for p in places]), strict=True):
                        grid[place] = value
            if min(grid.values()) <= 0:
                open_boxes.append((origin, width))
        if not open_boxes:
            return VALID
        boxes = [
            (tuple(o + width / 2 * s for o, s in zip(origin, steps, strict=True)), width / 2)
            for origin, width in open_boxes
            for steps in product((0, 1), repeat=3)
        ]
    return UNDECIDED


def sampled_minimum(corners: np.ndarray, steps: int = 10) -> np.ndarray:
    """Least of steps^3 determinants of each cell (C, 8, 3)."""
    columns = [corners[:, c].T for c in range(8)]
    least = np.full(len(corners), np.inf)
    for point in product(np.linspace(0, 1, steps), repeat=3):
        rows = shape_gradients(point)
        m = sum(np.array(rows[c])[None, :, None] * columns[c][:, None, :] for c in range(8))
        least = np.minimum(least, jacobian_of_matrices(m))
    return least


def jacobian_of_matrices(m: np.ndarray) -> np.ndarray:
    return np.linalg.det(np.moveaxis(m, -1, 0))


def states(corners: np.ndarray) -> np.ndarray:
    return certify(mesh_of(np.asarray(corners, dtype=float))).state


def inverted_inside() -> np.ndarray:
    """Cells positive at all eight corners and at the centre, but not everywhere."""
    random = np.random.default_rng(12)
    cells = CUBE + random.uniform(-0.55, 0.55, (20000, 8, 3))
    positive = quality(mesh_of(cells), "jacobian") > 0
    return cells[positive & (sampled_minimum(cells, 5) < -1e-3)]


def test_Q6_cells_inverted_inside_alone_are_found() -> None:
    cells = inverted_inside()
    assert len(cells) > 5
    assert (states(cells) == INVALID).all()


def test_Q6_agrees_with_exact_rational_subdivision() -> None:
    random = np.random.default_rng(6)
    cells = np.concatenate([CUBE + random.uniform(-r, r, (12, 8, 3)) for r in (0.2, 0.35, 0.45, 0.55)])
    found = states(cells)
    told = np.array([exact_state(cell) for cell in cells])
    decided = told != UNDECIDED
    np.testing.assert_array_equal(found[decided], told[decided])
    assert decided.mean() > 0.9
    assert {VALID, INVALID} <= set(told.tolist())


def test_Q6_dense_samples_never_contradict_valid() -> None:
    random = np.random.default_rng(7)
    cells = CUBE + random.uniform(-0.45, 0.45, (3000, 8, 3))
    validity = certify(mesh_of(cells))
    least = sampled_minimum(cells)
    assert (least[validity.state == VALID] > -1e-14).all()
    assert (validity.state[least < -1e-13] == INVALID).all()
    assert (validity.minimum <= least + 1e-14).all()
    assert 100 < np.count_nonzero(validity.state == VALID) < 2900


@pytest.mark.parametrize("sample", ["sound", "flat", "tiny", "huge", "all scales", "off the origin"])
def test_Q6_sound_cells_of_every_size_are_valid(sample: str) -> None:
    assert (states(samples()[sample]) == VALID).mean() > 0.99
    inverted = samples()[sample] * [1, -1, 1]
    assert (states(inverted) == INVALID).all()


def test_Q6_a_determinant_of_zero_at_a_corner_is_invalid() -> None:
    flat_corner = CUBE.copy()
    flat_corner[6] = [0.5, 0.5, 1]
    flat_corner[[5, 7]] = [[1, 0, 1], [0, 1, 1]]
    folded = CUBE.copy()
    folded[1] = folded[0]
    assert states(np.stack([flat_corner, folded, CUBE * [1, 1, 0], CUBE * 0])).tolist() == [INVALID] * 4


@pytest.mark.parametrize("step", [-1, 0, 1])
def test_Q6_one_rounding_from_zero_is_told_apart(step: int) -> None:
    """Corner 6 in the plane of its neighbours 2, 5, 7, where its determinant is exactly zero, and one step off."""
    cell = CUBE.copy()
    cell[6] = [1, 0.5, 0.5]
    if step:
        cell[6, 1] = np.nextafter(cell[6, 1], 0.5 + step)
    exact = [[Fraction(float(x)) for x in corner] for corner in cell]
    assert np.sign(jacobian(exact, PLACES[6])) == step
    assert states(cell[None])[0] == exact_state(cell, depth=6) == (VALID if step > 0 else INVALID)


def test_Q6_needles_and_slabs_do_not_drown_in_rounding() -> None:
    random = np.random.default_rng(8)
    cells = (CUBE + random.uniform(-0.2, 0.2, (500, 8, 3))) * 10 ** random.uniform(-6, 6, (500, 1, 3))
    assert (states(cells) == VALID).all()


def test_Q6_past_the_bound_on_subdivisions_cells_are_undecided() -> None:
    cells = inverted_inside()
    assert UNDECIDED in certify(mesh_of(cells), depth=0).state
    assert UNDECIDED not in certify(mesh_of(cells)).state


def test_Q6_infinite_coordinates_are_invalid() -> None:
    cells = np.stack([CUBE, CUBE, CUBE])
    cells[1, 3, 1] = np.nan
    cells[2, 3, 1] = np.inf
    assert states(cells).tolist() == [VALID, INVALID, INVALID]


@pytest.mark.parametrize("kind", [TETRAHEDRON, PYRAMID, WEDGE])
def test_Q6_other_kinds_by_their_nodes(kind: int) -> None:
    ideal = IDEAL[kind]
    apex = {TETRAHEDRON: 3, PYRAMID: 4, WEDGE: 3}[kind]
    flat, tiny, broken = ideal.copy(), ideal * 1e-120, ideal.copy()
    flat[:, 2] = 0
    broken[apex] = np.nan
    cells = np.stack([ideal, ideal * [1, 1, -1], flat, tiny, broken])
    assert certify(mesh_of(cells, kind)).state.tolist() == [VALID, INVALID, INVALID, VALID, INVALID]


def test_Q6_mixed_meshes_keep_their_ids() -> None:
    sound, turned = mesh_of(CUBE[None]), mesh_of((CUBE * [1, 1, -1])[None])
    tetrahedron = mesh_of(IDEAL[TETRAHEDRON][None], TETRAHEDRON)
    mesh = Mesh(
        np.concatenate([sound.coordinates, tetrahedron.coordinates, turned.coordinates], axis=1),
        np.concatenate([sound.corners, tetrahedron.corners + 8, turned.corners + 12], axis=1),
        np.array([HEXAHEDRON, TETRAHEDRON, HEXAHEDRON], np.uint8),
    )
    validity = certify(mesh)
    assert validity.state.tolist() == [VALID, VALID, INVALID]
    assert validity.counts == {"invalid": 1, "valid": 2, "undecided": 0}
    assert validity.minimum[0] == pytest.approx(1)
    assert certify(mesh_of(np.zeros((0, 8, 3)))).state.shape == (0,)
