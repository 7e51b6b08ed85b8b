"""The status document's schema and checks, held against the jsonschema library."""

from __future__ import annotations

import json
from copy import deepcopy
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hexalab import HexaLabError, status
from hexalab.status.schema import Schema
from tests.core.status.validator import jsonschema, validator
from tests.counting import lines_of_core

KNOWN_KEYWORDS = {
    "$schema", "title", "description", "type", "properties", "additionalProperties", "required", "default",
    "const", "enum", "minimum", "maximum", "exclusiveMinimum", "items", "minItems", "maxItems", "contains",
    "pattern", "minLength", "maxLength", "core",
}  # fmt: skip


REQUIRED = {"planes": {"normal": [0, 0, 1]}, "quality": {"quantity": "volume"}}


def subschemas(schema: Schema, path: tuple[Any, ...] = ()) -> list[tuple[tuple[Any, ...], Schema]]:
    found = [(path, schema)]
    for name, part in schema.get("properties", {}).items():
        found += subschemas(part, (*path, name))
    if "items" in schema:
        found += subschemas(schema["items"], (*path, 0))
    return found


def placed(path: tuple[Any, ...], value: Any) -> Any:
    """A partial document that holds one value at a path; items of lists get what they require."""
    for step in reversed(path):
        if step != 0:
            value = {step: value}
        elif isinstance(value, dict):
            value = [{**REQUIRED.get(path[1], {}), **value}]
        else:
            value = [value] * 3
    return value


def test_S1_schema_is_a_json_schema_of_keywords_that_the_checker_knows() -> None:
    jsonschema.Draft202012Validator.check_schema(status.SCHEMA)
    used = {keyword for _, schema in subschemas(status.SCHEMA) for keyword in schema}
    assert used <= KNOWN_KEYWORDS


def test_S1_defaults_are_complete_and_valid() -> None:
    validator().validate(status.DEFAULTS)
    clean, rejections = status.check(status.DEFAULTS)
    assert (clean, rejections) == (status.DEFAULTS, [])
    for path, schema in subschemas(status.SCHEMA):
        part: Any = status.DEFAULTS
        if 0 in path or schema.get("type") == "object":
            continue
        for name in path:
            part = part[name]
        assert part == schema["default"], path


def test_S2_round_trip_through_text_changes_nothing() -> None:
    text = json.dumps(status.DEFAULTS)
    clean, rejections = status.check(json.loads(text))
    assert not rejections
    assert json.dumps(status.merge(status.DEFAULTS, clean)) == text


def test_S1_partial_documents_apply_what_they_hold() -> None:
    partial = {"colour": {"by": "quality"}, "filters": {"peel": {"depth": 2}}}
    clean, rejections = status.check(partial)
    merged = status.merge(status.DEFAULTS, clean)
    assert not rejections
    expected = deepcopy(status.DEFAULTS)
    expected["colour"]["by"] = "quality"
    expected["filters"]["peel"]["depth"] = 2
    assert merged == expected
    assert status.DEFAULTS["colour"]["by"] == "sides"


def test_S1_a_list_replaces_a_list_and_its_items_are_completed() -> None:
    clean, rejections = status.check({"filters": {"planes": {"items": [{"normal": [0, 1, 0]}]}}})
    assert not rejections
    assert clean["filters"]["planes"]["items"] == [{"enabled": True, "normal": [0, 1, 0], "offset": 0}]


@pytest.mark.parametrize(
    ("partial", "path", "found", "words"),
    [
        ({"camera": {"distance": -1}}, "camera.distance", "-1", "above 0"),
        ({"camera": {"distance": float("nan")}}, "camera.distance", "NaN", "a number"),
        ({"camera": {"up": [0, 0, 0]}}, "camera.up", "[0, 0, 0]", "not all 0"),
        ({"camera": {"up": [0, 1]}}, "camera.up", "[0, 1]", "3 numbers"),
        ({"camera": {"target": [0, "1", 0]}}, "camera.target[1]", '"1"', "a number"),
        ({"separation": {"mode": "smooth"}}, "separation.mode", '"smooth"', "rounded"),
        ({"background": "white"}, "background", '"white"', "colour such as #"),
        ({"background": "#ffffff\n"}, "background", '"#ffffff\\n"', "colour"),
        ({"irregular": {"mode": 2.5}}, "irregular.mode", "2.5", "whole number from 0 to 6"),
        ({"irregular": {"boundary": 1}}, "irregular.boundary", "1", "true or false"),
        ({"silhouette": True}, "silhouette", "true", "a number from 0 to 1"),
        ({"silhouet": 1}, "silhouet", "1", "one of version, mesh"),
        ({"colour": {"range": [1]}}, "colour.range", "[1]", "2 numbers or null"),
        ({"filters": []}, "filters", "[]", "object"),
        ({"filters": {"planes": {"items": [{}]}}}, "filters.planes.items[0].normal", "nothing", "3"),
        ({"histogram": {"bins": 10**400}}, "histogram.bins", "1000", "1 to 1000"),
        ({"colour": {"metric": ""}}, "colour.metric", '""', "not empty"),
        ({"mesh": {"sha256": "abc"}}, "mesh.sha256", '"abc"', "64 hexadecimal"),
    ],
)  # fmt: skip
def test_S1_a_wrong_value_is_named_and_the_rest_applies(
    partial: dict[str, Any], path: str, found: str, words: str
) -> None:
    clean, rejections = status.check({**deepcopy(partial), "lighting": {"mode": "direct"}})
    assert [rejection.path for rejection in rejections] == [path]
    assert rejections[0].found.startswith(found)
    assert words in rejections[0].expected
    assert clean["lighting"] == {"mode": "direct"}
    assert status.check(clean) == (clean, [])


def test_S1_a_wrong_cell_number_leaves_the_others() -> None:
    clean, rejections = status.check({"filters": {"picking": {"hidden": [3, -1, 5.0, "7"]}}})
    assert clean["filters"]["picking"]["hidden"] == [3, 5]
    assert [rejection.path for rejection in rejections] == [
        "filters.picking.hidden[1]",
        "filters.picking.hidden[3]",
    ]


def test_F6_a_hundred_thousand_picked_cells_are_checked_at_once() -> None:
    def lines(count: int) -> int:
        document = {"filters": {"picking": {"hidden": list(range(count))}}}
        return lines_of_core(lambda: status.check(document))[0]

    assert lines(100_000) == lines(10), "no line of Python runs for each cell"
    cells = list(range(100_000))
    clean, rejections = status.check({"filters": {"picking": {"hidden": cells}}})
    assert clean["filters"]["picking"]["hidden"] == cells
    assert not rejections
    assert len(status.check({"filters": {"picking": {"hidden": [True, -2, 1.5, 4]}}})[1]) == 3


@pytest.mark.parametrize("document", [None, 3, "text", [], [{}]])
def test_S1_what_is_no_object_is_refused(document: Any) -> None:
    clean, rejections = status.check(document)
    assert clean == {}
    assert len(rejections) == 1


def test_S1_a_newer_document_applies_as_far_as_it_is_known() -> None:
    clean, rejections = status.read({"version": 7, "silhouette": 0.5, "holograms": True})
    assert clean == {"version": status.VERSION, "silhouette": 0.5}
    assert [rejection.path for rejection in rejections] == ["version", "holograms"]


JSON_VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-3, 70)
    | st.floats(-2, 2)
    | st.sampled_from(["", "lines", "jet", "#ffffff", "#12345", "inside", "scaled_jacobian", "a" * 64]),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.sampled_from("abc"), inner, max_size=2),
    max_leaves=5,
)
PLACES = [path for path, _ in subschemas(status.SCHEMA) if path]


@settings(max_examples=400, deadline=None)
@given(st.sampled_from(PLACES), JSON_VALUES)
def test_S1_checker_agrees_with_jsonschema(path: tuple[Any, ...], value: Any) -> None:
    document = placed(path, value)
    clean, rejections = status.check(document)
    assert (not rejections) == validator().is_valid(document)
    validator().validate(clean)
    validator().validate(status.merge(status.DEFAULTS, clean))


@settings(max_examples=200, deadline=None)
@given(JSON_VALUES)
def test_S1_any_json_is_answered(value: Any) -> None:
    clean, rejections = status.read(value)
    validator().validate(clean)
    for rejection in rejections:
        assert set(rejection.as_dict()) == {"path", "found", "expected"}
        assert rejection.expected in str(rejection)


def test_S2_text_that_is_no_json_is_told_as_such() -> None:
    for text in ("", "{", "[" * 100_000, "9" * 5000, '{"version": ' + "9" * 5000 + "}"):
        with pytest.raises(HexaLabError):
            status.parse(text)


def test_S2_a_byte_order_mark_before_the_text_is_no_error() -> None:
    assert status.parse('\N{BYTE ORDER MARK}{"silhouette": 0.5}') == {"silhouette": 0.5}
