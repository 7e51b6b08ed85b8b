"""Numpy finds a zero in white space: where a line is longer than the piece that is parsed, its end stands alone."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.formats import read_bytes
from hexalab.formats.text import PIECE
from hexalab.formats.tokens import parse

POINTS = "0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1"

MSH = """$MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
1 0 0 1
1 0 0 0 0{space}
4 -0.000000100000000000000 -0.000000100000000000000 -0.000000100000000000000 1.0000001 1.0000001 1.0000001 1 7 0
$EndEntities
$Nodes
1 8 1 8
3 4 0 8
1 2 3 4 5 6 7 8
{points}
$EndNodes
$Elements
1 1 1 1
3 4 5 1
1 1 2 3 4 5 6 7 8
$EndElements
"""


@pytest.mark.parametrize("dtype", [np.int64, np.float64])
def test_R10_no_number_is_found_in_white_space(dtype: type) -> None:
    for piece in (b"", b" ", b"\n", b" \r\n\t "):
        values, stopped = parse(piece, dtype)
        assert not len(values)
        assert not stopped


def test_R3_all_ids_on_one_line() -> None:
    count = PIECE // 16 + 1
    head = f"# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n{POINTS}\n"
    ids = " ".join(["0 1 2 3 4 5 6 7"] * count)
    offsets = " ".join(str(8 * cell) for cell in range(count + 1))
    text = (
        f"{head}CELLS {count + 1} {8 * count}\nOFFSETS vtktypeint64\n{offsets}\nCONNECTIVITY vtktypeint64\n{ids}\n"
        f"CELL_TYPES {count}\n{' '.join(['12'] * count)}\n"
    )
    found = read_bytes(text.encode(), "x.vtk").cells
    np.testing.assert_array_equal(found, np.tile(np.arange(8), (count, 1)))


@pytest.mark.parametrize("space", ["", " ", "\n\n"])
def test_R5_entities_that_gmsh_writes_on_long_lines(space: str) -> None:
    mesh = read_bytes(MSH.format(points=POINTS.replace("  ", "\n"), space=space).encode(), "x.msh")
    assert mesh.cells.tolist() == [list(range(8))]
    assert mesh.cell_data["physical"].tolist() == [7]
