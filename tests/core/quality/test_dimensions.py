"""The dimension of each metric, found by scaling: a mesh twice as large has values 2**power as large."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.quality import METRICS, quality_many
from tests.core.quality.verdict import IDEAL, mesh_of

POWERS = (0, 1, 2, 3)


def cells_of(kind: int) -> np.ndarray:
    """Cells that are no two alike, so that no metric of theirs is 0 or at its ideal."""
    random = np.random.default_rng(kind)
    sizes = np.linspace(1, 2, 6)[:, None, None]
    return sizes * (IDEAL[kind] + random.uniform(-0.2, 0.2, (6, *IDEAL[kind].shape)))


@pytest.mark.parametrize(("metric", "kind"), [(one, kind) for one in METRICS for kind in METRICS[one].kinds])
def test_Q1_a_metric_has_the_dimension_that_the_table_tells(metric: str, kind: int) -> None:
    cells = cells_of(kind)
    before, after = (quality_many(mesh_of(scale * cells, kind), [metric])[metric] for scale in (1, 2))
    assert np.isfinite(before).all() and (before != 0).any()
    fitting = [power for power in POWERS if np.allclose(after, before * 2.0**power, rtol=1e-12, atol=0)]
    assert fitting == [METRICS[metric].length_power]


def test_Q1_lengths_and_volumes_are_those_that_one_expects() -> None:
    powers = {metric.id: metric.length_power for metric in METRICS.values() if metric.length_power}
    assert powers == {"jacobian": 3, "volume": 3, "dimension": 1, "characteristic_length": 1}
