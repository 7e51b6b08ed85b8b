"""Metrics of tetrahedra, pyramids and wedges against VTK's Verdict."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.cells import HEXAHEDRON, KINDS, PYRAMID, TETRAHEDRON, WEDGE
from hexalab.mesh import Mesh
from hexalab.quality import METRICS, quality, quality_many
from tests.core.quality.verdict import CUBE, IDEAL, assert_equal, mesh_of, of_corners, samples
from tests.core.quality.verdict import NAMES as VERDICTS

CASES = [
    (kind, metric)
    for kind in (TETRAHEDRON, PYRAMID, WEDGE)
    for metric in VERDICTS
    if kind in METRICS[metric].kinds
]
NAMES = [f"{KINDS[kind]}-{metric}" for kind, metric in CASES]


@pytest.mark.parametrize(("kind", "metric"), CASES, ids=NAMES)
@pytest.mark.parametrize(
    "sample", ["sound", "wild", "inverted", "tiny", "huge", "all scales", "off the origin"]
)
def test_Q1_other_kinds_equal_verdict(kind: int, metric: str, sample: str) -> None:
    corners = samples(kind)[sample]
    assert_equal(quality(mesh_of(corners, kind), metric), of_corners(corners, metric, kind))


@pytest.mark.parametrize(("kind", "metric"), CASES, ids=NAMES)
def test_Q1_ideal_cells_equal_verdict(kind: int, metric: str) -> None:
    corners = IDEAL[kind][None]
    assert_equal(quality(mesh_of(corners, kind), metric), of_corners(corners, metric, kind), noise=1e-14)


@pytest.mark.parametrize("kind", [TETRAHEDRON, PYRAMID, WEDGE])
def test_Q1_ideal_cells_are_the_best(kind: int) -> None:
    values = quality_many(mesh_of(IDEAL[kind][None], kind))
    for metric in ("scaled_jacobian", "shape"):
        assert values[metric][0] == pytest.approx(1)
    assert values["equiangle_skew"][0] == pytest.approx(0, abs=1e-12)


def test_Q1_kinds_without_a_metric_have_nan() -> None:
    for kind in (TETRAHEDRON, PYRAMID, WEDGE):
        for metric, values in quality_many(mesh_of(IDEAL[kind][None], kind)).items():
            assert np.isnan(values[0]) == (kind not in METRICS[metric].kinds), (KINDS[kind], metric)


def test_Q1_mixed_meshes_compute_each_kind_by_itself() -> None:
    points, corners, kinds = [], [], []
    random = np.random.default_rng(5)
    for kind in (HEXAHEDRON, TETRAHEDRON, PYRAMID, WEDGE, HEXAHEDRON, TETRAHEDRON):
        cell = mesh_of((IDEAL[kind] + random.uniform(-0.1, 0.1, IDEAL[kind].shape))[None], kind)
        corners.append(cell.corners + sum(len(p) for p in points))
        points.append(cell.points)
        kinds.append(kind)
    mesh = Mesh(np.concatenate(points).T, np.concatenate(corners, axis=1), np.array(kinds, np.uint8))
    values = quality_many(mesh)
    for place in range(len(kinds)):
        alone = quality_many(Mesh(mesh.coordinates, mesh.corners[:, [place]], mesh.kinds[[place]]))
        for metric in METRICS:
            if "size" not in metric:
                np.testing.assert_allclose(values[metric][place], alone[metric][0], rtol=1e-14)
    two_cubes = mesh.kinds == HEXAHEDRON
    volumes = values["volume"][two_cubes]
    ratio = volumes / volumes.mean()
    np.testing.assert_allclose(
        values["relative_size_squared"][two_cubes], np.minimum(ratio, 1 / ratio) ** 2, rtol=0.05
    )
    assert CUBE.shape == (8, 3)
