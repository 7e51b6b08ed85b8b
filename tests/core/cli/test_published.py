"""`info` and `quality` on the published meshes, against what dictionaries and VTK's Verdict say of them."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest

from hexalab import cli

MESHES = Path(os.environ.get("HEXALAB_MESHES", Path(__file__).parents[4] / "shared" / "meshes"))
NAMES = sorted(json.loads((MESHES / "expected.json").read_text())) if MESHES.is_dir() else []

SENTINEL = 1e30
"""What Verdict returns where a metric has no value; ours are counted as not finite."""

RENAMED = {"face_connected_components": "components"}


def close(number: float) -> Any:
    return pytest.approx(number, rel=1e-9, abs=1e-12)


@pytest.mark.skipif(not NAMES, reason="the published meshes are not here")
@pytest.mark.parametrize("name", NAMES)
def test_A2_info_agrees_with_dictionaries_and_verdict(
    name: str, expected: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["info", "--json", str(MESHES / name)]) == 0
    facts = json.loads(capsys.readouterr().out)
    known = dict(expected[name])
    verdict = known.pop("verdict")
    assert {RENAMED.get(key, key): value for key, value in known.items()} == {
        key: facts[key] for key in (RENAMED.get(key, key) for key in known)
    }
    assert set(facts["quality"]) == set(verdict)
    for metric, numbers in facts["quality"].items():
        truth = verdict[metric]
        if abs(truth["max"]) >= SENTINEL or abs(truth["min"]) >= SENTINEL:
            assert numbers["not_finite"] > 0, metric
        else:
            assert numbers["not_finite"] == 0, metric
            assert numbers["max"] == close(truth["max"]), metric
            assert numbers["mean"] == close(truth["mean"]), metric
        if abs(truth["min"]) < SENTINEL:
            assert numbers["min"] == close(truth["min"]), metric


@pytest.mark.skipif(not NAMES, reason="the published meshes are not here")
@pytest.mark.parametrize("name", NAMES)
def test_A2_quality_gives_verdicts_values_in_file_order(
    name: str, expected: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["quality", "--json", "--cells", str(MESHES / name)]) == 0
    found = json.loads(capsys.readouterr().out)
    for metric, truth in expected[name]["verdict"].items():
        assert len(found[metric]["values"]) == expected[name]["cells"]
        for ours, theirs in zip(found[metric]["values"], truth["first8"], strict=False):
            assert ours is None if abs(theirs) >= SENTINEL else ours == close(theirs), metric
