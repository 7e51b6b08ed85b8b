"""`hexalab structure`, and structure as attributes of a converted mesh (SPEC T6).

Truths: grids, whose sheets are their layers and whose chords their rows, and dictionaries for the ends of arcs.
"""

from __future__ import annotations

import csv
import io
import json
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from hexalab import Mesh, read, structure, write
from hexalab.cli.structure import described
from hexalab.structure import CELL_DATA, TABLES, facts_of
from tests.core.conftest import grid_points
from tests.core.topology.brute_force import BruteForce
from tests.tools import tool

meshio = tool("meshio")

Run = Callable[..., tuple[int, str, str]]

STRUCTURES = Path(__file__).resolve().parents[3] / "repository" / "structures"
O_GRID, MIXED = STRUCTURES / "o-grid.mesh", STRUCTURES / "mixed.mesh"

KEYS = {
    "irregular": {
        "nodes", "nodes_inside", "arcs", "loops", "arcs_by_valence", "loops_by_valence", "node_types",
    },
    "sheets": {"count", "closed", "self_intersecting", "self_touching", "one_sided"},
    "chords": {"count", "closed", "self_intersecting"},
    "base_complex": {
        "blocks", "vertices", "edges", "faces", "kinds", "dims", "separation_faces", "cells_per_block",
    },
    "interior_base_complex": {"blocks"},
    "labels": {"sheets", "chords", "blocks"},
}  # fmt: skip
"""Keys of each part of the facts."""

ROWS = {"arcs": 4, "nodes": 8, "sheets": 6 + 2 + 4, "chords": 20 + 6 * 2 + 6 * 4, "blocks": 5}
"""Rows of each table of the O-grid: six layers, each with a core of 2 x 2 cells and two rings of 8 around it."""


def test_T6_text_tells_what_is_there(run: Run, mesh_file: Path) -> None:
    code, out, err = run("structure", mesh_file)
    assert (code, err) == (0, "")
    told = {line[2:28].strip(): line[28:].strip() for line in out.splitlines()[1:]}
    assert out.splitlines()[0] == str(mesh_file)
    assert told["Irregular edges inside"] == "0 arcs, 0 loops, 0 nodes"
    assert (told["Sheets"], told["Chords"], told["Blocks"]) == ("9", "26", "1 box")
    assert told["Base complex"] == "8 vertices, 12 edges, 6 faces"
    assert (told["Cells per block"], told["Class"]) == ("24.00", "regular")
    assert "2x3x4  1" in out
    assert max(map(len, out.splitlines())) <= max(110, len(str(mesh_file)))


def test_T6_text_of_several_files_and_of_what_is_not_traced(run: Run) -> None:
    code, out, err = run("structure", O_GRID, MIXED)
    assert (code, err) == (0, "")
    first, second = out.split(f"\n\n{MIXED}\n")
    assert "4 arcs, 0 loops, 8 nodes" in first and "b 3  8" in first and "Not traced" not in first
    assert "Not traced: 44 cells that aren't hexahedra; structure ends there." in second


def test_T6_json_is_one_object_a_line_with_all_keys(run: Run, mesh_file: Path, tmp_path: Path) -> None:
    bad = tmp_path / "bad.mesh"
    bad.write_bytes(mesh_file.read_bytes()[:200])
    code, out, err = run("structure", "--json", mesh_file, bad, O_GRID, tmp_path / "none.mesh", MIXED)
    assert code == 2
    complaints = err.splitlines()
    assert len(complaints) == 2 and "bad.mesh" in complaints[0] and "none.mesh" in complaints[1]
    assert "Traceback" not in err
    grid, o_grid, mixed = map(json.loads, out.splitlines())
    assert [found["file"] for found in (grid, o_grid, mixed)] == [str(mesh_file), str(O_GRID), str(MIXED)]
    for found in (grid, o_grid, mixed):
        assert {"file", "class", "irregular_vertex_share"} | set(KEYS) <= set(found)
        for part, keys in KEYS.items():
            assert keys <= set(found[part]), part
    assert "skipped" not in grid and mixed["skipped"] == "44 cells that aren't hexahedra"
    assert grid["sheets"]["count"] == 2 + 3 + 4 and grid["chords"]["count"] == 3 * 4 + 2 * 4 + 2 * 3
    assert (grid["class"], o_grid["class"]) == ("regular", None)
    assert o_grid["irregular"]["arcs_by_valence"] == {"3": 4}
    assert o_grid["base_complex"]["dims"] == {"2x2x6": 5}


@pytest.mark.parametrize("name", TABLES)
def test_T6_csv_of_each_table(run: Run, name: str) -> None:
    code, out, err = run("structure", "--csv", name, O_GRID)
    assert (code, err) == (0, "")
    heads, *rows = csv.reader(io.StringIO(out))
    assert heads[0] == "number" and len(set(heads)) == len(heads)
    assert [row[0] for row in rows] == [str(number) for number in range(ROWS[name])]
    assert all(len(row) == len(heads) for row in rows)


def test_T6_csv_agrees_with_a_grid(run: Run, mesh_file: Path) -> None:
    tables = {
        name: list(csv.DictReader(io.StringIO(run("structure", "--csv", name, mesh_file)[1])))
        for name in TABLES
    }
    assert tables["arcs"] == tables["nodes"] == []
    assert Counter(row["cells"] for row in tables["sheets"]) == {"12": 2, "8": 3, "6": 4}
    assert {row["kind"] for row in tables["sheets"]} == {"plain"}
    assert {(row["closed"], row["one_sided"]) for row in tables["sheets"]} == {("no", "no")}
    assert Counter(row["length"] for row in tables["chords"]) == {"2": 12, "3": 8, "4": 6}
    (block,) = tables["blocks"]
    assert [block[key] for key in ("cells", "kind", "i", "j", "k")] == ["24", "box", "2", "3", "4"]


def test_T6_arcs_and_nodes_go_by_the_numbers_of_the_file(run: Run) -> None:
    truth = BruteForce(read(O_GRID).cells.tolist())
    inside = {edge for edge, cells in truth.edge_cells.items() if len(cells) == 3} - truth.boundary_edges
    meeting = Counter(vertex for edge in inside for vertex in edge)
    ends = {str(vertex + 1) for vertex, edges in meeting.items() if edges == 1}  # Medit counts from 1
    arcs = list(csv.DictReader(io.StringIO(run("structure", "--csv", "arcs", O_GRID)[1])))
    assert {row[end] for row in arcs for end in ("from", "to")} == ends
    assert sum(int(row["edges"]) for row in arcs) == len(inside)
    assert {(row["valence"], row["closed"], row["boundary"]) for row in arcs} == {("3", "no", "no")}
    nodes = list(csv.DictReader(io.StringIO(run("structure", "--csv", "nodes", O_GRID)[1])))
    assert {row["vertex"] for row in nodes} == ends and {row["type"] for row in nodes} == {"b 3"}


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--csv", "arcs", O_GRID, MIXED], "--csv prints a table of one mesh: found 2 files"),
        (["--csv", "walls", O_GRID], "walls"),
        (["--csv", "arcs", "--json", O_GRID], "--json"),
        (["none.mesh"], "none.mesh"),
        (["--csv", "sheets", "none.mesh"], "none.mesh"),
        (["--json", STRUCTURES / "source.yaml"], "source.yaml"),
        ([], "FILE"),
    ],
)
def test_T6_a_mistake_is_one_line_and_exit_code_2(run: Run, words: list[object], told: str) -> None:
    code, out, err = run("structure", *words)
    assert (code, out) == (2, "")
    assert told in err and err.count("\n") == 1 and err.startswith("hexalab")


@pytest.fixture
def layered(tmp_path: Path) -> tuple[Path, np.ndarray]:
    """A grid of 2 x 3 x 4 cells in a shuffled order, with an attribute "block"; (3, C): the layers of each cell."""
    order = np.random.default_rng(5).permutation(24)
    points, cells = grid_points((2, 3, 4))
    cell = np.arange(24)
    layers = np.stack([cell % 2, cell // 2 % 3, cell // 6])[:, order]
    write(Mesh.from_cells(points, cells[order], cell_data={"block": np.ones(24)}), tmp_path / "grid.vtu")
    return tmp_path / "grid.vtu", layers


def tell_apart(labels: np.ndarray, *keys: np.ndarray) -> bool:
    """Whether things have the same label exactly where all keys are the same."""
    rows = list(zip(*(key.tolist() for key in keys), strict=True))
    return len(set(labels.tolist())) == len(set(rows)) == len(set(zip(labels.tolist(), rows, strict=True)))


@pytest.mark.parametrize("ending", ["vtu", "vtk", "msh"])
def test_T6_structure_is_added_to_a_converted_mesh(
    run: Run, layered: tuple[Path, np.ndarray], tmp_path: Path, ending: str
) -> None:
    source, layers = layered
    target = tmp_path / f"out.{ending}"
    assert run("convert", "--structure", source, target)[::2] == (0, "")
    data = read(target).cell_data
    assert {"block", "block (traced)", *CELL_DATA} <= set(data), "a name that is taken is kept"
    assert (data["block"] == 1).all() and (data["block (traced)"] == 0).all()
    assert (data["irregular_distance"] == -1).all(), "no way leads to an irregular edge"
    for direction in range(3):
        across, beside, below = (layers[(direction + k) % 3] for k in range(3))
        assert tell_apart(data[f"sheet_{direction + 1}"], across)
        assert tell_apart(data[f"chord_{direction + 1}"], beside, below)
    for what, number in (("sheet", 2 + 3 + 4), ("chord", 6 + 8 + 12)):
        assert set(np.concatenate([data[f"{what}_{k}"] for k in (1, 2, 3)])) == set(range(number))


def test_T6_meshio_reads_the_structure_that_was_written(run: Run, tmp_path: Path) -> None:
    target = tmp_path / "out.vtu"
    assert run("convert", "--structure", MIXED, target)[0] == 0
    theirs = meshio.read(target)
    traced = structure(read(MIXED))
    written = {name: np.concatenate(theirs.cell_data[name]).reshape(-1) for name in CELL_DATA}
    for name, values in CELL_DATA.items():
        assert written[name].tolist() == values(traced).tolist(), name
    hexahedra = np.repeat(
        [block.type == "hexahedron" for block in theirs.cells], [len(block) for block in theirs.cells]
    )
    assert ((written["sheet_1"] >= 0) == hexahedra).all() and not hexahedra.all()


def test_T6_a_format_without_a_place_for_it_says_so(run: Run, tmp_path: Path) -> None:
    code, _, err = run("convert", "--structure", O_GRID, tmp_path / "out.mesh")
    assert code == 0
    assert all(f"{name} (of cells)" in err for name in CELL_DATA)


def test_T1_ends_and_t_junctions_inside_are_told_by_the_types_of_nodes() -> None:
    facts = json.loads(json.dumps(facts_of(structure(read(O_GRID)))))
    lines = described("o-grid.mesh", facts).splitlines()
    assert not [line for line in lines if "Ends of arcs" in line or "T junctions" in line]
    facts["irregular"]["node_types"] |= {"i 5": 2, "i 6 6 6": 3, "i 3 3 5": 4, "i 3 3 3 3": 8, "b 6": 16}
    told = [line.split("  ") for line in described("o-grid.mesh", facts).splitlines()]
    counts = {row[1].strip(): row[-1].strip() for row in told if len(row) > 1}
    assert (counts["Ends of arcs inside"], counts["T junctions inside"]) == ("2", "7")
