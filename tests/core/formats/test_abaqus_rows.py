"""SPEC R5, R10: rows of Abaqus decks, regular and not; types of elements."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from tests.core.formats.samples import signed_volumes
from tests.core.formats.test_abaqus_scopes import CUBE, ELEMENT, nodes

ROW = "1, 1, 2, 3, 4, 5, 6, 7, 8"


def cube(rows: str, kind: str = "C3D8"):
    return read_bytes(f"{nodes()}*Element, type={kind}\n{rows}\n".encode(), "x.inp")


@pytest.mark.parametrize(
    "rows",
    [
        ROW,
        ROW + ",",
        ROW + " , ",
        "1, 1, 2, 3, 4,\n5, 6, 7, 8",
        "1, 1, 2, 3, 4,\r\n5, 6, 7, 8,\r\n",
        "1, 1, 2, 3, 4\n5, 6, 7, 8",  # CalculiX goes on without a comma
        "1,\n1,\n2,\n3,\n4,\n5,\n6,\n7,\n8",
        "\n  \n\t1,\t1, 2, 3, 4, 5, 6, 7, 8\n\n",
        "1., 1., 2., 3., 4., 5., 6., 7., 8.",
        "1 1 2 3 4 5 6 7 8",
        "** 1, 2\n1, 1, 2, 3, 4,\n** 2, 3\n5, 6, 7, 8\n** the end",
    ],
)
def test_R5_layouts_of_an_element(rows: str) -> None:
    mesh = cube(rows)
    assert mesh.cells.tolist() == [list(range(8))]
    assert mesh.notes == []


@pytest.mark.parametrize("end", [",\n", "\n", " ,\n"])
def test_R5_rows_after_one_that_is_wrapped(end: str) -> None:
    rows = f"1, 1, 2, 3, 4,\n5, 6, 7, 8{end}2, 5, 6, 7, 8, 1, 2, 3, 4{end}3, 1, 2, 3, 4, 5,\n6,\n7, 8"
    assert cube(rows).cells.tolist() == [
        [0, 1, 2, 3, 4, 5, 6, 7],
        [4, 5, 6, 7, 0, 1, 2, 3],
        [0, 1, 2, 3, 4, 5, 6, 7],
    ]


def test_R5_surplus_nodes_are_passed_over_in_some_rows() -> None:
    mesh = cube(f"{ROW}, 1, 2\n2, 5, 6, 7, 8, 1, 2, 3, 4\n3, 1, 2, 3, 4,\n5, 6, 7, 8, 8, 8\n4{ROW[1:]}")
    assert mesh.cells[:, 0].tolist() == [0, 4, 0, 0]
    assert mesh.cell_numbers is None
    assert mesh.notes == ["2 elements have more nodes than the 8 of type C3D8: the surplus is passed over."]


def test_R10_a_row_that_lacks_a_node_does_not_take_the_next_one_s() -> None:
    with pytest.raises(MeshReadError, match="line 11: element 1 of type C3D8 has 7 nodes, expected 8"):
        cube(f"1, 1, 2, 3, 4, 5, 6, 7\n2{ROW[1:]}")


@pytest.mark.parametrize("least", [20, 21, 27])
def test_R5_nodes_in_the_middle_of_faces_may_be_missing(least: int) -> None:
    if least == 20:
        kind, rows = "C3D20R", [[*range(1, 9)] + [8] * 12] * 3
    else:
        kind, rows = "C3D27", [[*range(1, 9)] + [8] * (least - 8)] * 3
    lines = [
        ", ".join(map(str, [n + 1, *row[:15]])) + ",\n" + ", ".join(map(str, row[15:]))
        for n, row in enumerate(rows)
    ]
    mesh = cube("\n".join(lines), kind)
    assert mesh.cells.tolist() == [list(range(8))] * 3


def test_R5_fields_that_blanks_part_and_fields_that_are_empty_do_not_make_up_for_each_other() -> None:
    """Four numbers and three commas in each row, but not in the same fields."""
    text = nodes().replace("8, 0.0, 1.0, 1.0", "8, , 1.0, 1.0\n9 9, 0.0, 1.0, 1.0")
    mesh = read_bytes((text + ELEMENT).encode(), "x.inp")
    assert mesh.points[7].tolist() == [0, 1, 1]


def test_R5_exponents_of_fortran_in_one_row_of_many() -> None:
    text = nodes(np.tile(CUBE, (5000, 1)) * 1.5).replace(
        "30000, 0.0, 1.5, 1.5", "30000, 0.0, 15.D-1, 1.5d+00"
    )
    mesh = read_bytes((text + ELEMENT).encode(), "x.inp")
    np.testing.assert_array_equal(mesh.points, np.tile(CUBE, (5000, 1)) * 1.5)


def test_R5_numbers_of_nodes_stay_exact() -> None:
    big = 2**53 - 9
    text = nodes(CUBE, big) + "*Element, type=C3D8\n999999999, " + ", ".join(str(big + n) for n in range(8))
    mesh = read_bytes(text.encode(), "x.inp")
    assert mesh.vertex_numbers.tolist() == [big + n for n in range(8)]
    assert mesh.cell_numbers.tolist() == [999999999]


def test_R5_elements_that_repeat_a_number_are_all_shown() -> None:
    mesh = cube(f"{ROW}\n1, 5, 6, 7, 8, 1, 2, 3, 4")
    assert mesh.cell_count == 2
    assert mesh.notes == ["1 element has the number of another one: all are shown."]


def test_R5_nodes_that_repeat_their_place_are_no_news() -> None:
    mesh = read_bytes((nodes() + nodes(CUBE[:3]) + ELEMENT).encode(), "x.inp")
    assert mesh.vertex_count == 8
    assert mesh.notes == []


@pytest.mark.parametrize(
    ("kind", "name"),
    [
        *[(kind, "hexahedron") for kind in ("C3D8", "C3D8IHT", "AC3D8R", "COH3D8P", "EC3D8R", "FC3D8", "F3D8R")],
        *[(kind, "hexahedron") for kind in ("Q3D8H", "SC8RT", "CSS8", "DCC3D8D", "EMC3D8", "GK3D8N", "DC3D8E")],
        *[(kind, "wedge") for kind in ("C3D6", "COH3D6", "GK3D6T", "SC6R", "F3D6", "AC3D6", "FC3D6")],
        *[(kind, "pyramid") for kind in ("C3D5", "C3D5H", "FC3D5", "AC3D5")],
        *[(kind, "tetrahedron") for kind in ("C3D4", "DC3D4", "F3D4", "FC3D4", "EMC3D4", "C3D4T")],
    ],
)  # fmt: skip
def test_R5_volumetric_families(kind: str, name: str) -> None:
    """Corners as in the element libraries: the base counter-clockwise seen from the top, volumes positive."""
    rows = {
        "hexahedron": ROW, "wedge": "1, 1, 2, 3, 5, 6, 7", "pyramid": "1, 1, 2, 3, 4, 5", "tetrahedron": "1, 1, 2, 3, 5"
    }  # fmt: skip
    mesh = cube(rows[name], kind)
    assert mesh.kind_counts == {name: 1}
    volume = {"hexahedron": 1, "wedge": 1 / 2, "pyramid": 1 / 3, "tetrahedron": 1 / 6}[name]
    np.testing.assert_allclose(signed_volumes(mesh), volume)


@pytest.mark.parametrize(
    "kind",
    [
        "GK3D4L",
        "GK3D6L",
        "GK3D18",
        "CCL12",
        "CIN3D8",
        "U8",
        "VU1",
        "COH3D4",
        "SC1",
        "C3D7",
        "SC4",
    ],
)
def test_R5_what_is_no_volume_is_left_out_by_name(kind: str) -> None:
    text = f"{nodes()}{ELEMENT}*Element, type={kind}\n2, 1, 2, 3, 4,\n5, 6, 7, 8\n3, 1, 2, 3, 4, 5, 6, 7, 8\n"
    mesh = read_bytes(text.encode(), "x.inp")
    assert mesh.cell_count == 1
    assert mesh.notes == [
        f"Left out, as they are no volumetric cells that can be shown: elements of type {kind} (2)."
    ]


def test_R5_faces_of_fluid_cavities_are_no_tetrahedra() -> None:
    """F3D4 is a tetrahedron of CalculiX, and a face of a cavity in Abaqus: that has a *FLUID PROPERTY."""
    faces = "*Element, type=F3D4\n2, 1, 2, 3, 4\n*FLUID PROPERTY, ELSET=e, REF NODE=9\n"
    mesh = read_bytes((nodes() + ELEMENT + faces).encode(), "x.inp")
    assert mesh.kind_counts == {"hexahedron": 1}
    assert "faces of fluid cavities, of type F3D4 (1)" in mesh.notes[0]
