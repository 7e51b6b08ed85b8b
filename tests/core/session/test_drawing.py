"""What an update of the settings draws and shows; truth: counting by hand on small grids."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from hexalab.quality import METRICS, quality_many
from hexalab.session import Session
from tests.core.conftest import grid_points, legacy_vtk
from tests.core.session.checks import ALL, RECORDS, plain, shown_of


def test_A1_the_first_update_brings_all_and_the_second_nothing(block: Session) -> None:
    first = block.update(ALL)
    assert plain(first)
    assert set(first) & RECORDS == {"surface", "silhouette", "colour"}
    assert first["colour"] is None
    assert (first["shown_cells"], first["shown_faces"]) == (64, 96)
    assert first["max_depth"] is None
    assert len(first["surface"]["faces"]) == 96
    second = block.update(ALL)
    assert set(second) & RECORDS == set()
    assert second["pending"] == ["irregular"]
    assert not {"status", "rejections"} & set(second)


@pytest.mark.parametrize("mode", ["lines", "darkness_coded_edges", "fissure", "rounded"])
def test_P2_what_a_lean_update_leaves_out_comes_with_the_next(
    block: Session, grid: Callable[..., bytes], mode: str
) -> None:
    half = {
        "filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.5}]}},
        "separation": {"mode": mode},
    }
    lean = block.update(half, lean=True)
    assert "silhouette" not in lean
    assert len(lean["surface"]["edges"]) == len(lean["surface"]["edge_cells"]) == 0
    more = block.update(half)
    afresh = Session()
    afresh.open("block.mesh", grid(4, 4, 4))
    whole = afresh.update(half)
    assert len(whole["silhouette"]["positions"]) == len(more["silhouette"]["positions"]) > 0
    lined = mode in ("lines", "darkness_coded_edges")
    assert ("surface" in more) == lined
    surface = more["surface"] if lined else lean["surface"]
    for name in ("positions", "normals", "faces", "edges", "edge_cells"):
        assert np.array_equal(surface[name], whole["surface"][name]), name
    assert (len(surface["edges"]) > 0) == lined
    assert set(block.update(half)) & RECORDS == set()


def test_V3_hidden_cells_that_are_seen_through_are_those_that_were_chosen(block: Session) -> None:
    half = {
        "planes": {"items": [{"normal": [1, 0, 0], "offset": 0.5}]},
        "picking": {"hidden": [3], "shown": [0]},
    }
    cells = lambda update: sorted(set(update["see_through"]["cells"].tolist()))  # noqa: E731
    every = block.update({"filters": half, "see_through": {"cells": "all"}})
    hidden = [cell for cell in range(64) if cell not in shown_of(every)]
    assert cells(every) == hidden and 3 in hidden and 0 not in hidden
    assert len(every["see_through"]["edges"]) > 0
    cut = block.update({"see_through": {"cells": "cut"}})
    assert set(cut) & RECORDS == {"see_through"} and cells(cut) == [cell for cell in hidden if cell % 4 < 2]
    assert cells(block.update({"see_through": {"cells": "picking"}})) == [3]
    assert "see_through" not in block.update({"filters": {"peel": {"depth": 1}}}, lean=True)
    assert cells(block.update()) == [3]
    off = block.update({"see_through": {"cells": "none"}})
    assert set(off) & RECORDS == {"see_through"} and cells(off) == [], "once more, empty"
    assert set(block.update()) & RECORDS == set()


def test_R8_arrows_follow_the_shown_cells_the_attribute_and_the_gap(session: Session) -> None:
    assert "arrows" not in session.update()
    first = session.update({"arrows": {"attribute": "point:flow"}})
    assert plain(first)
    assert set(first) & RECORDS == {"arrows"}
    assert sorted(first["arrows"]["cells"].tolist()) == sorted(
        (session.update(whole=True)["surface"]["faces"] // 8).tolist()
    )
    assert first["arrows"]["longest"] == pytest.approx(14**0.5)
    assert set(session.update({"arrows": {"length": 0.2, "colour": "#ff0000"}})) & RECORDS == set()
    assert set(session.update({"colour": {"by": "quality"}})) & RECORDS == {"colour"}
    cut = {"filters": {"picking": {"hidden": [2, 5]}}}
    lean = session.update(cut, lean=True)
    assert "surface" in lean and "arrows" not in lean
    after = session.update()
    assert set(after["arrows"]["cells"].tolist()) == {0, 1, 3, 4}
    assert after["arrows"]["longest"] == first["arrows"]["longest"], "a slice does not change the scale"
    assert set(session.update({"arrows": {"attribute": ""}})) & RECORDS == set()
    assert set(session.update({"arrows": {"attribute": "point:flow"}})) & RECORDS == set()
    moved = session.update({"separation": {"mode": "fissure", "gap": 0.2}})["arrows"]
    assert np.array_equal(moved["cells"], after["arrows"]["cells"])
    assert not np.allclose(moved["positions"], after["arrows"]["positions"])
    assert "arrows" in session.update({"separation": {"gap": 0.1}})
    assert "arrows" not in session.update({"separation": {"radius": 0.1}})
    back = session.update({"separation": {"mode": "rounded"}})["arrows"]
    assert np.array_equal(back["positions"], after["arrows"]["positions"])


def test_R8_arrows_of_another_attribute_are_sent(block: Session) -> None:
    points, cells = grid_points((2, 1, 1))
    rows = lambda values: [" ".join(map(str, row)) for row in values]  # noqa: E731
    flow, force = ["VECTORS flow double", *rows(points)], ["VECTORS force double", *rows(-2 * points)]
    block.open("two.vtk", legacy_vtk(points, cells, f"POINT_DATA {len(points)}", *flow, *force))
    first = block.update({"arrows": {"attribute": "point:flow"}})["arrows"]
    other = block.update({"arrows": {"attribute": "point:force"}})["arrows"]
    assert (first["longest"], other["longest"]) == pytest.approx((6**0.5, 2 * 6**0.5))
    assert np.allclose(first["vectors"], -other["vectors"])
    block.update({"arrows": {"attribute": "point:flow"}}, lean=True)
    assert block.update()["arrows"]["longest"] == first["longest"]


def test_V4_irregular_structure_comes_after_the_description(block: Session) -> None:
    block.update(ALL)
    block.describe()
    update = block.update()
    assert update["pending"] == []
    assert set(update) & RECORDS == {"irregular"}
    assert update["irregular"]["counts"]["interior"] == {}
    assert update["irregular"]["counts"]["boundary"] == {"1": 48}
    assert set(block.update({"irregular": {"mode": 2}})) & RECORDS == set()
    assert len(block.update({"irregular": {"mode": 5}})["irregular"]["paper"]) > 0
    assert set(block.update({"irregular": {"mode": 0}})) & RECORDS == set()


@pytest.mark.parametrize("offset", [0, 0.1, 0.5, 0.9, 1])
def test_F1_a_slice_shows_the_cells_before_the_plane(block: Session, offset: float) -> None:
    block.update(ALL)
    update = block.update({"filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": offset}]}}})
    x = np.arange(64) % 4 + 0.5
    behind = x < 0.5 + 3 * offset if offset < 1 else np.ones(64, bool)
    expected = set(np.flatnonzero(~behind).tolist())
    assert update["shown_cells"] == len(expected)
    if offset:
        assert shown_of(update) <= expected
        assert set(update) & RECORDS == {"surface", "silhouette"}
        assert len(update["silhouette"]["positions"]) == 12 * np.count_nonzero(
            behind[np.array(boundary_cells())]
        )
        assert update["plane_ranges"][0] == pytest.approx([-1.5 / 48**0.5, 1.5 / 48**0.5])
    else:
        assert update["plane_ranges"] == [None]


def boundary_cells() -> list[int]:
    """The cell of each of the 96 boundary faces of the 4 x 4 x 4 grid."""
    found = []
    for cell in range(64):
        places = (cell % 4, cell // 4 % 4, cell // 16)
        found += [cell] * sum((place == 0) + (place == 3) for place in places)
    return found


def test_F1_a_slice_that_hides_the_same_cells_sends_nothing(block: Session) -> None:
    block.update({"filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.4}]}}})
    update = block.update({"filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.45}]}}})
    assert set(update) & RECORDS == set()


def test_F2_peel(block: Session) -> None:
    update = block.update({"filters": {"peel": {"depth": 1}}})
    inner = [x + 4 * y + 16 * z for z in (1, 2) for y in (1, 2) for x in (1, 2)]
    assert shown_of(update) == set(inner)
    assert (update["shown_cells"], update["shown_faces"], update["max_depth"]) == (8, 24, 1)
    assert (update["surface"]["inside"] == 255).all()
    everything = block.update({"filters": {"peel": {"depth": 2}}})
    assert (everything["shown_cells"], everything["shown_faces"]) == (0, 0)
    assert len(everything["surface"]["positions"]) == 0


def test_F3_R8_cells_are_filtered_by_attributes_and_metrics(session: Session) -> None:
    band = {"quantity": "cell:load", "minimum": 2, "maximum": 3}
    update = session.update({"filters": {"quality": {"items": [band]}}})
    assert shown_of(update) == {2, 3}
    update = session.update({"filters": {"quality": {"items": [{**band, "keep": "outside"}]}}})
    assert update["shown_cells"] in (4, 6)  # the ends themselves may count to either side
    update = session.update({"filters": {"quality": {"items": [{"quantity": "point:height", "maximum": 1}]}}})
    assert shown_of(update) == {0, 3}
    update = session.update({"filters": {"quality": {"items": [{"quantity": "volume", "minimum": 2}]}}})
    assert update["shown_cells"] == 0


def test_F4_picked_cells(session: Session) -> None:
    picking = {"filters": {"picking": {"isolated": True, "shown": [4, 99]}}}
    checked = session.check(picking)
    assert [rejection["path"] for rejection in checked["rejections"]] == ["filters.picking.shown"]
    assert checked["partial"]["filters"]["picking"]["shown"] == [4]
    assert shown_of(session.update(checked["partial"])) == {4}
    assert session.update(picking)["shown_cells"] == 1


def test_P6_recolouring_sends_colours_only(session: Session) -> None:
    session.update(ALL)
    update = session.update({"colour": {"by": "quality", "metric": "volume"}})
    assert set(update) & RECORDS == {"colour"}
    assert update["colour"]["label"] == "Volume"
    assert set(session.update({"colour": {"map": "jet", "outside": "#123456"}})) & RECORDS == set()
    update = session.update({"colour": {"by": "attribute", "attribute": "cell:load"}})
    assert set(update) & RECORDS == {"colour"}
    assert np.allclose(update["colour"]["map_position"], np.arange(6) / 5)
    assert (update["colour"]["low"], update["colour"]["high"]) == (0, 5)
    update = session.update({"colour": {"range": [1, 3]}})
    assert np.allclose(update["colour"]["map_position"], [-0.5, 0, 0.5, 1, 1.5, 1.5])
    assert update["colour"]["high_first"] is False
    assert (session.update({"colour": {"by": "kind"}})["colour"]["map_position"] == 0).all()
    assert session.update({"colour": {"by": "sides"}})["colour"] is None
    assert plain(update)


def test_Q2_the_best_value_has_the_first_colour(twisted: bytes) -> None:
    session = Session()
    session.open("twisted.mesh", twisted)
    for metric, row in METRICS.items():
        values = quality_many(session._opened.mesh, [metric])[metric]  # type: ignore[union-attr]
        update = session.update({"colour": {"by": "quality", "metric": metric}})
        positions = update["colour"]["map_position"]
        assert update["colour"]["quantity"] == metric
        assert np.array_equal(np.isnan(positions), ~np.isfinite(values))
        if np.isfinite(values).all():
            better = np.argmax(values) if row.better == "high" else np.argmin(values)
            assert positions[better] == positions.min()


def test_F4_the_cell_behind_a_face(session: Session) -> None:
    behind = {session.neighbour(8 * 1 + local) for local in range(6)}
    assert behind == {-1, 0, 2, 4}
    assert session.neighbour(8 * 1 + 3) == 2
