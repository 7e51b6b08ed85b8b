"""SPEC R4: blocks of a `.vtu` file that LZMA compressed, where Python has it."""

from __future__ import annotations

import zlib
from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes
from tests.core.formats.samples import HEXAHEDRON, Sample, check, grid
from tests.core.formats.test_vtu import CASES, CUBE, GOOD, RAW, packed
from tests.tools import needs, tool

needs("_lzma")
lzma, meshio = tool("lzma"), tool("meshio")

SMALL, XZ = zlib.compress(RAW), lzma.compress(RAW)
GREEDY = lzma.compress(RAW, filters=[{"id": lzma.FILTER_LZMA2, "preset": 0, "dict_size": 2**29}])
"""A stream that asks for half a gigabyte of memory."""

UNIT_CUBE = Sample(
    np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=float),
    [(HEXAHEDRON, list(range(8)))],
)


def test_R4_lzma() -> None:
    check(read(CASES / "vtu-lzma.vtu"), UNIT_CUBE)


def test_R4_lzma_of_meshio(tmp_path: Path) -> None:
    sample = grid(3, 4, 5)
    mesh = meshio.Mesh(sample.points, [("hexahedron", sample.rows_of(HEXAHEDRON))])
    meshio.write(tmp_path / "x.vtu", mesh, compression="lzma")
    check(read(tmp_path / "x.vtu"), sample)


@pytest.mark.parametrize(
    ("header", "blocks", "words"),
    [
        ((1, 96, 0, len(XZ)), XZ, None),
        ((1, 95, 0, len(XZ)), XZ, ["block 1", "more", "95"]),
        ((1, 97, 0, len(XZ)), XZ, ["block 1", "96 bytes", "97"]),
        ((1, 96, 0, 40), XZ, ["block 1", "holds"]),
        ((1, 96, 0, len(XZ)), XZ[:30] + b"xyz" + XZ[33:], ["block 1", "damaged"]),
        ((1, 96, 0, len(SMALL)), SMALL, ["block 1", "damaged"]),
        ((1, 96, 0, len(RAW)), RAW, ["block 1", "damaged"]),
        ((1, 2**32 - 1, 0, len(XZ)), XZ, ["refused"]),
        ((1, 96, 0, len(GREEDY)), GREEDY, ["block 1", "damaged", "Memory usage limit"]),
    ],
)  # fmt: skip
def test_R10_blocks_of_lzma_that_lie(header: tuple[int, ...], blocks: bytes, words: list[str] | None) -> None:
    data = GOOD.replace(b'"UnstructuredGrid"', b'"UnstructuredGrid" compressor="vtkLZMADataCompressor"', 1)
    old = b'NumberOfComponents="3" format="ascii">' + CUBE.encode()
    data = data.replace(old, b'NumberOfComponents="3" format="binary">' + packed(header, blocks))
    if words is None:
        assert read_bytes(data, "x.vtu").cell_count == 1
        return
    with pytest.raises(MeshReadError) as caught:
        read_bytes(data, "bad.vtu")
    for word in words:
        assert word in str(caught.value)
