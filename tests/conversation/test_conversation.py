"""One whole conversation between a viewer and a core, through every way there is; truth: counting by hand."""

from __future__ import annotations

import gzip
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser

from benchmarks.page import SITE, serve
from hexalab.formats import read_bytes, write_bytes
from hexalab.groups import Group
from hexalab.mesh import Mesh
from hexalab.quality import METRICS
from hexalab.quality.sizes import NEEDS as SIZED
from hexalab.session.door import METHODS
from tests.conversation.ways import OFFERED, WAYS, Ask, Refused

pytestmark = pytest.mark.browser
ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def shelf(tmp_path_factory: pytest.TempPathFactory, attributed: bytes) -> Path:
    """A folder under /bench/ of the served site, with the harness in it, and a mesh."""
    folder = tmp_path_factory.mktemp("conversation")
    (folder / OFFERED).write_bytes(attributed)
    command = [ROOT / "node_modules/.bin/esbuild", Path(__file__).with_name("harness.js"), "--bundle"]
    subprocess.run(
        [*map(str, command), f"--outfile={folder / 'conversation.js'}"], check=True, capture_output=True
    )
    return folder


@pytest.fixture(scope="module")
def site(shelf: Path) -> Iterator[str]:
    if not (SITE / "viewer" / "index.html").is_file():
        pytest.fail("the site is not built: run `make build`")
    with serve(shelf) as address:
        yield address


@pytest.fixture(scope="module", params=list(WAYS))
def ask(request: pytest.FixtureRequest, chromium: Browser, site: str, shelf: Path) -> Iterator[Ask]:
    with WAYS[request.param](chromium, site, shelf) as way:
        yield way


@pytest.fixture
def said() -> set[str]:
    """The methods that were asked for."""
    return set()


SINGLE = ("mode", "quads", "two_sided")
"""Fields of the surface of a flat mode that are no arrays."""


def test_A1_a_whole_conversation(ask: Ask, said: set[str], attributed: bytes, twisted: bytes) -> None:
    def say(method: str, *args: Any) -> Any:
        said.add(method)
        return ask(method, *args)

    with pytest.raises(Refused, match="no mesh is open") as refused:
        say("update")
    assert refused.value.kind == "HexaLabError"
    assert say("check", {"silhouette": 0.5, "nonsense": 1})["rejections"][0]["path"] == "nonsense"

    with pytest.raises(Refused, match="nothing is offered by the name of 'none'"):
        say("open_offered", "none")

    summary = say("open", "grid.vtk", attributed)
    assert (summary["name"], summary["vertices"], summary["cells"]) == ("grid.vtk", 24, 6)
    assert {row["id"] for row in summary["attributes"]} >= {"cell:load", "point:height", "point:flow"}

    first = say("update")
    assert (first["shown_cells"], first["shown_faces"], first["pending"]) == (6, 22, ["irregular"])
    surface = first["surface"]
    assert {name: array.dtype for name, array in surface.items() if name not in SINGLE} == {
        "positions": np.float32, "normals": np.int16, "cells": np.uint32, "inside": np.uint8,
        "faces": np.uint32, "edges": np.float32, "edge_cells": np.uint8,
        "edge_faces": np.uint32,
    }  # fmt: skip
    assert [surface[name] for name in SINGLE] == ["lines", None, False]
    assert len(surface["faces"]) == 22
    low, high = (
        surface["positions"].reshape(-1, 3).min(axis=0),
        surface["positions"].reshape(-1, 3).max(axis=0),
    )
    assert np.allclose((high - low) * 14**0.5, [3, 2, 1], atol=1e-6)
    assert first["colour"] is None

    half = {"filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.5, "enabled": True}]}}}
    lean = say("update", half, True)
    assert (lean["shown_cells"], "silhouette" in lean, len(lean["surface"]["edges"])) == (4, False, 0)
    again = say("update", {})
    assert (again["shown_cells"], len(again["silhouette"]["positions"]) > 0) == (4, True)
    assert set(say("update", {}).keys() & {"surface", "silhouette", "irregular", "colour"}) == set()

    coloured = say("update", {"colour": {"by": "attribute", "attribute": "cell:load"}})["colour"]
    assert (coloured["quantity"], coloured["low"], coloured["high"]) == ("cell:load", 0, 5)
    assert coloured["map_position"].dtype == np.float32
    assert np.allclose(coloured["map_position"], np.arange(6) / 5)
    with pytest.raises(Refused, match="no metric and no attribute 'cell:none'"):
        say("update", {"colour": {"attribute": "cell:none"}})
    assert say("update", {"colour": {"by": "sides"}})["shown_cells"] == 4

    saved = say("save_cells", "vtk", ["volume"], ["cell:load"])
    part = read_bytes(saved["data"].tobytes(), "part.vtk")
    assert (saved["cells"], part.cell_count, saved["notes"]) == (4, 4, [])
    assert part.cell_data["load"].tolist() == part.cell_data["original_cell"].tolist() == [1, 2, 4, 5]
    assert part.cell_data["volume"].tolist() == [1, 1, 1, 1]

    numbers = say("quality", "cell:load")
    assert (numbers["min"], numbers["max"], numbers["mean"], numbers["best_value"]) == (0, 5, 2.5, None)
    assert say("quality", "edge_ratio")["full_range"] == [1, None]
    bins = say("histogram", "cell:load", 3, True)
    assert bins["counts"].tolist() == [1, 1, 2], "cells 1, 2, 4, 5 are shown"
    assert (bins["counts"].dtype, bins["edges"].dtype) == (np.uint32, np.float64)

    worst = say("worst", "cell:load", 2)
    assert (worst["cells"], worst["values"], worst["not_finite"]) == ([5, 4], [5, 4], [])
    assert worst["places"][0] == [2.5, 1.5, 0.5]
    assert say("values", "cell:load").tolist() == [0, 1, 2, 3, 4, 5]

    told = say("inspect", 1)
    assert (told["kind"], told["corners"]) == ("hexahedron", [1, 2, 6, 5, 13, 14, 18, 17])
    assert set(told["metrics"]) == set(METRICS)
    assert (told["pending"], told["metrics"]["relative_size_squared"]) == (list(SIZED), None)
    assert say("value", 1, "relative_size_squared")["pending"]
    assert say("measure_sizes") is True, "six cells are one share"
    assert say("value", 1, "relative_size_squared")["value"] == 1
    assert say("inspect", 1)["pending"] == []
    flow = say("value", 1, "point:flow")
    assert flow["components"] == [1.5, 0.5, 0.5]
    view = say("cell_view", 1)
    assert view["size"] == pytest.approx((3 / 14) ** 0.5)
    assert view["edges"].shape == (12 * 6,)
    assert say("cut_to", 1, [1, 0, 0]) == pytest.approx(0.5)
    assert say("neighbour", 8 * 1 + 3) == 2
    assert say("describe", "faces") == {"faces": 29, "boundary_faces": 22, "nonmanifold_faces": 0}
    assert say("validity")["valid"] == 6

    told = {
        form: say("report", form, {"sha256": "ab" * 32})["text"] for form in ("html", "md", "json", "xml")
    }
    assert all("ab" * 32 in text and "grid.vtk" in text for text in told.values())
    assert say("report", "json", {}, [], [{"metric": "volume", "minimum": 2}])["passed"] is False
    with pytest.raises(
        Refused, match=r"criteria\[0\]\.metric: found 'Volume', expected .*; did you mean volume"
    ):
        say("report", "json", {}, [], [{"metric": "Volume", "minimum": 2}])
    assert len(say("report_poses", "mm")) == 3

    with pytest.raises(Refused, match=r"bad\.mesh.*line") as refused:
        say("open", "bad.mesh", b"MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0")
    assert refused.value.kind == "MeshReadError"
    assert say("update", {})["shown_cells"] == 4, "the mesh that was open stays open"

    assert say("open", "twisted.mesh.gz", gzip.compress(twisted))["cells"] == 2
    fresh = say("update")
    assert (fresh["shown_cells"], "surface" in fresh) == (2, True)
    assert "invalid_corner_cells" in {finding["id"] for finding in say("describe")["findings"]}
    cells = say("finding_cells", "invalid_corner_cells")
    assert (cells.dtype, cells.tolist()) == (np.uint32, [1])
    assert say("validity")["invalid_cells"].tolist() == [1]

    say("open", "grid.vtk", attributed)
    talk_of_structure(say)
    talk_of_groups(say)
    talk_of_two(say, attributed)
    assert said == set(METHODS), "every method is asked for once at least"


def talk_of_structure(say: Callable[..., Any]) -> None:
    """Of a box of 3 x 2 x 1 cells: six sheets, eleven chords, one block, and no irregular edge inside."""
    assert say("inspect", 0)["structure"] is None
    steps = [say("trace")]
    while steps[-1]["next"]:
        steps.append(say("trace"))
    assert [step["done"] for step in steps] == list(range(1, steps[-1]["of"] + 1))
    facts = say("structure_facts")
    assert (facts["sheets"]["count"], facts["chords"]["count"], facts["class"]) == (6, 11, "regular")
    assert facts["base_complex"]["dims"] == {"1x2x3": 1}
    table = say("structure_table", "blocks")
    columns = {column["id"]: column["values"] for column in table["columns"]}
    assert (table["rows"], columns["cells"].tolist(), columns["cells"].dtype) == (1, [6], np.int32)
    assert say("structure_csv", "blocks").splitlines() == ["number,cells,kind,i,j,k", "0,6,box,1,2,3"]
    pairs = say("sheet_pairs")
    crossing = pairs["crossings"] > 0
    assert (pairs["count"], np.count_nonzero(crossing)) == (6, 3 * 2 + 2 * 1 + 3 * 1)
    sheets = say("inspect", 0)["structure"]["sheets"]
    assert len(set(sheets)) == 3
    assert say("structure_box", "blocks", [0])["centre"] == pytest.approx([0, 0, 0])
    looked = say("update", {"structure": {"kind": "sheets", "chosen": sheets[:1], "form": "surfaces"}})
    assert looked["surface"]["two_sided"] is True
    assert len(looked["see_through"]["faces"]) == 22
    say("update", {"structure": {"kind": "none"}})


def talk_of_groups(say: Callable[..., Any]) -> None:
    """Three cubes in a row, elements 30, 20 and 10, the first two of steel."""
    places = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in range(4)], dtype=float)
    corners = [[n + c for c in (0, 1, 5, 4, 8, 9, 13, 12)] for n in range(3)]
    groups = (
        Group("STEEL", "elset", [0, 1]),
        Group("GLASS", "elset", [2]),
        Group("N", "nset", [0], "vertex"),
    )
    deck = Mesh.from_cells(places, corners, groups=groups, cell_numbers=np.array([30, 20, 10]))
    assert say("open", "deck.inp", write_bytes(deck, "inp"))["cells"] == 3
    listed = say("describe", "groups")["groups"]
    assert [(row["id"], row["count"]) for row in listed] == [
        ("elset:STEEL", 2),
        ("elset:GLASS", 1),
        ("nset:N", 1),
    ]
    assert say("numbers")["cells"].tolist() == [30, 20, 10]
    found = say("find", "cell", 20)
    assert (found["rows"], found["around"].tolist(), found["place"]) == ([1], [0, 1, 2], [1.5, 0.5, 0.5])
    with pytest.raises(Refused, match="no element 7: its numbers are from 10 to 30"):
        say("find", "cell", 7)
    assert say("cell_list", [0, 2], "elset", "BAD") == "*ELSET, ELSET=BAD\n30, 10\n"
    assert [row["volume"] for row in say("group_table")] == [2, 1]
    (meet,) = say("interfaces", "elset")
    assert (meet["groups"], meet["faces"], meet["apart"]) == (["elset:STEEL", "elset:GLASS"], 1, 0)
    hidden = say(
        "update", {"filters": {"groups": {"hidden": ["elset:GLASS"]}}, "marks": {"nodes": ["nset:N"]}}
    )
    assert (hidden["shown_cells"], hidden["marks"]["counts"]) == (2, {"nodes": 1})
    coloured = say("update", {"colour": {"by": "group", "grouping": "elset"}})["colour"]
    assert coloured["map_position"][0] == coloured["map_position"][1] != coloured["map_position"][2]


def talk_of_two(say: Callable[..., Any], attributed: bytes) -> None:
    """A box of 3 x 2 x 1, beside itself one to the right; then beside a square above it."""
    say("open", "grid.vtk", attributed)
    with pytest.raises(Refused, match="the mesh is compared with nothing"):
        say("measure_distance")
    handed = say("hand_over", say("fingerprint"))
    assert (handed["vertices"], handed["cells"], handed["volume"]) == (24, 6, pytest.approx(6))
    assert (handed["points"].size, handed["triangles"].size) == (3 * 24, 3 * 44)
    points, coordinates = (handed[name].reshape(3, -1).copy() for name in ("points", "coordinates"))
    points[0] += 1
    coordinates[0] += 1
    told = {**{name: handed[name] for name in ("vertices", "cells", "volume")}, "name": "moved"}
    blocks = [array.tobytes() for array in (points, handed["triangles"], coordinates)]
    compared = say("compare_with", told, *blocks, True)
    assert (compared["same_cells"], compared["displacement"]["max"], compared["volume_ratio"]) == (True, 1, 1)
    measured = {"done": 0}
    while measured["done"] < measured.get("of", 1):
        measured = say("measure_distance")
    assert measured == {"done": 24, "of": 24}
    facts = say("distance_facts", False, 2)["there"]
    assert (facts["max"], facts["max_percent"], facts["vertices"]) == (1, 50, 24)
    assert say("distance_csv").splitlines()[:2] == ["vertex,x,y,z,distance", "0,0.0,0.0,0.0,1.0"]
    assert say("metric_changes", "volume") == {
        "worse": 0, "better": 0, "same": 6, "largest_loss": 0, "cells": [],
    }  # fmt: skip
    assert say("quality", "compare:displacement")["mean"] == 1
    drawn = say("update", {"compare": {"reference": {"shown": True}}})["reference"]["positions"]
    assert drawn.reshape(-1, 4, 3)[:, :, 0].max() == pytest.approx((4 - 1.5) / 14**0.5)
    with pytest.raises(Refused, match="nothing is offered by the name of 'none'"):
        say("compare_with_offered", "none")
    square = "OFF\n4 1 0\n0 0 3\n3 0 3\n3 2 3\n0 2 3\n4 0 1 2 3\n"
    assert say("compare_with_surface", "square.off", square.encode())["surface"]["triangles"] == 2
    facet = ["facet", "outer loop", *["vertex 0 0 3", "vertex 3 0 3", "vertex 3 2 3"], "endloop", "endfacet"]
    solid = "\n".join(["solid a", *facet, "endsolid a", ""])
    assert say("compare_with_surface", "one.stl", solid.encode())["surface"]["triangles"] == 1
    say("compare_with_surface", "square.off", square.encode())
    say("measure_distance", True)
    both = say("distance_facts", True)
    assert (both["there"]["max"], both["back"]["max"], both["back"]["vertices"]) == (3, 2, 4)
    assert say("stop_comparing") is None
    gone = say("update", {})
    assert len(gone["reference"]["positions"]) == 0


@pytest.mark.parametrize("method", ["_opened", "__init__", "preview", "formats", "x; import os"])
def test_A5_nothing_else_can_be_asked(ask: Ask, method: str) -> None:
    with pytest.raises(Refused, match="nothing can be asked by the name"):
        ask(method)


def test_A5_what_is_at_hand_is_opened_without_its_bytes(ask: Ask, shelf: Path) -> None:
    if not ask.offers:
        pytest.skip("a browser's own core has nothing at hand")
    file = shelf / OFFERED
    before = file.read_bytes()
    summary = ask("open_offered", OFFERED)
    assert (summary["name"], summary["cells"]) == (OFFERED, 6)
    assert ask("update")["shown_faces"] == 22
    file.write_bytes(b"# vtk DataFile Version 3.0\n")
    try:
        with pytest.raises(Refused, match=r"offered\.vtk") as refused:
            ask("open_offered", OFFERED)
        assert refused.value.kind == "MeshReadError"
        assert ask("update")["shown_cells"] == 6, "the mesh that was open stays open"
        file.unlink()
        with pytest.raises(Refused, match="No such file") as refused:
            ask("open_offered", OFFERED)
    finally:
        file.write_bytes(before)
    assert ask("open_offered", OFFERED)["cells"] == 6


def test_O5_arguments_that_are_none_are_told(ask: Ask) -> None:
    with pytest.raises(Refused):
        ask("inspect")
    with pytest.raises(Refused):
        ask("open", "a.mesh", {"$bytes": 7})
    assert ask("check", {})["rejections"] == []


def test_P2_many_picked_cells_pass_through(ask: Ask, grid: Callable[..., bytes]) -> None:
    ask("open", "block.mesh", grid(30, 30, 30))
    picked = {"filters": {"picking": {"hidden": list(range(0, 27_000, 2))}}}
    assert ask("update", picked)["shown_cells"] == 13_500


def test_O5_a_core_that_was_started_anew_answers(ask: Ask, attributed: bytes) -> None:
    page = ask.page
    if page is None:
        pytest.skip("this way has no core of its own to lose")
    page.evaluate("() => again()")
    with pytest.raises(Refused, match="no mesh is open"):
        ask("update")
    assert ask("open", "grid.vtk", attributed)["cells"] == 6
