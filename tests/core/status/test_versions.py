"""Documents that were written by older versions of the program still load, whole."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from hexalab import status
from tests.core.status.validator import validator

WRITTEN = json.loads(Path(__file__).with_name("version_1.json").read_text("utf-8"))
"""What version 1.0.0 saved: every setting, with two quality bands."""


def bands_of(document: dict[str, Any]) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = document["filters"]["quality"]["items"]
    return found


def test_S1_a_whole_document_of_version_1_loads() -> None:
    clean, rejections = status.read(WRITTEN)
    assert rejections == []
    assert bands_of(clean) == [
        {"quantity": "scaled_jacobian", "keep": "inside", "minimum": None, "maximum": 0.5},
        {"quantity": "cell:load", "keep": "outside", "minimum": 1, "maximum": 2},
    ]
    expected = {**WRITTEN, "version": status.VERSION}
    expected["camera"] = {"fit": False, **WRITTEN["camera"]}
    expected["filters"] = {**WRITTEN["filters"], "quality": clean["filters"]["quality"]}
    assert clean == expected
    validator().validate(clean)


@pytest.mark.parametrize("section", sorted(WRITTEN.keys() - {"version"}))
def test_S1_parts_of_it_load_with_and_without_the_version(section: str) -> None:
    part = {section: WRITTEN[section]}
    for document in (part, {"version": 1, **part}):
        clean, rejections = status.read(document)
        assert rejections == []
        assert clean[section] == status.read(WRITTEN)[0][section]
        assert clean.get("version", status.VERSION) == status.VERSION


def test_S1_reading_leaves_the_document_as_it_was() -> None:
    before = json.dumps(WRITTEN)
    status.read(WRITTEN)
    assert json.dumps(WRITTEN) == before


@pytest.mark.parametrize(
    "filters", [None, 3, [], {"quality": 1}, {"quality": {"items": 7}}, {"quality": {"items": [3]}}]
)
def test_R10_odd_documents_of_version_1_are_told(filters: Any) -> None:
    clean, rejections = status.read({"version": 1, "filters": filters})
    assert len(rejections) == 1
    assert clean["version"] == status.VERSION


def test_S1_a_band_of_the_present_version_has_no_source() -> None:
    band = {"source": "volume", "keep": "inside", "minimum": None, "maximum": 9}
    clean, rejections = status.read({"version": 2, "filters": {"quality": {"items": [band]}}})
    assert {rejection.path for rejection in rejections} == {
        "filters.quality.items[0].source",
        "filters.quality.items[0].quantity",
    }
    assert bands_of(clean) == []
