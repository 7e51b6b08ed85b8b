"""Which box is drawn by, and what a camera is fitted to (SPEC V6)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from hexalab import Mesh, read
from hexalab.session import Session
from hexalab.surface import DrawnMesh, long_axis, outline, skin, upward
from hexalab.surface.frame import STRAY
from tests import published

from .shapes import grid


def together(first: Mesh, second: Mesh) -> Mesh:
    """Two meshes as parts of one."""
    cells = np.concatenate([first.cells, second.cells + first.vertex_count])
    return Mesh.from_cells(np.concatenate([first.points, second.points]), cells)


def moved(mesh: Mesh, *by: float) -> Mesh:
    return replace(mesh, coordinates=mesh.coordinates + np.reshape(by, (3, 1)))


def test_V6_a_mesh_is_drawn_by_its_extent():
    mesh = moved(grid(4, 3, 2), 500_000, 4_500_000, 100)
    frame = DrawnMesh(mesh).frame
    assert np.array_equal([frame.low, frame.high], mesh.extent)
    assert frame.cells == 24


def test_V6_parts_that_can_be_seen_together_are_drawn_together():
    near = together(grid(4, 3, 2), moved(grid(4, 3, 2), 0.9 * STRAY * 5, 0, 0))
    frame = DrawnMesh(near).frame
    assert frame.cells == 48
    assert np.array_equal([frame.low, frame.high], near.extent)


@pytest.mark.parametrize("stray_first", [True, False])
def test_V6_a_mesh_at_map_coordinates_with_a_stray_cell_is_drawn_by_its_largest_part(stray_first):
    body, stray = moved(grid(4, 3, 2), 500_000, 4_500_000, 100), grid(1, 1, 1)
    mesh = together(stray, body) if stray_first else together(body, stray)
    drawn = DrawnMesh(mesh)
    assert drawn.frame.cells == 24
    assert np.array_equal([drawn.frame.low, drawn.frame.high], body.extent)
    own = mesh.corners[:, -24:] if stray_first else mesh.corners[:, :24]
    places = drawn.coordinates[:, np.unique(own)]
    assert np.ptp(places, axis=1) == pytest.approx(np.array([4, 3, 2]) / np.sqrt(29), rel=1e-5)


def test_V6_a_coarse_mesh_with_gaps_between_its_vertices_is_whole():
    assert DrawnMesh(grid(1, 1, 1)).frame.cells == 1


def test_V6_an_outline_stands_for_the_body():
    rng = np.random.default_rng(0)
    ball = rng.normal(size=(3, 50_000))
    ball *= 0.5 * rng.random(50_000) ** (1 / 3) / np.linalg.norm(ball, axis=0)
    ball[:, 7] = [0, 0, 0.9]  # an arm
    points = outline(ball)
    assert points.dtype == np.float32
    assert len(points) <= 6 * 12 * 12
    for direction in rng.normal(size=(50, 3)):
        direction /= np.linalg.norm(direction)
        reach = float((direction @ ball).max())
        assert reach - 0.02 < float((points @ direction).max()) <= reach + 1e-6


def test_V6_the_outline_of_a_single_point_is_that_point():
    assert outline(np.zeros((3, 5))).tolist() == [[0, 0, 0]]


def test_V6_a_needle_has_a_long_axis_and_a_cube_has_none():
    along = np.array([0.5, -0.8, 0.33])
    along /= np.linalg.norm(along)
    t = np.linspace(-0.5, 0.5, 200)
    thin = 0.01 * np.random.default_rng(1).normal(size=(3, 200))
    found = long_axis(along[:, None] * t + thin)
    assert found is not None
    assert abs(found @ along) == pytest.approx(1, abs=1e-3)
    assert long_axis(grid(3, 3, 3).coordinates) is None
    assert long_axis(np.zeros((3, 1))) is None


def test_V6_what_the_viewer_is_told(tmp_path):
    body, stray = moved(grid(4, 3, 2), 5000, 0, 0), grid(1, 1, 1)
    mesh = together(body, stray)
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(mesh.vertex_count)]
    lines += [" ".join(map(str, [*point, 0])) for point in mesh.points]
    lines += [
        "Hexahedra",
        str(mesh.cell_count),
        *(" ".join(map(str, [*cell + 1, 0])) for cell in mesh.cells),
        "End",
    ]
    told = Session().open("stray.mesh", "\n".join(lines).encode())
    assert told["framed_cells"] == 24
    assert told["extent"] == mesh.extent.tolist()
    assert told["frame"] == body.extent.tolist()
    assert told["centre"] == pytest.approx([5002, 1.5, 1])
    assert told["diagonal"] == pytest.approx(np.sqrt(29))
    assert np.abs(told["outline"]).max() <= 0.5
    assert set(told["view"]) == {"direction", "up", "facing"}


def test_V6_vertices_of_stray_parts_are_not_fitted_to():
    body, stray = moved(grid(4, 3, 2), 5000, 0, 0), grid(1, 1, 1)
    mesh = together(body, stray)
    points = skin(mesh, DrawnMesh(mesh).frame)
    assert points.shape == (3, 54)  # of 60 vertices six are inside


def test_V6_no_corner_of_a_large_mesh_stands_out_of_its_outline() -> None:
    """The top of a grid of a million cells was cut off: its corners are boundary vertices, which are all looked at."""
    mesh = grid(48, 40, 36, turned=False)
    points = outline(skin(mesh, DrawnMesh(mesh).frame))
    corners = (
        np.array(np.meshgrid(*[[-0.5, 0.5]] * 3)).reshape(3, -1).T
        * [48, 40, 36]
        / np.linalg.norm([48, 40, 36])
    )
    for corner in corners:
        assert np.abs(points - corner).max(axis=1).min() < 1e-6


def standing(up: int, sign: int) -> np.ndarray:
    """Points of a statue on a flat foot."""
    random = np.random.default_rng(up)
    foot = np.vstack([random.uniform(-0.3, 0.3, (2, 200)), np.zeros(200)])
    angle, height = random.uniform(0, 2 * np.pi, 1000), random.uniform(0, 1, 1000)
    body = np.vstack([0.2 * np.cos(angle) * (1 - height), 0.2 * np.sin(angle) * (1 - height), height])
    points = np.hstack([foot, body])
    return np.roll(sign * points, up - 2, axis=0)


@pytest.mark.parametrize(("up", "axis", "sign"), [
    ("z", 2, 1), ("-z", 2, -1), ("y", 1, 1), ("-y", 1, -1), ("x", 0, 1), ("-x", 0, -1),
])  # fmt: skip
def test_C8_a_body_stands_on_its_foot(up, axis, sign):
    assert upward(standing(axis, sign)) == up


def test_C8_what_has_no_foot_stands_along_z():
    box = skin(grid(9, 5, 3), DrawnMesh(grid(9, 5, 3)).frame)
    ball = np.random.default_rng(1).normal(size=(3, 5000))
    for points in (box, ball / np.linalg.norm(ball, axis=0), np.zeros((3, 1)), np.zeros((3, 0))):
        assert upward(points) == "z"


@pytest.mark.parametrize(
    ("name", "up"),
    [
        ("2014-l1-based-construction--fertility-hex.vtk", "y"),
        ("2014-l1-based-construction--gargoyle-hex.mesh", "z"),
        ("2015-practical-hex-mesh--armadillo-stresstest-out.mesh", "y"),
        ("2016-efficient-volumetric-polycube--Fertility-hex-small.mesh", "y"),
        ("2016-all-hex-meshing--nut-hex.mesh", "z"),
        ("2019-singularity-structure-simplification--buste-buste-input.mesh", "x"),
    ],
)
def test_C8_published_bodies_stand_upright(name, up):
    mesh = read(published.file_of(name))
    assert upward(skin(mesh, DrawnMesh(mesh).frame)) == up
