"""SPEC R3: every volumetric cell type of VTK, against volumes and scaled Jacobians that VTK computes itself."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes
from hexalab.quality import quality
from tests.core.formats.samples import signed_volumes
from tests.core.formats.vtk_files import insert, legacy, xml
from tests.tools import tool

vtk = tool("vtk")
vtk_to_numpy = tool("vtk.util.numpy_support").vtk_to_numpy

CASES = Path(__file__).parent / "cases"
KINDS_OF_TYPES = {
    "tetrahedron": (10, 24, 71, 78),
    "hexahedron": (11, 12, 25, 29, 33, 72, 79),
    "wedge": (13, 26, 31, 32, 73, 80),
    "pyramid": (14, 27, 37),
}
LINEAR = {"tetrahedron": 10, "hexahedron": 12, "wedge": 13, "pyramid": 14}
OF_SOURCE = [
    (kind, number, order)
    for kind, numbers in KINDS_OF_TYPES.items()
    for number in numbers
    if number not in (31, 32, 33)
    for order in ((1, 2, 3, 4) if number > 70 else (1,))
]
"""Types that vtkCellTypeSource makes."""


def cells_of_source(number: int, order: int, mirrored: bool) -> Any:
    """A unit cube filled with cells of the type, sheared and stretched, or that seen in a mirror."""
    source = vtk.vtkCellTypeSource()
    source.SetCellType(number)
    source.SetCellOrder(order)
    source.SetOutputPrecision(1)
    source.Update()
    grid = vtk.vtkUnstructuredGrid()
    grid.DeepCopy(source.GetOutput())
    assert grid.GetCellType(0) == number
    points = vtk_to_numpy(grid.GetPoints().GetData())
    if number == 11:
        points *= [1, 2, 3]
    else:
        points[:] = points @ [[1, 0.2, 0], [0, 1.5, 0.1], [0.3, 0, 2]]
        points[:, 0] *= -1 if mirrored else 1
    return grid


def volumes_of_vtk(grid: Any) -> np.ndarray:
    """Signed volumes by vtkCellSizeFilter."""
    size = vtk.vtkCellSizeFilter()
    size.SetInputData(grid)
    size.Update()
    return vtk_to_numpy(size.GetOutput().GetCellData().GetArray("Volume"))


def linear_cells(grid: Any, kind: str, number: int) -> Any:
    """The grid with each cell made linear by its first nodes, which are its corners in every type of VTK."""
    corners = {"tetrahedron": 4, "hexahedron": 8, "wedge": 6, "pyramid": 5}[kind]
    order = list(range(corners))
    if number in (73, 80):
        order = [0, 2, 1, 3, 5, 4]
    if number == 11:
        order = [0, 1, 3, 2, 4, 5, 7, 6]
    out = vtk.vtkUnstructuredGrid()
    out.SetPoints(grid.GetPoints())
    for cell in range(grid.GetNumberOfCells()):
        ids = grid.GetCell(cell).GetPointIds()
        insert(out, LINEAR[kind], [ids.GetId(place) for place in order])
    return out


def scaled_jacobians_of_vtk(grid: Any) -> np.ndarray:
    """Scaled Jacobians by vtkMeshQuality."""
    quality = vtk.vtkMeshQuality()
    quality.SetInputData(grid)
    for kind in ("Tet", "Hex", "Wedge", "Pyramid"):
        getattr(quality, f"Set{kind}QualityMeasureToScaledJacobian")()
    quality.Update()
    return vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality"))


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize(("kind", "number", "order"), OF_SOURCE)
def test_R3_every_cell_type_has_the_volume_and_scaled_jacobian_of_vtk(
    tmp_path: Path, kind: str, number: int, order: int, mirrored: bool
) -> None:
    grid = cells_of_source(number, order, mirrored)
    linear = linear_cells(grid, kind, number)
    volumes = volumes_of_vtk(linear)
    if number not in (25, 29):  # whose volumes VTK 9.6 gets wrong (release notes of 9.7)
        np.testing.assert_allclose(volumes_of_vtk(grid), volumes, rtol=1e-9)
    assert (volumes < 0).all() if mirrored and number != 11 else (volumes > 0).all()
    for data, name in ((xml(grid, tmp_path / "x.vtu"), "x.vtu"), (legacy(grid, 51, True), "x.vtk")):
        mesh = read_bytes(data, name)
        assert mesh.kind_counts == {kind: len(volumes)}
        np.testing.assert_allclose(signed_volumes(mesh), volumes, rtol=1e-9)
        found = quality(mesh, "scaled_jacobian")
        np.testing.assert_allclose(found, scaled_jacobians_of_vtk(linear), rtol=1e-6, atol=1e-9)
        assert any("higher order" in note for note in mesh.notes) == (
            grid.GetCell(0).GetNumberOfPoints() > linear.GetCell(0).GetNumberOfPoints()
        )


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize(("number", "count"), [(31, 12), (32, 18), (33, 24)])
def test_R3_types_that_the_source_does_not_make_have_outward_faces_as_vtk_says(
    number: int, count: int, mirrored: bool
) -> None:
    cell = vtk.vtkGenericCell.InstantiateCell(number)
    coordinates = cell.GetParametricCoords()
    points = np.array([coordinates[i] for i in range(3 * count)]).reshape(count, 3)
    points[:, 0] *= -1 if mirrored else 1
    for place in range(count):
        cell.GetPointIds().SetId(place, place)
    total = 0.0
    for number_of_face in range(cell.GetNumberOfFaces()):
        face = cell.GetFace(number_of_face)
        ring = [points[face.GetPointId(place)] for place in range(face.GetNumberOfEdges())]
        total += sum(np.dot(ring[0], np.cross(ring[i], ring[i + 1])) for i in range(1, len(ring) - 1)) / 6
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(vtk.vtkPoints())
    for point in points:
        grid.GetPoints().InsertNextPoint(*point)
    insert(grid, number, list(range(count)))
    assert np.sign(volumes_of_vtk(grid)) == np.sign(total)
    mesh = read_bytes(legacy(grid), "x.vtk")
    np.testing.assert_allclose(signed_volumes(mesh), total, rtol=1e-6)


def test_R3_a_lagrange_wedge_is_numbered_the_other_way_round_than_a_linear_one() -> None:
    mesh = read(CASES / "vtu-lagrange-wedge.vtu")
    assert mesh.kind_counts == {"hexahedron": 1, "wedge": 1}
    np.testing.assert_allclose(signed_volumes(mesh), [1, 0.5])


@pytest.mark.parametrize("case", ["quadratic-quad", "polyvertex-of-8", "triangle-strip-of-8"])
def test_R3_rows_of_eight_that_are_no_cells_are_left_out(case: str) -> None:
    with pytest.raises(MeshReadError, match=r"no volumetric cells, only [a-z -]+ \(1\)"):
        read(CASES / f"vtk-{case}.vtk")


@pytest.mark.parametrize("number", [2, 4, 6, 7, 23, 36, 41, 42, 68, 70, 75, 77])
def test_R3_rows_of_eight_beside_hexahedra_are_no_hexahedra(number: int) -> None:
    text = (CASES / "vtk-quadratic-quad.vtk").read_text().replace("1 9\n", "2 18\n8 0 1 2 3 4 5 6 7\n")
    mesh = read_bytes(text.replace("TYPES 1\n23", f"TYPES 2\n12\n{number}").encode(), "x.vtk")
    assert mesh.kind_counts == {"hexahedron": 1}
    edge_or_face = {23: [0, 1, 2, 3], 68: [0, 1], 70: [0, 1, 2, 3], 75: [0, 1], 77: [0, 1, 2, 3]}
    if number == 4:
        assert mesh.features[0].corners.T.tolist() == [[n, n + 1] for n in range(7)]
    elif number in edge_or_face:
        assert mesh.features[0].corners[:, 0].tolist() == edge_or_face[number]
    else:
        assert "(1)" in mesh.notes[-1] and not mesh.features


@pytest.mark.parametrize(
    ("number", "nodes"), [(12, 20), (12, 27), (10, 10), (13, 15), (13, 18), (14, 13), (11, 9), (25, 27)]
)
def test_R3_of_more_nodes_than_the_type_has_the_first_are_the_corners(number: int, nodes: int) -> None:
    text = (CASES / "vtk-type12-of-20.vtk").read_text()
    text = text.replace("POINTS 20 double\n", "POINTS 27 double\n" + "9 9 9\n" * 0)
    text = text.replace("CELLS 1 21", "7 7 7\n" * 7 + f"CELLS 1 {nodes + 1}")
    row = text.index("20 0 1 2")
    text = text[:row] + f"{nodes} {' '.join(map(str, range(nodes)))}\nCELL_TYPES 1\n{number}\n"
    mesh = read_bytes(text.encode(), "x.vtk")
    assert mesh.cell_count == 1
    assert f"type {number} " in mesh.notes[0] and f"({nodes})" in mesh.notes[0]
    reader = vtk.vtkUnstructuredGridReader()
    reader.ReadFromInputStringOn()
    reader.SetInputString(text)
    reader.Update()
    ids = reader.GetOutput().GetCell(0).GetPointIds()
    assert {ids.GetId(place) for place in range(len(set(mesh.cells[0])))} == set(mesh.cells[0].tolist())


def test_R3_a_quadratic_hexahedron_called_a_linear_one() -> None:
    mesh = read(CASES / "vtk-type12-of-20.vtk")
    assert mesh.cells.tolist() == [list(range(8))] and "(20)" in mesh.notes[0]


@pytest.mark.parametrize("number", [13, 26, 73, 80])
@pytest.mark.parametrize("mirrored", [False, True])
def test_R3_wedges_that_are_all_inverted_may_be_numbered_in_another_way(
    tmp_path: Path, number: int, mirrored: bool
) -> None:
    grid = cells_of_source(number, 1, mirrored)
    for data, name in ((xml(grid, tmp_path / "x.vtu"), "x.vtu"), (legacy(grid, 51, True), "x.vtk")):
        notes = [
            note
            for note in read_bytes(data, name).notes
            if f"{number}" in note and "are inverted as VTK" in note
        ]
        assert len(notes) == mirrored
        assert not notes or "(2)" in notes[0]


@pytest.mark.parametrize(("number", "nodes"), [(31, 12), (32, 18)])
def test_R3_quadratic_wedges_that_are_numbered_as_linear_ones_are_told(number: int, nodes: int) -> None:
    """As MFEM writes them. A wedge of type 13 has its triangle 0 1 2 clockwise, seen from 3 4 5."""
    points = "0 0 0 0 1 0 1 0 0 0 0 1 0 1 1 1 0 1" + " 0.5 0.5 0.5" * (nodes - 6)
    text = (
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
        f"POINTS {nodes} double\n{points}\nCELLS 1 {nodes + 1}\n{nodes} {' '.join(map(str, range(nodes)))}\n"
        f"CELL_TYPES 1\n{number}\n"
    )
    assert any(
        "31, 32, 73 or 80 (1) are inverted" in note for note in read_bytes(text.encode(), "x.vtk").notes
    )
