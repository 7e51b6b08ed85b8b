"""The settings of structure (SPEC T4, T5): defaults, limits, and which of them concern the core."""

from __future__ import annotations

from typing import Any

import pytest

from hexalab import status
from tests.core.status.validator import validator

LOOK = {
    "kind": "none", "chosen": [], "form": "cells", "complex": "whole", "boundary": False, "curves": False,
    "explode": 0,
}  # fmt: skip
FILTER = {
    "enabled": True, "keep": "inside", "complex": "whole", "blocks": [], "sheets": [], "chords": [],
}  # fmt: skip


def test_S1_by_default_nothing_of_the_structure_is_looked_at_or_hidden() -> None:
    assert status.DEFAULTS["structure"] == LOOK
    assert status.DEFAULTS["filters"]["structure"] == FILTER
    assert status.core_part(status.DEFAULTS)["structure"] == LOOK, "all of it concerns the core"
    assert status.core_part(status.DEFAULTS)["filters"]["structure"] == FILTER


RIGHT: list[dict[str, Any]] = [
    *({"structure": {"kind": kind}} for kind in ("none", "arcs", "sheets", "chords", "blocks")),
    *({"structure": {"form": form}} for form in ("cells", "surfaces")),
    *({"structure": {"complex": one}} for one in ("whole", "interior")),
    *({"structure": {"explode": share}} for share in (0, 0.5, 1)),
    {"structure": {"chosen": [7, 0, 7, 2**31]}},
    {"structure": {"boundary": True, "curves": True}},
    *({"filters": {"structure": {"keep": keep}}} for keep in ("inside", "outside")),
    {"filters": {"structure": {"blocks": [1], "sheets": [0, 2], "chords": [3], "complex": "interior"}}},
    *({"colour": {"by": by}} for by in ("block", "chosen")),
    {"colour": {"by": "attribute", "attribute": "structure:distance"}},
    {"see_through": {"cells": "structure"}},
]

WRONG: list[tuple[dict[str, Any], str]] = [
    ({"structure": {"kind": "walls"}}, "structure.kind"),
    ({"structure": {"form": "curves"}}, "structure.form"),
    ({"structure": {"complex": ""}}, "structure.complex"),
    ({"structure": {"explode": -0.01}}, "structure.explode"),
    ({"structure": {"explode": 1.01}}, "structure.explode"),
    ({"structure": {"chosen": [-1]}}, "structure.chosen[0]"),
    ({"structure": {"chosen": [0, "1"]}}, "structure.chosen[1]"),
    ({"structure": {"chosen": None}}, "structure.chosen"),
    ({"structure": {"boundary": 0}}, "structure.boundary"),
    ({"structure": {"nodes": []}}, "structure.nodes"),
    ({"filters": {"structure": {"keep": "some"}}}, "filters.structure.keep"),
    ({"filters": {"structure": {"chords": [0.5]}}}, "filters.structure.chords[0]"),
    ({"filters": {"structure": {"arcs": [0]}}}, "filters.structure.arcs"),
    ({"colour": {"by": "sheet"}}, "colour.by"),
]


@pytest.mark.parametrize("document", RIGHT, ids=str)
def test_S1_what_is_right_is_taken_as_it_is(document: dict[str, Any]) -> None:
    assert validator().is_valid(document)
    assert status.check(document) == (document, [])


@pytest.mark.parametrize(("document", "path"), WRONG, ids=str)
def test_S1_what_is_wrong_is_named(document: dict[str, Any], path: str) -> None:
    assert not validator().is_valid(document)
    _, rejections = status.check(document)
    assert [rejection.path for rejection in rejections] == [path]


def test_S1_settings_from_before_structure_are_read_and_draw_what_they_drew() -> None:
    old = {"version": status.DEFAULTS["version"], "silhouette": 0.5, "filters": {"peel": {"depth": 1}}}
    partial, rejections = status.read(old)
    assert rejections == []
    whole = status.merge(status.DEFAULTS, partial)
    assert (whole["structure"], whole["filters"]["structure"]) == (LOOK, FILTER)


def test_S1_lists_of_structure_replace_each_other() -> None:
    chosen = lambda *numbers: {"structure": {"kind": "sheets", "chosen": [*numbers]}}  # noqa: E731
    merged = status.merge(chosen(1, 2), chosen(3))
    assert merged == chosen(3)
