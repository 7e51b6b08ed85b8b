"""Questions about the structure (SPEC T1 to T5): traced step by step, told as tables, placed, saved, checked."""

from __future__ import annotations

import csv
import io
import itertools
from collections import Counter
from typing import Any

import numpy as np
import pytest

import hexalab
from hexalab.errors import HexaLabError
from hexalab.formats import read_bytes
from hexalab.packing import jsonable
from hexalab.session import Session
from hexalab.session.traced import STEPS
from hexalab.structure import CELL_DATA, TABLES, Structure, facts_of
from hexalab.structure.blocks import KINDS
from hexalab.structure.tables import CHORD_KINDS, SHEET_KINDS
from tests.core.session.checks import plain
from tests.core.session.looks import MESHES, NOWHERE, mesh_of, session_of, truth_of
from tests.core.structure.brute_force import FACES, FIRST, OPPOSITE

NODES = "layouts/nodes-of-six"


def traced(session: Session) -> Session:
    """The session when all is traced."""
    for _ in STEPS:
        session.trace()
    return session


@pytest.mark.parametrize("name", MESHES)
def test_T1_tracing_goes_on_until_nothing_follows(name: str) -> None:
    session, names, told = session_of(name), list(STEPS), []
    following: str | None = names[0]
    while following is not None:
        answer = session.trace()
        following = answer["next"]
        told.append((answer["done"], answer["of"], following))
    assert told == [(n + 1, len(names), one) for n, one in enumerate([*names[1:], None])]
    assert session.trace() == {"done": len(names), "of": len(names), "next": None}


def test_T1_other_questions_come_between_and_change_nothing() -> None:
    session = session_of(NODES)
    session.trace()
    assert session.structure_table("blocks")["rows"] > 0
    session.update({"structure": {"kind": "sheets", "chosen": [0]}})
    assert session.trace()["done"] == 2
    for _ in STEPS:
        session.trace()
    assert session.structure_facts() == session_of(NODES).structure_facts()


@pytest.mark.parametrize("name", MESHES)
def test_T6_the_facts_are_those_of_the_library(name: str) -> None:
    session = session_of(name)
    structure = hexalab.structure(mesh_of(name))
    assert session.structure_facts() == jsonable(facts_of(structure, labels=False))
    assert session.structure_facts(True) == jsonable(facts_of(structure)) and plain(
        session.structure_facts(True)
    )


def expected_table(structure: Structure, table: str, variant: str) -> dict[str, list[Any]]:
    """Each column as words, numbers and truths, out of the library's arrays."""
    if table == "arcs":
        graph = structure.whole_graph if variant == "whole" else structure.graph
        return {
            "valence": graph.valence.tolist(), "edges": [len(chain) - 1 for chain in graph.chains],
            "closed": [n >= graph.arcs for n in range(graph.count)], "boundary": graph.on_boundary.tolist(),
            "from": [int(chain[0]) + 1 for chain in graph.chains], "to": [int(chain[-1]) + 1 for chain in graph.chains],
        }  # fmt: skip
    if table == "nodes":
        graph = structure.graph
        return {
            "vertex": (graph.nodes + 1).tolist(),
            "type": [graph.types[kind] for kind in graph.node_types.tolist()],
        }
    if table == "sheets":
        sheets = structure.sheets
        kind = [
            SHEET_KINDS[2 if crossing else 1 if touching else 0]
            for crossing, touching in zip(sheets.self_intersecting, sheets.self_touching, strict=True)
        ]
        return {
            "cells": sheets.cells.tolist(), "edges": sheets.edges.tolist(), "crossings": sheets.crossings.tolist(),
            "kind": kind, "closed": sheets.closed.tolist(), "one_sided": sheets.one_sided.tolist(),
            "base_sheet": structure.base_sheets[0].tolist(),
        }  # fmt: skip
    if table == "chords":
        chords = structure.chords
        return {
            "length": chords.length.tolist(), "closed": chords.closed.tolist(),
            "kind": [CHORD_KINDS[crossing] for crossing in chords.self_intersecting.tolist()],
            "base_chord": structure.base_chords[0].tolist(),
        }  # fmt: skip
    blocks = (structure.interior_base_complex if variant == "interior" else structure.base_complex).blocks
    return {
        "cells": blocks.cells.tolist(), "kind": [KINDS[kind] for kind in blocks.kinds.tolist()],
        "i": blocks.dimensions[:, 0].tolist(), "j": blocks.dimensions[:, 1].tolist(),
        "k": blocks.dimensions[:, 2].tolist(),
    }  # fmt: skip


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("variant", ["whole", "interior"])
@pytest.mark.parametrize("table", TABLES)
def test_T4_tables_and_their_csv_are_the_librarys_arrays(name: str, variant: str, table: str) -> None:
    session = session_of(name)
    expected = expected_table(hexalab.structure(mesh_of(name)), table, variant)
    rows = len(next(iter(expected.values())))
    expected = {"number": [*range(rows)], **expected}
    told = session.structure_table(table, variant)
    assert plain(told) and told["rows"] == rows
    assert {column["id"] for column in told["columns"]} == set(expected)
    for column in told["columns"]:
        values, words = column["values"], column["words"]
        found = [words[value] for value in values.tolist()] if words else values.tolist()
        assert found == expected[column["id"]], column["id"]
        flags = isinstance(expected[column["id"]][0], bool) if rows else values.dtype == np.uint8
        assert values.dtype == (np.uint8 if flags else np.int32)
    text = list(csv.DictReader(io.StringIO(session.structure_csv(table, variant))))
    assert len(text) == rows
    as_told = {True: "yes", False: "no"}
    for id, values in expected.items():
        told_values = [as_told[value] if isinstance(value, bool) else str(value) for value in values]
        assert [row[id] for row in text] == told_values


def test_T4_a_table_that_there_is_not_is_told() -> None:
    session = session_of(NODES)
    for ask in (session.structure_table, session.structure_csv):
        with pytest.raises(HexaLabError, match="no table 'walls' of a structure, but arcs, nodes, sheets"):
            ask("walls")
    with pytest.raises(HexaLabError, match="no 'nodes', but arcs, sheets, chords, blocks"):
        session.structure_box("nodes", [0])


@pytest.mark.parametrize("name", MESHES)
def test_T4_pairs_of_sheets(name: str) -> None:
    told, slow = session_of(name).sheet_pairs(), truth_of(name).slow
    assert plain(told)
    sheet, label = slow.sheets(), {}
    crossed = [
        [label.setdefault(sheet[frozenset(cell[p] for p in ends)], len(label)) for ends in FIRST]
        for cell in slow.cells
    ]
    crossings: Counter[tuple[int, int]] = Counter()
    for a, b, c in crossed:
        crossings.update(tuple(sorted(pair)) for pair in ((a, b), (b, c), (a, c)))  # type: ignore[misc]
    beside: Counter[tuple[int, int]] = Counter()
    through = {side: d for d, pair in enumerate(OPPOSITE) for side in pair}
    for face, around in slow.face_cells.items():
        if len(around) == 2:
            ends = []
            for cell in around:
                (side,) = (k for k, ring in enumerate(FACES) if {slow.cells[cell][p] for p in ring} == face)
                ends.append(crossed[cell][through[side]])
            beside[min(ends), max(ends)] += 1
    pairs = list(zip(told["one"].tolist(), told["other"].tolist(), strict=True))
    assert told["count"] == len(label) and pairs == sorted(crossings | beside)
    assert told["crossings"].tolist() == [crossings[pair] for pair in pairs]
    assert told["beside"].tolist() == [beside[pair] for pair in pairs]


@pytest.mark.parametrize("name", MESHES)
def test_T4_the_box_around_some_things(name: str) -> None:
    session, truth = session_of(name), truth_of(name)
    frame = session._open_mesh().drawn_mesh.frame
    for kind in ("sheets", "chords", "blocks"):
        for variant in ("whole", "interior"):
            count = len(truth.members(kind, variant))
            for numbers in ([0], [count - 1, count // 2, NOWHERE]):
                told = session.structure_box(kind, numbers, variant)
                cells = np.flatnonzero(truth.mask(kind, numbers, variant))
                points = truth.mesh.points[truth.mesh.cells[cells].reshape(-1)]
                low, high = points.min(axis=0), points.max(axis=0)
                assert told is not None and plain(told)
                centre = ((low + high) / 2 - frame.centre) / frame.diagonal
                assert told["centre"] == pytest.approx(centre.tolist(), abs=1e-6)
                assert told["size"] == pytest.approx(np.linalg.norm(high - low) / frame.diagonal, abs=1e-6)
    assert session.structure_box("blocks", []) is session.structure_box("sheets", [NOWHERE]) is None


def test_T4_the_box_around_arcs_holds_the_cells_at_their_edges() -> None:
    session, truth = session_of(NODES), truth_of(NODES)
    frame = session._open_mesh().drawn_mesh.frame
    chain = hexalab.structure(truth.mesh).arcs[3].tolist()
    edges = {frozenset(pair) for pair in itertools.pairwise(chain)}
    cells = sorted(set().union(*(truth.slow.edge_cells[edge] for edge in edges)))
    points = truth.mesh.points[truth.mesh.cells[cells].reshape(-1)]
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    told = session.structure_box("arcs", [3], "interior")
    assert told is not None
    assert told["centre"] == pytest.approx(((middle - frame.centre) / frame.diagonal).tolist(), abs=1e-6)


def test_T4_cells_and_blocks_that_are_drawn_apart_are_found_where_they_are_drawn() -> None:
    session, truth = session_of(NODES), truth_of(NODES)
    before = {cell: session.cell_view(cell) for cell in (0, 100)}
    box = session.structure_box("blocks", [2])
    surface = session.update({"structure": {"kind": "blocks", "explode": 0.8}})["surface"]
    positions = surface["positions"].reshape(-1, 3)
    own = np.isin(surface["cells"], sorted(truth.whole["blocks"][2]))
    low, high = positions[own].min(axis=0), positions[own].max(axis=0)
    moved = session.structure_box("blocks", [2])
    assert box is not None and moved is not None
    assert moved["size"] == pytest.approx(box["size"], abs=1e-6)
    assert moved["centre"] == pytest.approx(((low + high) / 2).tolist(), abs=1e-6)
    assert np.abs(np.array(moved["centre"]) - box["centre"]).max() > 0.01
    for cell, view in before.items():
        now = session.cell_view(cell)
        corners = {tuple(np.round(end, 4)) for end in now["edges"].reshape(-1, 3).tolist()}
        drawn = {tuple(np.round(end, 4)) for end in positions[surface["cells"] == cell].tolist()}
        assert drawn and drawn <= corners
        assert now["size"] == view["size"]
        shift = np.array(now["centre"]) - view["centre"]
        assert np.allclose(now["edges"].reshape(-1, 3) - view["edges"].reshape(-1, 3), shift, atol=1e-6)
    session.update({"structure": {"explode": 0}})
    assert session.structure_box("blocks", [2]) == box
    assert session.cell_view(100)["centre"] == before[100]["centre"]


@pytest.mark.parametrize("name", ["structures/mixed", "structures/self-crossing"])
def test_T4_what_a_cell_is_part_of_is_told_when_all_is_traced(name: str) -> None:
    session, mesh = session_of(name), mesh_of(name)
    assert session.inspect(0)["structure"] is session.value(0, "volume")["structure"] is None
    for _ in list(STEPS)[1:]:
        session.trace()
        assert session.inspect(0)["structure"] is None
    session.trace()
    structure = hexalab.structure(mesh)
    for cell in range(0, mesh.cell_count, 7):
        told = session.inspect(cell)["structure"]
        assert told == session.value(cell, "volume")["structure"]
        if structure.block_of_cells[cell] < 0:
            assert told == {"sheets": [], "chords": [], "block": None}
        else:
            assert told == {
                "sheets": structure.sheet_of_cells[:, cell].tolist(),
                "chords": structure.chord_of_cells[:, cell].tolist(),
                "block": int(structure.block_of_cells[cell]),
            }
    session.open_offered(name)
    assert session.inspect(0)["structure"] is None, "another mesh is not traced"


@pytest.mark.parametrize("name", ["structures/mixed", NODES])
def test_T5_saved_cells_have_the_labels_that_they_have_in_the_whole(name: str) -> None:
    session, mesh = session_of(name), mesh_of(name)
    structure = hexalab.structure(mesh)
    for filters in ({"structure": {"sheets": [1, 2]}}, {"structure": {"sheets": [1], "keep": "outside"}}, {}):
        session.update(
            {"filters": {"structure": {"sheets": [], "keep": "inside", **filters.get("structure", {})}}}
        )
        saved = session.save_cells("vtu", structure=True)
        found = read_bytes(saved["data"].tobytes(), "part.vtu")
        rows = np.asarray(found.cell_data.get("original_cell", np.arange(mesh.cell_count)))
        assert len(rows) == saved["cells"] and (len(rows) < mesh.cell_count) == bool(filters)
        for label, values in CELL_DATA.items():
            assert np.asarray(found.cell_data[label]).tolist() == values(structure)[rows].tolist(), label
    assert (
        set(CELL_DATA) & set(read_bytes(session.save_cells("vtu")["data"].tobytes(), "a.vtu").cell_data)
        == set()
    )


@pytest.mark.parametrize(
    ("document", "paths"),
    [
        ({"structure": {"kind": "walls"}}, ["structure.kind"]),
        ({"structure": {"chosen": [0, -1, 2.5, 3]}}, ["structure.chosen[1]", "structure.chosen[2]"]),
        ({"structure": {"chosen": 4, "form": "lines"}}, ["structure.chosen", "structure.form"]),
        ({"structure": {"explode": 1.5}}, ["structure.explode"]),
        ({"structure": {"complex": "both", "boundary": 1, "curves": "yes"}}, [
            "structure.boundary", "structure.complex", "structure.curves"]),
        ({"structure": {"sheets": [1]}}, ["structure.sheets"]),
        ({"structure": []}, ["structure"]),
        ({"filters": {"structure": {"keep": "both", "blocks": ["0"], "arcs": [1]}}}, [
            "filters.structure.arcs", "filters.structure.blocks[0]", "filters.structure.keep"]),
        ({"colour": {"by": "structure", "attribute": "structure:beauty"}}, ["colour.attribute", "colour.by"]),
        ({"see_through": {"cells": "sheets"}}, ["see_through.cells"]),
    ],
)  # fmt: skip
def test_S1_wrong_settings_of_structure_are_named_and_the_rest_applies(
    document: dict[str, Any], paths: list[str]
) -> None:
    session = session_of(NODES)
    whole = {"structure": {"kind": "sheets", "chosen": [1]}}
    checked = session.check(document)
    assert sorted(rejection["path"] for rejection in checked["rejections"]) == paths
    assert session.check({**whole, "filters": {"structure": {"sheets": [1]}}})["rejections"] == []
    session.update(checked["partial"])
    if "chosen" in document.get("structure", {}) and "structure.chosen" not in paths:
        assert checked["partial"]["structure"]["chosen"] == [0, 3]
