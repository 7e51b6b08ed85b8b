"""The arrays of a `.vtu` file: ascii, base64 or appended, compressed or not.

Layout after VTK's file formats, "Uncompressed and compressed data": a header of one integer (bytes that
follow) or, compressed, of 3 + n (blocks, size of a block, size of the last if smaller, compressed sizes).
"""

from __future__ import annotations

import binascii

import numpy as np

from ..arrays import Array
from ..errors import MeshReadError
from .container import inflation_bound
from .file import File
from .text import Text
from .tokens import quoted
from .vtu_compression import Damaged, Inflate, Unreadable, inflate_zlib, inflater
from .xml_tags import Element

TYPES = {
    "Int8": "i1",
    "UInt8": "u1",
    "Int16": "i2",
    "UInt16": "u2",
    "Int32": "i4",
    "UInt32": "u4",
    "Int64": "i8",
    "UInt64": "u8",
    "Float32": "f4",
    "Float64": "f8",
}


class Arrays:
    """Decodes DataArray elements.

    Parameters
    ----------
    file : File
        The file.
    top : Element
        Its VTKFile element.
    appended : Element or None
        Its AppendedData element.
    """

    def __init__(self, file: File, top: Element, appended: Element | None) -> None:
        self.file = file
        given = top.attributes
        order = given.get("byte_order", "LittleEndian")
        if order not in ("LittleEndian", "BigEndian"):
            raise self.error(top, f"byte_order is {quoted(order)}, expected LittleEndian or BigEndian")
        self.order = "<" if order == "LittleEndian" else ">"
        header = given.get("header_type", "UInt32")
        if header not in ("UInt32", "UInt64"):
            raise self.error(top, f"header_type is {quoted(header)}, expected UInt32 or UInt64")
        self.header = np.dtype(self.order + TYPES[header])
        self.compressor = given.get("compressor", "")
        self.inflate: Inflate = inflate_zlib
        self.appended_base64 = False
        self.appended_begin = -1
        if appended is not None:
            encoding = appended.attributes.get("encoding", "base64")
            if encoding not in ("raw", "base64"):
                raise self.error(
                    appended, f"appended data are encoded as {quoted(encoding)}, expected raw or base64"
                )
            self.appended_base64 = encoding == "base64"
            mark = file.data.find(b"_", appended.begin, appended.begin + 4096)
            if mark < 0:
                raise self.error(appended, "the appended data do not begin with an underscore")
            self.appended_begin = mark + 1

    def error(self, element: Element, message: str) -> MeshReadError:
        """The error for an element."""
        return self.file.error(message, line_at=element.begin)

    def values(self, element: Element, what: str) -> Array:
        """The numbers of a DataArray, flat, in this machine's byte order where that costs no copy."""
        name = element.attributes.get("type", "")
        if name not in TYPES:
            raise self.error(
                element, f"{what} are of type {quoted(name)}, expected one of {', '.join(TYPES)}"
            )
        dtype = np.dtype(self.order + TYPES[name])
        form = element.attributes.get("format", "ascii")
        if form == "ascii":
            return self.ascii(element, dtype, what)
        try:
            self.inflate = inflater(self.compressor)
        except Unreadable as error:
            raise self.error(
                element, f"{what} are compressed by {quoted(self.compressor)}; {error}"
            ) from None
        if form == "binary":
            data = self.decoded(self.file.data[element.begin : self.content_end(element)], element, what)
        elif form == "appended":
            data = self.appended(element, what)
        else:
            raise self.error(
                element, f"{what} have the format {quoted(form)}, expected ascii, binary or appended"
            )
        if len(data) % dtype.itemsize:
            raise self.error(
                element, f"{what} are {len(data)} bytes, expected a multiple of {dtype.itemsize}"
            )
        return np.frombuffer(data, dtype)

    def content_end(self, element: Element) -> int:
        """Where the element's own content ends: at its first child (VTK puts InformationKey there), if any."""
        end = self.file.data.find(b"<", element.begin, element.end)
        return element.end if end < 0 else end

    def ascii(self, element: Element, dtype: np.dtype[np.generic], what: str) -> Array:
        """Numbers written out."""
        parsed = np.float64 if dtype.kind == "f" else np.int64
        values = Text(self.file).between(element.begin, self.content_end(element), parsed, what)
        return values.astype(dtype.newbyteorder("="), copy=False)

    def appended(self, element: Element, what: str) -> bytes | memoryview:
        """The bytes of an array in the AppendedData element."""
        offset = element.attributes.get("offset", "")
        if self.appended_begin < 0:
            raise self.error(element, f"{what} should be in the appended data, but the file has none")
        start = self.appended_begin + (int(offset) if offset.isdigit() and len(offset) < 16 else -1)
        if not self.appended_begin <= start < len(self.file.data):
            raise self.error(
                element, f"{what} should be at offset {quoted(offset)} of the appended data, behind their end"
            )
        if self.appended_base64:
            end = self.file.data.find(b"<", start)
            end = len(self.file.data) if end < 0 else end
            return self.decoded(self.file.data[start:end], element, what)
        raw = memoryview(self.file.data)[start:]
        head = self.header.itemsize
        if not self.compressor:
            (size,) = self.integers(raw, 1, element, what)
            return self.exactly(raw[head:], size, element, what)
        sizes = self.block_sizes(raw, element, what)
        return self.inflated(raw[head * len(sizes) :], sizes, element, what)

    def decoded(self, text: bytes, element: Element, what: str) -> bytes | memoryview:
        """The bytes of an array in base64; its header is encoded by itself or together with the data."""
        text = text.translate(None, b" \t\r\n")
        head = self.header.itemsize
        if not self.compressor:
            units = (head + 2) // 3 * 4
            first = self.base64(text[:units], element, what)
            (size,) = self.integers(memoryview(first), 1, element, what)
            if len(first) == head:
                rest = self.base64(text[units : units + (size + 2) // 3 * 4], element, what)
                return self.exactly(memoryview(rest), size, element, what)
            whole = self.base64(text[: (size + head + 2) // 3 * 4], element, what)
            return self.exactly(memoryview(whole)[head:], size, element, what)
        first = self.base64(text[: (3 * head + 2) // 3 * 4], element, what)
        (count,) = self.integers(memoryview(first), 1, element, what)
        if not count:
            return b""
        units = ((3 + count) * head + 2) // 3 * 4
        if units > len(text) + 4:
            raise self.error(
                element, f"{what} announce {count} compressed blocks, more than there is room for"
            )
        sizes = self.block_sizes(memoryview(self.base64(text[:units], element, what)), element, what)
        data = self.base64(text[units : units + (sum(sizes[3:]) + 2) // 3 * 4], element, what)
        return self.inflated(memoryview(data), sizes, element, what)

    def base64(self, text: bytes, element: Element, what: str) -> bytes:
        """Decode base64 without blanks; a wrong letter or length is an error, not skipped."""
        try:
            return binascii.a2b_base64(text, strict_mode=True) if text else b""
        except binascii.Error as error:
            raise self.error(element, f"{what} are not in base64 ({error})") from None

    def integers(self, data: memoryview, count: int, element: Element, what: str) -> list[int]:
        """So many integers of a header."""
        size = count * self.header.itemsize
        if len(data) < size:
            raise self.error(
                element, f"{what} have {len(data)} bytes of data, expected a header of {size} bytes"
            )
        return [int(n) for n in np.frombuffer(data, self.header, count)]

    def exactly(self, data: memoryview, size: int, element: Element, what: str) -> memoryview:
        """The first `size` bytes; an error if there are fewer."""
        if size > len(data):
            raise self.error(element, f"{what} should be {size} bytes, but only {len(data)} are there")
        return data[:size]

    def block_sizes(self, data: memoryview, element: Element, what: str) -> list[int]:
        """The header of compressed data: blocks, size, size of the last, compressed sizes."""
        (count,) = self.integers(data, 1, element, what)
        if count > len(data) // self.header.itemsize:
            raise self.error(
                element, f"{what} announce {count} compressed blocks, more than there is room for"
            )
        return self.integers(data, 3 + count if count else 1, element, what) + ([0, 0] if not count else [])

    def inflated(self, data: memoryview, sizes: list[int], element: Element, what: str) -> bytes:
        """The inflated blocks; none may be larger than its header says."""
        count, size, last = sizes[:3]
        out: list[bytes] = []
        total = position = 0
        bound = inflation_bound(len(self.file.data))
        for index, packed in enumerate(sizes[3:]):
            full = last if last and index == count - 1 else size
            if packed > len(data) - position:
                raise self.error(
                    element, f"block {index + 1} of {what} should be {packed} bytes, but the data end"
                )
            total += full
            if total > bound:
                raise self.error(element, f"{what} inflate to more than {bound // 2**20} MB: refused")
            try:
                block = self.inflate(bytes(data[position : position + packed]), full + 1)
            except Damaged as error:
                raise self.error(element, f"block {index + 1} of {what} is damaged ({error})") from None
            if len(block) != full:
                found = "more" if len(block) > full else f"{len(block)}"
                raise self.error(
                    element, f"block {index + 1} of {what} holds {found} bytes, its header says {full}"
                )
            out.append(block)
            position += packed
        return b"".join(out)
