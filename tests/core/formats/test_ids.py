"""Numbers of any type, byte order and address become int32, those that do not fit an end of its range."""

from __future__ import annotations

import re
from itertools import product

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from hexalab.formats.byte_order import STRETCH, as_coordinates, native, stretches
from hexalab.formats.ids import LARGEST_ID, as_int32
from hexalab.formats.vtk_cells import evenly

EDGES = (
    0,
    1,
    127,
    128,
    255,
    2**16,
    LARGEST_ID,
    2**31 - 1,
    2**31,
    2**32 - 1,
    2**32,
    2**63 - 1,
    -1,
    -(2**31),
    -(2**63),
)


def placed(values: np.ndarray, shift: int) -> np.ndarray:
    """The values at an address that is `shift` bytes from an even one, read-only as a file's bytes are."""
    data = bytes(shift) + values.tobytes()
    return np.frombuffer(data, values.dtype, values.size, shift).reshape(values.shape)


@pytest.mark.parametrize("code", ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8"])
@pytest.mark.parametrize("order", "<>")
def test_R3_ids_of_any_number_type_and_byte_order(code: str, order: str) -> None:
    span = np.iinfo(code)
    edges = [edge for edge in EDGES if span.min <= edge <= span.max]
    for chosen in ([5], [7, 0, 3, 100], *([3, edge, 1] for edge in edges)):
        values = np.array(chosen, dtype=order + code)
        found = as_int32(native(values) if values.itemsize < 4 else values)
        for value, got in zip(chosen, found.tolist(), strict=True):
            end = LARGEST_ID if value > 0 else -LARGEST_ID
            assert got == value or (abs(value) > LARGEST_ID and got == end)


@pytest.mark.parametrize("shift", range(9))
def test_R3_tables_at_odd_addresses_come_whole_and_in_order(shift: int) -> None:
    rng = np.random.default_rng(shift)
    for dtype, count, width in product((">i8", "<i8", ">i4", "u1"), (0, 1, 5, STRETCH // 64 + 3), (1, 8, 9)):
        table = rng.integers(0, 200, (count, width)).astype(dtype)
        found = [(part.start, part.stop, rows.copy()) for part, rows in stretches(placed(table, shift))]
        assert [start for start, _, _ in found] == [0, *(stop for _, stop, _ in found)][: len(found)]
        assert np.array_equal(np.concatenate([np.empty((0, width)), *(rows for *_, rows in found)]), table)


@pytest.mark.parametrize("dtype", [">f8", "<f8", ">f4", "<f4", ">i4", "u1", ">i8"])
def test_R3_coordinates_of_any_number_type(dtype: str) -> None:
    points = np.random.default_rng(3).uniform(0, 200, (STRETCH // 24 + 7, 3)).astype(dtype)
    found = as_coordinates(placed(points, 3))
    assert found.dtype == np.float64 and found.flags.c_contiguous
    assert np.array_equal(found, points.T.astype(np.float64))


def test_R3_offsets_that_rise_evenly() -> None:
    for dtype in (">i8", "<i4", ">u8"):
        offsets = (8 * np.arange(STRETCH // 8 + 100)).astype(dtype)
        assert evenly(placed(offsets, 1), 8)
        for wrong in (0, 1, STRETCH // 8, len(offsets) - 1):
            other = offsets.copy()
            other[wrong] += 1
            assert not evenly(placed(other, 1), 8)


@pytest.mark.parametrize("wrong", [2**31 - 2, 2**31, 5 * 10**9, -(5 * 10**9), 2**62, 10**30])
def test_R10_a_number_that_no_vertex_has_is_not_told_wrongly(wrong: int) -> None:
    points = "0 0 0 0 " * 8
    text = f"MeshVersionFormatted 2 Dimension 3 Vertices 8 {points} Hexahedra 1 1 2 3 4 5 6 7 {wrong} 0 End"
    with pytest.raises(MeshReadError) as caught:
        read_bytes(text.encode(), "x.mesh")
    assert "expected 1 to 8" in str(caught.value)
    told = [int(number) for number in re.findall(r"vertex (-?\d+)", str(caught.value))]
    assert told in ([], [wrong])
