"""The report of an open mesh is the one that the command line writes."""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest

from hexalab import HexaLabError
from hexalab.formats import read_bytes
from hexalab.report import About, MetricCriterion, ReportPicture, collect, written
from hexalab.session import Session
from tests.core.report.decks import deck

PICTURE = {"title": "Whole.", "alt": "All of it.", "address": "data:image/png;base64,AAAA"}


@pytest.fixture
def opened() -> Session:
    session = Session()
    session.open("folder/part.inp", deck())
    return session


def test_it_is_that_of_the_mesh_with_what_the_page_tells(opened: Session) -> None:
    answer = opened.report("html", {"sha256": "ab" * 32, "unit": "mm", "notes": ["Dark."]}, [PICTURE])
    about = About("part.inp", len(deck()), "ab" * 32, "mm", ("Dark.",))
    facts = collect(read_bytes(deck(), "part.inp"), about)
    assert answer == {
        "text": written(facts, "html", [ReportPicture(**PICTURE)]),
        "ending": "html",
        "passed": False,
    }


def test_what_was_measured_before_changes_nothing(opened: Session) -> None:
    fresh = opened.report("json")["text"]
    opened.quality("oddy")
    opened.group_table()
    assert opened.report("json")["text"] == fresh


def test_criteria_decide(opened: Session) -> None:
    asked = {"criteria": [{"metric": "volume", "minimum": 0}]}
    answer = opened.report("json", criteria=asked)
    assert answer["passed"] and not opened.report("json", criteria=asked, strict=True)["passed"]
    told = collect(read_bytes(deck(), "part.inp"), None, [MetricCriterion("volume", 0)])
    assert json.loads(answer["text"])["verdict"] == told["verdict"]
    with pytest.raises(HexaLabError, match=r"criteria\[0\]: found"):
        opened.report("json", criteria=[{}])
    with pytest.raises(HexaLabError, match="found no form of a report"):
        opened.report("pdf")


def test_an_offered_mesh_has_the_size_that_its_holder_tells(grid: Callable[..., bytes]) -> None:
    meshes = {
        "a": lambda: read_bytes(grid(1, 1, 1), "a.mesh"),
        "b": lambda: read_bytes(grid(1, 1, 2), "b.mesh"),
    }
    session = Session(meshes, {"a": lambda: 77})
    sizes = []
    for name in ("a", "b"):
        session.open_offered(name)
        sizes.append(json.loads(session.report("json")["text"])["file"]["bytes"])
    assert sizes == [77, None]


def test_without_a_mesh_there_is_no_report() -> None:
    for ask in (Session().report, Session().report_poses):
        with pytest.raises(HexaLabError, match="no mesh is open"):
            ask("html")
