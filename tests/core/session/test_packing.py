"""Packed results: what comes out is what went in, and bytes that lie are refused."""

from __future__ import annotations

import gc
import json
import struct
import weakref

import numpy as np
import pytest

from hexalab.errors import HexaLabError
from hexalab.packing import jsonable, lay_out, pack, unpack

VALUE = {
    "name": "cube ∎",
    "empty": np.zeros((0, 3), np.float32),
    "surface": {"positions": np.arange(7, dtype=np.float32), "cells": np.arange(3, dtype=np.uint32)},
    "list": [1, None, True, {"inside": np.array([[1, 255]], np.uint8)}],
    "offset": 3,
}


def test_O2_packed_arrays_come_back() -> None:
    data = pack(VALUE)
    back = unpack(data)
    assert back["name"] == "cube ∎"
    assert back["list"][:3] == [1, None, True]
    assert back["empty"].shape == (0, 3)
    for found, put in (
        (back["surface"]["positions"], VALUE["surface"]["positions"]),
        (back["surface"]["cells"], VALUE["surface"]["cells"]),
        (back["list"][3]["inside"], VALUE["list"][3]["inside"]),
    ):
        assert found.dtype == put.dtype
        assert np.array_equal(found, put)


def test_O2_the_form_is_as_documented() -> None:
    data = pack({"a": np.array([1.5], ">f8"), "b": np.array([True, False])})
    magic, length = struct.unpack_from("<4sI", data)
    header = json.loads(data[8 : 8 + length])
    assert magic == b"HXB1"
    assert (8 + length) % 8 == 0
    assert header["a"] == {"dtype": "float64", "shape": [1], "offset": 0}
    assert header["b"] == {"dtype": "uint8", "shape": [2], "offset": 8}
    assert struct.unpack_from("<d", data, 8 + length) == (1.5,)
    assert len(data) % 8 == 0


def test_O2_what_is_not_finite_becomes_null() -> None:
    assert unpack(pack({"a": float("nan"), "b": np.float64("inf"), "c": np.int32(4)})) == {
        "a": None,
        "b": None,
        "c": 4,
    }
    assert jsonable({"x": np.array([1.0, np.nan]), 3: (np.float32(2), float("-inf"))}) == {
        "x": [1.0, None],
        "3": [2.0, None],
    }


def test_O2_arrays_of_other_types_are_refused() -> None:
    with pytest.raises(TypeError, match="complex"):
        pack({"a": np.zeros(2, complex)})


HEADERS = [b"{", b"[1]", b'{"a":{"dtype":"float64","shape":[9],"offset":0}}']
HEADERS += [
    b'{"a":{"dtype":"object","shape":[1],"offset":0}}',
    b'{"a":{"dtype":"int8","shape":[-1],"offset":0}}',
]


@pytest.mark.parametrize(
    "data",
    [b"", b"HXB2\0\0\0\0", b"HXB1\xff\0\0\0"] + [b"HXB1" + struct.pack("<I", len(h)) + h for h in HEADERS],
)
def test_O2_bytes_of_another_form_are_refused(data: bytes) -> None:
    with pytest.raises(HexaLabError, match="packed data"):
        unpack(data)


def test_P7_nothing_holds_the_arrays_when_the_answer_is_gone() -> None:
    """A circle of references would keep the arrays of every slice until Python looks for circles."""
    array = np.arange(5.0)
    gone = weakref.ref(array)
    gc.disable()
    try:
        packed = lay_out({"result": {"deep": [{"surface": array}]}})
        assert np.shares_memory(packed.arrays[0][1], array), "laid out, not copied"
        del packed, array
        assert gone() is None
    finally:
        gc.enable()
