"""Meshes of some of another's cells; truth: the cells one by one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hexalab import HexaLabError, Mesh, select_cells
from hexalab.session.warm_up import grid


def numbered() -> Mesh:
    """A block of 27 cubes with attributes of each sort, and numbers of its own."""
    mesh = grid(3)
    v, c = mesh.vertex_count, mesh.cell_count
    return Mesh(
        mesh.coordinates, mesh.corners, mesh.kinds,
        {"height": np.arange(v) / 7, "flow": np.arange(3 * v).reshape(v, 3)},
        {"load": np.arange(c, dtype=np.int16)},
        name="block.vtu", vertex_numbers=10 * np.arange(v), cell_numbers=5 + np.arange(c),
    )  # fmt: skip


@given(st.sets(st.integers(0, 26)))
def test_A8_a_part_has_the_cells_that_were_chosen_and_no_vertex_more(chosen: set[int]) -> None:
    mesh, rows = numbered(), sorted(chosen)
    part = select_cells(mesh, np.array(rows, dtype=np.int64))
    assert part.cell_count == len(rows)
    assert part.points[part.cells].tolist() == mesh.points[mesh.cells[rows]].tolist()
    assert part.kinds.tolist() == mesh.kinds[rows].tolist()
    used = np.unique(mesh.cells[rows])
    assert part.vertex_count == len(used)
    assert part.point_data["height"].tolist() == mesh.point_data["height"][used].tolist()
    assert part.point_data["flow"].tolist() == mesh.point_data["flow"][used].tolist()
    assert part.cell_data["load"].tolist() == rows
    assert part.cell_data["load"].dtype == np.int16
    assert part.vertex_numbers is not None and part.vertex_numbers.tolist() == (10 * used).tolist()
    assert part.cell_numbers is not None and part.cell_numbers.tolist() == [5 + row for row in rows]
    mask = np.isin(np.arange(27), rows)
    assert select_cells(mesh, mask).cells.tolist() == part.cells.tolist()


def test_A8_a_mesh_without_numbers_gets_none() -> None:
    part = select_cells(grid(2), [3])
    assert part.cell_numbers is None and part.vertex_numbers is None


@pytest.mark.parametrize(
    ("cells", "words"),
    [
        (np.ones(3, bool), r"found a mask of shape \(3,\), expected \(27,\)"),
        ([27], "expected rows from 0 to 26"),
        ([-1], "expected rows from 0 to 26"),
        ([2, 1], "that rise, each once"),
        ([1, 1], "that rise, each once"),
        ([0.5], "found an array of float64"),
        ([[1]], "expected rows or a mask"),
    ],
)
def test_A8_what_is_no_choice_of_cells_is_told(cells: Any, words: str) -> None:
    with pytest.raises(HexaLabError, match=words):
        select_cells(grid(3), cells)
