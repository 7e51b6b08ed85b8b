"""An update that fails leaves nothing behind that would pass for done: the next one brings the whole picture."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from hexalab.filters.stack import FilterStack
from hexalab.packing import unpack
from hexalab.session import Session, door, picture
from hexalab.session.opened import Opened
from hexalab.topology import Topology
from tests.core.conftest import grid_points, legacy_vtk
from tests.core.session.checks import RECORDS

HALF = {
    "filters": {"planes": {"items": [{"enabled": True, "normal": [1, 0, 0], "offset": 0.5}]}},
    "colour": {"by": "quality"},
    "see_through": {"cells": "cut"},
    "irregular": {"mode": 3},
    "arrows": {"attribute": "point:flow"},
}
STEPS = {
    "the filters": (FilterStack, "apply"),
    "the surface": (picture, "extract_surface"),
    "the silhouette": (picture, "extract_silhouette"),
    "the arrows": (picture, "extract_arrows"),
    "what is seen through": (FilterStack, "hidden_by"),
    "the irregular structure": (Opened, "irregular"),
    "the colours": (picture, "map_positions"),
    "the count of faces": (Topology, "interface"),
    "the layers": (Opened, "max_depth"),
    "the planes' ranges": (Opened, "plane_ranges"),
    "the answer": (door, "lay_out"),
}


class Once:
    """A function that runs out of memory the first time, after its work is done or before."""

    def __init__(self, work: Callable[..., Any], late: bool) -> None:
        self.work, self.late, self.failed = work, late, False

    def __get__(self, owner: Any, kind: Any = None) -> Callable[..., Any]:
        return self if owner is None else lambda *words, **more: self(owner, *words, **more)

    def __call__(self, *words: Any, **more: Any) -> Any:
        if self.failed:
            return self.work(*words, **more)
        self.failed = True
        if self.late:
            self.work(*words, **more)
        raise MemoryError


def asked(core: door.Door, *words: Any) -> dict[str, Any]:
    return unpack(core.answer("update", json.dumps(words)).joined())


@pytest.mark.parametrize("late", [False, True], ids=["before", "after"])
@pytest.mark.parametrize("step", STEPS)
def test_R10_after_an_update_that_failed_the_next_brings_the_whole_picture(
    monkeypatch: pytest.MonkeyPatch, step: str, late: bool
) -> None:
    points, cells = grid_points((4, 4, 4))
    flow = [" ".join(map(str, point)) for point in points]
    data = legacy_vtk(points, cells, f"POINT_DATA {len(points)}", "VECTORS flow double", *flow)
    cores = []
    for _ in range(2):
        session = Session()
        session.open("block.vtk", data)
        session.describe("edges")
        session.update()
        cores.append(door.Door(session))
    owner, name = STEPS[step]
    once = Once(getattr(owner, name), late)
    with monkeypatch.context() as patch:
        patch.setattr(owner, name, once)
        assert asked(cores[0], HALF)["error"]["kind"] == "MemoryError"
    assert once.failed
    whole = step == "the answer"  # of which the session can't know that it got lost: whoever asked does
    again, fresh = asked(cores[0], HALF, False, whole)["result"], asked(cores[1], HALF, False, True)["result"]
    assert again.keys() & RECORDS == RECORDS
    assert (again["shown_cells"], again["shown_faces"]) == (32, fresh["shown_faces"])
    for record in RECORDS:
        for part, value in fresh[record].items():
            np.testing.assert_array_equal(again[record][part], value)


def test_R10_the_whole_picture_comes_when_it_is_asked_for(block: Session) -> None:
    block.update({"colour": {"by": "quality"}})
    assert not block.update().keys() & RECORDS
    came = block.update({}, False, True)
    assert came.keys() & RECORDS == {"surface", "silhouette", "see_through", "colour"}
    assert not len(came["see_through"]["faces"]), "what was switched off may be on the screen still"
