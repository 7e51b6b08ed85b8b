"""`info` and `quality` on whole meshes, against what dictionaries and VTK's Verdict say of them."""

from __future__ import annotations

import json
from typing import Any

import pytest

from hexalab import METRICS, cli
from tests.core.quality.test_whole_meshes import ROUNDED, is_incomparable
from tests.whole_meshes import HEXAHEDRAL, WholeMesh

ASKED = [whole for whole in HEXAHEDRAL if whole.name != "faults/all-inverted.mesh"]
"""All but the mesh that the program turns round before it measures."""

SENTINEL = 1e30
"""What Verdict returns where a metric has no value; ours are counted as not finite."""

RENAMED = {"face_connected_components": "components"}


def close(number: float, metric: str) -> Any:
    return pytest.approx(number, rel=ROUNDED.get(metric, 1e-9), abs=1e-12)


@pytest.mark.parametrize("whole", ASKED, ids=str)
def test_A2_info_agrees_with_dictionaries_and_verdict(
    whole: WholeMesh, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["info", "--json", str(whole.file())]) == 0
    facts = json.loads(capsys.readouterr().out)
    known, verdict = dict(whole.facts()), whole.verdict()
    known.pop("verdict", None)
    assert {RENAMED.get(key, key): value for key, value in known.items()} == {
        key: facts[key] for key in (RENAMED.get(key, key) for key in known)
    }
    assert METRICS.keys() == facts["quality"].keys() >= verdict.keys()
    for metric, numbers in ((metric, facts["quality"][metric]) for metric in verdict):
        if is_incomparable(whole, metric):
            continue
        truth = verdict[metric]
        if abs(truth["max"]) >= SENTINEL or abs(truth["min"]) >= SENTINEL:
            assert numbers["not_finite"] > 0, metric
        else:
            assert numbers["not_finite"] == 0, metric
            assert numbers["max"] == close(truth["max"], metric), metric
            assert numbers["mean"] == close(truth["mean"], metric), metric
        if abs(truth["min"]) < SENTINEL:
            assert numbers["min"] == close(truth["min"], metric), metric


@pytest.mark.parametrize("whole", ASKED, ids=str)
def test_A2_quality_gives_verdicts_values_in_file_order(
    whole: WholeMesh, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["quality", "--json", "--cells", str(whole.file())]) == 0
    found = json.loads(capsys.readouterr().out)
    for metric, truth in whole.verdict().items():
        assert len(found[metric]["values"]) == whole.cells
        if is_incomparable(whole, metric):
            continue
        for ours, theirs in zip(found[metric]["values"], truth["first8"], strict=False):
            assert ours is None if abs(theirs) >= SENTINEL else ours == close(theirs, metric), metric
