"""The stack: order, switches, and that what it keeps is never stale."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hexalab.filters import FilterStack, Regulariser, band, peel, pick
from hexalab.filters.plane import any_corner_places, barycentre_places, plane
from hexalab.mesh import Mesh
from hexalab.status import DEFAULTS
from tests.core.filters.boxes import box

MESH = box(5, 4, 3)
COUNT = MESH.cell_count
VALUES = {
    "scaled_jacobian": np.linspace(-0.2, 1, COUNT),
    "skew": np.where(np.arange(COUNT) % 7, np.linspace(0, 1, COUNT), np.nan),
    "cell:t": np.cos(np.arange(COUNT)),
}


def by_hand(mesh: Mesh, filters: dict[str, Any]) -> list[bool]:
    """All filters in SPEC's order, nothing kept."""
    hidden = np.zeros(mesh.cell_count, bool)
    planes = filters["planes"]
    for item in planes["items"] if planes["enabled"] else ():
        if planes["rule"] == "barycentre":
            places = barycentre_places(mesh.barycentres, item["normal"])
        else:
            places = any_corner_places(mesh.coordinates, mesh.corners, mesh.referenced, item["normal"])
        if item["enabled"]:
            hidden |= plane(places, item["offset"])
    if filters["peel"]["enabled"]:
        hidden |= peel(mesh.topology.depth, filters["peel"]["depth"])
    if filters["regularisation"]["enabled"]:
        hidden = Regulariser(mesh.topology).regularise(hidden, filters["regularisation"]["strength"])
    for item in filters["quality"]["items"] if filters["quality"]["enabled"] else ():
        worst = {"scaled_jacobian": -np.inf, "skew": np.inf, "cell:t": np.nan}[item["quantity"]]
        ends = item["minimum"], item["maximum"]
        hidden |= band(VALUES[item["quantity"]], item["keep"], *ends, worst)
    picking = filters["picking"]
    if picking["enabled"]:
        hidden = pick(hidden, picking["isolated"], picking["hidden"], picking["shown"])
    return (~hidden).tolist()


unit = st.sampled_from([0, 0.2, 0.5, 0.8, 1])
end = st.sampled_from([None, -0.1, 0.3, 0.6])
cells = st.lists(st.integers(0, COUNT - 1), max_size=3)
often = st.sampled_from([True, True, False])
sections = st.fixed_dictionaries(
    {
        "planes": st.fixed_dictionaries(
            {
                "enabled": often,
                "rule": st.sampled_from(["barycentre", "any_corner"]),
                "items": st.lists(
                    st.fixed_dictionaries(
                        {
                            "enabled": often,
                            "normal": st.sampled_from([[1, 0, 0], [0.2, -1, 0.5], [0, 0, -1]]),
                            "offset": unit,
                        }
                    ),
                    max_size=2,
                ),
            }
        ),
        "peel": st.fixed_dictionaries({"enabled": often, "depth": st.integers(0, 3)}),
        "regularisation": st.fixed_dictionaries({"enabled": often, "strength": st.integers(0, 2)}),
        "quality": st.fixed_dictionaries(
            {
                "enabled": often,
                "items": st.lists(
                    st.fixed_dictionaries(
                        {
                            "quantity": st.sampled_from(sorted(VALUES)),
                            "keep": st.sampled_from(["inside", "outside"]),
                            "minimum": end,
                            "maximum": end,
                        }
                    ),
                    max_size=2,
                ),
            }
        ),
        "picking": st.fixed_dictionaries(
            {"enabled": often, "isolated": st.booleans(), "hidden": cells, "shown": cells}
        ),
    }
)


@given(st.lists(sections, min_size=1, max_size=8))
@settings(max_examples=80, deadline=None)
def test_F6_the_stack_equals_the_filters_one_by_one_in_any_sequence(sequence: list[dict[str, Any]]) -> None:
    stack = FilterStack(MESH, VALUES.__getitem__)
    for filters in sequence:
        shown = stack.apply(filters)
        assert shown.tolist() == by_hand(MESH, filters)
        shown[:] = False


@given(sections)
@settings(max_examples=60, deadline=None)
def test_V3_what_some_filters_hide_by_themselves(filters: dict[str, Any]) -> None:
    stack = FilterStack(MESH, VALUES.__getitem__)
    stack.apply(filters)
    groups = {
        "cut": ("planes", "peel", "regularisation"),
        "quality": ("quality",),
        "picking": ("picking",),
    }
    for group, names in groups.items():
        alone = {**DEFAULTS["filters"], **{name: filters[name] for name in names}}
        assert (~stack.hidden_by(group, filters)).tolist() == by_hand(MESH, alone)
    assert not stack.hidden_by("parts", filters).any()
    assert stack.hidden_by("parts", {"parts": {"hidden": [0]}}).all()


def test_F6_nothing_is_hidden_by_defaults_or_by_nothing() -> None:
    stack = FilterStack(MESH, VALUES.__getitem__)
    assert stack.apply(DEFAULTS["filters"]).all()
    assert stack.apply({}).all()


def test_F6_a_moved_plane_measures_nothing_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    stack = FilterStack(MESH, VALUES.__getitem__)
    stack.apply({"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.2}]}})
    monkeypatch.setattr("hexalab.filters.stack.barycentre_places", None)
    stack.apply({"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.4}]}})
    with pytest.raises(TypeError):
        stack.apply({"planes": {"items": [{"normal": [0, 1, 0], "offset": 0.4}]}})


def test_P7_places_kept_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    stack = FilterStack(MESH, VALUES.__getitem__)
    for turn in range(40):
        stack.places([1, 0, turn])
    assert len(stack._places) == 32
    monkeypatch.setattr("hexalab.filters.stack.MOST_BYTES_OF_PLACES", 0)
    first = stack.places([0, 1, 0])
    assert len(stack._places) == 1
    assert stack.places([0, 1, 0]) is first


def test_F1_places_tell_the_ends_of_the_slider() -> None:
    stack = FilterStack(MESH, VALUES.__getitem__)
    assert stack.places([2, 0, 0])[1:] == (0.5, 4.5)
    assert stack.places([0, 0, 1], "any_corner")[1:] == (0, 3)
