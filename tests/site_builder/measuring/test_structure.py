"""The structure among the facts of meshes that lie here: measured once, kept, and not guessed of others (SPEC T6)."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from hexalab import structure
from hexalab.formats import read_bytes
from hexalab.structure import facts_of
from site_builder.measuring.measurer import Measurer, measure
from site_builder.model.facts import Facts
from site_builder.model.published import read_published
from tests.published import SHARED

REPOSITORY = Path(__file__).resolve().parents[3] / "repository"
FIGURES = ("arcs", "sheets", "self_intersecting_sheets", "blocks")


def measured(name: str) -> Facts:
    """Facts of a mesh of the repository."""
    file = REPOSITORY / name
    return measure(file.read_bytes(), file.name)


@pytest.mark.parametrize(
    ("name", "part", "figure", "value"),
    [
        ("layouts/straight-walls", "base_complex", "blocks", 7),
        ("layouts/winding-walls", "base_complex", "blocks", 57),
        ("layouts/one-sided", "sheets", "one_sided", 2),
        ("layouts/self-touching", "sheets", "self_touching", 1),
        ("layouts/hoops", "irregular", "loops", 4),
        ("structures/self-crossing", "sheets", "self_intersecting", 4),
    ],
)
def test_T6_a_mesh_has_the_structure_that_it_was_made_for(
    name: str, part: str, figure: str, value: int
) -> None:
    facts = measured(f"{name}.mesh")
    assert facts.structure and facts.structure[part][figure] == value


@pytest.mark.parametrize("name", ["shapes/bracket", "shapes/knot", "structures/octree", "structures/moebius"])
def test_T6_figures_are_those_of_another_program(name: str) -> None:
    """Facts of a slow program in dictionaries, whose blocks and graphs agree with two published ones."""
    file = SHARED / "structure" / "own.json"
    if not file.is_file():
        pytest.skip("needs facts of structure, which are not here")
    known = json.loads(file.read_text("utf-8"))[f"{name.split('/')[1]}.mesh"]
    graph, sheets = known["singularities"]["graph_interior"], known["sheets"]
    blocks = known["base_complex"]["all"]["blocks"]
    facts = measured(f"{name}.mesh")
    assert [getattr(facts, figure) for figure in FIGURES] == [
        graph["arcs"] + graph["loops"],
        sheets["count"],
        sheets["self_intersecting"],
        blocks,
    ]


def test_T6_what_is_kept_is_what_was_measured(tmp_path: Path) -> None:
    file = REPOSITORY / "structures" / "o-grid.mesh"
    measurer = Measurer(tmp_path)
    first, second = measurer.facts(file), measurer.facts(file)
    assert measurer.measured == 1
    assert first == second
    assert second.structure == facts_of(structure(read_bytes(file.read_bytes(), file.name)))
    assert Facts.from_dict(json.loads(json.dumps(second.to_dict()))) == first


def test_T6_where_nothing_can_be_traced_there_are_no_figures() -> None:
    text = b"""MeshVersionFormatted 2 Dimension 3 Vertices 4
0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0
Tetrahedra 1 1 2 3 4 0 End"""
    facts = measure(text, "one.mesh")
    assert facts.structure and facts.structure["skipped"] == "1 cell that isn't a hexahedron"
    assert [getattr(facts, figure) for figure in FIGURES] == [None] * 4


def test_T6_beside_other_cells_hexahedra_are_traced() -> None:
    facts = measured("structures/mixed.mesh")
    assert facts.structure and facts.structure["skipped"] == "44 cells that aren't hexahedra"
    assert (facts.blocks, facts.sheets) == (1, 10)


def test_T6_facts_without_a_structure_are_read_as_ever() -> None:
    facts = Facts.from_dict({"cells": 8, "interior_edge_valence": {"4": 6, "5": 2}})
    assert facts.irregular_edges == 2 and "structure" not in facts.to_dict()
    (remote,) = (
        one.facts
        for one in read_published(Path(__file__).parents[1] / "demo" / "far" / "facts.json").values()
    )
    assert remote.structure is None
    assert [getattr(remote, figure) for figure in FIGURES] == [None] * 4
