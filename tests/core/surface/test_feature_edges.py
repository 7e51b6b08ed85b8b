"""Feature edges: closed forms, dictionaries, and vtkFeatureEdges on whole meshes."""

from __future__ import annotations

import gc
import math
from collections import defaultdict
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hexalab.formats import read
from hexalab.mesh import Mesh
from hexalab.surface import DrawnMesh, boundary_edge_angles, sharp_edges
from hexalab.surface.feature_edges import _KEPT
from tests.core.surface.shapes import KINDS, grid, grid_cells, grid_points, mesh_of, split_grid
from tests.core.topology.brute_force import FACES, BruteForce
from tests.core.topology.strategies import meshes
from tests.tools import tool
from tests.whole_meshes import WHOLE_MESHES, WholeMesh

vtk, numpy_support = tool("vtk"), tool("vtk.util.numpy_support")

Edge = frozenset[int]

MIRRORED = [4, 5, 6, 7, 0, 1, 2, 3]
"""Corners of a cell numbered anew, so that it is of opposite orientation."""

LEFT_OUT = {
    "faults/coincident-vertices.mesh": "VTK takes vertices at one place for one",
    "faults/zero-volume.mesh": "VTK takes vertices at one place for one",
    "faults/repeated-vertex.mesh": "VTK takes a face for an edge's whose diagonal has its ends",
    "faults/opposite-orientation.mesh": "VTK takes normals as the cells tell, where one is turned round",
}

COMPARED = [whole for whole in WHOLE_MESHES if whole.cells < 10_000 and whole.name not in LEFT_OUT]


def pairs(edges: np.ndarray) -> set[Edge]:
    assert edges.dtype == np.int32 and (edges[0] < edges[1]).all()
    found = {frozenset(pair) for pair in edges.T.tolist()}
    assert len(found) == edges.shape[1], "each edge once"
    return found


def polygons(cells: list[list[int]]) -> list[list[int]]:
    """Faces of exactly one cell as rings without repeats, outside of the cell to the front, by dictionaries."""
    truth = BruteForce(cells)
    rings = [
        [cells[number][place] for place in FACES[local]]
        for face in truth.boundary
        for number, local in truth.face_sides[face]
    ]
    whole = [[v for v, before in zip(ring, [ring[-1], *ring], strict=False) if v != before] for ring in rings]
    return [ring for ring in whole if len(set(ring)) == len(ring)]


def cylinder(n: int, layers: int) -> Mesh:
    """A round bar: each square ring of a grid of 2n x 2n cells becomes a circle, its vertices equally far apart."""
    points = grid_points(2 * n, 2 * n, layers)
    x, y = points[:, 0] - n, points[:, 1] - n
    ring = np.maximum(abs(x), abs(y))
    with np.errstate(invalid="ignore"):
        octants = np.select(
            [(x == ring) & (y > -ring), (y == ring), (x == -ring)],
            [y / ring, 2 - x / ring, 4 - y / ring],
            6 + x / ring,
        )
    turn = np.nan_to_num(octants * math.pi / 4)
    points[:, 0], points[:, 1] = ring * np.cos(turn), ring * np.sin(turn)
    return mesh_of(points, grid_cells(2 * n, 2 * n, layers))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", [1, 2, 5])
def test_a_cube_has_its_twelve_edges(kind: str, n: int) -> None:
    mesh = split_grid(kind, n)
    _, angles = boundary_edge_angles(mesh)
    assert set(angles.round(6)) <= {0, 90}
    sharp = sharp_edges(mesh, 89.9)
    assert sharp.shape == (2, 12 * n)
    on_rims = [sum(side in (0, n) for side in mesh.points[v]) >= 2 for v in sharp.reshape(-1)]
    assert all(on_rims)
    assert pairs(sharp_edges(mesh, 1e-6)) == pairs(sharp)
    assert sharp_edges(mesh, 90.1).shape == (2, 0)


def test_the_angle_itself_is_not_sharper_than_it() -> None:
    assert sharp_edges(grid(1, 1, 1), 90).shape == (2, 0)
    assert sharp_edges(grid(1, 1, 1), np.nextafter(90, 0)).shape == (2, 12)


@pytest.mark.parametrize(("n", "layers"), [(1, 1), (2, 3), (5, 2)])
def test_a_cylinder_has_two_rims_and_the_sides_of_its_polygon(n: int, layers: int) -> None:
    mesh, sides = cylinder(n, layers), 8 * n
    vertices, angles = boundary_edge_angles(mesh)
    between = np.isclose(angles, 360 / sides)
    assert between.sum() == sides * layers
    assert np.isclose(angles, 90).sum() == 2 * sides
    assert np.isclose(angles, 0, atol=1e-5).sum() == len(angles) - sides * (layers + 2)
    rims = pairs(sharp_edges(mesh, 360 / sides + 0.01))
    assert len(rims) == 2 * sides
    assert all(len({mesh.points[v][2] for v in edge}) == 1 for edge in rims)
    assert len(pairs(sharp_edges(mesh, 360 / sides - 0.01))) == sides * (layers + 2)
    upright = mesh.points[vertices[:, between]]
    assert (upright[0, :, :2] == upright[1, :, :2]).all(), "the sides stand upright"


def test_two_cubes_that_share_an_edge_alone_have_it_whatever_the_angle() -> None:
    cells = grid_cells(2, 2, 1)[[0, 3]]
    mesh = mesh_of(grid_points(2, 2, 1), cells)
    assert boundary_edge_angles(mesh).nonmanifold_count == 1
    (edge,) = pairs(sharp_edges(mesh, 180))
    assert {tuple(mesh.points[v]) for v in edge} == {(1, 1, 0), (1, 1, 1)}
    assert len(pairs(sharp_edges(mesh, 45))) == 23


def test_the_end_of_a_slit_turns_back_by_180_degrees() -> None:
    """Four cubes around an edge; the face between two of them is torn, so that its inner edge is the boundary's."""
    points = grid_points(2, 2, 1)
    cells = grid_cells(2, 2, 1)
    cells[1][cells[1] == 1], cells[1][cells[1] == 10] = 18, 19
    mesh = mesh_of(np.concatenate([points, points[[1, 10]]]), cells)
    vertices, angles = boundary_edge_angles(mesh)
    assert vertices[:, angles > 179.999].T.tolist() == [[4, 13]]
    assert angles.max() == 180


def test_three_cells_at_one_face_leave_edges_of_three_faces() -> None:
    cells = [[0, 1, 2, 3, *range(4 * n, 4 * n + 4)] for n in (1, 2, 3)]
    points = np.random.default_rng(1).uniform(size=(16, 3))
    found = boundary_edge_angles(mesh_of(points, np.array(cells)))
    assert found.nonmanifold_count == 4
    assert pairs(found.vertices[:, np.isinf(found.angles)]) == {
        frozenset(one) for one in ((0, 1), (1, 2), (2, 3), (3, 0))
    }


def test_no_cells_and_no_boundary_have_no_edges() -> None:
    assert sharp_edges(mesh_of(np.zeros((0, 3)), np.zeros((0, 8))), 0).shape == (2, 0)
    vanished = mesh_of(np.zeros((1, 3)), np.zeros((3, 8)))
    assert sharp_edges(vanished, 0).shape == (2, 0)


def angles_of(mesh: Mesh) -> dict[Edge, float]:
    vertices, angles = boundary_edge_angles(mesh)
    return {frozenset(pair): angle for pair, angle in zip(vertices.T.tolist(), angles.tolist(), strict=True)}


def test_a_cell_of_opposite_orientation_bends_as_its_neighbours_do() -> None:
    mesh = grid(3, 3, 3, jitter=0.2)
    cells = mesh.cells.copy()
    for some in (slice(None, None, 5), slice(None)):
        cells[some] = cells[some][:, MIRRORED]
        turned = mesh_of(mesh.points, cells)
        assert angles_of(turned).keys() == angles_of(mesh).keys()
        for edge, angle in angles_of(mesh).items():
            assert angles_of(turned)[edge] == pytest.approx(angle, abs=1e-9)


@pytest.mark.parametrize("power", [-900, -300, 300, 900])
def test_angles_do_not_depend_on_the_unit(power: int) -> None:
    mesh = grid(3, 2, 2, jitter=0.2)
    scaled = replace(mesh, coordinates=np.ldexp(mesh.coordinates, power))
    assert angles_of(scaled) == angles_of(mesh)


def test_a_flat_face_looks_out_of_its_cell() -> None:
    """A cube one of whose faces has drawn together to a line: it has no normal of its own."""
    mesh = grid(1, 1, 1, turned=False)
    coordinates = mesh.coordinates.copy()
    coordinates[1, [4, 5, 6, 7]] = 0.5
    roof = replace(mesh, coordinates=coordinates)
    slope = math.degrees(math.atan(0.5))
    found = angles_of(roof)
    assert found[frozenset((4, 5))] == found[frozenset((6, 7))] == pytest.approx(90 - slope)
    assert found[frozenset((0, 1))] == pytest.approx(90 + slope)


def test_where_nothing_has_a_direction_nothing_is_sharp() -> None:
    _, angles = boundary_edge_angles(mesh_of(np.zeros((8, 3)), np.arange(8)))
    assert len(angles) == 12 and np.isnan(angles).all()
    assert sharp_edges(mesh_of(np.zeros((8, 3)), np.arange(8)), 0).shape == (2, 0)


def test_cells_that_repeat_others_hide_no_edges_of_the_drawn_mesh() -> None:
    mesh = grid(2, 2, 2)
    twice = mesh_of(mesh.points, np.concatenate([mesh.cells, mesh.cells[:1]]))
    assert pairs(sharp_edges(DrawnMesh(twice).mesh, 45)) == pairs(sharp_edges(mesh, 45))


def test_angles_are_found_once_and_go_with_the_mesh() -> None:
    mesh = grid(2, 2, 2)
    assert boundary_edge_angles(mesh) is boundary_edge_angles(mesh)
    count = len(_KEPT)
    del mesh
    gc.collect()
    assert len(_KEPT) < count


def by_dictionaries(points: np.ndarray, cells: list[list[int]]) -> dict[Edge, float]:
    """Angle at each edge of the boundary; normals as Newell sums them."""
    around: dict[Edge, list[tuple[tuple[int, int], np.ndarray]]] = defaultdict(list)
    for ring in polygons(cells):
        sides = list(pairwise([*ring, ring[0]]))
        middle = points[ring].mean(axis=0)
        normal = sum(np.cross(points[a] - middle, points[b] - middle) for a, b in sides)
        for side in sides:
            around[frozenset(side)].append((side, normal))
    found = {}
    for edge, faces in around.items():
        if len(faces) != 2:
            found[edge] = math.inf
            continue
        (one, u), (other, v) = faces
        v = -v if one == other else v
        found[edge] = math.degrees(math.atan2(float(np.linalg.norm(np.cross(u, v))), float(u @ v)))
    return found


@given(meshes, st.integers(0, 2**32 - 1))
@settings(max_examples=200, deadline=None)
def test_random_meshes_equal_dictionaries(cells: np.ndarray, seed: int) -> None:
    points = np.random.default_rng(seed).normal(size=(int(cells.max(initial=0)) + 1, 3))
    expected = by_dictionaries(points, cells.tolist())
    found = angles_of(mesh_of(points, cells))
    assert found.keys() == expected.keys()
    for edge, angle in expected.items():
        assert found[edge] == pytest.approx(angle, abs=1e-6)
    mesh = mesh_of(points, cells)
    assert pairs(sharp_edges(mesh, 100)) == {edge for edge, angle in found.items() if angle > 100}
    assert boundary_edge_angles(mesh).nonmanifold_count == sum(map(math.isinf, expected.values()))


@pytest.mark.parametrize("whole", [whole for whole in WHOLE_MESHES if whole.name in LEFT_OUT], ids=str)
def test_meshes_of_which_vtk_tells_something_else_equal_dictionaries(whole: WholeMesh) -> None:
    mesh = read(whole.file())
    expected, found = by_dictionaries(mesh.points, mesh.cells.tolist()), angles_of(mesh)
    assert found.keys() == expected.keys()
    flat = whole.name == "faults/zero-volume.mesh"  # faces without a normal of their own
    for edge, angle in expected.items():
        assert flat or found[edge] == pytest.approx(angle, abs=1e-6)
        assert math.isinf(found[edge]) == math.isinf(angle)


def by_vtk(points: np.ndarray, rings: list[list[int]], angle: float) -> set[Edge]:
    """What vtkFeatureEdges finds on polygons: feature, boundary and non-manifold edges."""
    data, places, faces = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    places.SetData(numpy_support.numpy_to_vtk(np.ascontiguousarray(points, float), deep=1))
    for ring in rings:
        faces.InsertNextCell(len(ring), ring)
    data.SetPoints(places)
    data.SetPolys(faces)
    ids = numpy_support.numpy_to_vtk(np.arange(len(points)), deep=1)
    ids.SetName("id")
    data.GetPointData().AddArray(ids)
    finder = vtk.vtkFeatureEdges()
    finder.SetInputData(data)
    finder.SetFeatureAngle(angle)
    finder.ColoringOff()
    for switch in ("FeatureEdgesOn", "BoundaryEdgesOn", "NonManifoldEdgesOn", "ManifoldEdgesOff"):
        getattr(finder, switch)()
    finder.Update()
    out = finder.GetOutput()
    if not out.GetNumberOfLines():
        return set()
    own = numpy_support.vtk_to_numpy(out.GetPointData().GetArray("id"))
    lines = numpy_support.vtk_to_numpy(out.GetLines().GetConnectivityArray()).reshape(-1, 2)
    return {frozenset(pair) for pair in own[lines].tolist()}


@pytest.mark.parametrize("whole", COMPARED, ids=str)
def test_whole_meshes_have_the_edges_that_vtk_finds(whole: WholeMesh) -> None:
    mesh = read(whole.file())
    rings = polygons(mesh.cells.tolist())
    angles = angles_of(mesh)
    for threshold in (15.5, 30.5, 60.5):
        unsure = {
            edge for edge, angle in angles.items() if abs(angle - threshold) < 1e-4 or math.isnan(angle)
        }
        expected = by_vtk(mesh.points, rings, threshold)
        assert pairs(sharp_edges(mesh, threshold)) - unsure == expected - unsure
