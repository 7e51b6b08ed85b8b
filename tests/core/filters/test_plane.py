"""The slicing plane: what it hides, the ends of its slider."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from hexalab.filters import FilterStack
from hexalab.filters.plane import any_corner_places, barycentre_places, plane, project
from hexalab.mesh import Mesh
from tests.core.filters.boxes import box

numbers = st.floats(-1, 1).map(lambda x: round(x, 3))
normals = st.tuples(numbers, numbers, numbers).filter(lambda n: sum(x * x for x in n) > 0.01)


def behind(mesh: Mesh, normal: NDArray[np.float64], threshold: float, rule: str) -> list[bool]:
    """By hand: the rule's word for word."""
    out = []
    for cell in range(mesh.cell_count):
        corners = mesh.points[mesh.cells[cell]]
        along = (corners.mean(axis=0) if rule == "barycentre" else corners) @ normal
        out.append(bool(np.any(along < threshold)))
    return out


@given(normals, st.floats(0.01, 0.99))
@settings(max_examples=60, deadline=None)
def test_F1_hides_cells_whose_barycentre_lies_behind(normal: tuple[float, ...], offset: float) -> None:
    mesh = box(4, 3, 2)
    unit = np.array(normal) / np.linalg.norm(normal)
    along = mesh.points[mesh.cells].mean(axis=1) @ unit
    threshold = along.min() + offset * (along.max() - along.min())
    if np.abs(along - threshold).min() < 1e-9:
        return
    hidden = plane(barycentre_places(mesh.barycentres, normal), offset)
    assert hidden.tolist() == behind(mesh, unit, threshold, "barycentre")


@given(normals, st.floats(0.01, 0.99))
@settings(max_examples=60, deadline=None)
def test_F1_any_corner_behind_as_in_the_original(normal: tuple[float, ...], offset: float) -> None:
    mesh = box(4, 3, 2)
    unit = np.array(normal) / np.linalg.norm(normal)
    along = mesh.points @ unit
    threshold = along.min() + offset * (along.max() - along.min())
    if np.abs(along - threshold).min() < 1e-9:
        return
    places = any_corner_places(mesh.coordinates, mesh.corners, mesh.referenced, normal)
    assert plane(places, offset).tolist() == behind(mesh, unit, threshold, "any_corner")


@pytest.mark.parametrize("rule", ["barycentre", "any_corner"])
def test_F1_slider_hides_nothing_at_0_and_everything_at_1(rule: str) -> None:
    mesh = box(3, 3, 3)
    stack = FilterStack(mesh, lambda quantity: np.zeros(27))
    shares = []
    for offset in (0, 1e-9, 0.25, 0.5, 0.75, 1 - 1e-9, 1):
        items = [{"normal": [0.3, -0.5, 0.8], "offset": offset}]
        shares.append(int(stack.apply({"planes": {"rule": rule, "items": items}}).sum()))
    assert shares[0] == 27 and shares[-1] == 0
    assert shares == sorted(shares, reverse=True)
    assert rule == "any_corner" or (shares[1] > 0 and shares[-2] == 1)


def test_F1_vertices_of_no_cell_do_not_stretch_the_slider() -> None:
    mesh = box(2, 1, 1)
    stray = Mesh(np.hstack([mesh.coordinates, [[99.0], [0], [0]]]), mesh.corners, mesh.kinds)
    for one, other in ((mesh, stray), (stray, mesh)):
        a, b = (any_corner_places(m.coordinates, m.corners, m.referenced, (1, 0, 0)) for m in (one, other))
        assert (a.low, a.high) == (b.low, b.high) == (0, 2)


def test_F1_a_normal_of_any_length_and_of_none() -> None:
    mesh = box(4, 1, 1)
    for length in (1e-6, 1, 1e6):
        assert project(mesh.coordinates, (length, 0, 0)) == pytest.approx(mesh.coordinates[0])
    assert not plane(barycentre_places(mesh.barycentres, (0, 0, 0)), 0.7).any()


def test_F1_cells_that_are_nowhere_do_not_hold_the_slider() -> None:
    mesh = box(4, 1, 1)
    coordinates = mesh.coordinates.copy()
    coordinates[0, 0] = np.nan
    mesh = replace(mesh, coordinates=coordinates)
    hidden = plane(barycentre_places(mesh.barycentres, (1, 0, 0)), 0.7)
    assert hidden.tolist() == [False, True, True, False]
    assert barycentre_places(np.full((3, 2), np.nan), (1, 0, 0))[1:] == (0, 0)


def test_F1_a_flat_layer_is_hidden_at_the_end_only() -> None:
    places = barycentre_places(box(3, 3, 1).barycentres, (0, 0, 1))
    assert not plane(places, 0.999).any()
    assert plane(places, 1).all()


def test_F1_the_cut_faces_the_viewer() -> None:
    """A normal that is the view direction, as "set plane" takes it: near cells go first."""
    mesh = box(1, 1, 4)
    eye, direction = np.array([0.5, 0.5, 10.0]), (0, 0, -3.0)
    hidden = plane(barycentre_places(mesh.barycentres, direction), 0.5)
    distance = np.abs(mesh.barycentres[2] - eye[2])
    assert distance[hidden].max() < distance[~hidden].min()


def test_F1_inverted_plane_hides_what_was_shown() -> None:
    mesh = box(7, 1, 1)
    before = plane(barycentre_places(mesh.barycentres, (1, 0, 0)), 0.4)
    after = plane(barycentre_places(mesh.barycentres, (-1, 0, 0)), 1 - 0.4)
    assert after.tolist() == (~before).tolist()
