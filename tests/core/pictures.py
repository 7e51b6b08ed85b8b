"""PNG files made byte by byte, to be read by the core: whole pictures, and texts put into them."""

from __future__ import annotations

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
TEXT_CHUNKS = (b"iTXt", b"zTXt", b"tEXt")


def chunk(name: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))


def png(*texts: bytes) -> bytes:
    """A picture of one pixel with some more chunks."""
    header = chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 0, 0, 0, 0))
    pixels = chunk(b"IDAT", zlib.compress(b"\0\0"))
    return SIGNATURE + header + b"".join(texts) + pixels + chunk(b"IEND", b"")


def write_text(data: bytes, text: str, keyword: str = "hexalab") -> bytes:
    """The PNG with the text in an iTXt chunk before IEND; texts of that keyword are replaced."""
    parts, place = [data[: len(SIGNATURE)]], len(SIGNATURE)
    while place < len(data):
        (size,) = struct.unpack_from(">I", data, place)
        name, body = data[place + 4 : place + 8], data[place + 8 : place + 8 + size]
        if name == b"IEND":
            parts.append(chunk(b"iTXt", keyword.encode("latin-1") + b"\0\0\0\0\0" + text.encode()))
        if name not in TEXT_CHUNKS or body.partition(b"\0")[0].decode("latin-1") != keyword:
            parts.append(data[place : place + size + 12])
        place += size + 12
    return b"".join(parts)
