"""SPEC R11, R12: a session's numbers and groups; coloured, hidden, measured, found."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from hexalab.diagnosis import diagnose
from hexalab.errors import HexaLabError
from hexalab.formats import write_bytes
from hexalab.group_facts import group_measures, interfaces
from hexalab.grouping import Grouping
from hexalab.groups import Features, Group
from hexalab.mesh import Mesh
from hexalab.quality import certify, quality
from hexalab.session import Session
from hexalab.session.grouped import apart
from tests.core.formats.samples import grid


def row_of_cubes() -> Mesh:
    """Six cubes in a row, the last of them inverted; three materials, two sets that overlap, numbers of their own."""
    sample = grid(6, 1, 1)
    sample.points = np.round(sample.points)
    cells = sample.rows_of(0).copy()
    cells[5] = cells[5][[4, 5, 6, 7, 0, 1, 2, 3]]
    return Mesh.from_cells(
        sample.points,
        cells,
        cell_numbers=np.array([70, 60, 50, 40, 30, 20]),
        vertex_numbers=np.arange(28)[::-1] * 2 + 5,
        cell_data={"material": np.array([3, 3, 8, 8, 9, 9])},
        groups=(
            Group("A", "elset", [0, 1, 2]),
            Group("B", "elset", [2, 3]),
            Group("N", "nset", [0, 5], "vertex"),
        ),
        first_number=1,
        name="row.inp",
    )


@pytest.fixture
def session() -> Session:
    session = Session({"row": row_of_cubes})
    session.open_offered("row")
    return session


def shown(session: Session, filters: dict) -> list[int]:
    session.update({"filters": filters})
    return np.flatnonzero(session._drawn().shown).tolist()


def test_R12_groups_are_listed_with_the_description(session: Session) -> None:
    found = session.describe("groups")
    assert [(row["id"], row["kind"], row["count"]) for row in found["groups"]] == [
        ("elset:A", "cells", 3),
        ("elset:B", "cells", 2),
        ("nset:N", "vertices", 2),
        ("material:3", "cells", 2),
        ("material:8", "cells", 2),
        ("material:9", "cells", 2),
    ]
    assert found["features"]["edges"]["count"] == 0


@pytest.mark.parametrize(
    ("groups", "wanted"),
    [
        ({"hidden": ["elset:A"]}, [3, 4, 5]),
        ({"hidden": ["elset:A", "material:9"]}, [3]),
        ({"hidden": ["elset:A"], "shown": ["elset:B"]}, [2, 3, 4, 5]),
        ({"isolated": True, "shown": ["elset:B", "material:9"]}, [2, 3, 4, 5]),
        ({"isolated": True}, []),
        ({"hidden": ["elset:A"], "enabled": False}, [0, 1, 2, 3, 4, 5]),
        ({"hidden": ["elset:none"]}, [0, 1, 2, 3, 4, 5]),
    ],
)
def test_R12_groups_hide_and_are_shown_alone(session: Session, groups: dict, wanted: list[int]) -> None:
    assert shown(session, {"groups": groups}) == wanted


def test_R12_hidden_groups_are_seen_through(session: Session) -> None:
    answer = session.update(
        {"filters": {"groups": {"hidden": ["elset:A"]}}, "see_through": {"cells": "groups"}}
    )
    assert len(answer["see_through"]["positions"]) > 0


def test_R12_settings_that_name_no_group_are_told(session: Session) -> None:
    told = session.check(
        {
            "filters": {"groups": {"hidden": ["elset:A", "elset:C"]}},
            "colour": {"by": "group", "grouping": "part"},
        }
    )
    assert told["partial"]["filters"]["groups"]["hidden"] == ["elset:A"]
    assert [row["path"] for row in told["rejections"]] == ["colour.grouping", "filters.groups.hidden"]
    assert "by" not in told["partial"]["colour"]


def test_R12_cells_are_coloured_by_their_group_and_neighbours_differ(session: Session) -> None:
    colour = session.update({"colour": {"by": "group", "grouping": "material"}})["colour"]
    places = colour["map_position"]
    assert colour["label"] == "material" and colour["without"] == 0 and colour["in_several"] == 0
    assert places[0] == places[1] != places[2] == places[3] != places[4] == places[5]
    assert {row["id"]: row["colour"] for row in colour["groups"]}["material:8"] == places[2]
    first = session.update({"colour": {"grouping": ""}})["colour"]
    assert first["quantity"] == "group:elset" and first["in_several"] == 1 and first["without"] == 2
    assert np.isnan(first["map_position"][[4, 5]]).all()
    assert first["map_position"][2] == first["map_position"][3], "of two groups the smaller one counts"


def test_R12_a_mesh_without_groups_is_coloured_by_sides() -> None:
    sample = grid(2, 1, 1)
    session = Session({"x": lambda: Mesh.from_cells(sample.points, sample.rows_of(0))})
    session.open_offered("x")
    assert session.update({"colour": {"by": "group"}})["colour"] is None


def test_R12_statistics_of_groups(session: Session) -> None:
    table = {row["id"]: row for row in session.group_table()}
    assert table["elset:A"] == {
        "id": "elset:A",
        "volume": pytest.approx(3),
        "scaled_jacobian_min": pytest.approx(1),
        "scaled_jacobian_mean": pytest.approx(1),
        "invalid": 0,
    }
    assert table["material:9"]["invalid"] == 1 and table["material:9"][
        "scaled_jacobian_mean"
    ] == pytest.approx(0)
    assert table["material:9"]["volume"] == pytest.approx(0)


def test_R12_measures_of_random_groups_are_those_of_a_loop() -> None:
    random = np.random.default_rng(3)
    volume, shape = random.normal(size=200), random.normal(size=200)
    shape[random.integers(0, 200, 20)] = np.nan
    invalid = random.random(200) < 0.2
    groups = [Group(str(n), "x", np.flatnonzero(random.random(200) < n / 10)) for n in range(8)]
    for group, row in zip(groups, group_measures(groups, volume, shape, invalid), strict=True):
        own = [int(cell) for cell in group.members]
        finite = [shape[cell] for cell in own if np.isfinite(shape[cell])]
        assert row["volume"] == pytest.approx(sum(volume[cell] for cell in own))
        assert row["invalid"] == sum(invalid[cell] for cell in own)
        assert row["scaled_jacobian_min"] == (min(finite) if finite else None)
        assert row["scaled_jacobian_mean"] == (pytest.approx(np.mean(finite)) if finite else None)


def test_R12_interfaces_are_the_faces_between_two_groups() -> None:
    sample = grid(4, 3, 2)
    random = np.random.default_rng(5)
    label = random.integers(-1, 3, 24)
    mesh = Mesh.from_cells(sample.points, sample.rows_of(0))
    grouping = Grouping("x", tuple(Group(str(n), "x", np.flatnonzero(label == n)) for n in range(3)), 24)
    wanted: dict[tuple[int, int], set[frozenset[int]]] = {}
    cells = [set(row) for row in mesh.cells.tolist()]
    for one in range(24):
        for other in range(one):
            common = frozenset(cells[one] & cells[other])
            if len(common) == 4 and label[one] != label[other]:
                pair = tuple(sorted((int(label[one]), int(label[other]))))
                wanted.setdefault(pair, set()).add(common)
    topology = mesh.topology
    found = {
        pair: {
            frozenset(column)
            for column in topology.corners_of(
                topology.face_cells[0, rows], topology.face_locals[0, rows]
            ).T.tolist()
        }
        for pair, rows in interfaces(grouping, topology).items()
    }
    assert found == wanted


def test_R12_colours_of_things_that_meet_differ_while_there_are_enough() -> None:
    random = np.random.default_rng(1)
    pairs = [(int(a), int(b)) for a, b in random.integers(0, 40, (60, 2)) if a != b]
    colours = apart(40, pairs, 12)
    assert all(colours[a] != colours[b] for a, b in pairs)
    crowd = [(a, b) for a in range(5) for b in range(a)]
    assert len(set(apart(5, crowd, 3).tolist())) == 3


def test_R12_where_groups_meet_is_told_pair_by_pair(session: Session) -> None:
    rows = {tuple(row["groups"]): row for row in session.interfaces("material")}
    assert rows["material:3", "material:8"]["faces"] == 1 and rows["material:8", "material:9"]["apart"] == 0
    assert (None, "elset:B") in {tuple(row["groups"]) for row in session.interfaces("elset")}
    marks = session.update({"marks": {"interfaces": "material"}})["marks"]
    assert marks["counts"] == {"interfaces": 2} and len(marks["faces"]) == 24
    assert marks["face_colours"].tolist() == [rows[pair]["colour"] for pair in rows]
    gone = session.update({"marks": {"interfaces": ""}})["marks"]
    assert len(gone["faces"]) == 0 and "marks" not in session.update({})


def test_R12_sets_of_nodes_are_drawn_as_points(session: Session) -> None:
    marks = session.update({"marks": {"nodes": ["nset:N"]}})["marks"]
    frame = session._open_mesh().drawn_mesh
    wanted = frame.points(np.array([0, 5])).T.reshape(-1)
    assert marks["points"].tolist() == wanted.tolist() and marks["counts"] == {"nodes": 2}


def test_R13_features_are_drawn_on_shown_cells_and_lost_ones_anywhere() -> None:
    mesh = row_of_cubes()
    corners = mesh.corners
    edges = np.array([corners[[0, 1], 0], corners[[0, 1], 4], [0, 27]], dtype=np.int32).T
    faces = np.array([corners[[0, 1, 2, 3], 0], corners[[0, 1, 2, 3], 5]], dtype=np.int32).T
    features = (
        Features(0, np.array([[0, 27]]), {}, (Group("corners", "mark", [0, 1]),)),
        Features(1, edges, {"reference": np.array([4, 5, 5])}),
        Features(2, faces, {"reference": np.array([1, 2])}),
    )
    session = Session({"x": lambda: replace(mesh, features=features)})
    session.open_offered("x")
    marks = session.update()["marks"]
    assert marks["counts"] == {"corners": 2, "edges": 3} and marks["edge_colours"].tolist() == [0, 1, 7]
    isolated = {"picking": {"isolated": True, "shown": [0]}}
    marks = session.update({"filters": isolated, "marks": {"faces": True}})["marks"]
    assert marks["counts"] == {"corners": 1, "edges": 2, "faces": 1}
    assert marks["edge_colours"].tolist() == [0, 7] and marks["face_colours"].tolist() == [0]
    marks = session.update({"marks": {"hidden": ["edges:reference:4", "corners:mark:corners"]}})["marks"]
    assert marks["counts"] == {"corners": 0, "edges": 1, "faces": 1}
    told = session.check(
        {"marks": {"hidden": ["edges:reference:4", "edges:reference:6"], "nodes": ["nset:X"]}}
    )
    assert told["partial"]["marks"] == {"hidden": ["edges:reference:4"], "nodes": []}
    assert len(told["rejections"]) == 2
    listed = session.describe("groups")["features"]["edges"]
    assert listed["lost"] == 1 and [row["colour"] for row in listed["groups"]] == [0, 1]


def test_R13_sharp_edges_of_a_cut_mesh_are_those_of_its_boundary(session: Session) -> None:
    marks = session.update({"marks": {"sharp_angle": 45}})["marks"]
    assert marks["counts"]["sharp"] == 4 * 6 + 8 and set(marks["edge_colours"].tolist()) == {6}
    shown_two = {"picking": {"isolated": True, "shown": [0, 1]}}
    marks = session.update({"filters": shown_two})["marks"]
    assert marks["counts"]["sharp"] == 4 * 2 + 4
    assert "marks" in session.update({"marks": {"sharp_angle": 180}})


def test_R11_a_cell_tells_its_number_its_nodes_and_its_groups(session: Session) -> None:
    found = session.inspect(2)
    assert (found["cell"], found["number"]) == (2, 50)
    assert found["nodes"] == [(27 - corner) * 2 + 5 for corner in found["corners"]]
    assert found["groups"] == ["elset:A", "elset:B", "material:8"]


def test_R11_numbers_lead_to_cells_and_what_is_around_them(session: Session) -> None:
    assert session.numbers()["cells"].tolist() == [70, 60, 50, 40, 30, 20]
    assert session.numbers()["first"] == 1
    found = session.find("cell", 50)
    assert (found["rows"], found["cell"], found["around"].tolist()) == ([2], 2, [1, 2, 3])
    assert found["place"] == [2.5, 0.5, 0.5]
    assert session.find("cell", 50, [1, 0, 0])["around"].tolist() == [2, 3]
    assert session.find("cell", 50, [0, 1, 0])["around"].tolist() == [1, 2, 3]
    node = session.find("vertex", 5)
    assert (node["rows"], node["cell"], node["around"].tolist()) == ([27], 5, [5])


def test_R11_a_number_that_is_not_there_is_told_with_those_that_are(session: Session) -> None:
    with pytest.raises(HexaLabError, match="no element 80: its numbers are from 20 to 70"):
        session.find("cell", 80)
    with pytest.raises(HexaLabError, match="no node 6: its numbers are from 5 to 59"):
        session.find("vertex", 6)
    with pytest.raises(HexaLabError, match="expected cell or vertex"):
        session.find("face", 1)


def test_R11_rows_that_are_counted_on_are_found_too() -> None:
    sample = grid(3, 1, 1)
    session = Session()
    session.open("x.mesh", write_bytes(Mesh.from_cells(sample.points, sample.rows_of(0)), "mesh"))
    assert session.numbers() == {"first": 1, "cells": None}
    assert session.find("cell", 3)["rows"] == [2] and session.inspect(2)["number"] == 3
    with pytest.raises(HexaLabError, match="from 1 to 3"):
        session.find("cell", 0)
    session.open("x.vtu", write_bytes(Mesh.from_cells(sample.points, sample.rows_of(0)), "vtu"))
    assert session.numbers()["first"] == 0 and session.find("cell", 0)["rows"] == [0]


def test_R11_cells_as_texts_for_other_programs(session: Session) -> None:
    assert session.cell_list([0, 5], "elset", "BAD") == "*ELSET, ELSET=BAD\n70, 20\n"
    assert session.cell_list([0, 5], "paraview") == "isin(id, [0, 5])\n"
    with pytest.raises(HexaLabError, match="expected one of list, elset, gmsh, paraview"):
        session.cell_list([0], "nastran")


def test_R13_lost_features_are_findings() -> None:
    mesh = row_of_cubes()
    edges = np.array([[0, 0, 0], [1, 8, 27]], dtype=np.int32)
    lost = Mesh(mesh.coordinates, mesh.corners, mesh.kinds, features=(Features(1, edges),))
    found = {finding.id: finding for finding in diagnose(lost)}
    assert found["lost_edges"].count == 2
    assert "2 feature edges are no edge of the mesh." in found["lost_edges"].message
    assert 27 in found["lost_edges"].vertices
    assert certify(mesh).state.tolist().count(0) == 1 and quality(mesh, "scaled_jacobian")[
        5
    ] == pytest.approx(-1)
