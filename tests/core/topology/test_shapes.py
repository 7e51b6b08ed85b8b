"""What cells are, or have collapsed to (SPEC R7, V2)."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hexalab.cells import COLLAPSE, FACES, KINDS
from hexalab.topology.edges import repeating_cells
from hexalab.topology.shapes import SHAPES, shapes


def shape_of(corners: list[int], kind: int = 0) -> str:
    cells = np.array([corners], dtype=np.int32).T
    return SHAPES[shapes(np.array([kind], np.uint8), cells, repeating_cells(cells))[0]]


@pytest.mark.parametrize("kind", range(4))
def test_R7_a_hexahedron_collapsed_as_a_kind_is_that_kind(kind: int) -> None:
    assert shape_of(list(COLLAPSE[kind])) == KINDS[kind]
    assert shape_of(list(COLLAPSE[kind]), kind) == KINDS[kind]


@pytest.mark.parametrize(
    ("corners", "shape"),
    [
        ([0, 1, 2, 3, 4, 5, 6, 6], "other"),  # a knife of seven vertices
        ([0, 1, 1, 0, 4, 5, 6, 7], "wedge"),  # a face collapsed to an edge
        ([0, 1, 0, 1, 4, 5, 6, 7], "other"),  # crosswise
        ([0, 1, 2, 3, 0, 1, 2, 3], "other"),  # flat: the same face twice
        ([0, 0, 0, 0, 4, 5, 6, 7], "pyramid"),
        ([0, 1, 2, 2, 2, 2, 2, 2], "other"),
        ([7, 7, 7, 7, 7, 7, 7, 7], "other"),
    ],
)
def test_R7_what_hexahedra_collapse_to(corners: list[int], shape: str) -> None:
    assert shape_of(corners) == shape


@given(st.lists(st.lists(st.integers(0, 7), min_size=8, max_size=8), min_size=1, max_size=20))
def test_R7_shapes_follow_from_the_sets_of_vertices(cells: list[list[int]]) -> None:
    corners = np.array(cells, dtype=np.int32).T
    found = shapes(np.zeros(len(cells), np.uint8), corners, repeating_cells(corners))
    forms = {(6, 2, 3): "wedge", (5, 4, 1): "pyramid", (4, 4, 0): "tetrahedron"}
    for cell, code in zip(cells, found, strict=True):
        faces = [frozenset(cell[place] for place in face) for face in FACES]
        real = [face for face in faces if len(face) >= 3]
        form = (len(set(cell)), sum(len(f) == 3 for f in real), sum(len(f) == 4 for f in real))
        expected = forms.get(form, "other") if len(set(real)) == len(real) else "other"
        assert SHAPES[code] == (expected if len(set(cell)) < 8 else "hexahedron")
