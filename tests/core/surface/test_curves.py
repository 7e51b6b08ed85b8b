"""Curves and points of the structure (SPEC T4): line by line, against dictionaries."""

from __future__ import annotations

from collections import Counter
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import hexalab
from hexalab.structure import Structure
from hexalab.structure.graph import Graph
from hexalab.surface import DrawnMesh, ExplodedMesh, Pieces
from hexalab.surface.curves import BASE, CHORD_ROWS, CHORDS, NODES, VERTICES, Drawing
from hexalab.surface.records import Curves
from tests.core.structure.brute_force import EDGES, FACES, OPPOSITE, Slow
from tests.core.surface.shapes import grid, random_mask

REPOSITORY = Path(__file__).resolve().parents[3] / "repository"
NAMES = (
    "layouts/nodes-of-six", "structures/valence-8", "structures/self-crossing", "structures/mixed",
    "structures/o-grid", "layouts/hoops", "shapes/t-junction",
)  # fmt: skip

Edge = frozenset[int]


@cache
def opened(name: str) -> tuple[DrawnMesh, Structure, Slow, list[int]]:
    """A mesh, its structure, the same of its hexahedra by dictionaries, and their rows."""
    mesh = hexalab.read(REPOSITORY / f"{name}.mesh")
    rows = [cell for cell in range(mesh.cell_count) if len(set(mesh.cells[cell].tolist())) == 8]
    return DrawnMesh(mesh), hexalab.structure(mesh), Slow(mesh.cells[rows].tolist()), rows


def graph_of(structure: Structure, whole: bool) -> Graph:
    return structure.whole_graph if whole else structure.graph


def vertices_at(drawn_mesh: DrawnMesh) -> dict[tuple[float, ...], int]:
    """The vertex at each place."""
    return {tuple(place): vertex for vertex, place in enumerate(drawn_mesh.coordinates.T.tolist())}


def lines_of(drawn_mesh: DrawnMesh, record: Curves) -> list[Edge]:
    """The vertices of each line."""
    at = vertices_at(drawn_mesh)
    return [frozenset(at[tuple(end)] for end in line) for line in record.edges.reshape(-1, 2, 3).tolist()]


def points_of(drawn_mesh: DrawnMesh, record: Curves) -> list[int]:
    """The vertex of each point."""
    at = vertices_at(drawn_mesh)
    return [at[tuple(place)] for place in record.points.reshape(-1, 3).tolist()]


def check_form(record: Curves) -> None:
    """Number types, and a row and a flag for each line and point."""
    assert record.edges.dtype == record.points.dtype == np.float32
    for positions, width, rows, faint in (
        (record.edges, 6, record.edge_rows, record.edge_faint),
        (record.points, 3, record.point_rows, record.point_faint),
    ):
        assert rows.dtype == faint.dtype == np.uint8
        assert len(positions) == width * len(rows) == width * len(faint)
        assert set(faint.tolist()) <= {0, 1}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("whole", [False, True])
def test_T1_T4_arcs_are_the_irregular_edges_in_rows_by_valence(name: str, whole: bool) -> None:
    drawn_mesh, structure, slow, _ = opened(name)
    graph, drawing = graph_of(structure, whole), Drawing()
    drawing.arcs(drawn_mesh, graph, np.ones(graph.count, bool))
    record = drawing.record()
    check_form(record)
    irregular = slow.irregular if whole else slow.irregular - slow.boundary_edges
    row = {edge: min(max(len(slow.edge_cells[edge]), 2), 6) - 2 for edge in irregular}
    found = list(zip(lines_of(drawn_mesh, record), record.edge_rows.tolist(), strict=True))
    assert len(found) == len(row) and dict(found) == row
    assert not record.edge_faint.any() and not record.point_faint.any()
    nodes = points_of(drawn_mesh, record)
    assert len(nodes) == len(set(nodes)) and set(nodes) == slow.graph(whole)[0]
    assert set(record.point_rows.tolist()) <= {NODES}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("whole", [False, True])
def test_T4_arcs_that_are_not_chosen_are_faint_and_nodes_at_none_that_is(name: str, whole: bool) -> None:
    drawn_mesh, structure, slow, _ = opened(name)
    graph, drawing = graph_of(structure, whole), Drawing()
    chosen = random_mask(graph.count, 4, 0.4)
    drawing.arcs(drawn_mesh, graph, chosen)
    record = drawing.record()
    first = [frozenset(chain[:2].tolist()) for chain in graph.chains]
    _, chains = slow.graph(whole)
    strong = set().union(
        *(chain for chain in chains if any(first[k] in chain for k in np.flatnonzero(chosen)))
    )
    for line, faint in zip(lines_of(drawn_mesh, record), record.edge_faint, strict=True):
        assert (line not in strong) == faint
    near_one = set().union(*strong)  # chains end at nodes: within one there is none
    for vertex, faint in zip(points_of(drawn_mesh, record), record.point_faint, strict=True):
        assert (vertex not in near_one) == faint


@pytest.mark.parametrize("name", NAMES)
def test_T2_T4_chords_lead_from_face_to_face_through_the_cells_that_are_shown(name: str) -> None:
    drawn_mesh, structure, slow, rows = opened(name)
    shown = random_mask(drawn_mesh.mesh.cell_count, 5, 0.8)
    chords = structure.chords
    chosen = np.flatnonzero(random_mask(chords.count, 2, 0.3)).astype(np.int32)
    drawing = Drawing()
    drawing.chords(drawn_mesh, structure.frame, chords, chosen, shown)
    record = drawing.record()
    check_form(record)
    assert not record.edge_faint.any() and not len(record.points)
    label = slow.chords()
    row: dict[int, int] = {}
    for cell in range(len(slow.cells)):
        for d, (a, _) in enumerate(OPPOSITE):
            number = int(chords.of_cells[d, cell])
            if number in chosen:
                face = frozenset(slow.cells[cell][place] for place in FACES[a])
                row[label[face]] = CHORDS + chosen.tolist().index(number) % CHORD_ROWS
    expected = Counter(
        (frozenset(middle(drawn_mesh, slow.cells[place], side) for side in pair), row[label[face]])
        for place, cell in enumerate(rows)
        for pair in OPPOSITE
        for face in [frozenset(slow.cells[place][corner] for corner in FACES[pair[0]])]
        if shown[cell] and label[face] in row
    )
    lines = record.edges.reshape(-1, 2, 3)
    found = Counter(
        (frozenset(map(near, line)), number)
        for line, number in zip(lines, record.edge_rows.tolist(), strict=True)
    )
    assert found == expected and found


def near(place: NDArray[np.float32]) -> tuple[float, ...]:
    return tuple(np.round(place.astype(float) * 2**14).tolist())


def middle(drawn_mesh: DrawnMesh, cell: list[int], side: int) -> tuple[float, ...]:
    return near(drawn_mesh.points(np.array([cell[place] for place in FACES[side]])).mean(axis=1))


def test_T2_T4_a_chord_of_a_grid_is_a_straight_row() -> None:
    mesh = grid(3, 4, 2)
    drawn_mesh, structure = DrawnMesh(mesh), hexalab.structure(mesh)
    for chord in range(structure.chords.count):
        drawing = Drawing()
        drawing.chords(
            drawn_mesh, structure.frame, structure.chords, np.array([chord], np.int32), np.ones(24, bool)
        )
        record = drawing.record()
        places = record.edges.reshape(-1, 3) * drawn_mesh.frame.diagonal + drawn_mesh.frame.centre
        spans = np.ptp(places, axis=0).round(4)
        (axis,) = np.flatnonzero(spans)
        assert spans[axis] == (3, 4, 2)[axis] == len(record.edge_rows) == structure.chords.length[chord]
        assert np.allclose(np.delete(places, axis, axis=1) % 1, 0.5, atol=1e-4)
        assert set(record.edge_rows.tolist()) == {CHORDS}


@pytest.mark.parametrize("name", NAMES)
def test_T3_T4_edges_of_the_base_complex_are_those_all_of_whose_faces_are_complex(name: str) -> None:
    drawn_mesh, structure, slow, _ = opened(name)
    drawing = Drawing()
    drawing.base_complex(drawn_mesh, structure.frame, structure.skeleton)
    record = drawing.record()
    check_form(record)
    lines = lines_of(drawn_mesh, record)
    on = complex_edges(slow)
    assert len(lines) == len(on) and set(lines) == on
    assert set(record.edge_rows.tolist()) == {BASE} and not record.edge_faint.any()
    met: dict[int, list[Edge]] = {}
    for edge in on:
        for vertex in edge:
            met.setdefault(vertex, []).append(edge)
    corners = {
        vertex
        for vertex, edges in met.items()
        if len(edges) != 2 or slow.edge_cells[edges[0]] & slow.edge_cells[edges[1]]
    }
    points = points_of(drawn_mesh, record)
    assert len(points) == len(corners) and set(points) == corners
    assert set(record.point_rows.tolist()) <= {VERTICES}


def complex_edges(slow: Slow) -> set[Edge]:
    complex_faces = slow.walls() | slow.boundary
    return {edge for edge, faces in slow.edge_faces.items() if faces <= complex_faces}


@pytest.mark.parametrize(
    "name", ["layouts/nodes-of-six", "structures/o-grid", "structures/mixed", "shapes/t-junction"]
)
def test_T3_T4_of_blocks_drawn_apart_each_box_has_its_own_twelve_edges(name: str) -> None:
    drawn_mesh, structure, slow, rows = opened(name)
    blocks = structure.base_complex.blocks
    assert (blocks.kinds == 0).all(), "these are boxes alone"
    labels = structure.block_of_cells
    apart = ExplodedMesh(Pieces(drawn_mesh, labels), 1.0)
    drawing = Drawing()
    drawing.base_complex(apart, structure.frame, structure.skeleton)
    record = drawing.record()
    check_form(record)
    own: dict[Edge, int] = {}
    for cell in rows:
        corners = apart.mesh.corners[:, cell].tolist()
        for a, b in EDGES:
            own[frozenset((corners[a], corners[b]))] = int(labels[cell])
    places = {tuple(place): vertex for vertex, place in enumerate(apart.coordinates.T.tolist())}
    assert len(places) == apart.mesh.vertex_count, "all are apart"
    lines = [
        frozenset(places[tuple(end)] for end in line) for line in record.edges.reshape(-1, 2, 3).tolist()
    ]
    assert len(set(lines)) == len(lines) and all(len(line) == 2 for line in lines)
    of_block = Counter(own[line] for line in lines)
    assert [of_block[block] for block in range(blocks.count)] == (4 * blocks.dimensions.sum(axis=1)).tolist()
    on = complex_edges(slow)
    assert all(frozenset(apart.pieces.source[sorted(line)].tolist()) in on for line in lines)
    piece = apart.pieces.piece
    points = [places[tuple(place)] for place in record.points.reshape(-1, 3).tolist()]
    source = [(int(piece[point]), int(apart.pieces.source[point])) for point in points]
    corners_of = Counter(block for block, _ in source)
    assert all(corners_of[block] >= 8 for block in range(blocks.count))
    assert {vertex for _, vertex in source} == set(structure.skeleton.vertices.tolist())
    turning = {
        point for point, lines_at in Counter(end for line in lines for end in line).items() if lines_at == 3
    }
    assert len(turning) == 8 * blocks.count and turning <= set(points), "each box has its eight corners"


def test_T4_an_empty_drawing_is_a_record_of_nothing() -> None:
    record = Drawing().record()
    check_form(record)
    assert len(record.edges) == len(record.points) == 0
    mesh = grid(2, 2, 2)
    structure = hexalab.structure(mesh)
    drawing = Drawing()
    drawing.arcs(DrawnMesh(mesh), structure.graph, np.empty(0, bool))
    assert len(drawing.record().edges) == len(drawing.record().points) == 0
