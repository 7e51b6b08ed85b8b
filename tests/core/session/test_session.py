"""Session, the door between the viewer and the core; truth: counting by hand on small grids."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from hexalab.errors import HexaLabError, MeshReadError
from hexalab.formats import write_bytes
from hexalab.mesh import Mesh
from hexalab.packing import unpack
from hexalab.quality import METRICS, quality_many
from hexalab.session import DESCRIBED, Session
from hexalab.status import CORE_PATHS, DEFAULTS, core_part, merge
from tests import published
from tests.whole_meshes import WHOLE_MESHES, WholeMesh

ALL = core_part(DEFAULTS)
RECORDS = {"surface", "silhouette", "irregular", "colour"}


def plain(value: Any) -> bool:
    """Whether a result holds only what the worker can hand over."""
    if isinstance(value, dict):
        return all(isinstance(name, str) and plain(part) for name, part in value.items())
    if isinstance(value, list | tuple):
        return all(map(plain, value))
    if isinstance(value, np.ndarray):
        return (
            value.dtype.kind in "iuf" and value.dtype.itemsize < 9 and value.dtype not in ("int64", "uint64")
        )
    return value is None or type(value) in (bool, int, float, str, bytes)


@pytest.fixture
def session(attributed: bytes) -> Session:
    """A session with the 3 x 2 x 1 grid that has attributes."""
    opened = Session()
    opened.open("grid.vtk", attributed)
    return opened


@pytest.fixture
def block(grid: Callable[..., bytes]) -> Session:
    """A session with a grid of 4 x 4 x 4 unit cubes."""
    opened = Session()
    opened.open("block.mesh", grid(4, 4, 4))
    return opened


def core_settings(partial: dict[str, Any]) -> dict[str, Any]:
    """The settings of a checked document under which the core draws, as the page would tell them."""
    return core_part(merge(DEFAULTS, partial))


def shown_of(update: dict[str, Any]) -> set[int]:
    return set((update["surface"]["faces"] // 8).tolist())


def test_A1_summary_of_an_opened_mesh(attributed: bytes) -> None:
    summary = Session().open("grid.vtk", attributed)
    assert plain(summary)
    assert (summary["name"], summary["format"]) == ("grid.vtk", "vtk")
    assert (summary["vertices"], summary["cells"], summary["boundary_faces"]) == (24, 6, 22)
    assert summary["kinds"] == {"hexahedron": 6}
    assert summary["extent"] == [[0, 0, 0], [3, 2, 1]]
    assert summary["centre"] == [1.5, 1, 0.5]
    assert summary["diagonal"] == pytest.approx(14**0.5)
    assert "max_depth" not in summary
    rows = {row["id"]: row for row in summary["attributes"]}
    assert rows["cell:load"] == {"id": "cell:load", "name": "load", "on": "cell", "min": 0, "max": 5}
    assert (rows["point:flow:1"]["min"], rows["point:flow:1"]["max"]) == (0, 2)
    json.dumps(summary)


def test_A1_opening_computes_faces_only(block: Session) -> None:
    topology = block._opened.mesh.topology  # type: ignore[union-attr]
    assert "faces" in vars(topology)
    assert not {"edges", "depth", "_components"} & set(vars(topology))
    first = block.update(ALL)
    assert first["pending"] == ["irregular"]
    assert not {"edges", "depth", "_components"} & set(vars(topology))


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
    for record in RECORDS - {"irregular"}:
        for name, value in whole[record].items():
            assert np.array_equal(kept[record][name], value), (record, name)


def test_A1_what_concerns_the_core_stands_in_the_schema_and_nothing_else_is_kept(block: Session) -> None:
    assert set(CORE_PATHS) == {
        "filters", "separation.mode", "separation.gap", "separation.radius", "colour.by", "colour.metric",
        "colour.attribute", "colour.range", "silhouette", "irregular.mode",
    }  # fmt: skip
    assert set(ALL) == {"filters", "separation", "colour", "silhouette", "irregular"}
    assert set(ALL["colour"]) == {"by", "metric", "attribute", "range"}


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
    assert np.allclose(update["colour"]["map_position"], [0, 0, 0.5, 1, 1, 1])
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


def test_S1_settings_that_name_what_is_not_there_are_refused_and_change_nothing(session: Session) -> None:
    session.update({"silhouette": 0.25, "filters": {"peel": {"depth": 0}}})
    with pytest.raises(HexaLabError, match="no metric and no attribute 'cell:none'"):
        session.update({"colour": {"by": "attribute", "attribute": "cell:none"}, "silhouette": 0.75})
    with pytest.raises(HexaLabError, match="no metric and no attribute 'x'"):
        session.update({"filters": {"quality": {"items": [{"quantity": "x", "minimum": 0}]}}})
    update = session.update()
    assert update["shown_cells"] == 6
    assert set(update) & RECORDS == {"surface", "silhouette", "colour"}, "what the failed call drew was lost"
    assert set(session.update({"silhouette": 0.25})) & RECORDS == set()


def test_S1_another_mesh_starts_with_the_defaults(session: Session, grid: Callable[..., bytes]) -> None:
    session.update({"filters": {"peel": {"depth": 1}}, "separation": {"mode": "rounded"}})
    session.open("other.mesh", grid(2, 2, 2))
    update = session.update()
    assert set(update) & RECORDS == {"surface", "silhouette", "colour"}
    assert (update["shown_cells"], update["surface"]["mode"]) == (8, "lines")


def test_R10_a_failed_open_leaves_the_mesh_that_was_open(session: Session) -> None:
    session.update({"filters": {"picking": {"hidden": [3]}}, "silhouette": 0.25})
    for data in (b"", b"MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0", b"\x89PNG\r\n\x1a\n"):
        with pytest.raises(MeshReadError, match=r"bad\.mesh"):
            session.open("bad.mesh", data)
    update = session.update()
    assert (update["shown_cells"], set(update) & RECORDS) == (5, set())


def test_R9_a_mesh_of_inverted_cells_is_turned_round(grid: Callable[..., bytes]) -> None:
    session = Session()
    summary = session.open("inverted.mesh", grid(2, 2, 2, inverted=True))
    assert "turned" in " ".join(summary["notes"])
    assert session.quality("volume")["min"] == 1
    assert [finding["id"] for finding in session.describe()["findings"]] == ["turned_round"]


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


INSPECTED = (
    "structures/collapsed.mesh",
    "faults/repeated-vertex.mesh",
    "2021-at-most-hexa--cylinder-n-slivers.mesh",
)


@pytest.mark.parametrize("whole", [one for one in WHOLE_MESHES if one.name in INSPECTED], ids=str)
def test_V7_inspector_agrees_with_the_whole_mesh(whole: WholeMesh) -> None:
    session = Session()
    session.open(whole.file().name, whole.file().read_bytes())
    mesh = session._opened.mesh  # type: ignore[union-attr]
    values = quality_many(mesh)
    for cell in (0, 17, whole.cells // 2, whole.cells - 1):
        told = session.inspect(cell)
        assert plain(told)
        for metric, value in told["metrics"].items():
            whole = values[metric][cell]
            assert value == pytest.approx(whole, rel=1e-12) if np.isfinite(whole) else value is None
        assert set(told["metrics"]) == set(METRICS)


def test_V7_inspector(session: Session) -> None:
    told = session.inspect(1)
    assert (told["kind"], told["validity"]) == ("hexahedron", "valid")
    assert told["corners"] == [1, 2, 6, 5, 13, 14, 18, 17]
    assert told["coordinates"][0] == [1, 0, 0]
    assert sorted(told["neighbours"]) == [-1, -1, -1, 0, 2, 4]
    assert told["metrics"]["volume"] == 1
    assert told["attributes"] == {
        "load": 1,
        "height (mean of corners)": 1.5,
        "flow (mean of corners)": [1.5, 0.5, 0.5],
    }
    assert session.cell_view(1)["size"] == pytest.approx((3 / 14) ** 0.5)
    assert session.cell_view(1)["centre"] == pytest.approx(list(np.array([0, -0.5, 0]) / 14**0.5))
    for cell in (-1, 6):
        with pytest.raises(HexaLabError, match=f"no cell {cell}"):
            session.inspect(cell)


def test_F4_the_cell_behind_a_face(session: Session) -> None:
    behind = {session.neighbour(8 * 1 + local) for local in range(6)}
    assert behind == {-1, 0, 2, 4}
    assert session.neighbour(8 * 1 + 3) == 2


def test_R9_findings_and_their_cells(twisted: bytes) -> None:
    session = Session()
    session.open("twisted.mesh", twisted)
    told = session.describe()
    assert plain(told)
    assert told["components"] == 1
    assert (told["faces"], told["edges"], told["cells_per_depth"], told["max_depth"]) == (11, 20, [2], 0)
    assert told["findings"]
    for finding in told["findings"]:
        cells = session.finding_cells(finding["id"])
        assert cells.dtype == np.uint32
        assert set(cells.tolist()) <= {0, 1}
    assert any(session.finding_cells(finding["id"]).tolist() == [1] for finding in told["findings"])
    with pytest.raises(HexaLabError, match="found no 'x'"):
        session.finding_cells("x")


def test_R9_of_a_finding_about_vertices_the_cells_around_them_are_given() -> None:
    cube = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)
    apart = np.concatenate([cube + np.array([x, 0, 0]) for x in (0, 1, 5)])
    mesh = Mesh.from_cells(apart, np.arange(24))
    session = Session()
    session.open("apart.mesh", write_bytes(mesh, "mesh"))
    assert "coincident_vertices" in {finding["id"] for finding in session.describe()["findings"]}
    assert session.finding_cells("coincident_vertices").tolist() in ([0, 1], [1], [0])


def test_R9_the_description_comes_in_parts(block: Session) -> None:
    whole = block.describe()
    parts = [block.describe(part) for part in DESCRIBED]
    assert {name: fact for part in parts for name, fact in part.items()} == whole
    assert [set(part) for part in parts[:2]] == [
        {"faces", "boundary_faces", "nonmanifold_faces"},
        {"edges", "interior_edge_valence", "boundary_edge_valence"},
    ]
    with pytest.raises(HexaLabError, match="no part 'x'"):
        block.describe("x")


def test_Q6_validity(twisted: bytes) -> None:
    session = Session()
    session.open("twisted.mesh", twisted)
    told = session.validity()
    assert plain(told)
    assert (told["valid"], told["invalid"], told["undecided"]) == (1, 1, 0)
    assert told["invalid_cells"].tolist() == [1]


def test_O2_preview(session: Session) -> None:
    session.update({"filters": {"picking": {"hidden": [0]}}})
    data = session.preview()
    assert isinstance(data, bytes)
    found = unpack(data)
    assert found["summary"]["cells"] == 6
    assert found["summary"]["centre"] == [1.5, 1, 0.5]
    assert (found["shown_cells"], found["shown_faces"]) == (6, 22)
    assert len(found["surface"]["positions"]) == 12 * len(found["surface"]["faces"]) == 12 * 22
    assert found["colour"] is None
    assert session.update()["shown_cells"] == 5


def test_A1_without_a_mesh() -> None:
    session = Session()
    assert session.check({"silhouette": 0.5})["partial"] == {"silhouette": 0.5}
    for call in (session.update, session.describe, session.validity, session.preview):
        with pytest.raises(HexaLabError, match="no mesh is open"):
            call()


def test_P7_values_are_kept_within_bounds(block: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    opened = block._opened
    assert opened is not None
    monkeypatch.setattr("hexalab.session.opened.MOST_BYTES_OF_VALUES", 2 * 64 * 8)
    first = opened.values("volume")
    assert opened.values("volume") is first
    opened.values("skew")
    opened.values("taper")
    assert opened.values("volume") is not first
    assert len(opened._values) == 2


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
