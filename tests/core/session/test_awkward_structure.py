"""Meshes with little or odd structure (SPEC T1 to T5): traced to the end, looked at in every way, told in words."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import hexalab
from hexalab.formats import read_bytes, write_bytes
from hexalab.mesh import Mesh
from hexalab.session import Session, prepared
from hexalab.session.traced import STEPS
from hexalab.structure import CELL_DATA, TABLES
from hexalab.structure.quantities import QUANTITIES
from tests.core.session.checks import plain
from tests.core.session.looks import Screen, Truth, all_looks
from tests.core.surface.shapes import grid, split_grid, unit_cube
from tests.core.surface.test_repeated_cells import with_repeats

REPOSITORY = Path(__file__).resolve().parents[3] / "repository"


def three_at_a_face() -> Mesh:
    """Three cubes whose lowest face is the same."""
    random = np.random.default_rng(4)
    cells = [[0, 1, 2, 3, *range(4 * n, 4 * n + 4)] for n in (1, 2, 3)]
    return Mesh.from_cells(random.random((16, 3)), cells)


def crossed() -> Mesh:
    """Two cubes whose common four vertices follow each other in another order."""
    return Mesh.from_cells(
        np.random.default_rng(4).random((12, 3)), [[0, 1, 2, 3, 4, 5, 6, 7], [4, 6, 5, 7, 8, 9, 10, 11]]
    )


def nothing() -> Mesh:
    """Three vertices without a cell."""
    return Mesh.from_cells(np.eye(3), np.empty((0, 8), int))


def ours(name: str) -> Callable[[], Mesh]:
    """A mesh that lies here."""
    return lambda: hexalab.read(REPOSITORY / f"{name}.mesh")


CASES: dict[str, tuple[Callable[[], Mesh], str, tuple[int, int, int]]] = {
    "no cell": (nothing, "", (0, 0, 0)),
    "tetrahedra": (lambda: split_grid("tetrahedron", 2), "48 cells that aren't hexahedra", (0, 0, 0)),
    "one wedge": (lambda: split_grid("wedge", 1), "2 cells that aren't hexahedra", (0, 0, 0)),
    "one cell": (unit_cube, "", (3, 3, 1)),
    "a cell twice": (lambda: with_repeats(unit_cube(), 0), "1 cell has the same eight vertices as another", (3, 3, 1)),
    "two of a grid twice": (
        lambda: with_repeats(grid(3, 2, 2), 0, 5), "2 cells have the same eight vertices as others", (7, 16, 1),
    ),
    "all thrice": (
        lambda: with_repeats(grid(2, 1, 1), 0, 1, 0, 1), "4 cells have the same eight vertices as others", (4, 5, 1),
    ),
    "three at a face": (three_at_a_face, "1 face has more than two cells", (5, 9, 3)),
    "crossed": (crossed, "1 face has its vertices in another order in its other cell", (5, 6, 2)),
    "shared faces": (ours("faults/shared-faces"), "1 face has more than two cells", (5, 9, 3)),
    "a duplicate": (ours("faults/duplicate-cell"), "1 cell has the same eight vertices as another", (9, 27, 1)),
    "collapsed": (ours("structures/collapsed"), "60 cells repeat a vertex", (19, 94, 1)),
    "repeated vertex": (ours("faults/repeated-vertex"), "8 cells repeat a vertex", (9, 26, 1)),
    "three boxes at edges": (ours("faults/touching-edge"), "", (24, 81, 3)),
}  # fmt: skip
"""What is not traced in words; sheets, chords, blocks: those of boxes are counted by hand."""


@pytest.fixture(params=CASES)
def case(request: pytest.FixtureRequest) -> tuple[str, Session, Mesh]:
    name = str(request.param)
    mesh = prepared(CASES[name][0]())
    session = Session({name: lambda: mesh})
    session.open_offered(name)
    return name, session, mesh


def test_T1_awkward_meshes_are_traced_to_the_end_and_told(case: tuple[str, Session, Mesh]) -> None:
    name, session, mesh = case
    _, skipped, counts = CASES[name]
    for _ in STEPS:
        answer = session.trace()
    assert answer["next"] is None
    facts = session.structure_facts(True)
    assert plain(facts) and facts.get("skipped", "") == skipped
    found = facts["sheets"]["count"], facts["chords"]["count"], facts["base_complex"]["blocks"]
    assert found == counts
    assert facts["irregular"]["arcs"] == facts["irregular"]["loops"] == 0
    assert (facts["class"] is None) == bool(skipped or not mesh.cell_count)
    for table in TABLES:
        for variant in ("whole", "interior"):
            told = session.structure_table(table, variant)
            assert plain(told) and len(session.structure_csv(table, variant).splitlines()) == 1 + told["rows"]
    assert plain(session.sheet_pairs()) and session.sheet_pairs()["count"] == counts[0]
    for kind in ("arcs", "sheets", "chords", "blocks"):
        box = session.structure_box(kind, [0])
        there = dict(zip(("sheets", "chords", "blocks"), counts, strict=True)).get(kind)
        assert plain(box) and (there is None or (box is None) == (there == 0))


def test_T4_awkward_meshes_are_looked_at_in_every_way(case: tuple[str, Session, Mesh]) -> None:
    name, session, mesh = case
    screen, truth = Screen(session), Truth(mesh)
    every = np.ones(mesh.cell_count, bool)
    screen.update()
    outer = set((np.array(screen.faces("surface"), int) // 8).tolist())
    usual = not len(mesh.topology.repeated_cells) and not mesh.topology.nonmanifold_face_count
    for look in all_looks(mesh):
        screen.update({"structure": look, "colour": {"by": "block"}})
        assert plain(screen.records)
        seen = set((np.array(screen.faces("surface") + screen.faces("see_through"), int) // 8).tolist())
        assert seen <= set(range(mesh.cell_count))
        if look["form"] == "cells" or look["kind"] == "none":
            assert seen >= outer, "what is seen from outside is drawn, whole or faint"
        if look["form"] == "surfaces" and look["kind"] in ("arcs", "chords"):
            assert screen.faces("surface") == []
        if usual and name != "crossed" and look["kind"] in ("none", "blocks") and look["form"] == "cells":
            assert screen.faces("surface") == truth.around(truth.solid(look, every), look)
    for mode in ("darkness_coded_edges", "fissure", "rounded"):
        screen.update(
            {
                "structure": {"kind": "blocks", "form": "cells", "explode": 1, "chosen": []},
                "separation": {"mode": mode},
            }
        )
        assert (len(screen.faces("surface")) > 0) == (mesh.cell_count > 0)


def test_T5_awkward_meshes_are_coloured_filtered_measured_and_saved(case: tuple[str, Session, Mesh]) -> None:
    name, session, mesh = case
    count = mesh.cell_count
    traced = hexalab.structure(mesh).block_of_cells >= 0
    assert traced.any() == (CASES[name][2][0] > 0)
    for id in QUANTITIES:
        values = session.values(id)
        finite = np.isfinite(values)
        assert values.shape == (count,) and (
            not finite.any() if id.endswith("distance") else (finite == traced).all()
        )
        assert plain(session.update({"colour": {"by": "attribute", "attribute": id}}))
        assert session.histogram(id)["counts"].sum() == finite.sum() and plain(session.quality(id))
    for by in ("block", "chosen"):
        places = session.update({"colour": {"by": by}})["colour"]["map_position"]
        assert np.isnan(places).tolist() == ((~traced).tolist() if by == "block" else [False] * count)
    for keep, expected in (("inside", traced), ("outside", ~traced)):
        chosen = {"blocks": [*range(CASES[name][2][2] + 1)], "keep": keep}
        update = session.update({"filters": {"structure": chosen}})
        assert update["shown_cells"] == expected.sum()
    session.update({"filters": {"structure": {"blocks": []}}})
    if count:
        saved = read_bytes(session.save_cells("vtu", structure=True)["data"].tobytes(), "a.vtu")
        assert (np.asarray(saved.cell_data["block"]) >= 0).tolist() == traced.tolist()
        for _ in STEPS:
            session.trace()
        for cell in range(min(count, 5)):
            told = session.inspect(cell)["structure"]
            assert (told["block"] is None) == (not traced[cell]) == (told["sheets"] == [])
    assert set(CELL_DATA) >= {"block", "sheet_1"}


def test_T1_of_cells_that_are_there_twice_the_first_is_traced() -> None:
    once, twice = grid(3, 3, 3), with_repeats(grid(3, 3, 3), 13, 0)
    one, two = hexalab.structure(once), hexalab.structure(twice)
    for mine, theirs in (
        (one.sheet_of_cells, two.sheet_of_cells),
        (one.chord_of_cells, two.chord_of_cells),
        (one.block_of_cells[None], two.block_of_cells[None]),
    ):
        assert np.array_equal(mine, theirs[:, :27]) and (theirs[:, 27:] == -1).all()
    assert two.frame.count == 27


def test_T1_a_file_of_tetrahedra_is_traced_through_the_door() -> None:
    session = Session()
    session.open("tets.mesh", write_bytes(split_grid("tetrahedron", 1), "mesh"))
    session.update({"structure": {"kind": "blocks", "form": "surfaces", "curves": True}})
    assert session.structure_facts()["skipped"] == "6 cells that aren't hexahedra"
