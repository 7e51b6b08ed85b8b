"""Metrics of cells whose values follow on paper."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from hexalab.cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from hexalab.quality import METRICS, quality, quality_many
from tests.core.quality import verdict
from tests.core.quality.verdict import CUBE, NAMES, mesh_of

OF_A_BOX: dict[str, Callable[[float, float, float], float]] = {
    "sicn": lambda a, b, c: 3 / np.sqrt((a * a + b * b + c * c) * (a**-2 + b**-2 + c**-2)),
    "gauss_jacobian_ratio": lambda a, b, c: 1,
    "warpage": lambda a, b, c: 0,
    "smallest_face_angle": lambda a, b, c: 90,
    "largest_face_angle": lambda a, b, c: 90,
    "characteristic_length": lambda a, b, c: min(a, b, c),
}
"""Metrics that Verdict has not got, by what they are of a box with sides a, b and c."""


def value(corners: np.ndarray, metric: str) -> float:
    return float(quality(mesh_of(np.asarray(corners, dtype=float)[None]), metric)[0])


@pytest.mark.parametrize("metric", [m.id for m in METRICS.values() if m.unit_cube is not None])
def test_Q2_unit_cube_has_the_value_of_the_table(metric: str) -> None:
    assert value(CUBE, metric) == pytest.approx(METRICS[metric].unit_cube, abs=1e-12)


def test_Q1_box() -> None:
    a, b, c = 1.0, 2.0, 5.0
    box = CUBE * [a, b, c]
    assert value(box, "volume") == pytest.approx(a * b * c)
    assert value(box, "jacobian") == pytest.approx(a * b * c)
    assert value(box, "max_edge_ratio") == pytest.approx(c / a)
    assert value(box, "stretch") == pytest.approx(np.sqrt(3) * a / np.sqrt(a * a + b * b + c * c))
    assert value(box, "shape") == pytest.approx(3 * (a * b * c) ** (2 / 3) / (a * a + b * b + c * c))
    norm = (a**2 + b**2 + c**2) * ((b * c) ** 2 + (a * c) ** 2 + (a * b) ** 2)
    assert value(box, "max_aspect_frobenius") == pytest.approx(np.sqrt(norm) / (3 * a * b * c))
    squares = a**4 + b**4 + c**4 - (a * a + b * b + c * c) ** 2 / 3
    assert value(box, "oddy") == pytest.approx(squares / (a * b * c) ** (4 / 3))
    gradients = 8 * ((b * c / 4) ** 2 + (a * c / 4) ** 2 + (a * b / 4) ** 2)
    assert value(box, "dimension") == pytest.approx(a * b * c / np.sqrt(2 * gradients))
    for metric in ("scaled_jacobian", "shear", "diagonal", "distortion", "nodal_jacobian_ratio"):
        assert value(box, metric) == pytest.approx(1)


def test_Q1_every_metric_has_a_truth_outside() -> None:
    """Verdict's, or a formula that follows on paper."""
    assert NAMES.keys() | OF_A_BOX.keys() == METRICS.keys()
    assert not NAMES.keys() & OF_A_BOX.keys()
    for metric, formula in OF_A_BOX.items():
        for sides in ((1.0, 2.0, 5.0), (3.0, 0.5, 0.5)):
            assert value(CUBE * sides, metric) == pytest.approx(formula(*sides), abs=1e-12)


@pytest.mark.parametrize("slant", [0.25, 1.0, 3.0])
def test_Q1_sheared_cube(slant: float) -> None:
    sheared = CUBE + CUBE[:, 2:] * [slant, 0, 0]
    length = np.sqrt(1 + slant * slant)
    angle = np.degrees(np.arctan(slant))
    assert value(sheared, "volume") == pytest.approx(1)
    assert value(sheared, "scaled_jacobian") == pytest.approx(1 / length)
    assert value(sheared, "skew") == pytest.approx(slant / length)
    assert value(sheared, "taper") == pytest.approx(0, abs=1e-12)
    assert value(sheared, "equiangle_skew") == pytest.approx(angle / 90)
    assert value(sheared, "shape") == pytest.approx(3 / (2 + length**2))


def test_Q1_frustum() -> None:
    top = 0.5
    frustum = CUBE - [0.5, 0.5, 0]
    frustum[4:, :2] *= top
    assert value(frustum, "volume") == pytest.approx((1 + top + top * top) / 3)
    assert value(frustum, "nodal_jacobian_ratio") == pytest.approx(top * top)
    assert value(frustum, "jacobian") == pytest.approx(top * top)
    assert value(frustum, "taper") == pytest.approx((2 - 2 * top) / (2 + 2 * top))


@pytest.mark.parametrize("edge", verdict.EDGES)
def test_Q7_edge_ratio_sees_every_edge(edge: tuple[int, int]) -> None:
    """Of a cube of which one edge alone is made twice as long, in its own direction."""
    cell = CUBE.copy()
    cell[edge[1]] += CUBE[edge[1]] - CUBE[edge[0]]
    lengths = [np.linalg.norm(cell[a] - cell[b]) for a, b in verdict.EDGES]
    assert value(cell, "edge_ratio") == pytest.approx(max(lengths) / min(lengths)) == pytest.approx(2)


def test_Q8_gauss_jacobian_ratio_of_a_frustum() -> None:
    """Its Jacobian is (1 - z / 2)^2, whatever x and y."""
    frustum = CUBE - [0.5, 0.5, 0]
    frustum[4:, :2] *= 0.5
    low, high = (1 - 1 / np.sqrt(3)) / 2, (1 + 1 / np.sqrt(3)) / 2
    assert value(frustum, "gauss_jacobian_ratio") == pytest.approx(((1 - high / 2) / (1 - low / 2)) ** 2)


def test_Q8_warpage_of_a_lifted_corner() -> None:
    """One corner of the top face lifted by h: at it and across the normals are (-h, -h, 1) and (0, 0, 1), at the two
    others (-h, 0, 1) and (0, -h, 1); the two sides beside it stay flat."""
    h = 0.4
    cell = CUBE.copy()
    cell[6, 2] += h
    across, beside = 1 / np.sqrt(1 + 2 * h * h), 1 / (1 + h * h)
    assert value(cell, "warpage") == pytest.approx(1 - min(across, beside) ** 3)


def test_Q8_angles_of_a_dent() -> None:
    """The corner 2 of the bottom pushed to (0.25, 0.25): its angle is beyond 180 degrees; so is that of the top."""
    cell = CUBE.copy()
    cell[[2, 6], :2] = 0.25
    slope = np.degrees(np.arctan(1 / 3))
    assert value(cell, "smallest_face_angle") == pytest.approx(slope)
    assert value(cell, "largest_face_angle") == pytest.approx(360 - (90 + 2 * slope))


def test_Q8_angles_of_a_collapsed_hexahedron_are_those_of_its_triangles() -> None:
    wedge = CUBE[[0, 1, 2, 2, 4, 5, 6, 6]]
    assert value(wedge, "smallest_face_angle") == pytest.approx(45)
    assert value(wedge, "largest_face_angle") == pytest.approx(90)


@pytest.mark.parametrize(("kind", "volume", "face"), [
    (HEXAHEDRON, 1, 1), (WEDGE, 0.75**0.5 / 2, 1), (PYRAMID, 0.5**0.5 / 3, 1),
    (TETRAHEDRON, 2**0.5 / 12, 0.75**0.5 / 2),
])  # fmt: skip
def test_Q8_ideal_cells(kind: int, volume: float, face: float) -> None:
    """All edges are 1; faces are squares and equilateral triangles."""
    values = {id: float(v[0]) for id, v in quality_many(mesh_of(verdict.IDEAL[kind][None], kind)).items()}
    assert values["characteristic_length"] == pytest.approx(volume / face)
    assert values["sicn"] == pytest.approx(1)
    assert values["smallest_face_angle"] == pytest.approx(90 if kind == HEXAHEDRON else 60)
    assert values["largest_face_angle"] == pytest.approx(60 if kind == TETRAHEDRON else 90)
    assert kind == TETRAHEDRON or values["warpage"] == pytest.approx(0, abs=1e-12)
