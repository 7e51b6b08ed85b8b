"""The irregular structure: wires, barbs, paper, counts."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

from hexalab.cells import FACES
from hexalab.mesh import Mesh
from hexalab.surface import DrawnMesh, extract_irregular
from tests.core.surface.shapes import KINDS, grid, mesh_of, split_grid, three_around_an_edge
from tests.core.topology.brute_force import BruteForce


def expected_flaps(mesh: Mesh) -> dict[frozenset[int], set[frozenset[int]]]:
    """For each irregular edge the faces around it, all as sets of vertices."""
    truth = BruteForce(mesh.cells.tolist())
    boundary = truth.boundary_edges
    irregular = {
        edge for edge, around in truth.edge_cells.items() if len(around) != (2 if edge in boundary else 4)
    }
    found: dict[frozenset[int], set[frozenset[int]]] = {edge: set() for edge in irregular}
    for face, around in truth.face_sides.items():
        cell, local = around[0]
        ring = [int(mesh.corners[place, cell]) for place in FACES[local]]
        ring = [v for i, v in enumerate(ring) if v != ring[i - 1]]
        for pair in zip(ring, ring[1:] + ring[:1], strict=True):
            if frozenset(pair) in irregular:
                found[frozenset(pair)].add(face)
    return found


def check(mesh: Mesh) -> None:
    drawing = DrawnMesh(mesh)
    irregular = extract_irregular(drawing)
    truth = BruteForce(mesh.cells.tolist())
    boundary = truth.boundary_edges
    place = {tuple(point): i for i, point in enumerate(drawing.coordinates.T.tolist())}
    edges = [
        frozenset((place[tuple(a)], place[tuple(b)])) for a, b in irregular.edges.reshape(-1, 2, 3).tolist()
    ]
    expected = expected_flaps(mesh)
    assert Counter(edges) == Counter(expected.keys())
    assert irregular.valence.tolist() == [len(truth.edge_cells[edge]) for edge in edges]
    assert irregular.boundary.tolist() == [int(edge in boundary) for edge in edges]
    outer = set().union(*boundary)
    ends = [
        [place[tuple(point)] in outer for point in pair]
        for pair in irregular.edges.reshape(-1, 2, 3).tolist()
    ]
    assert irregular.ends_on_boundary.tolist() == [first + 2 * second for first, second in ends]
    for flags in (irregular.boundary, irregular.barb_boundary, irregular.paper_boundary):
        assert (np.diff(flags.astype(int)) >= 0).all()
    check_flaps(drawing, place, expected, boundary)
    for name, on_boundary, usual in (("interior", False, 4), ("boundary", True, 2)):
        valence = truth.valence(on_boundary)
        valence.pop(usual, None)
        assert irregular.counts[name] == {str(n): count for n, count in valence.items()}


def check_flaps(drawing: DrawnMesh, place: dict, expected: dict, boundary: set[frozenset[int]]) -> None:
    """Each flap lies on its face, 45 % deep; the barbs are its sides."""
    irregular = extract_irregular(drawing)
    points = drawing.coordinates.T.astype(float)
    seen: Counter[tuple[frozenset[int], frozenset[int]]] = Counter()
    flaps = irregular.paper.reshape(-1, 4, 3)
    barbs = irregular.barbs.reshape(-1, 2, 2, 3)
    assert len(flaps) == len(barbs) == len(irregular.paper_valence) == len(irregular.barb_valence) / 2
    for i, (flap, pair) in enumerate(zip(flaps, barbs, strict=True)):
        v0, v1 = (place[tuple(point)] for point in flap[:2].tolist())
        edge = frozenset((v0, v1))
        sides = {}
        for root, far in ((v0, flap[3]), (v1, flap[2])):
            goals = {v for face in expected[edge] for v in face - {root}}
            reach = {v: np.abs(points[root] + 0.45 * (points[v] - points[root]) - far).max() for v in goals}
            sides[root] = min(reach, key=lambda v: reach[v])
            assert reach[sides[root]] < 1e-6
        face = edge | set(sides.values())
        assert face in expected[edge]
        seen[edge, face] += 1
        assert (pair[:, 0] == flap[:2]).all() and (pair[:, 1] == flap[[3, 2]]).all()
        assert irregular.paper_boundary[i] == irregular.barb_boundary[2 * i] == (edge in boundary)
        assert irregular.paper_valence[i] == irregular.barb_valence[2 * i + 1]
    assert seen == Counter({(edge, face): 1 for edge, faces in expected.items() for face in faces})


@pytest.mark.parametrize("kind", KINDS)
def test_V4_irregular_edges_of_all_kinds(kind: str) -> None:
    check(split_grid(kind, 2, 0.1))


def test_V4_grid_has_no_irregular_interior() -> None:
    irregular = extract_irregular(DrawnMesh(grid(3, 4, 5)))
    assert irregular.counts == {"interior": {}, "boundary": {"1": 4 * (3 + 4 + 5)}}
    assert (irregular.boundary == 1).all() and (irregular.valence == 1).all()


def test_V4_three_cells_around_the_axis() -> None:
    layers = 3
    irregular = extract_irregular(DrawnMesh(three_around_an_edge(layers)))
    assert irregular.counts["interior"] == {"3": layers}
    assert irregular.valence[:layers].tolist() == [3] * layers
    axis = irregular.edges.reshape(-1, 2, 3)[:layers]
    assert np.allclose(axis[:, :, :2], axis[0, 0, :2], atol=1e-7)
    interior = irregular.paper_boundary == 0
    assert interior.sum() == 3 * layers and (irregular.barb_boundary == 0).sum() == 6 * layers
    assert (irregular.paper_valence[interior] == 3).all()


def test_V4_only_the_parts_asked_for() -> None:
    drawing = DrawnMesh(three_around_an_edge(1))
    wires = extract_irregular(drawing, barbs=False, paper=False)
    assert len(wires.edges) and not len(wires.barbs) and not len(wires.paper)
    assert not len(wires.barb_valence) and not len(wires.paper_boundary)
    barbed = extract_irregular(drawing, paper=False)
    assert len(barbed.barbs) == 6 * len(barbed.barb_valence) and not len(barbed.paper)
    assert set(wires.arrays()) >= {"edges", "valence", "boundary", "counts"}


def test_V4_no_cells() -> None:
    irregular = extract_irregular(DrawnMesh(mesh_of(np.empty((0, 3)), np.empty((0, 8), np.int32))))
    assert irregular.counts == {"interior": {}, "boundary": {}} and len(irregular.edges) == 0


def test_V4_a_face_of_three_cells_has_one_flap() -> None:
    """Three cubes on one square."""
    two = grid(2, 1, 1, turned=False)
    points = np.concatenate([two.points, two.points[[2, 5, 8, 11]] + [0.4, 0.1, 0.3]])
    check(mesh_of(points, np.concatenate([two.cells, [[1, 12, 13, 4, 7, 14, 15, 10]]])))
