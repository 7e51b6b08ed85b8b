"""Metrics and validity of the published meshes against what Verdict said of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hexalab.formats import read
from hexalab.quality import METRICS, certify, quality_many

NOISE = {"oddy": 1e-12, "skew": 1e-13, "taper": 1e-13, "equiangle_skew": 1e-12}
"""Metrics that are zero for perfect cells: what rounding leaves of that is not compared."""


def test_Q1_published_meshes_equal_verdict(meshes: Path, expected: dict[str, Any]) -> None:
    for name, facts in expected.items():
        for metric, values in quality_many(read(meshes / name)).items():
            told = facts["verdict"][metric]
            noise = NOISE.get(metric, 0.0)
            shown = np.where(np.isfinite(values[:8]), values[:8], np.nan)
            first = np.array(told["first8"])
            first[np.abs(first) >= 1e30] = np.nan
            np.testing.assert_allclose(shown, first, rtol=1e-9, atol=noise, err_msg=f"{name} {metric}")
            if facts["cells_repeating_a_vertex"]:
                continue
            finite = values[np.isfinite(values)]
            ends = {"min": finite.min(), "max": finite.max(), "mean": finite.mean()}
            if finite.size < values.size:
                assert max(abs(told["min"]), abs(told["max"])) >= 1e30
                del ends["mean"]
            for end, ours in ends.items():
                if abs(told[end]) < 1e30:
                    assert ours == pytest.approx(told[end], rel=1e-9, abs=noise), (name, metric, end)


def test_Q1_cells_that_repeat_a_vertex_have_no_scaled_jacobian(
    meshes: Path, expected: dict[str, Any]
) -> None:
    for name, facts in expected.items():
        if facts["cells_repeating_a_vertex"]:
            values = quality_many(read(meshes / name), ["scaled_jacobian", "shape"])
            degenerate = ~np.isfinite(values["scaled_jacobian"])
            assert np.count_nonzero(degenerate) == facts["cells_repeating_a_vertex"]
            assert (values["shape"][degenerate] == 0).all()
            assert values["scaled_jacobian"][~degenerate].min() == pytest.approx(
                facts["verdict"]["scaled_jacobian"]["min"], rel=1e-9
            )


def test_Q6_published_meshes_are_decided(meshes: Path, expected: dict[str, Any]) -> None:
    for name, facts in expected.items():
        mesh = read(meshes / name)
        validity = certify(mesh)
        jacobian = quality_many(mesh, ["jacobian"])["jacobian"]
        assert validity.counts["undecided"] == 0
        assert validity.counts["invalid"] >= max(
            np.count_nonzero(jacobian < 0), facts["cells_repeating_a_vertex"]
        )
        assert not (validity.state[jacobian < 0] == 1).any()
    assert METRICS["jacobian"].acceptable_range == (0, np.inf)
