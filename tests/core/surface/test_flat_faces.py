"""Normals of faces without area: what float32 leaves of a cross product is noise, not a direction."""

from __future__ import annotations

import numpy as np

from hexalab.surface.normals import quad_normals


def test_V1_a_face_drawn_out_to_a_line_looks_away_from_the_inside_of_its_cell() -> None:
    random = np.random.default_rng(5)
    start, along = random.uniform(-0.3, 0.3, (3, 500)), random.normal(size=(3, 500))
    along /= np.linalg.norm(along, axis=0)
    shares = np.array([0, 0.3, 1, 0.6])[None, :, None]
    points = (start[:, None] + shares * along[:, None]).astype(np.float32)
    inside = start + random.normal(size=(3, 500))
    outward = points.mean(axis=1) - inside
    found = quad_normals(points, lambda which: inside[:, which])
    np.testing.assert_allclose(found, outward / np.linalg.norm(outward, axis=0), atol=1e-5)


def test_V1_a_slim_face_still_has_a_normal_of_its_own() -> None:
    """A thousand times as long as wide: its normal is up, whatever lies inside."""
    ring = np.array([[0, 0, 0], [1, 0, 0], [1, 1e-3, 0], [0, 1e-3, 0]], np.float32)
    found = quad_normals(ring.T[:, :, None], lambda which: np.zeros((3, len(which))))
    np.testing.assert_allclose(found[:, 0], [0, 0, 1], atol=1e-6)
