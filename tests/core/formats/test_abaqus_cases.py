"""SPEC R5, R10: small decks of the kinds that real tools write and read; `cases/` holds them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read
from tests.core.formats.samples import signed_volumes

CASES = Path(__file__).parent / "cases"
CUBE = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=float)


@pytest.mark.parametrize(
    "name", ["abaqus-empty-fields", "abaqus-surplus-nodes", "abaqus-short-node-rows", "calculix-f3d8"]
)
def test_R5_the_unit_cube(name: str) -> None:
    mesh = read(CASES / f"{name}.inp")
    assert mesh.kind_counts == {"hexahedron": 1}
    np.testing.assert_array_equal(mesh.points[mesh.cells[0]], CUBE)


def test_R5_a_node_row_ends_with_its_line() -> None:
    mesh = read(CASES / "abaqus-short-node-rows-silent.inp")
    np.testing.assert_array_equal(mesh.points[mesh.cells[0]], CUBE)
    assert mesh.vertex_numbers.tolist() == [1, 9, 10, 11, 12, 2, 3, 4, 5, 6, 7, 8]
    np.testing.assert_array_equal(mesh.points[1:5], [[2, 2, 0], [3, 3, 0], [4, 4, 0], [5, 5, 0]])


def test_R5_the_last_definition_of_a_node_counts() -> None:
    mesh = read(CASES / "abaqus-node-redefined.inp")
    assert mesh.vertex_count == 8
    assert mesh.points[mesh.cells[0, 6]].tolist() == [2, 2, 2]
    assert mesh.notes == ["1 node has more than one place: the last definition counts."]


def test_R5_nodes_within_instances() -> None:
    mesh = read(CASES / "abaqus-nodes-in-instances.inp")
    np.testing.assert_array_equal(mesh.points[mesh.cells[0]], CUBE)
    np.testing.assert_array_equal(mesh.points[mesh.cells[1]], CUBE + np.array([5, 0, 0]))
    assert mesh.vertex_numbers.tolist() == [1, 2, 3, 4, 5, 6, 7, 8] * 2
    assert mesh.cell_numbers.tolist() == [1, 1]


def test_R12_sets_are_kept() -> None:
    mesh = read(CASES / "abaqus-elset.inp")
    assert mesh.cell_count == 2
    np.testing.assert_allclose(signed_volumes(mesh), 1)
    assert mesh.notes == []
    assert {group.id: group.members.tolist() for group in mesh.groups} == {
        "elset:STEEL": [0],
        "elset:RUBBER": [1],
    }


def test_R5_surplus_nodes_are_noted() -> None:
    mesh = read(CASES / "abaqus-surplus-nodes.inp")
    assert mesh.notes == ["1 element has more nodes than the 8 of type C3D8: the surplus is passed over."]


def test_R10_a_deck_that_includes_its_mesh_asks_for_it() -> None:
    with pytest.raises(MeshReadError) as caught:
        read(CASES / "abaqus-include-only.inp")
    assert "it includes mesh.inp, which was not found in its folder; open the files together" in str(
        caught.value
    )
