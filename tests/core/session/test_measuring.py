"""Numbers for the panels: statistics and histograms; truth: counting by hand on small grids."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.errors import HexaLabError
from hexalab.session import Session
from tests.core.session.checks import plain


def test_Q3_statistics_with_what_the_table_knows(session: Session) -> None:
    numbers = session.quality("edge_ratio")
    assert plain(numbers)
    assert (numbers["id"], numbers["symbol"], numbers["low"], numbers["high"]) == ("edge_ratio", "ER", 1, 1)
    assert numbers["full_range"] == [1, None]
    load = session.quality("cell:load")
    assert (load["mean"], load["low"], load["high"], load["best_value"]) == (2.5, 0, 5, None)
    with pytest.raises(HexaLabError, match="no metric and no attribute 'x'"):
        session.quality("x")


def test_Q4_histogram_counts_every_finite_cell(session: Session) -> None:
    told = session.histogram("cell:load", 3)
    assert plain(told)
    assert told["counts"].tolist() == [2, 2, 2]
    assert np.allclose(told["map_position"], [1 / 6, 1 / 2, 5 / 6])
    session.update({"filters": {"picking": {"hidden": [0, 5]}}})
    assert session.histogram("cell:load", 3, True)["counts"].tolist() == [1, 2, 1]
    sj = session.histogram("scaled_jacobian", 10)
    assert (sj["low"], sj["high"]) == (0, 1)
    assert sj["counts"].tolist() == [0] * 9 + [6]
    assert (np.diff(sj["map_position"]) < 0).all()


def test_Q4_the_histograms_axis_holds_negative_scaled_jacobians(twisted: bytes) -> None:
    session = Session()
    session.open("twisted.mesh", twisted)
    told = session.histogram("scaled_jacobian", 20)
    assert told["low"] == session.quality("scaled_jacobian")["min"] < 0
    assert told["counts"].sum() == 2
    assert told["map_position"][0] == 1


def test_R8_an_attribute_without_a_finite_value_is_borne(attributed: bytes) -> None:
    session = Session()
    text = attributed.decode()
    head, tail = text.split("LOOKUP_TABLE default\n", 1)
    session.open("nan.vtk", (head + "LOOKUP_TABLE default\n" + "nan\n" * 6 + tail.split("\n", 6)[6]).encode())
    update = session.update({"colour": {"by": "attribute", "attribute": "cell:load"}})
    assert np.isnan(update["colour"]["map_position"]).all()
    assert (update["colour"]["low"], session.quality("cell:load")["min"]) == (None, None)
    told = session.histogram("cell:load", 4)
    assert (told["low"], told["high"], told["not_finite"]) == (0, 1, 6)
    assert told["counts"].sum() == 0


def test_R8_a_constant_attribute_has_the_first_colour(attributed: bytes) -> None:
    session = Session()
    session.open("grid.vtk", attributed)
    session.update({"filters": {"planes": {"items": []}}})
    update = session.update({"colour": {"by": "attribute", "attribute": "cell:load", "range": [9, 9]}})
    assert (update["colour"]["map_position"] == 0).all()
