"""SPEC R11: the file's own numbers of nodes and elements are kept, and cost nothing where they are the rows."""

from __future__ import annotations

import numpy as np

from hexalab.formats import read_bytes

NODES = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1), (2, 2, 2)]


def deck(node_numbers: list[int], rows: str) -> bytes:
    lines = [f"{number}, {x}, {y}, {z}" for number, (x, y, z) in zip(node_numbers, NODES, strict=True)]
    return ("*NODE\n" + "\n".join(lines) + "\n" + rows).encode()


def test_R11_numbers_with_gaps_and_out_of_order_are_kept() -> None:
    numbers = [70, 10, 20, 30, 40, 50, 60, 5, 99]
    rows = "*ELEMENT, TYPE=C3D8\n12, 70,10,20,30,40,50,60,5\n*ELEMENT, TYPE=C3D4\n7, 70,10,20,40\n"
    mesh = read_bytes(deck(numbers, rows), "a.inp")
    assert mesh.vertex_numbers is not None and mesh.cell_numbers is not None
    assert mesh.vertex_numbers.tolist() == numbers
    assert mesh.cell_numbers.tolist() == [12, 7]


def test_R11_numbers_that_are_the_rows_are_not_stored() -> None:
    rows = "*ELEMENT, TYPE=C3D8\n1, 1,2,3,4,5,6,7,8\n"
    mesh = read_bytes(deck(list(range(1, 10)), rows), "a.inp")
    assert mesh.vertex_numbers is None and mesh.cell_numbers is None


def test_R11_gmsh_elements_of_several_kinds_keep_theirs_in_file_order() -> None:
    nodes = "".join(f"{number} {x} {y} {z}\n" for number, (x, y, z) in zip(range(11, 20), NODES, strict=True))
    elements = "5 5 0 11 12 13 14 15 16 17 18\n9 4 0 11 12 13 15\n3 5 0 11 12 13 14 15 16 17 18\n"
    text = f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n{nodes}$EndNodes\n$Elements\n3\n{elements}$EndElements\n"
    mesh = read_bytes(text.encode(), "a.msh")
    assert mesh.cell_numbers is not None and mesh.vertex_numbers is not None
    assert mesh.cell_numbers.tolist() == [5, 9, 3]
    np.testing.assert_array_equal(mesh.vertex_numbers, np.arange(11, 20))
    assert mesh.kinds.tolist() == [0, 3, 0]
