"""SPEC R3, R4: polyhedra of VTK are rebuilt from their faces where they are of one of our kinds."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes
from tests.core.formats.samples import Sample, grid, mixed, signed_volumes
from tests.core.formats.test_openvolumemesh import OUTWARD, sample_volumes
from tests.core.formats.vtk_files import insert, legacy, unstructured_grid, xml
from tests.tools import tool

vtk = tool("vtk")
CASES = Path(__file__).parent / "cases"
Faces = list[list[int]]
PRISM = [[0, 4, 3, 2, 1], [5, 6, 7, 8, 9]] + [[i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5] for i in range(5)]
"""A pentagonal prism of ten vertices."""


def faces_of(kind: int, ids: list[int], random: np.random.Generator) -> Faces:
    """The cell's faces, seen from outside, in any order and beginning anywhere."""
    faces = [[ids[place] for place in local] for local in OUTWARD[kind]]
    faces = [list(np.roll(face, random.integers(len(face)))) for face in faces]
    return [[int(i) for i in faces[at]] for at in random.permutation(len(faces))]


def polyhedra(points: np.ndarray, cells: list[Faces]) -> Any:
    """VTK's data set of polyhedra."""
    data = unstructured_grid(Sample(points, []))
    for faces in cells:
        insert(data, vtk.VTK_POLYHEDRON, [len(faces)] + [i for face in faces for i in [len(face), *face]])
    return data


def old_vtu(points: np.ndarray, cells: list[Faces], others: tuple[int, ...] = ()) -> bytes:
    """A `.vtu` file with `faces` and `faceoffsets`, as VTK wrote until 9.4; a tetrahedron of `others` comes first."""

    def array(name: str, values: Any, kind: str = "Int64", width: int = 1) -> str:
        text = " ".join(map(str, np.ravel(values).tolist()))
        return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{width}" format="ascii">{text}</DataArray>'

    streams = [[len(faces)] + [i for face in faces for i in [len(face), *face]] for faces in cells]
    rows = [list(others)] * bool(others) + [sorted({i for face in faces for i in face}) for faces in cells]
    ends = [-1] * bool(others) + np.cumsum([len(stream) for stream in streams]).tolist()
    inside = [
        array("connectivity", [i for row in rows for i in row]),
        array("offsets", np.cumsum([len(row) for row in rows])),
        array("types", [10] * bool(others) + [42] * len(cells), "UInt8"),
        array("faces", [i for stream in streams for i in stream]),
        array("faceoffsets", ends),
    ]
    return (
        '<VTKFile type="UnstructuredGrid"><UnstructuredGrid>'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(rows)}">'
        f"<Points>{array('', points, 'Float64', 3)}</Points><Cells>{''.join(inside)}</Cells></Piece>"
        "</UnstructuredGrid></VTKFile>"
    ).encode()


def forms(points: np.ndarray, cells: list[Faces], folder: Path) -> dict[str, bytes]:
    """The same polyhedra in every form that VTK has for them."""
    data = polyhedra(points, cells)
    return {
        "4.2.vtk": legacy(data, 42),
        "4.2 binary.vtk": legacy(data, 42, True),
        "5.1.vtk": legacy(data, 51),
        "5.1 binary.vtk": legacy(data, 51, True),
        "new.vtu": xml(data, folder / "x.vtu"),
        "old.vtu": old_vtu(points, cells),
    }


def volumes_of_vtk(data: bytes) -> np.ndarray:
    """Volumes by vtkCellSizeFilter, of a `.vtu` file."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.ReadFromInputStringOn()
    reader.SetInputString(data.decode("latin-1"))
    size = vtk.vtkCellSizeFilter()
    size.SetInputConnection(reader.GetOutputPort())
    size.Update()
    array = size.GetOutput().GetCellData().GetArray("Volume")
    return np.array([array.GetValue(i) for i in range(array.GetNumberOfTuples())])


@pytest.mark.parametrize("seed", range(4))
def test_R3_polyhedra_of_every_kind_in_any_order_of_their_nodes(tmp_path: Path, seed: int) -> None:
    random = np.random.default_rng(seed)
    sample = mixed()
    sample.cells = sample.cells[:4]
    order = random.permutation(len(sample.points))
    points = np.empty_like(sample.points)
    points[order] = sample.points
    moved = [(kind, [int(order[i]) for i in ids]) for kind, ids in sample.cells]
    cells = [faces_of(kind, ids, random) for kind, ids in moved]
    truth = sample_volumes(sample)
    np.testing.assert_allclose(volumes_of_vtk(old_vtu(points, cells)), truth, rtol=1e-12)
    for name, data in forms(points, cells, tmp_path).items():
        mesh = read_bytes(data, name)
        assert mesh.kinds.tolist() == [kind for kind, _ in moved], name
        np.testing.assert_allclose(signed_volumes(mesh), truth, rtol=1e-5, err_msg=name)
        for cell, (_, ids) in enumerate(moved):
            assert set(mesh.cells[cell].tolist()) == set(ids)
        assert mesh.notes == []


def test_R3_a_cube_whose_nodes_stand_in_the_order_of_a_lattice() -> None:
    mesh = read(CASES / "polyhedron-lattice-cube.vtu")
    assert mesh.kind_counts == {"hexahedron": 1}
    np.testing.assert_allclose(signed_volumes(mesh), 1)


@pytest.mark.parametrize(
    ("turns", "signs", "told"),
    [
        (lambda cell, face: False, [1, 1, 1], None),
        (lambda cell, face: True, [1, 1, 1], "faces point into most cells (3 of 3)"),
        (lambda cell, face: cell == 1, [1, -1, 1], None),
        (lambda cell, face: cell != 1, [1, -1, 1], "faces point into most cells (2 of 3)"),
        (lambda cell, face: cell == 1 and face < 2, [1, 1, 1], "some from outside: 1."),
        (lambda cell, face: face % 2, [1, 1, 1], "some from outside: 3."),
    ],
)
def test_R3_the_majority_of_the_polyhedra_tells_from_where_faces_are_seen(
    tmp_path: Path, turns: Callable[[int, int], bool], signs: list[int], told: str | None
) -> None:
    sample, random = grid(3, 1, 1), np.random.default_rng(1)
    cells = [faces_of(kind, ids, random) for kind, ids in sample.cells]
    cells = [
        [face[::-1] if turns(cell, place) else face for place, face in enumerate(faces)]
        for cell, faces in enumerate(cells)
    ]
    for name, data in forms(sample.points, cells, tmp_path).items():
        mesh = read_bytes(data, name)
        assert np.sign(signed_volumes(mesh)).tolist() == signs, name
        assert told is None if not mesh.notes else told is not None and told in mesh.notes[0]


def test_R4_the_majority_is_that_of_all_pieces() -> None:
    sample, random = grid(3, 1, 1), np.random.default_rng(1)
    cells = [faces_of(kind, ids, random) for kind, ids in sample.cells]
    inverted = old_vtu(sample.points, [[face[::-1] for face in cells[0]]]).decode()
    others = old_vtu(sample.points, cells[1:]).decode()
    pieces = [text[text.index("<Piece") : text.index("</UnstructuredGrid>")] for text in (inverted, others)]
    data = others.replace(pieces[1], pieces[0] + pieces[1])
    mesh = read_bytes(data.encode(), "x.vtu")
    assert np.sign(signed_volumes(mesh)).tolist() == [-1, 1, 1]


def test_R3_other_polyhedra_are_counted_as_left_out(tmp_path: Path) -> None:
    angle = np.arange(5) * 2 * np.pi / 5
    ring = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    points = np.concatenate([ring, ring + np.array([0, 0, 1]), grid(1, 1, 1).points])
    random = np.random.default_rng(3)
    cube = faces_of(*grid(1, 1, 1).cells[0], random)
    open_cube = [[i + 10 for i in face] for face in [*cube[:5], cube[4]]]
    cells = [PRISM, [[i + 10 for i in face] for face in cube], PRISM, open_cube]
    for name, data in forms(points, cells, tmp_path).items():
        mesh = read_bytes(data, name)
        assert mesh.kind_counts == {"hexahedron": 1}, name
        assert "polyhedra (3)" in mesh.notes[-1]


def test_R8_attributes_stay_with_the_cells_that_are_rebuilt(tmp_path: Path) -> None:
    sample, random = grid(1, 1, 1), np.random.default_rng(3)
    data = polyhedra(sample.points, [faces_of(*sample.cells[0], random)])
    insert(data, 5, [0, 1, 2])
    insert(data, 10, [0, 1, 2, 4])
    array = vtk.vtkIntArray()
    array.SetName("q")
    for value in (7, 8, 9):
        array.InsertNextValue(value)
    data.GetCellData().AddArray(array)
    for content, name in ((legacy(data), "x.vtk"), (xml(data, tmp_path / "x.vtu"), "x.vtu")):
        mesh = read_bytes(content, name)
        assert list(mesh.kind_counts) == ["hexahedron", "tetrahedron"] and mesh.kinds.tolist() == [0, 3]
        assert mesh.cell_data["q"].tolist() == [7, 9]


def test_R4_faces_of_cells_that_are_no_polyhedra_are_not_there() -> None:
    sample, random = grid(1, 1, 1), np.random.default_rng(3)
    mesh = read_bytes(old_vtu(sample.points, [faces_of(*sample.cells[0], random)], (0, 1, 2, 4)), "x.vtu")
    assert mesh.kinds.tolist() == [3, 0]
    np.testing.assert_allclose(signed_volumes(mesh)[1], sample_volumes(sample)[0], rtol=0.2)


GOOD = old_vtu(grid(1, 1, 1).points, [faces_of(*grid(1, 1, 1).cells[0], np.random.default_rng(3))])


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (b">31</", b">32</", ["faceoffsets should rise from 0 to 31"]),
        (b">31</", b">31 31</", ["faceoffsets has 2 entries, expected one for each of 1 cells"]),
        (b'"faces" Num', b'"fases" Num', ["no volumetric cells, only polyhedra (1)"]),
        (b">6 4 ", b">5 4 ", ["no volumetric cells, only polyhedra (1)"]),
        (b">6 4 ", b">6 99999 ", ["no volumetric cells, only polyhedra (1)"]),
    ],
)
def test_R10_bad_faces(old: bytes, new: bytes, words: list[str]) -> None:
    assert old in GOOD
    with pytest.raises(MeshReadError) as caught:
        read_bytes(GOOD.replace(old, new), "bad.vtu")
    for word in ["bad.vtu", *words]:
        assert word in str(caught.value)


def test_R10_a_face_of_a_vertex_that_is_not_there() -> None:
    last = GOOD.index(b'"faces"')
    for number in (b"8", b"-1", b"99999999999999"):
        data = GOOD[:last] + GOOD[last:].replace(b" 7", b" " + number)
        with pytest.raises(MeshReadError, match=r"bad\.vtu, line 1: a hexahedron refers to"):
            read_bytes(data, "bad.vtu")
