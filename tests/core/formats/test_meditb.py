"""SPEC R2: `.meshb` versions 1 to 4 in both byte orders, written by hand after libMeshb's documentation."""

from __future__ import annotations

import struct

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from tests.core.formats.samples import Sample, check, grid, mixed

FROM_VTK = ((0, 1, 2, 3, 4, 5, 6, 7), (0, 2, 1, 3, 5, 4), (0, 1, 2, 3, 4), (0, 1, 2, 3))
NUMBERS = (10, 9, 49, 8)


def meshb(sample: Sample, version: int, order: str, end: bool = True, extra: bytes | None = None) -> bytes:
    """The sample as a `.meshb` file."""
    real = "f" if version == 1 else "d"
    whole = "q" if version == 4 else "i"
    place = "q" if version >= 3 else "i"
    out = struct.pack(f"{order}ii", 1, version)

    def section(number: int, content: bytes) -> None:
        nonlocal out
        following = len(out) + 4 + struct.calcsize("<" + place) + len(content)
        out += struct.pack(f"{order}i{place}", number, following) + content

    section(3, struct.pack(f"{order}i", 3))
    if extra is not None:
        section(120, extra)
    rows = b"".join(struct.pack(f"{order}3{real}{whole}", *p, i % 3) for i, p in enumerate(sample.points))
    section(4, struct.pack(f"{order}{whole}", len(sample.points)) + rows)
    section(6, struct.pack(f"{order}{whole}4{whole}", 1, 1, 2, 3, 0))
    for kind, number in enumerate(NUMBERS):
        cells = sample.rows_of(kind)[:, list(FROM_VTK[kind])] + 1
        rows = b"".join(struct.pack(f"{order}{cells.shape[1] + 1}{whole}", *row, 5) for row in cells)
        section(number, struct.pack(f"{order}{whole}", len(cells)) + rows)
    return out + (struct.pack(f"{order}i{place}", 54, 0) if end else b"")


@pytest.mark.parametrize("version", [1, 2, 3, 4])
@pytest.mark.parametrize("order", ["<", ">"])
def test_R2_versions_and_byte_orders(version: int, order: str) -> None:
    sample = mixed().grouped()
    mesh = read_bytes(meshb(sample, version, order, extra=b"unknown section"), "x.meshb")
    check(mesh, sample, 1e-6 if version == 1 else 0)
    assert mesh.cell_data["reference"].tolist() == [5] * 5
    assert mesh.point_data["reference"].tolist() == [i % 3 for i in range(13)]
    assert mesh.notes == []
    assert [part.corners.T.tolist() for part in mesh.features] == [[[0, 1, 2, 2]]]


def test_R2_the_content_decides_not_the_name() -> None:
    assert read_bytes(meshb(grid(1, 2, 1), 2, "<"), "x.mesh").format == "meshb"


def test_R2_a_missing_end_is_noted() -> None:
    mesh = read_bytes(meshb(grid(1, 2, 1), 3, ">", end=False), "x.meshb")
    check(mesh, grid(1, 2, 1))
    assert any("cut short" in note for note in mesh.notes)


@pytest.mark.parametrize(
    ("at", "format", "value", "words"),
    [
        (4, "i", 5, ["byte 4", "version 5", "expected 1 to 4"]),
        (12, "i", 10**9, ["byte 8", "section 3", "1000000000"]),
        (12, "i", 9, ["section 3", "byte 9"]),
        (12, "i", -1, ["section 3", "byte -1"]),
        (16, "i", 2, ["dimension is 2"]),
        (28, "i", 2**30, ["1073741824 vertices"]),
        (28, "i", -4, ["-4 vertices"]),
        (32, "d", float("nan"), ["byte 32", "x coordinate of vertex 1 is nan"]),
    ],
)
def test_R10_bad_meshb_files(at: int, format: str, value: float, words: list[str]) -> None:
    data = bytearray(meshb(grid(2, 1, 1), 2, "<"))
    struct.pack_into("<" + format, data, at, value)
    with pytest.raises(MeshReadError) as caught:
        read_bytes(bytes(data), "bad.meshb")
    for word in ["bad.meshb", *words]:
        assert word in str(caught.value)


def test_R10_a_vertex_that_is_not_there_is_told_by_byte() -> None:
    sample = grid(2, 1, 1)
    data = meshb(sample, 2, "<")
    row = struct.pack("<9i", *(np.array(sample.cells[1][1]) + 1), 5)
    at = data.index(row)
    data = data.replace(row, struct.pack("<9i", 1, 2, 3, 77, 5, 6, 7, 8, 5))
    with pytest.raises(MeshReadError, match=f"byte {at + 12}: .*vertex 77"):
        read_bytes(data, "bad.meshb")
