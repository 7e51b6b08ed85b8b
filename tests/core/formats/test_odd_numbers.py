"""SPEC R1, R2, R3, R8: integers stay exact, whatever their size; words for numbers that are not finite are read."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes
from hexalab.formats.tokens import parse
from tests.core.formats.samples import HEX_22
from tests.tools import tool

vtk = tool("vtk")
meshio = tool("meshio")

CASES = Path(__file__).parent / "cases"
CUBE = ["0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 0 1", "1 0 1", "1 1 1", "0 1 1"]
LARGE = [2**31 - 2, 2**31 - 1, 2**31, -(2**31), -(2**31) - 1, 2**53 + 1, 2**63 - 1, -(2**63)]


def medit(references: list[object], of_cell: object) -> bytes:
    rows = [f"{point} {reference}" for point, reference in zip(CUBE, references, strict=True)]
    return "\n".join(
        ["MeshVersionFormatted 4", "Dimension 3", "Vertices", "8", *rows, "Hexahedra", "1",
         f"1 2 3 4 5 6 7 8 {of_cell}", "End"]
    ).encode()  # fmt: skip


def vtk_file(number_type: str, *words: str, section: str = "SCALARS q {} 1\nLOOKUP_TABLE default\n") -> bytes:
    cells = "".join("8 0 1 2 3 4 5 6 7\n" for _ in words)
    return (
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n" + "\n".join(CUBE)
        + f"\nCELLS {len(words)} {9 * len(words)}\n{cells}CELL_TYPES {len(words)}\n" + "12\n" * len(words)
        + f"CELL_DATA {len(words)}\n" + section.format(number_type) + "\n".join(words) + "\n"
    ).encode()  # fmt: skip


def test_R1_references_of_the_largest_int_stay_what_they_are() -> None:
    mesh = read(CASES / "medit-int-max.mesh")
    assert mesh.cell_data["reference"].tolist() == [2147483647]
    assert mesh.point_data["reference"].tolist() == [2147483647] * 8
    found = meshio.read(CASES / "medit-int-max.mesh")
    assert found.cell_data["medit:ref"][0].tolist() == mesh.cell_data["reference"].tolist()


@pytest.mark.parametrize("value", LARGE)
def test_R1_references_of_any_size_up_to_int64_are_exact(value: int) -> None:
    mesh = read_bytes(medit([value, 1, 2, 3, 4, 5, 6, 7], value), "x.mesh")
    assert mesh.cell_data["reference"].tolist() == [value]
    assert mesh.point_data["reference"].tolist() == [value, 1, 2, 3, 4, 5, 6, 7]
    assert mesh.cell_data["reference"].dtype == (np.int32 if -(2**31) <= value < 2**31 else np.int64)


@pytest.mark.parametrize("vertex", [9, 2**31 - 1, 2**31, 2**32 + 8, 2**63 - 1, -(2**31) - 8])
def test_R10_vertices_out_of_range_are_found_whatever_their_size(vertex: int) -> None:
    data = medit([0] * 8, 0).replace(b"6 7 8 0", f"6 7 {vertex} 0".encode())
    with pytest.raises(MeshReadError, match=r"line 15: .*which is not there: expected 1 to 8"):
        read_bytes(data, "x.mesh")


def test_R1_real_references_are_read_with_a_note() -> None:
    mesh = read(CASES / "medit-real-references.mesh")
    assert mesh.cell_count == 1 and "reference" not in mesh.cell_data
    assert any("decimal point" in note for note in mesh.notes)
    mesh = read_bytes(medit(["7.0"] * 8, "3.0"), "x.mesh")
    assert mesh.cell_data["reference"].tolist() == [3] and mesh.point_data["reference"].tolist() == [7] * 8
    assert mesh.cell_data["reference"].dtype == np.int32
    with pytest.raises(MeshReadError, match=r"‘1\.5’"):
        read_bytes(medit([0] * 8, "3.0").replace(b"1 2 3 4 5", b"1.5 2 3 4 5"), "x.mesh")


def test_R3_integers_of_vtk_files_are_exact_as_vtk_reads_them() -> None:
    data = vtk_file("int", "2147483647", "-2147483648", "2147483646")
    reader = vtk.vtkUnstructuredGridReader()
    reader.ReadFromInputStringOn()
    reader.SetInputString(data.decode())
    reader.Update()
    array = reader.GetOutput().GetCellData().GetArray("q")
    wanted = [int(array.GetTuple1(row)) for row in range(3)]
    assert (
        read_bytes(data, "x.vtk").cell_data["q"].tolist() == wanted == [2147483647, -2147483648, 2147483646]
    )


def test_R3_integers_that_their_type_cannot_hold_are_not_wrapped() -> None:
    for number_type, word in (("int", "4294967301"), ("unsigned_char", "300"), ("short", "-40000")):
        assert read_bytes(vtk_file(number_type, word), "x.vtk").cell_data["q"].tolist() == [int(word)]


def test_R3_a_type_with_a_number_behind_it_is_read_as_vtk_does() -> None:
    mesh = read(CASES / "vtk-int1.vtk")
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName(str(CASES / "vtk-int1.vtk"))
    reader.Update()
    array = reader.GetOutput().GetCellData().GetArray("Label")
    assert mesh.cell_data["Label"].tolist() == [array.GetTuple1(0)] == [3]
    assert any("‘int1’" in note for note in mesh.notes)


NOT_FINITE = {
    "-nan(ind)": np.nan, "nan(snan)": np.nan, "1.#QNAN": np.nan, "-1.#IND": np.nan, "1.#IND00": np.nan,
    "1.#SNAN": np.nan, "1.#INF": np.inf, "-1.#INF": -np.inf, "1.#INF00": np.inf, "inf": np.inf,
    "-Infinity": -np.inf, "NaN": np.nan,
}  # fmt: skip


@pytest.mark.parametrize("word", NOT_FINITE)
@pytest.mark.parametrize("words", [["{}"], ["{}", "2.5"], ["2.5", "{}"]])
def test_R8_words_for_numbers_that_are_not_finite(word: str, words: list[str]) -> None:
    wanted = [NOT_FINITE[word] if one == "{}" else float(one) for one in words]
    data = vtk_file("double", *(one.format(word) for one in words))
    for content in (data, data + b"POINT_DATA 8\nSCALARS p int 1\nLOOKUP_TABLE default\n0 0 0 0 0 0 0 7\n"):
        mesh = read_bytes(content, "x.vtk")
        np.testing.assert_array_equal(mesh.cell_data["q"], wanted)
        assert any(f"‘{word}’" in note for note in mesh.notes) == ("(" in word or "#" in word)
    rows = "\n".join(f"{element} {one.format(word)}" for element, one in zip((4, 70), words, strict=False))
    text = f'$ElementData\n1\n"q"\n0\n3\n0\n1\n{len(words)}\n{rows}\n$EndElementData\n'
    np.testing.assert_array_equal(
        read_bytes((HEX_22 + text).encode(), "x.msh").cell_data["q"][: len(words)], wanted
    )


def test_R8_the_case_of_vtk() -> None:
    assert np.isnan(read(CASES / "vtk-nan-ind.vtk").cell_data["q"]).tolist() == [True]


@pytest.mark.parametrize("word", NOT_FINITE)
def test_R10_coordinates_that_are_not_finite_are_an_error(word: str) -> None:
    if "#" not in word:  # which begins a comment there
        with pytest.raises(
            MeshReadError, match=r"line 6: the y coordinate of vertex 2 .* not a finite number"
        ):
            read_bytes(medit([0] * 8, 0).replace(b"1 0 0", f"1 {word} 0".encode(), 1), "x.mesh")
    with pytest.raises(MeshReadError, match=r"the z coordinate of vertex 8 .* not a finite number"):
        read_bytes(vtk_file("int", "1").replace(b"0 1 1\n", f"0 1 {word}\n".encode(), 1), "x.vtk")


@pytest.mark.parametrize("last", ["1.5d0", "15D-1", "1.5E0"])
def test_R1_a_fortran_exponent_in_the_last_number_of_a_section_counts(last: str) -> None:
    """The number before the exponent alone is a number too."""
    data = "\n".join([*CUBE[:-1], f"0 1 {last}"])
    text = f"MeshVersionFormatted 2\nDimension 3\nVertices\n8\n{data}\nHexahedra\n1\n1 2 3 4 5 6 7 8\nEnd\n"
    mesh = read_bytes(text.encode(), "x.mesh")
    assert mesh.points[7].tolist() == [0, 1, 1.5]


def test_R1_numbers_that_32_bits_cannot_hold_are_parsed_again() -> None:
    """As WebAssembly's intp would move them to the ends of its range."""
    values, _ = parse(b"2147483647 -2147483648 5", np.int32)
    assert values.dtype == np.int64 and values.tolist() == [2147483647, -2147483648, 5]
    assert parse(b"2147483646 5", np.int32)[0].dtype == np.int32
