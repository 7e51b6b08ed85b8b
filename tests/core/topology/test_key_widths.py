"""Keys of faces and edges at their bounds: ids just past 21 bits, vertices of more edges than there are layers."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.typing import NDArray

from hexalab.topology.keys import NARROW_BITS
from tests.core.topology.checks import check_edges, check_faces, topology
from tests.core.topology.strategies import meshes


@pytest.mark.parametrize("fourth", [20, 1000, 1 << 20])
def test_R7_faces_whose_ids_carry_from_one_field_of_the_key_to_the_next_stay_apart(fourth: int) -> None:
    """0 1 10 (2^21 + n) and 0 1 11 n are one number when three fields of 21 bits are added up."""
    past = (1 << NARROW_BITS) + fourth
    cells = np.array([[0, 1, 10, past, 2, 3, 4, 5], [0, 1, 11, fourth, 6, 7, 8, 9]], dtype=np.int32)
    t = topology(cells, past + 1)
    check_faces(cells, t)
    assert t.face_count == 12


@given(meshes)
@settings(max_examples=40, deadline=None)
def test_R7_edges_left_to_the_sort_are_the_same(cells: NDArray[np.int32]) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("hexalab.topology.edges.LAYERS", 0)
        t = topology(cells)
        check_edges(cells, t)
    assert (t.edge_vertices[0] < t.edge_vertices[1]).all()
