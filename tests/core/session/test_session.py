"""Session: opening, describing, single cells; truth: counting by hand on small grids."""

from __future__ import annotations

import json
from collections.abc import Callable

import numpy as np
import pytest

from hexalab.errors import HexaLabError, MeshReadError
from hexalab.formats import write_bytes
from hexalab.mesh import Mesh
from hexalab.packing import unpack
from hexalab.quality import METRICS, quality_many
from hexalab.session import DESCRIBED, Session
from tests.core.session.checks import ALL, RECORDS, plain
from tests.whole_meshes import WHOLE_MESHES, WholeMesh

INSPECTED = (
    "structures/collapsed.mesh",
    "faults/repeated-vertex.mesh",
    "2021-at-most-hexa--cylinder-n-slivers.mesh",
)


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
    assert rows["cell:load"] == {
        "id": "cell:load", "name": "load", "on": "cell", "components": 1, "min": 0, "max": 5,
    }  # fmt: skip
    assert (rows["point:flow:1"]["min"], rows["point:flow:1"]["max"]) == (0, 2)
    outline = summary.pop("outline")
    assert (outline.dtype, len(outline) % 3) == ("float32", 0)
    json.dumps(summary)


@pytest.mark.parametrize("cells", [16, 64, 100, 120])
def test_A1_opening_computes_faces_only(grid: Callable[..., bytes], cells: int) -> None:
    block = Session()
    block.open("block.mesh", grid(cells, 2, 2))  # coarser ones are looked through for parts that strayed, too
    topology = block._opened.mesh.topology  # type: ignore[union-attr]
    assert "faces" in vars(topology)
    assert not {"edges", "depth", "_components"} & set(vars(topology))
    first = block.update(ALL)
    assert first["pending"] == ["irregular"]
    assert not {"edges", "depth", "_components"} & set(vars(topology))


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


@pytest.mark.parametrize("whole", [one for one in WHOLE_MESHES if one.name in INSPECTED], ids=str)
def test_V7_inspector_agrees_with_the_whole_mesh(whole: WholeMesh) -> None:
    session = Session()
    session.open(whole.file().name, whole.file().read_bytes())
    mesh = session._opened.mesh  # type: ignore[union-attr]
    values = quality_many(mesh)
    while not session.measure_sizes():
        pass
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
    assert [set(part) for part in parts[:3]] == [
        {"groups", "features"},
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
