"""Packs a nested result with arrays into one block of bytes, and back.

The form, little-endian throughout::

    4 bytes    "HXB1"
    4 bytes    uint32: length of the header
    header     JSON, UTF-8, padded with spaces so that the arrays start at a multiple of 8
    arrays     each at a multiple of 8 from the first one's start

In the header an array is ``{"dtype": "float32", "shape": [n, ...], "offset": bytes}``, its offset counted
from the end of the header. Numbers that are not finite become null.
"""

from __future__ import annotations

import json
import math
import struct
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import HexaLabError

MAGIC = b"HXB1"
ALIGNMENT = 8
DTYPES = (
    "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64",
)  # fmt: skip
START = struct.Struct("<4sI")


@dataclass(frozen=True)
class Packed:
    """A packed result whose arrays have not been copied yet.

    Attributes
    ----------
    head : bytes
        All that stands before the arrays.
    arrays : list of (offset, array)
        Contiguous, little-endian; offsets are counted from the head's end and grow.
    size : int
        Bytes of the whole.
    """

    head: bytes
    arrays: list[tuple[int, NDArray[Any]]]
    size: int

    def joined(self) -> bytes:
        """Return the whole as one block of bytes."""
        out = bytearray(self.size)
        out[: len(self.head)] = self.head
        for offset, array in self.arrays:
            start = len(self.head) + offset
            out[start : start + array.nbytes] = array.reshape(-1).view(np.uint8).data
        return bytes(out)


def lay_out(value: dict[str, Any]) -> Packed:
    """Make a dict of dicts, lists, numbers, texts and arrays ready to be packed.

    A caller that can write to its receiver's memory copies each array straight to where it is wanted.

    Raises
    ------
    TypeError
        If an array's number type is none of `DTYPES` (or bool, which is packed as uint8).
    """
    arrays: list[tuple[int, NDArray[Any]]] = []
    text = json.dumps(_described(value, arrays), ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    header = text.encode()
    header += b" " * (_aligned(START.size + len(header)) - START.size - len(header))
    head = START.pack(MAGIC, len(header)) + header
    return Packed(head, arrays, len(head) + _end(arrays))


def _described(part: Any, arrays: list[tuple[int, NDArray[Any]]]) -> Any:
    """A part as the header has it; its arrays join those before.

    No function within a function: one that calls itself holds itself, and with it all arrays, until Python looks for
    such circles. Every slice would then be drawn into fresh memory, which costs a tenth of its time.
    """
    if isinstance(part, np.ndarray):
        array = _little_endian(part)
        offset = _end(arrays)
        arrays.append((offset, array))
        return {"dtype": array.dtype.name, "shape": list(array.shape), "offset": offset}
    if isinstance(part, dict):
        return {str(name): _described(inner, arrays) for name, inner in part.items()}
    if isinstance(part, list | tuple):
        return [_described(inner, arrays) for inner in part]
    return plain(part)


def _end(arrays: list[tuple[int, NDArray[Any]]]) -> int:
    """Where the next array begins."""
    if not arrays:
        return 0
    offset, array = arrays[-1]
    return offset + _aligned(array.nbytes)


def pack(value: dict[str, Any]) -> bytes:
    """Pack a dict of dicts, lists, numbers, texts and arrays; errors as for `lay_out`."""
    return lay_out(value).joined()


def unpack(data: bytes | memoryview) -> dict[str, Any]:
    """Unpack what `pack` made; the arrays are views of `data`.

    Raises
    ------
    HexaLabError
        If the bytes are not in this form.
    """
    data = memoryview(data).cast("B")
    if len(data) < START.size:
        raise HexaLabError(f"packed data: found {len(data)} bytes, expected {START.size} at least")
    magic, length = START.unpack_from(data)
    if magic != MAGIC or START.size + length > len(data):
        raise HexaLabError("packed data: does not start with HXB1 and a header")
    try:
        header = json.loads(bytes(data[START.size : START.size + length]))
    except ValueError as error:
        raise HexaLabError(f"packed data: its header is not JSON: {error}") from None
    body = data[START.size + length :]
    found = _restored(header, body)
    if not isinstance(found, dict):
        raise HexaLabError("packed data: its header is not an object")
    return found


def plain(value: Any) -> Any:
    """Turn a scalar into what JSON holds: numpy's into Python's, and what is not finite into None."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def jsonable(value: Any) -> Any:
    """Turn a nested result into what JSON holds: arrays into lists, and what is not finite into None."""
    if isinstance(value, dict):
        return {str(name): jsonable(part) for name, part in value.items()}
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, list | tuple):
        return [jsonable(part) for part in value]
    return plain(value)


def _restored(part: Any, body: memoryview) -> Any:
    if isinstance(part, list):
        return [_restored(inner, body) for inner in part]
    if not isinstance(part, dict):
        return part
    if part.keys() != {"dtype", "shape", "offset"}:
        return {name: _restored(inner, body) for name, inner in part.items()}
    dtype, shape, offset = part["dtype"], part["shape"], part["offset"]
    if dtype not in DTYPES or not all(isinstance(size, int) and size >= 0 for size in [*shape, offset]):
        raise HexaLabError(f"packed data: found an array described as {part}")
    count = math.prod(shape)
    kind = np.dtype(dtype).newbyteorder("<")
    if offset + count * kind.itemsize > len(body):
        raise HexaLabError("packed data: it ends before the arrays that its header names")
    return np.frombuffer(body, kind, count, offset).reshape(shape)


def _little_endian(array: NDArray[Any]) -> NDArray[Any]:
    if array.dtype == bool:
        array = array.view(np.uint8)
    if array.dtype.name not in DTYPES:
        raise TypeError(f"arrays of {array.dtype} can't be packed")
    return np.ascontiguousarray(array, array.dtype.newbyteorder("<"))


def _aligned(size: int) -> int:
    return -(-size // ALIGNMENT) * ALIGNMENT
