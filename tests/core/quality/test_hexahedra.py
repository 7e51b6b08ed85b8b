"""Metrics of hexahedra against VTK's Verdict, on random cells of every sort."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.quality import METRICS, quality, quality_many
from tests.core.quality import verdict
from tests.core.quality.verdict import CUBE, assert_equal, hexahedra, mesh_of, of_corners, samples

SAMPLES = {**samples(), **hexahedra()}
TRIPLES = (
    (0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7), (4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2), (7, 6, 4, 3),
)  # fmt: skip
AXES = (((0, 3, 4, 7), (1, 2, 5, 6)), ((0, 1, 4, 5), (3, 2, 7, 6)), ((0, 1, 2, 3), (4, 5, 6, 7)))


@pytest.mark.parametrize("metric", verdict.NAMES)
@pytest.mark.parametrize("sample", SAMPLES)
def test_Q1_hexahedra_equal_verdict(metric: str, sample: str) -> None:
    corners = SAMPLES[sample]
    if metric in ("oddy", "nodal_jacobian_ratio"):
        corners = corners[~near_the_threshold(corners)]
    noise = 1e-20 if "size" in metric else 0
    assert_equal(quality(mesh_of(corners), metric), of_corners(corners, metric), noise)


def near_the_threshold(corners: np.ndarray) -> np.ndarray:
    """Whether a determinant is near 2.2e-15 of the cube of the cell's size: Verdict has it in the file's unit."""
    size = np.linalg.norm(np.ptp(corners, axis=1), axis=1)
    edges = [corners[:, list(ends)] - corners[:, corner, None] for corner, *ends in TRIPLES]
    x, y, z = ((corners[:, AXES[axis][1]] - corners[:, AXES[axis][0]]).sum(axis=1) for axis in range(3))
    found = (
        np.abs([*(np.linalg.det(edge) for edge in edges), np.linalg.det(np.stack([x, y, z], axis=1))])
        / size**3
    )
    return ((found > 1e-17) & (found < 1e-13)).any(axis=0)


def test_Q1_all_at_once_equals_one_by_one() -> None:
    mesh = mesh_of(np.concatenate([SAMPLES["sound"], SAMPLES["wild"], SAMPLES["stretched"]]))
    together = quality_many(mesh)
    assert list(together) == list(METRICS)
    for metric, values in together.items():
        np.testing.assert_array_equal(values, quality(mesh, metric))


def test_Q1_blocks_of_cells_do_not_disturb_one_another() -> None:
    corners = np.random.default_rng(3).uniform(-0.3, 0.3, (9001, 8, 3)) + CUBE
    whole, parts = quality_many(mesh_of(corners)), []
    alone = [metric for metric in METRICS if "size" not in metric]
    for start in (0, 5000):
        parts.append(quality_many(mesh_of(corners[start : start + 5000]), alone))
    for metric in alone:
        np.testing.assert_array_equal(whole[metric], np.concatenate([part[metric] for part in parts]))


@pytest.mark.parametrize("metric", ["equiangle_skew", "skew", "taper", "oddy", "distortion"])
@pytest.mark.parametrize("size", [1e-4, 1.0, 3e7])
def test_Q1_perfect_cells_differ_by_no_more_than_rounding(metric: str, size: float) -> None:
    turn = np.linalg.qr(np.random.default_rng(4).normal(size=(200, 3, 3)))[0]
    corners = (CUBE * size) @ turn
    assert_equal(quality(mesh_of(corners), metric), of_corners(corners, metric), noise=1e-12)


REPEATS = {
    "wedge": (0, 1, 2, 2, 4, 5, 6, 6),
    "pyramid": (0, 1, 2, 3, 4, 4, 4, 4),
    "tetrahedron": (0, 1, 2, 2, 4, 4, 4, 4),
    "edge 01": (0, 0, 2, 3, 4, 5, 6, 7),
    "edge 12": (0, 1, 1, 3, 4, 5, 6, 7),
    "edge 67": (0, 1, 2, 3, 4, 5, 6, 6),
    "edge 04": (0, 1, 2, 3, 0, 5, 6, 7),
    "diagonal 02": (0, 1, 0, 3, 4, 5, 6, 7),
    "flat": (0, 1, 2, 3, 0, 1, 2, 3),
    "point": (0, 0, 0, 0, 0, 0, 0, 0),
}


@pytest.mark.parametrize("places", REPEATS.values(), ids=REPEATS)
def test_Q1_repeated_vertices_are_computed_on_the_eight_corners(places: tuple[int, ...]) -> None:
    corners = CUBE[list(places)][None]
    for metric in verdict.NAMES:
        ours, theirs = quality(mesh_of(corners), metric), of_corners(corners, metric)
        assert_equal(ours, theirs, noise=1e-15)


def test_Q1_sentinels_are_infinite_at_the_worst_end() -> None:
    values = quality_many(mesh_of(CUBE[list(REPEATS["point"])][None]))
    for metric in ("diagonal", "edge_ratio", "max_edge_ratio", "oddy", "scaled_jacobian", "skew", "taper"):
        assert values[metric][0] == METRICS[metric].worst
    for metric in ("shape", "shear", "volume", "jacobian"):
        assert values[metric][0] == 0
    assert METRICS["scaled_jacobian"].worst == -np.inf
    assert METRICS["skew"].worst == np.inf


def test_Q7_what_passes_verdicts_bound_of_1e30_is_what_it_is() -> None:
    corners = np.stack([CUBE * 2e10, CUBE * 2e10 * [1, 1, -1], CUBE * 0.5e10])
    for metric in ("volume", "jacobian"):
        np.testing.assert_allclose(quality(mesh_of(corners), metric), [8e30, -8e30, 0.125e30])


def test_Q1_coordinates_that_are_no_numbers_spoil_their_own_cell_alone() -> None:
    corners = np.stack([CUBE, CUBE + 0.1 * np.sin(np.arange(24)).reshape(8, 3)])
    alone = [metric for metric in METRICS if "size" not in metric]
    sound = quality_many(mesh_of(corners), alone)
    corners[1, 6, 2] = np.nan
    spoilt = quality_many(mesh_of(corners), alone)
    for metric in alone:
        assert spoilt[metric][0] == sound[metric][0]
    assert not np.isfinite(spoilt["scaled_jacobian"][1])
    assert not np.isfinite(spoilt["volume"][1])


def test_Q1_sizes_compare_with_the_mean_volume_of_the_mesh() -> None:
    corners = np.stack([CUBE, CUBE * 2, CUBE * 0.5])
    mean = (1 + 8 + 0.125) / 3
    expected = [(1 / mean) ** 2, (mean / 8) ** 2, (0.125 / mean) ** 2]
    np.testing.assert_allclose(quality(mesh_of(corners), "relative_size_squared"), expected, rtol=1e-12)
    np.testing.assert_allclose(quality(mesh_of(corners), "shape_and_size"), expected, rtol=1e-12)
    mirrored = np.stack([CUBE * [-1, 1, 1] * 2, CUBE, CUBE * 0.5])
    for metric in ("relative_size_squared", "shape_and_size", "shear_and_size"):
        assert_equal(quality(mesh_of(mirrored), metric), of_corners(mirrored, metric))


def test_Q1_an_unknown_metric_is_named() -> None:
    with pytest.raises(KeyError, match="niceness"):
        quality(mesh_of(CUBE[None]), "niceness")


def test_Q1_a_mesh_without_cells_has_no_values() -> None:
    empty = mesh_of(np.zeros((0, 8, 3)))
    assert all(values.shape == (0,) for values in quality_many(empty).values())
