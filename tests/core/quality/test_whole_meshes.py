"""Metrics and validity of whole meshes against what Verdict says of them."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.formats import read
from hexalab.quality import METRICS, certify, quality_many
from tests.core.quality.verdict import NAMES
from tests.whole_meshes import HEXAHEDRAL, WholeMesh

NOISE = {"oddy": 1e-12, "skew": 1e-13, "taper": 1e-13, "equiangle_skew": 1e-12}
"""Metrics that are zero for perfect cells: what rounding leaves of that is not compared."""

ROUNDED = {"dimension": 1e-7}
"""Metrics that Verdict computes from raw coordinates, so that digits are lost where cells are flat or far away."""

UNDECIDED = {("faults/zero-volume.mesh", "distortion")}
"""Nothing by nothing: Verdict gives the ratio of what rounding left of both."""

HALF = ("edge_ratio",)
"""Metrics that Verdict computes of half of the edges."""

REPEATING = ("2021-at-most-hexa", "structures/collapsed", "faults/repeated-vertex")
"""How the names of meshes begin that have cells which repeat a vertex."""


def is_incomparable(whole: WholeMesh, metric: str) -> bool:
    """Whether Verdict's value of the metric is not what the metric is."""
    return metric in HALF or (whole.name, metric) in UNDECIDED


@pytest.mark.parametrize("whole", HEXAHEDRAL, ids=str)
def test_Q1_whole_meshes_equal_verdict(whole: WholeMesh) -> None:
    repeating = whole.facts()["cells_repeating_a_vertex"]
    for metric, values in quality_many(read(whole.file()), NAMES).items():
        if is_incomparable(whole, metric):
            continue
        told = whole.verdict()[metric]
        noise = NOISE.get(metric, 0.0)
        first = np.array(told["first8"])
        first[np.abs(first) >= 1e30] = np.nan
        ours = values[: len(first)]
        shown = np.where(np.isfinite(ours), ours, np.nan)
        np.testing.assert_allclose(shown, first, rtol=ROUNDED.get(metric, 1e-9), atol=noise, err_msg=metric)
        if repeating:
            continue
        finite = values[np.isfinite(values)]
        if not finite.size:
            assert min(abs(told["min"]), abs(told["max"])) >= 1e30
            continue
        ends = {"min": finite.min(), "max": finite.max(), "mean": finite.mean()}
        if finite.size < values.size:
            assert max(abs(told["min"]), abs(told["max"])) >= 1e30
            del ends["mean"]
        for end, number in ends.items():
            if abs(told[end]) < 1e30:
                assert number == pytest.approx(told[end], rel=ROUNDED.get(metric, 1e-9), abs=noise), (
                    metric,
                    end,
                )


@pytest.mark.parametrize("whole", [one for one in HEXAHEDRAL if one.name.startswith(REPEATING)], ids=str)
def test_Q1_cells_that_repeat_a_vertex_have_no_scaled_jacobian(whole: WholeMesh) -> None:
    values = quality_many(read(whole.file()), ["scaled_jacobian", "shape"])
    degenerate = ~np.isfinite(values["scaled_jacobian"])
    assert np.count_nonzero(degenerate) == whole.facts()["cells_repeating_a_vertex"] > 0
    assert (values["shape"][degenerate] == 0).all()
    assert values["scaled_jacobian"][~degenerate].min() == pytest.approx(
        whole.verdict()["scaled_jacobian"]["min"], rel=1e-9
    )


@pytest.mark.parametrize("whole", HEXAHEDRAL, ids=str)
def test_Q6_whole_meshes_are_decided(whole: WholeMesh) -> None:
    mesh = read(whole.file())
    validity = certify(mesh)
    jacobian = quality_many(mesh, ["jacobian"])["jacobian"]
    assert validity.counts["undecided"] == 0
    assert validity.counts["invalid"] >= max(
        np.count_nonzero(jacobian < 0), whole.facts()["cells_repeating_a_vertex"]
    )
    assert not (validity.state[jacobian < 0] == 1).any()
    assert METRICS["jacobian"].acceptable_range == (0, np.inf)
