"""The structure on a mesh's page: nothing twice, nothing guessed, long lists folded (SPEC T6, C2)."""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from site_builder.measuring.measurer import measure
from site_builder.model.facts import Facts
from site_builder.pages.structure import FIRST, Tally, figures, tallies

REPOSITORY = Path(__file__).resolve().parents[3] / "repository"


def measured(name: str) -> Facts:
    """Facts of a mesh of the repository."""
    file = REPOSITORY / f"{name}.mesh"
    return measure(file.read_bytes(), file.name)


def tables(facts: Facts) -> dict[str, Tally]:
    """The tables by their captions."""
    found = [table for column in tallies(facts) for table in column]
    assert len({table.caption for table in found}) == len(found)
    assert all(len(numbers) == len(table.heads) - 1 for table in found for _, numbers in table.rows)
    return {table.caption: table for table in found}


def test_T6_the_figures_of_a_mesh_with_irregular_edges() -> None:
    assert figures(measured("structures/octree")) == [
        ("Arcs", "224"),
        ("Loops", "0"),
        ("Nodes", "178"),
        ("Sheets", "26"),
        ("Chords", "316"),
        ("Blocks", "524"),
        ("Cells per block", "2.31"),
        ("Irregular vertices inside", "34.2 %"),
    ]


@pytest.mark.parametrize(
    ("name", "word"),
    [
        ("shapes/cube", "regular"),
        ("layouts/winding-walls", "polycube"),
        ("layouts/hoops", None),
        ("structures/mixed", None),
    ],
)
def test_T3_the_class_is_a_figure_where_there_is_one(name: str, word: str | None) -> None:
    assert dict(figures(measured(name))).get("Class") == word


def test_T6_tables_of_a_mesh_with_irregular_edges() -> None:
    found = tables(measured("structures/octree"))
    edges = found["Interior edges by the cells around them"]
    assert edges.heads == ("Valence", "Edges", "Arcs")
    assert edges.rows == [("3", [320, 96]), ("4", [2570, None]), ("6", [128, 128])]
    assert found["Nodes by the valences that meet there"].rows == [
        ("3 3 6 6, inside", [64]),
        ("3, on the boundary", [64]),
        ("6 6 6 6, inside", [26]),
        ("6, on the boundary", [24]),
    ]
    base = dict(found["Base complex"].rows)
    counted = [base[part] for part in ("vertices", "edges", "faces", "blocks")]
    assert counted == [[780], [2059], [1804], [524]]
    assert found["Blocks by kind"].rows == [("box", [524])]
    assert found["Blocks by size"].rows == [("1 × 1 × 3", [324]), ("1 × 1 × 1", [164]), ("1 × 1 × 2", [36])]


def test_T6_tables_of_sheets_and_of_blocks_that_close() -> None:
    through = dict(tables(measured("structures/self-crossing"))["Sheets and chords"].rows)
    assert (through["in all"], through["self-intersecting"]) == ([35, 224], [4, 12])
    assert through["one-sided"] == [0, None], "a chord has no sides"
    one_sided = tables(measured("layouts/one-sided"))
    assert dict(one_sided["Sheets and chords"].rows)["one-sided"] == [2, None]
    assert one_sided["Blocks by kind"].rows == [("twisted ring", [1])]
    assert one_sided["Blocks by size"].rows == [("twisted ring of 432", [1])]
    hoops = tables(measured("layouts/hoops"))
    assert hoops["Interior edges by the cells around them"].heads == ("Valence", "Edges", "Loops")
    assert hoops["Blocks by size"].rows == [("ring 2 × 3 × (30)", [4]), ("ring 3 × 3 × (30)", [1])]


def test_T6_of_what_nobody_traced_there_is_nothing() -> None:
    remote = Facts(cells=844, interior_edge_valence={4: 1777, 5: 8})
    assert figures(remote) == []
    assert list(tables(remote)) == ["Interior edges by the cells around them"]
    assert tables(remote)["Interior edges by the cells around them"].rows == [("4", [1777]), ("5", [8])]
    assert tallies(Facts()) == []


def test_T6_the_page_has_each_figure_and_says_what_is_not_traced(demo, rebuild, edit) -> None:
    names = ("self-crossing.mesh", "mixed.mesh")
    for name in names:
        shutil.copyfile(REPOSITORY / "structures" / name, demo / "small" / name)
    rows = [{"file": name, "description": "A mesh that has a structure to tell."} for name in names]
    edit(demo / "small" / "source.yaml", lambda data: data["meshes"].extend(rows))
    rebuild()
    crossing, mixed = (
        (demo.parent / "site" / "sources" / "small" / name.removesuffix(".mesh") / "index.html").read_text()
        for name in names
    )
    assert "<dt>Sheets</dt><dd>35</dd>" in crossing and "<dt>Class</dt><dd>polycube</dd>" in crossing
    row = '<th scope="row">self-intersecting</th><td>4</td><td>12</td>'
    assert row in crossing
    assert crossing.count("Polycube: no interior edge is irregular, 2 blocks.") > 0
    assert "Not traced" not in crossing
    assert "Not traced: 44 cells that aren&#39;t hexahedra; structure ends there." in mixed
    assert "<dt>Sheets</dt><dd>10</dd>" in mixed and "<dt>Class</dt>" not in mixed
    remote = (demo.parent / "site" / "sources" / "far" / "one-folder-first" / "index.html").read_text()
    assert "<dt>Sheets</dt>" not in remote and "<caption>Interior edges" in remote


@pytest.mark.parametrize(("sizes", "folded"), [(FIRST, 0), (FIRST + 1, 1), (FIRST + 30, 30)])
def test_T6_a_long_list_is_folded_behind_its_number(rendered, sizes: int, folded: int) -> None:
    facts = measured("structures/o-grid")
    base = facts.structure["base_complex"] | {"dims": {f"1x1x{n}": 100 - n for n in range(sizes)}}
    html = rendered(replace(facts, structure=facts.structure | {"base_complex": base}))
    table = html.split("<caption>Blocks by size</caption>")[1].split("</div>")[0]
    seen, _, behind = table.partition("<details>")
    assert len(re.findall("1 × 1 × ", seen)) == FIRST
    assert len(re.findall("1 × 1 × ", behind)) == folded
    assert (f"<summary>and {folded} more</summary>" in behind) == (folded > 0)


@pytest.fixture
def rendered(demo):
    """A function that makes the page of a mesh with these facts."""
    from site_builder.pages.pages import Pages
    from site_builder.reading.repository import read_repository

    catalogue = read_repository(demo)
    catalogue.address = "https://meshes.example.org/"
    mesh = catalogue.meshes[0]

    def page(facts: Facts) -> str:
        mesh.facts = facts
        return Pages(catalogue, set()).mesh(mesh)

    return page
