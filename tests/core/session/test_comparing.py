"""A session beside another, or beside a reference surface (SPEC S6, S7): colours, filters, histograms, what is kept."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from hexalab import HexaLabError, Mesh, quality
from hexalab.cells import TETRAHEDRON
from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes, write_bytes
from hexalab.quality import METRICS
from hexalab.session import Session, prepared
from tests.core.conftest import grid_points

WORSE = {"quantity": "change:scaled_jacobian", "keep": "inside", "minimum": None, "maximum": 0}
SQUARE = b"OFF\n4 1 0\n0 0 2\n3 0 2\n3 2 2\n0 2 2\n4 0 1 2 3\n"


def grid(shape: tuple[int, int, int] = (3, 2, 1)) -> Mesh:
    return Mesh.from_cells(*grid_points(shape))


def pushed(mesh: Mesh, vertex: int, way: tuple[float, float, float]) -> Mesh:
    coordinates = mesh.coordinates.copy()
    coordinates[:, vertex] += way
    return replace(mesh, coordinates=coordinates)


def opened(mesh: Mesh, name: str = "mesh.vtk") -> Session:
    session = Session()
    session.open(name, write_bytes(mesh, "vtk"))
    session.update()
    return session


def tell(session: Session, other: Session, second: bool = True) -> dict[str, Any]:
    """Compare as whoever holds both sessions does."""
    handed = other.hand_over(session.fingerprint())
    told = {name: handed[name] for name in ("name", "vertices", "cells", "volume")}
    blocks = [handed[name] for name in ("points", "triangles", "coordinates")]
    given = [None if block is None else block.tobytes() for block in blocks]
    return session.compare_with(told, *given, second)  # type: ignore[arg-type]


def colour(session: Session, **settings: Any) -> dict[str, Any]:
    return dict(session.update({"colour": settings})["colour"])


BEFORE = grid()
AFTER = pushed(pushed(grid(), 0, (0.3, 0.2, 0.1)), 3, (0.1, 0, 0))


def test_S6_changes_are_coloured_with_no_change_in_the_middle() -> None:
    session = opened(BEFORE)
    tell(session, opened(AFTER))
    drawn = colour(session, by="attribute", attribute="change:volume")
    change = quality(AFTER, "volume") - quality(BEFORE, "volume")
    most = np.abs(change).max()
    assert (drawn["low"], drawn["high"]) == (pytest.approx(-most), pytest.approx(most))
    better = METRICS["volume"].better == "high"
    assert drawn["high_first"] is better
    share = (change + most) / (2 * most)
    assert drawn["map_position"] == pytest.approx(1 - share if better else share, abs=1e-6)
    assert drawn["map_position"][change == 0] == pytest.approx(0.5)


def test_S6_a_metric_of_which_low_is_better_gets_worse_as_it_grows() -> None:
    session = opened(BEFORE)
    tell(session, opened(AFTER))
    drawn = colour(session, by="attribute", attribute="change:skew")
    change = quality(AFTER, "skew") - quality(BEFORE, "skew")
    assert change.max() > 0
    assert drawn["map_position"][int(change.argmax())] == pytest.approx(1)
    assert session.worst("change:skew", 1)["cells"] == [int(change.argmax())]
    assert session.worst("change:scaled_jacobian", 1)["cells"] == [
        int((quality(AFTER, "scaled_jacobian") - quality(BEFORE, "scaled_jacobian")).argmin())
    ]


def test_S6_only_what_got_worse_is_shown_on_either_side() -> None:
    first, second = opened(BEFORE), opened(AFTER)
    tell(first, second), tell(second, first, second=False)
    change = quality(AFTER, "scaled_jacobian") - quality(BEFORE, "scaled_jacobian")
    worse = np.flatnonzero(change < -1e-9)
    assert 0 < len(worse) < 6
    for session in (first, second):
        told = session.update({"filters": {"quality": {"enabled": True, "items": [WORSE]}}})
        assert told["shown_cells"] == len(worse)
        assert set(told["surface"]["cells"].tolist()) == set(worse.tolist())
        assert session.metric_changes("scaled_jacobian")["worse"] == len(worse)
        outside = {**WORSE, "keep": "outside", "minimum": 0, "maximum": None}
        told = session.update({"filters": {"quality": {"items": [outside]}}})
        assert told["shown_cells"] == len(worse), "the same from the other side"
        around = {**WORSE, "minimum": -1e-12, "maximum": 1e-12}
        told = session.update({"filters": {"quality": {"items": [around]}}})
        assert told["shown_cells"] == np.count_nonzero(abs(change) < 1e-12), (
            "what did not change, if that is asked"
        )


def test_S6_cells_without_the_metric_are_not_among_those_that_got_worse() -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], dtype=float)
    corners = np.array([[0, 1, 2, 2, 3, 3, 3, 3], [1, 2, 4, 4, 3, 3, 3, 3]]).T
    before = Mesh(points.T.copy(), corners, np.full(2, TETRAHEDRON, np.uint8))
    session = opened(before)
    tell(session, opened(pushed(before, 4, (0.5, 0, 0))))
    counts = session.metric_changes("skew")
    assert (counts["worse"], counts["better"], counts["same"]) == (0, 0, 0)
    item = {**WORSE, "quantity": "change:skew", "minimum": 0, "maximum": None}
    assert session.update({"filters": {"quality": {"enabled": True, "items": [item]}}})["shown_cells"] == 0


def test_S6_colours_and_histogram_are_made_for_the_range_of_both() -> None:
    session = opened(AFTER)
    own = quality(AFTER, "volume")
    alone = colour(session, by="quality", metric="volume")
    reach = [0.0, 4.0]
    both = colour(session, reach=reach)
    assert (both["low"], both["high"]) == (0, 4)
    assert both["map_position"] == pytest.approx(1 - METRICS["volume"].normalise(own, *reach), abs=1e-6)
    assert np.abs(both["map_position"] - alone["map_position"]).max() > 0.1
    bins = session.histogram("volume", 4)
    assert bins["edges"].tolist() == [0, 1, 2, 3, 4]
    assert int(bins["counts"].sum()) == 6
    session.update({"colour": {"by": "sides"}})
    assert session.histogram("volume", 4)["edges"].tolist() == [0, 1, 2, 3, 4], "it is still looked at"
    assert session.histogram("shape", 4)["high"] <= 1, "another metric has its own"


def test_S7_the_distance_of_a_cell_is_that_of_its_farthest_vertex_and_none_inside() -> None:
    session = opened(grid((3, 3, 3)))
    session.compare_with_surface("square.off", SQUARE)
    values = session.values("compare:distance")
    assert np.isnan(values).tolist() == [cell == 13 for cell in range(27)]
    assert np.nanmax(values[:9]) == pytest.approx((2**2 + 1) ** 0.5), (
        "its corner at y = 3 is one beside the square"
    )
    assert session.quality("compare:distance")["not_finite"] == 1


def test_S7_another_counterpart_takes_the_place_of_the_one_before() -> None:
    session = opened(BEFORE)
    tell(session, opened(AFTER))
    first = session.values("change:volume")
    shown = session.update({"filters": {"quality": {"enabled": True, "items": [WORSE]}}})["shown_cells"]
    tell(session, opened(BEFORE))
    assert first.any()
    assert not session.values("change:volume").any()
    assert session.update({})["shown_cells"] == 0 != shown
    tell(session, opened(AFTER))
    assert session.update({})["shown_cells"] == shown


def test_S7_a_broken_surface_leaves_what_was_compared() -> None:
    session = opened(BEFORE)
    tell(session, opened(AFTER))
    with pytest.raises(MeshReadError, match=r"bad\.stl"):
        session.compare_with_surface("bad.stl", b"solid a\nfacet normal 0 0\n")
    assert session.metric_changes("volume")["worse"] > 0


def test_S6_other_cells_have_no_changes_but_distances() -> None:
    session = opened(BEFORE)
    told = tell(session, opened(grid((3, 2, 2))))
    assert (told["same_cells"], told["displacement"]) == (False, None)
    assert told["difference"] == "24 and 36 vertices, 6 and 12 cells"
    assert told["volume_ratio"] == pytest.approx(2)
    for ask in (
        lambda: session.metric_changes("volume"),
        lambda: session.values("change:volume"),
        lambda: session.update({"colour": {"by": "attribute", "attribute": "compare:displacement"}}),
    ):
        with pytest.raises(HexaLabError, match="has not the same cells"):
            ask()
    assert session.quality("compare:distance")["max"] == pytest.approx(1), (
        "what is the top here is inside there"
    )


def test_S6_nothing_is_told_without_a_comparison_and_after_it() -> None:
    session = opened(BEFORE)
    for after in (False, True):
        if after:
            tell(session, opened(AFTER))
            session.update({"compare": {"reference": {"shown": True}}})
            session.stop_comparing()
            assert not len(session.update({})["reference"]["positions"])
        with pytest.raises(HexaLabError, match="compared with nothing"):
            session.metric_changes("volume")
        with pytest.raises(HexaLabError, match="compared with nothing"):
            session.distance_facts()


def test_S6_another_mesh_is_compared_with_nothing() -> None:
    session = opened(BEFORE)
    tell(session, opened(AFTER))
    session.open("next.vtk", write_bytes(BEFORE, "vtk"))
    with pytest.raises(HexaLabError, match="compared with nothing"):
        session.distance_facts()


def test_S7_the_way_back_is_measured_where_it_is_asked_for() -> None:
    session = opened(BEFORE)
    session.compare_with_surface("square.off", SQUARE)
    assert session.measure_distance(False) == {"done": 24, "of": 24}
    assert session.measure_distance(True) == {"done": 28, "of": 28}
    facts = session.distance_facts(True, 10.0)
    assert (facts["there"]["max"], facts["there"]["max_percent"]) == (2, 20)
    assert (facts["back"]["max"], facts["back"]["vertices"]) == (1, 4)
    rows = [line.split(",") for line in session.distance_csv().splitlines()[1:]]
    assert [float(row[4]) for row in rows] == [2.0] * 12 + [1.0] * 12


def test_S7_displacements_are_arrows() -> None:
    session = opened(BEFORE)
    tell(session, opened(pushed(grid(), 0, (0, 0, -1))))
    arrows = session.update({"arrows": {"attribute": "compare:displacement"}})["arrows"]
    assert arrows["longest"] == pytest.approx(1)


MEDIT_SQUARE = (
    b"MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 2 0\n3 0 2 0\n3 2 2 0\n0 2 2 0\n"
    b"Quadrilaterals\n1\n1 2 3 4 0\nEnd\n"
)


def test_S7_an_offered_file_of_faces_alone_is_a_surface() -> None:
    offers = {"0": lambda: prepared(BEFORE), "1": lambda: read_bytes(MEDIT_SQUARE, "square.mesh")}
    session = Session(offers)
    session.open_offered("0")
    session.update()
    told = session.compare_with_offered("1")
    assert (told["name"], told["surface"]["triangles"]) == ("square.mesh", 2)
    assert session.distance_facts() is not None
