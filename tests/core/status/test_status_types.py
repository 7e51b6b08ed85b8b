"""The viewer's type of the status document is the one that the schema makes."""

from __future__ import annotations

import re

from hexalab.status import DEFAULTS
from tests.core.status.status_types import FILE, status_types, type_of


def test_S1_the_viewers_type_of_the_status_is_the_schemas() -> None:
    assert FILE.read_text() == status_types(), (
        "the schema has changed: renew the file with tests/core/status/status_types.py"
    )


def test_types_of_single_settings() -> None:
    assert type_of({"enum": ["lines", "fissure"]}) == '"lines" | "fissure"'
    assert type_of({"const": 2}) == "2"
    assert type_of({"type": ["number", "null"]}) == "number | null"
    assert type_of({"type": "array", "items": {"type": "integer"}}) == "readonly number[]"
    three = {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}
    assert type_of(three) == "readonly [number, number, number]"
    assert type_of({"type": "array", "items": {"enum": [1, 2]}}) == "readonly (1 | 2)[]"


def test_S1_every_setting_of_the_defaults_is_in_the_type() -> None:
    def names(part: object) -> set[str]:
        if isinstance(part, list):
            return set().union(*map(names, part))
        if isinstance(part, dict):
            return set(part).union(*map(names, part.values()))
        return set()

    told = set(re.findall(r"readonly (\w+):", FILE.read_text()))
    assert names(DEFAULTS) <= told
    assert told - names(DEFAULTS) == {"quantity", "minimum", "maximum"}, "those of a quality band"
