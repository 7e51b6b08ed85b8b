"""The warm-up does real work on a mesh of its own."""

from __future__ import annotations

import hexalab
from hexalab.session import Session
from hexalab.session.door import Door
from hexalab.session.warm_up import SIDE, grid, warm_up


def test_P5_the_warm_up_grid_is_a_valid_mesh() -> None:
    mesh = grid(SIDE)
    assert mesh.cell_count == SIDE**3
    assert mesh.topology.boundary_face_count == 6 * SIDE**2
    assert (hexalab.quality(mesh, "scaled_jacobian") > 0.999).all()


def test_P5_warming_up_ends_with_a_sliced_grid() -> None:
    session = Session()
    warm_up(Door(session))
    shown = session.update()["shown_cells"]
    assert 0 < shown < SIDE**3
