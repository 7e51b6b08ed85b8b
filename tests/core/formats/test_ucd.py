"""SPEC R5: AVS UCD in text, beside meshio (which numbers as AVS does) and VTK (which numbers as VTK does)."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from tests.core.formats.samples import MESHIO_NAMES, Sample, check, grid, mixed, signed_volumes
from tests.tools import tool

meshio = tool("meshio")
vtk = tool("vtk")

WORDS = ("hex", "prism", "pyr", "tet")
OF_AVS = ((4, 5, 6, 7, 0, 1, 2, 3), (3, 4, 5, 0, 1, 2), (4, 0, 1, 2, 3), (0, 1, 3, 2))
"""Places of VTK's corners in the order in which meshio writes them."""


def ucd(
    sample: Sample, order: tuple[tuple[int, ...], ...] = OF_AVS, tail: str = "", counts: str = "0 0 0"
) -> bytes:
    """The text of a file; nodes are numbered 10, 20, ..., cells 7, 8, ..., materials 1, 2, 1, 2, ..."""
    lines = ["# made by a test", f"{len(sample.points)} {len(sample.cells)} {counts}"]
    lines += [f"{10 * at + 10} {x!r} {y!r} {z!r}" for at, (x, y, z) in enumerate(sample.points.tolist())]
    for at, (kind, ids) in enumerate(sample.cells):
        nodes = [str(10 * ids[place] + 10) for place in order[kind]]
        lines.append(f"{at + 7} {at % 2 + 1} {WORDS[kind]} " + " ".join(nodes))
    return ("\n".join(lines) + "\n" + tail).encode()


def sound() -> Sample:
    """The mixed sample with no cell inside out."""
    sample = mixed()
    return Sample(sample.points, sample.cells[:4])


def test_R5_cells_of_all_kinds_numbered_as_avs_does() -> None:
    sample = sound()
    mesh = read_bytes(ucd(sample), "x.inp")
    check(mesh, sample)
    assert mesh.format == "ucd" and not mesh.notes
    assert mesh.vertex_numbers is not None and mesh.vertex_numbers.tolist() == list(range(10, 140, 10))
    assert mesh.cell_numbers is not None and mesh.cell_numbers.tolist() == [7, 8, 9, 10]
    assert mesh.cell_data["material"].tolist() == [1, 2, 1, 2]


def test_R5_cells_numbered_as_vtk_does_are_told(tmp_path: Path) -> None:
    """As deal.II and Cubit write them; the truth is what VTK makes of the file, which sees pyramids as AVS does."""
    sample = sound()
    path = tmp_path / "x.inp"
    path.write_bytes(ucd(sample, (tuple(range(8)), tuple(range(6)), OF_AVS[2], tuple(range(4)))))
    mesh = read_bytes(path.read_bytes(), path.name)
    check(mesh, sample)
    assert len(mesh.notes) == 3 and all("as VTK numbers them" in note for note in mesh.notes)
    reader = vtk.vtkAVSucdReader()
    reader.SetFileName(str(path))
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    theirs = sizes.GetOutput()
    volumes = [theirs.GetCellData().GetArray("Volume").GetValue(cell) for cell in range(mesh.cell_count)]
    np.testing.assert_allclose(np.abs(signed_volumes(mesh)), np.abs(volumes))


def test_R5_what_meshio_writes(tmp_path: Path) -> None:
    sample = sound().grouped()
    blocks = [(MESHIO_NAMES[kind], sample.rows_of(kind)) for kind in range(4)]
    heat, flow = np.arange(13.0), np.arange(12.0).reshape(4, 3)
    theirs = meshio.Mesh(
        sample.points,
        blocks,
        point_data={"heat": heat},
        cell_data={"flow": [flow[at : at + 1] for at in range(4)]},
    )
    meshio.write(tmp_path / "x.inp", theirs, file_format="avsucd")
    mesh = read_bytes((tmp_path / "x.inp").read_bytes(), "x.inp")
    check(mesh, sample)
    assert not mesh.notes
    np.testing.assert_array_equal(mesh.point_data["heat"], heat)
    np.testing.assert_array_equal(mesh.cell_data["flow"], flow)


def test_R5_values_keep_their_places_though_lines_are_in_another_order_beside_faces() -> None:
    sample = grid(2, 1, 1)
    text = ucd(sample, counts="0 1 0").replace(b"12 2 0 1 0", b"12 3 0 1 0")
    text += b"99 4 quad 10 20 50 40\n1 1\nheat, K\n99 5\n8 2.5\n7 -nan(ind)\n"
    mesh = read_bytes(text, "x.ucd")
    assert mesh.cell_count == 2
    assert np.isnan(mesh.cell_data["heat"][0]) and mesh.cell_data["heat"][1] == 2.5
    (faces,) = mesh.features
    assert mesh.vertex_numbers[faces.corners[:, 0]].tolist() == [10, 20, 50, 40]
    assert faces.data["material"].tolist() == [4]


def test_R5_an_inverted_cell_stays_inverted_among_sound_ones() -> None:
    sample = grid(3, 1, 1)
    kind, ids = sample.cells[1]
    sample.cells[1] = (kind, ids[4:] + ids[:4])
    mesh = read_bytes(ucd(sample), "x.inp")
    assert np.sign(signed_volumes(mesh)).tolist() == [1, -1, 1]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (b"hex 70", b"hexa 70", ["line 15", "‘hexa’", "hex, line, prism"]),
        (b"hex 70", b"hex 75", ["cell 7", "node 75", "missing"]),
        (b"\n20 1", b"\n20.5 1", ["line 4", "not whole"]),
        (b"\n20 1", b"\n20 x", ["line 4", "‘x"]),
        (b"12 2 0", b"12 3 0", ["line 16", "cells should be 3 rows"]),
        (b"12 2 0 0 0", b"12 2 0 2 0", ["the number of arrays"]),
        (b"12 2 0 0 0", b"12 99999999 0 0 0", ["line 2", "cut short"]),
    ],
)
def test_R10_faults_are_told_with_their_line(old: bytes, new: bytes, words: list[str]) -> None:
    sample = grid(2, 1, 1)
    sample.points = np.abs(np.round(sample.points))
    text = ucd(sample).replace(b".0", b"")
    assert text.count(old) == 1
    with pytest.raises(MeshReadError) as error:
        read_bytes(text.replace(old, new), "x.inp")
    assert all(word in str(error.value) for word in words), error.value


def test_R6_binary_ucd_is_named() -> None:
    with pytest.raises(MeshReadError, match="binary"):
        read_bytes(b"\x07\x00\x00\x00\x08", "x.inp")
