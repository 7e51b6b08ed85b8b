"""Findings that depend on which cells come first, or on where a block of faces begins."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.diagnosis import diagnose
from hexalab.mesh import Mesh
from tests.core.filters.boxes import box


def joined(one: Mesh, other: Mesh) -> Mesh:
    """Two meshes apart from each other, as one."""
    points = np.concatenate([one.points, other.points + np.array([50.0, 0, 0])])
    return Mesh.from_cells(points, np.concatenate([one.cells, other.cells + one.vertex_count]))


@pytest.mark.parametrize("small_first", [True, False])
def test_R9_all_parts_but_the_largest_are_marked_wherever_it_stands(small_first: bool) -> None:
    small, large = box(2, 1, 1), box(3, 2, 2)
    mesh = joined(small, large) if small_first else joined(large, small)
    (finding,) = (found for found in diagnose(mesh) if found.id == "components")
    assert finding.count == 2
    assert finding.cells.tolist() == ([0, 1] if small_first else [12, 13])


@pytest.mark.parametrize("block", [1, 7, 1 << 18])
def test_R9_neighbours_of_opposite_orientation_in_any_block(
    monkeypatch: pytest.MonkeyPatch, block: int
) -> None:
    """One cell of a bar mirrored, its vertices the same: at odds with the cells on both sides."""
    monkeypatch.setattr("hexalab.diagnosis._BLOCK", block)
    mesh = box(40, 1, 1)
    cells = mesh.cells.copy()
    cells[30] = cells[30][[4, 5, 6, 7, 0, 1, 2, 3]]
    (finding,) = (
        found for found in diagnose(Mesh.from_cells(mesh.points, cells)) if found.id == "opposite_orientation"
    )
    assert finding.count == 2
    assert finding.cells.tolist() == [29, 30, 31]
