"""The tables that the viewer's page carries; truth: the defaults, and the values that the schema's check lets pass."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from hexalab.status import DEFAULTS, check
from site_builder.pages.viewer_tables import viewer_tables

TABLES = viewer_tables()
CHOICES = Path(__file__).parents[3] / "static" / "viewer" / "state" / "choices.js"


def at(document: dict[str, Any], path: str) -> Any:
    for name in path.split("."):
        document = document[name]
    return document


def rejected(path: str, value: Any) -> bool:
    document = value
    for name in reversed(path.split(".")):
        document = {name: document}
    return bool(check(document)[1])


def test_tables_are_json() -> None:
    assert json.loads(json.dumps(TABLES, allow_nan=False)) == json.loads(json.dumps(viewer_tables()))


@pytest.mark.parametrize("path", TABLES["choices"])
def test_choices_are_the_words_that_a_setting_takes(path: str) -> None:
    words = TABLES["choices"][path]
    assert at(DEFAULTS, path) == words[0]
    assert not any(rejected(path, word) for word in words)
    assert rejected(path, "none of them")


@pytest.mark.parametrize("path", TABLES["limits"])
def test_limits_are_the_least_and_the_greatest_that_a_setting_takes(path: str) -> None:
    low, high = TABLES["limits"][path]
    assert not rejected(path, low) and not rejected(path, high)
    assert rejected(path, low - 1) and rejected(path, high + 1)
    default = at(DEFAULTS, path)
    assert default is None or low <= default <= high


def test_every_word_and_limit_of_the_defaults_is_told() -> None:
    assert {"separation.mode", "colour.by", "colour.map", "lighting.mode"} <= TABLES["choices"].keys()
    assert {"irregular.mode", "histogram.bins", "camera.field_of_view"} <= TABLES["limits"].keys()
    assert "version" not in TABLES["choices"]


def test_every_step_of_the_irregular_edges_has_a_name() -> None:
    steps = re.search(r"IRREGULAR_STEPS = \[(.*?)\];", CHOICES.read_text(), re.DOTALL)
    assert steps
    low, high = TABLES["limits"]["irregular.mode"]
    assert len(re.findall(r'"[^"]+"', steps[1])) == high - low + 1
