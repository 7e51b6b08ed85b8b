"""What the pictures of a report show."""

from __future__ import annotations

import json

import numpy as np
import pytest

from hexalab.mesh import Mesh
from hexalab.report import poses
from hexalab.session import Session
from hexalab.status import check
from hexalab.status.views import three_quarters
from hexalab.surface.frame import frame_of
from tests.core.conftest import grid_points, medit

from .decks import BAD, EMPTY, deck


def asked(data: bytes, name: str = "a.mesh") -> list[dict[str, object]]:
    session = Session()
    session.open(name, data)
    return session.report_poses("mm")


def test_there_are_three_and_their_settings_are_sound() -> None:
    poses = asked(deck(), "part.inp")
    assert len(poses) == 3
    for pose in poses:
        partial, rejections = check(json.loads(json.dumps(pose["status"])))
        assert rejections == [] and partial["unit"] == "mm"
        assert pose["title"] and pose["alt"]
    assert str(poses[2]["title"]).startswith(f"Cell {BAD}, the worst by Scaled Jacobian (-")


@pytest.mark.parametrize("cell", [0, 62, 124])
def test_the_worst_cell_stands_before_its_neighbours(cell: int) -> None:
    """A grid of 5 x 5 x 5, of which a cell in the middle or in a corner is flattened."""
    points, cells = grid_points((5, 5, 5))
    own = points[cells[cell]]
    away = own.mean(axis=0) - 2.5
    for row in cells[cell]:  # away from the faces of the body
        points[row] = points[row] * 0.7 + own.mean(axis=0) * 0.3
    moved = cells[cell][np.argmin(((own - 2.5) ** 2).sum(axis=1)) if away.any() else 0]
    points[moved] = own.mean(axis=0) + 0.1 * (points[moved] - own.mean(axis=0))
    _, _, pose = asked(medit(points, cells))
    status = pose["status"]
    assert isinstance(status, dict)
    shown = status["filters"]["picking"]["shown"]
    assert cell in shown and str(pose["title"]).startswith(f"Cell {cell + 1},")
    direction = np.array(status["camera"]["direction"])
    centres = points[cells].mean(axis=1)
    near = {row for row in range(len(cells)) if set(cells[row]) & set(cells[cell])}
    depth = (centres - centres[cell]) @ direction
    assert set(shown) == {row for row in near if depth[row] >= -1e-9 or row == cell}
    if cell != 62:
        assert (direction * away).sum() < 0, "seen from outside"
    mesh = Mesh.from_cells(points, cells)
    eye = np.array(status["camera"]["target"]) * mesh.diagonal + mesh.centre
    reach = np.sqrt(((points[np.unique(cells[shown])] - eye) ** 2).sum(axis=1)).max()
    half = np.radians(status["camera"]["field_of_view"] / 2)
    assert status["camera"]["distance"] * mesh.diagonal * np.sin(half) == pytest.approx(1.1 * reach)


def test_what_is_not_finite_is_worst_and_what_can_not_be_drawn_is_passed_over() -> None:
    points, cells = grid_points((5, 1, 1))
    cells[1, 4:] = cells[1, :4]  # flat: its Scaled Jacobian is not finite
    cells[3, :4], cells[3, 4:] = cells[3, 4:].copy(), cells[3, :4].copy()
    title = str(asked(medit(points, cells))[2]["title"])
    assert title.startswith("Cell 2, the worst by Scaled Jacobian (not finite)")
    points[11] = np.nan
    mesh = Mesh.from_cells(points, grid_points((5, 1, 1))[1])
    session = Session({"odd": lambda: mesh})
    session.open_offered("odd")
    assert str(session.report_poses()[2]["title"]).startswith("Cell 0, the worst by Scaled Jacobian (1.000)")


@pytest.mark.parametrize("odd", [np.nan, -np.inf])
def test_of_cells_without_a_finite_value_the_smallest_is_shown(odd: float) -> None:
    points, cells = grid_points((4, 1, 1))
    mesh = Mesh.from_cells(points, cells)
    view = three_quarters([4, 1, 1])
    quality, volume = np.array([odd, 0.1, odd, odd]), np.array([3.0, -5, 1, 2])
    found = poses(mesh, frame_of(mesh), view, quality, volume, "none")
    assert found[2].title.startswith("Cell 2, the worst by Scaled Jacobian (not finite)")


def test_a_mesh_of_nothing_has_no_pictures() -> None:
    session = Session({"nothing": lambda: EMPTY})
    session.open_offered("nothing")
    assert session.report_poses() == []
