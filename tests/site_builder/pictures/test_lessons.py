"""What the pictures of structure say is so: their captions, held against the meshes themselves (SPEC T)."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import hexalab
from hexalab.status import check
from hexalab.structure import facts_of
from site_builder.pictures.lessons import LESSONS
from site_builder.pictures.structures import GALLERY

ROOT = Path(__file__).resolve().parents[3]
TEMPLATES = ROOT / "site_builder" / "pages" / "templates"


@cache
def structure_of(mesh: str):
    """The structure of a mesh of our own."""
    return hexalab.structure(hexalab.read(ROOT / "repository" / f"{mesh}.mesh"))


def lesson(name):
    """The structure of the mesh that a lesson shows, and what of it is chosen."""
    recipe = LESSONS[name]
    return structure_of(recipe.mesh), recipe.settings["structure"].get("chosen", [])


@pytest.mark.parametrize("name", [*LESSONS, *(f"gallery {name}" for name in GALLERY)])
def test_T4_each_picture_has_a_mesh_settings_that_are_some_and_things_that_are_there(name):
    recipe = GALLERY[name.removeprefix("gallery ")] if name.startswith("gallery ") else LESSONS[name]
    structure = structure_of(recipe.mesh)
    assert check(recipe.settings)[1] == []
    look = recipe.settings.get("structure", {"kind": "none"})
    count = {
        "none": 0,
        "arcs": structure.graph.count,
        "sheets": structure.sheets.count,
        "chords": structure.chords.count,
        "blocks": structure.base_complex.blocks.count,
    }[look["kind"]]
    assert all(number < count for number in look.get("chosen", []))


def test_T4_the_page_shows_every_picture_once():
    text = "".join(file.read_text("utf-8") for file in TEMPLATES.glob("structure_*.jinja"))
    named = re.findall(r"parts\.term\([^,]*, [^,]*, \(([^)]*)\)\)", text.replace(", and no", " and no"))
    named += re.findall(r"for name in \(([^)]*)\) if name in figures", text)
    shown = [name for row in named for name in re.findall(r'"([^"]+)"', row)]
    assert sorted(shown) == sorted(set(LESSONS) - {"window"})
    assert 'picture("window"' in text


@pytest.mark.parametrize("valence", [3, 5])
def test_T1_an_edge_of_each_valence(valence):
    assert structure_of(LESSONS[f"valence-{valence}"].mesh).graph.valence.tolist() == [valence]


def test_T1_arcs_loops_and_types_of_nodes():
    sphere, _ = lesson("arcs")
    assert (sphere.graph.arcs, sphere.graph.valence.tolist()) == (20, [3] * 20)
    hoops, _ = lesson("loops")
    assert (len(hoops.arcs), len(hoops.loops), len(hoops.graph.nodes)) == (0, 4, 0)
    nodes, chosen = lesson("node")
    inside = [name for name in nodes.graph.types if name.startswith("i ")]
    assert len(inside) == 8
    ends = {int(end) for number in chosen for end in nodes.arcs[number][[0, -1]]}
    types = {
        nodes.graph.types[kind] for kind in nodes.graph.node_types[np.isin(nodes.graph.nodes, list(ends))]
    }
    assert types == {"i 3 3 5 5", "b 3", "b 5"}
    assert LESSONS["node"].title in types
    six, _ = lesson("nodes-of-six")
    assert LESSONS["nodes-of-six"].title in six.graph.types


def test_T2_each_kind_of_sheet_is_of_its_kind():
    for name in ("closed", "self-intersecting", "self-touching", "one-sided"):
        structure, (sheet,) = lesson(name)
        kinds = {
            kind: bool(getattr(structure.sheets, kind.replace("-", "_"))[sheet])
            for kind in ("closed", "self-intersecting", "self-touching", "one-sided")
        }
        assert [kind for kind, holds in kinds.items() if holds] == [name]


def test_T2_sheets_and_chords_are_as_large_and_cross_as_often_as_is_said():
    pipe, (layer,) = lesson("layer")
    assert f"{pipe.sheets.cells[layer]} cells" in LESSONS["layer"].sentence
    sphere, (one, other) = lesson("matrix")
    both = [(sphere.sheet_of_cells == sheet).any(axis=0) for sheet in (one, other)]
    assert f"{np.all(both, axis=0).sum()} cells" in LESSONS["matrix"].sentence
    torus, chords = lesson("chord")
    assert torus.chords.closed[chords].tolist() == [True, True, False, False]
    assert torus.chords.length[chords][:2].tolist() == [36, 36]
    shell, (one, other) = lesson("crossing")
    crossing = np.flatnonzero(np.all([(shell.sheet_of_cells == k).any(axis=0) for k in (one, other)], axis=0))
    third = np.argmin(np.isin(shell.sheet_of_cells[:, crossing], (one, other)), axis=0)
    along = shell.chord_of_cells[third, crossing]  # the chord that runs as both sheets do
    assert (len(crossing), len(set(along.tolist()))) == (4, 2)  # two columns of two cells each


@pytest.mark.parametrize(
    ("name", "blocks", "kinds"),
    [
        ("apart", 7, {"box": 7}),
        ("five", 5, {"box": 5}),
        ("whole", 14, {"box": 14}),
        ("ring", 5, {"ring": 5}),
        ("twisted", 1, {"twisted": 1}),
        ("winding", 57, {"box": 57}),
        ("straight", 7, {"box": 7}),
        ("polycube", 20, {"box": 20}),
        ("octree-blocks", 524, {"box": 524}),
    ],
)
def test_T3_there_are_as_many_blocks_as_is_said(name, blocks, kinds):
    base = facts_of(lesson(name)[0])["base_complex"]
    assert (base["blocks"], base["kinds"]) == (blocks, kinds)


def test_T3_classes_are_what_they_are_called():
    for name in ("regular", "polycube"):
        assert facts_of(lesson(name)[0])["class"] == name
    assert {facts_of(lesson(name)[0])["class"] for name in ("winding", "straight")} == {"polycube"}


def test_T3_what_the_inside_alone_enforces():
    structure, _ = lesson("interior")
    assert structure.interior_base_complex.blocks.count == 6
    assert structure.graph.valence.tolist() == [6, 6]
    gear = structure_of("shapes/gear")
    assert (gear.base_complex.blocks.count, gear.interior_base_complex.blocks.count) == (36, 1)


def test_T3_what_runs_side_by_side_belongs_to_one_base_sheet_and_one_base_chord():
    sphere, sheets = lesson("base-sheet")
    of_sheets, _ = sphere.base_sheets
    assert sorted(sheets) == np.flatnonzero(of_sheets == of_sheets[sheets[0]]).tolist()
    sphere, chords = lesson("base-chord")
    of_chords, _ = sphere.base_chords
    assert set(of_chords[chords].tolist()) == {of_chords[0]}
    assert np.count_nonzero(of_chords == of_chords[0]) == 36
    passed = np.isin(sphere.chord_of_cells, chords).any(axis=0)
    assert len(set(sphere.block_of_cells[passed].tolist())) == 3
