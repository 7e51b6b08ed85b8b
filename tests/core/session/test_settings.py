"""Settings told to the session, and documents that it checks; truth: counting by hand on small grids."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from hexalab.errors import HexaLabError
from hexalab.session import Session
from hexalab.status import CORE_PATHS, merge
from tests import published
from tests.core.session.checks import ALL, RECORDS, core_settings, shown_of


def test_S2_settings_that_were_told_before_change_nothing(block: Session) -> None:
    changed = {"filters": {"planes": {"items": [{"normal": [0, 1, 0], "offset": 0.3}]}}, "silhouette": 0.5}
    block.update(changed)
    again = block.update(json.loads(json.dumps(changed)))
    assert set(again) & RECORDS == set()
    assert set(block.update(merge(ALL, changed))) & RECORDS == set()


@pytest.mark.parametrize("mode", ["lines", "fissure"])
def test_A1_settings_told_one_by_one_draw_what_they_draw_together(
    block: Session, grid: Callable[..., bytes], mode: str
) -> None:
    """What the page sends is what changed: the session's own part of the status must add up."""
    steps: list[dict[str, Any]] = [
        {"filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.3}]}}},
        {"separation": {"mode": mode}},
        {"filters": {"peel": {"depth": 1}}},
        {"separation": {"gap": 0.3}, "colour": {"by": "quality"}},
        {"filters": {"picking": {"hidden": [21]}, "peel": {"depth": 0}}},
        {"colour": {"metric": "volume", "range": [0, 2]}, "silhouette": 0.25},
    ]
    kept: dict[str, Any] = {}
    for step in steps:
        kept = {**kept, **{name: part for name, part in block.update(step).items() if name in RECORDS}}
    together: dict[str, Any] = {}
    for step in steps:
        together = merge(together, step)
    afresh = Session()
    afresh.open("block.mesh", grid(4, 4, 4))
    whole = afresh.update(together)
    for record in RECORDS - {"irregular", "see_through", "arrows"}:
        for name, value in whole[record].items():
            assert np.array_equal(kept[record][name], value), (record, name)


def test_A1_what_concerns_the_core_stands_in_the_schema_and_nothing_else_is_kept(block: Session) -> None:
    assert set(CORE_PATHS) == {
        "filters", "separation.mode", "separation.gap", "separation.radius", "colour.by", "colour.metric",
        "colour.attribute", "colour.grouping", "colour.range", "colour.reach", "silhouette", "see_through.cells",
        "arrows.attribute", "irregular.mode", "marks", "structure.kind", "structure.chosen", "structure.form",
        "structure.complex", "structure.boundary", "structure.curves", "structure.explode",
        "compare.reference.shown",
    }  # fmt: skip
    assert set(ALL) == {
        "filters", "separation", "colour", "silhouette", "see_through", "arrows", "irregular", "marks",
        "structure", "compare",
    }  # fmt: skip
    assert set(ALL["colour"]) == {"by", "metric", "attribute", "grouping", "range", "reach"}


def test_S1_wrong_values_are_named_and_the_rest_applies(session: Session) -> None:
    checked = session.check(
        {
            "colour": {"by": "quality", "metric": "beauty", "inside": "#00ff00"},
            "filters": {
                "quality": {"items": [{"quantity": "cell:none"}, {"quantity": "volume", "maximum": 9}]}
            },
            "silhouette": 2,
            "separation": {"mode": "fissure"},
        }
    )
    rejections = checked["rejections"]
    assert {rejection["path"] for rejection in rejections} == {
        "colour.metric",
        "filters.quality.items[0].quantity",
        "silhouette",
    }
    assert "scaled_jacobian" in rejections[-2]["expected"] + rejections[-1]["expected"]
    partial = checked["partial"]
    assert partial["colour"] == {"inside": "#00ff00"}
    assert [band["quantity"] for band in partial["filters"]["quality"]["items"]] == ["volume"]
    assert partial["separation"] == {"mode": "fissure"}
    assert session.update(partial)["surface"]["mode"] == "fissure"


def test_S1_bands_of_the_first_version_are_read(session: Session) -> None:
    band = {"source": "volume", "keep": "inside", "minimum": None, "maximum": 9}
    for version in ({"version": 1}, {}):
        checked = session.check({**version, "filters": {"quality": {"items": [band]}}})
        assert checked["rejections"] == []
        (found,) = checked["partial"]["filters"]["quality"]["items"]
        assert found == {"quantity": "volume", "keep": "inside", "minimum": None, "maximum": 9}


def test_S1_an_attribute_of_another_mesh_is_told(session: Session, grid: Callable[..., bytes]) -> None:
    by_load = {"colour": {"by": "attribute", "attribute": "cell:load"}}
    assert session.check(by_load)["rejections"] == []
    session.update(by_load)
    session.open("other.mesh", grid(1, 1, 1))
    assert session.update()["colour"] is None
    checked = session.check(by_load)
    assert [rejection["path"] for rejection in checked["rejections"]] == ["colour.attribute"]
    assert checked["rejections"][0]["expected"] == "nothing: the mesh has none"
    assert checked["partial"]["colour"] == {}


def test_S1_arrows_are_of_attributes_of_three_components(
    session: Session, grid: Callable[..., bytes]
) -> None:
    told = {}
    for attribute in ("point:flow", "", "point:flow:0", "cell:load", "cell:none"):
        checked = session.check({"arrows": {"attribute": attribute, "length": 0.1}})
        told[attribute] = [(one["path"], one["found"], one["expected"]) for one in checked["rejections"]]
        kept = {} if told[attribute] else {"attribute": attribute}
        assert checked["partial"]["arrows"] == {**kept, "length": 0.1}
    assert told["point:flow"] == told[""] == []
    for attribute in ("point:flow:0", "cell:load", "cell:none"):
        expected = "one of the attributes of three components: point:flow"
        assert told[attribute] == [("arrows.attribute", f'"{attribute}"', expected)]
    with pytest.raises(HexaLabError, match="no attribute 'cell:load' of three components"):
        session.update({"arrows": {"attribute": "cell:load"}})
    session.open("other.mesh", grid(1, 1, 1))
    (rejection,) = session.check({"arrows": {"attribute": "point:flow"}})["rejections"]
    assert rejection["expected"] == "nothing: the mesh has no attributes of three components"
    closed = Session().check({"arrows": {"attribute": "point:flow"}})
    assert (closed["rejections"], closed["partial"]) == ([], {"arrows": {"attribute": "point:flow"}})


def test_S1_settings_that_name_what_is_not_there_are_refused_and_change_nothing(session: Session) -> None:
    session.update({"silhouette": 0.25, "filters": {"peel": {"depth": 0}}})
    with pytest.raises(HexaLabError, match="no metric and no attribute 'cell:none'"):
        session.update({"colour": {"by": "attribute", "attribute": "cell:none"}, "silhouette": 0.75})
    with pytest.raises(HexaLabError, match="no metric and no attribute 'x'"):
        session.update({"filters": {"quality": {"items": [{"quantity": "x", "minimum": 0}]}}})
    update = session.update()
    assert update["shown_cells"] == 6
    lost = {"surface", "silhouette", "see_through", "colour"}
    assert set(update) & RECORDS == lost, "what the failed call drew was lost"
    assert set(session.update({"silhouette": 0.25})) & RECORDS == set()


def test_S1_another_mesh_starts_with_the_defaults(session: Session, grid: Callable[..., bytes]) -> None:
    session.update({"filters": {"peel": {"depth": 1}}, "separation": {"mode": "rounded"}})
    session.open("other.mesh", grid(2, 2, 2))
    update = session.update()
    assert set(update) & RECORDS == {"surface", "silhouette", "colour"}
    assert (update["shown_cells"], update["surface"]["mode"]) == (8, "lines")


def test_S4_a_document_of_the_original_is_applied(twisted: bytes) -> None:
    session = Session()
    session.open("twisted.mesh", twisted)
    document = {
        "camera": {"offset": {"x": 1, "y": 0, "z": 0}, "distance": 2},
        "rendering": {"quality_measure": "EdgeRatio", "apply_color_map": True, "geometry_mode": "Cracked"},
        "filters": {"Quality": {"enabled": True, "min": 0, "max": 0.5}},
    }
    checked = session.check(json.dumps(document))
    assert (checked["form"], checked["rejections"]) == ("original", [])
    (band,) = checked["partial"]["filters"]["quality"]["items"]
    worst = session.quality("edge_ratio")["max"]
    assert band["minimum"] == pytest.approx(1 + (worst - 1) / 2)
    update = session.update(core_settings(checked["partial"]))
    assert update["surface"]["mode"] == "fissure"
    assert update["colour"]["quantity"] == "edge_ratio"
    assert shown_of(update) == {1}
    assert checked["partial"]["camera"]["target"] == pytest.approx([1 / 6**0.5, 0, 0])


def test_S1_a_document_that_is_no_json_is_told(session: Session) -> None:
    with pytest.raises(HexaLabError, match="line 1, column 2"):
        session.check("{x")


def test_S4_the_view_of_a_real_picture_of_the_original() -> None:
    from hexalab.png_text import read_settings

    session = Session()
    name = "2012-all-hex-meshing--rod-rod.vtk"
    session.open(name, published.file_of(name).read_bytes())
    checked = session.check(read_settings(published.picture("original-3.png").read_bytes()))
    assert checked["rejections"] == []
    update = session.update(core_settings(checked["partial"]))
    assert update["surface"]["mode"] == "rounded"
    assert update["colour"]["quantity"] == "scaled_jacobian"
    mesh = session._opened.mesh  # type: ignore[union-attr]
    x = mesh.coordinates[0]
    low, high = x.min() - 1e-5, x.max() + 1e-5
    behind = (x[mesh.corners] < low + 0.4000000059604645 * (high - low)).any(axis=0)
    assert update["shown_cells"] == np.count_nonzero(~behind)
