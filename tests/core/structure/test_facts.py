"""Structures of published meshes and of our own, to the last label (SPEC T1-T3).

The facts come from a slow program in dictionaries and sets, whose blocks and graphs agree with two published
programs.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hexalab
from hexalab.structure import Structure, facts_of
from hexalab.structure.blocks import KINDS
from hexalab.structure.graph import Graph
from tests.published import CELLS, SHARED, file_of

REPOSITORY = Path(__file__).resolve().parents[3] / "repository"
OWN = sorted(
    path.name
    for folder in ("shapes", "structures")
    for path in (REPOSITORY / folder).glob("*.*")
    if path.suffix in (".mesh", ".vtk")
)


@cache
def known() -> dict[str, Any]:
    """Facts by the name of the file; the test is left out where they are not here."""
    files = [SHARED / "structure" / name for name in ("published.json", "own.json")]
    if not all(file.is_file() for file in files):
        pytest.skip("needs facts of structure, which are not here")
    return {name: facts for file in files for name, facts in json.loads(file.read_text("utf-8")).items()}


def traced(name: str) -> tuple[dict[str, Any], Structure]:
    """What is known of a mesh, and its structure."""
    if name not in known():
        pytest.skip("needs facts of this mesh, which are not here")
    path = file_of(name) if name in CELLS else next(REPOSITORY.glob(f"s*/{name}"))
    return known()[name], hexalab.structure(hexalab.read(path))


@pytest.mark.parametrize("name", [*CELLS, *OWN])
def test_T6_what_is_printed_is_what_is_known(name: str) -> None:
    expected, structure = traced(name)
    found = facts_of(structure)
    if "skipped" in expected:
        assert found["skipped"] == expected["skipped"]
        return
    graph = expected["singularities"]["graph_interior"]
    base = expected["base_complex"]
    word = expected["class"]["word"]
    assert found == {
        "irregular": {key: graph[key] for key in found["irregular"]},
        "sheets": {key: expected["sheets"][key] for key in found["sheets"]},
        "chords": {key: expected["chords"][key] for key in found["chords"]},
        "base_complex": {key: base["all"][key] for key in found["base_complex"]},
        "interior_base_complex": {"blocks": base["interior"]["blocks"]},
        "class": word if word in ("regular", "polycube") else None,
        "irregular_vertex_share": expected["class"]["irregular_vertex_share"],
        "labels": {
            "sheets": expected["sheets"]["sheets_sha"],
            "chords": expected["chords"]["chords_sha"],
            "blocks": base["all"]["blocks_sha"],
        },
    }


@pytest.mark.parametrize("name", [*CELLS, *OWN])
def test_T1_T2_T3_all_else_that_is_known(name: str) -> None:
    expected, structure = traced(name)
    if "skipped" in expected:
        return
    frame, sheets, chords = structure.frame, structure.sheets, structure.chords
    for key, graph in (("graph_interior", structure.graph), ("graph_all", structure.whole_graph)):
        check_graph(expected["singularities"][key], graph)
    known_sheets = expected["sheets"]
    assert int(sheets.cells.max()) == known_sheets["largest_cells"]
    assert int(sheets.cells.min()) == known_sheets["smallest_cells"]
    assert int((sheets.crossings - sheets.cells).sum()) == known_sheets["cells_crossed_again"]
    assert tally(chords.length) == expected["chords"]["lengths"]
    assert tally(chords.length[chords.closed]) == expected["chords"]["lengths_closed"]
    for key, base in (("all", structure.base_complex), ("interior", structure.interior_base_complex)):
        known_base, blocks = expected["base_complex"][key], base.blocks
        kinds = np.bincount(blocks.kinds, minlength=len(KINDS))
        assert {KINDS[kind]: int(number) for kind, number in enumerate(kinds) if number} == known_base[
            "kinds"
        ]
        assert int(np.count_nonzero(base.separating[: frame.paired])) == known_base["separation_faces"]
        assert int(np.count_nonzero(blocks.cells == 1)) == known_base["one_cell_blocks"]
        assert int(blocks.cells.max()) == known_base["largest_block"]
    assert len(structure.skeleton.mesh_edges) == expected["base_complex"]["all"]["complex_mesh_edges"]


def check_graph(expected: dict[str, Any], graph: Graph) -> None:
    """Hold a graph's counts against what is known, and its chains against its edges."""
    arcs, lengths = graph.arcs, graph.lengths
    types = np.bincount(graph.node_types, minlength=len(graph.types)).tolist()
    assert dict(zip(graph.types, types, strict=True)) == expected["node_types"]
    assert tally(lengths[:arcs]) == expected["arc_lengths"]
    assert tally(lengths[arcs:]) == expected["loop_lengths"]
    assert tally(np.repeat(graph.valence, lengths)) == expected["edges"]
    first, last = graph.vertices[graph.starts[:-1]], graph.vertices[graph.starts[1:] - 1]
    assert int(np.count_nonzero(first[:arcs] == last[:arcs])) == expected["arcs_from_a_node_to_itself"]
    assert np.array_equal(first[arcs:], last[arcs:])
    assert np.isin(np.concatenate([first[:arcs], last[:arcs]]), graph.nodes).all()


def tally(values: np.ndarray) -> dict[str, int]:
    """How often each value occurs."""
    found, numbers = np.unique(values, return_counts=True)
    return {str(value): int(number) for value, number in zip(found, numbers, strict=True)}


@pytest.mark.parametrize("name", OWN)
def test_T3_euler_where_it_applies(name: str) -> None:
    structure = hexalab.structure(hexalab.read(next(REPOSITORY.glob(f"s*/{name}"))))
    frame, skeleton, blocks = structure.frame, structure.skeleton, structure.base_complex.blocks
    if skeleton.edges.open != skeleton.edges.count or (blocks.kinds != 0).any():
        return  # closed base edges, or blocks that are no boxes
    used = int(np.count_nonzero(frame.vertex_used))
    of_mesh = used - frame.edge_count + frame.face_count - frame.count
    assert len(skeleton.vertices) - skeleton.edges.count + skeleton.faces - blocks.count == of_mesh
