"""Settings inside pictures: text chunks of PNG files (SPEC S3).

Read are iTXt, zTXt and tEXt chunks with the keyword ``hexalab``, as the original HexaLab, this one's viewer and
others write them. Source: the PNG specification, third edition, 11.3.3.
"""

from __future__ import annotations

import json
import struct
import zlib
from collections.abc import Iterator
from typing import Any

from .errors import HexaLabError

KEYWORD = "hexalab"
SIGNATURE = b"\x89PNG\r\n\x1a\n"
LARGEST_TEXT = 16 * 1024 * 1024
TEXT_CHUNKS = (b"iTXt", b"zTXt", b"tEXt")
IEND = b"IEND"


class PngError(HexaLabError):
    """A file is not a picture that carries settings."""


def read_settings(data: bytes) -> Any:
    """Return the settings that a PNG carries, parsed from JSON.

    Raises
    ------
    PngError
        If the bytes are no PNG, or carry no settings, or settings that are not JSON.
    """
    text = read_text(data)
    if text is None:
        raise PngError(f"the picture carries no settings (no text chunk named {KEYWORD})")
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        raise PngError(f"the picture's settings are not JSON: {error}") from None


def read_text(data: bytes, keyword: str = KEYWORD) -> str | None:
    """Return the text that a PNG carries under a keyword, or None.

    Raises
    ------
    PngError
        If the bytes are no PNG, or the text can't be decompressed or is larger than 16 MB.
    """
    for name, start, end in _chunks(data):
        if name not in TEXT_CHUNKS:
            continue
        found, _, rest = data[start:end].partition(b"\0")
        if found.decode("latin-1") == keyword:
            return _decoded(name, rest)
    return None


def _chunks(data: bytes) -> Iterator[tuple[bytes, int, int]]:
    """Yield each chunk's name and where its data start and end, IEND last."""
    if data[: len(SIGNATURE)] != SIGNATURE:
        raise PngError("not a PNG picture")
    place = len(SIGNATURE)
    while True:
        if place + 12 > len(data):
            raise PngError("the PNG picture is cut off: it has no IEND chunk")
        (size,) = struct.unpack_from(">I", data, place)
        name, start, end = data[place + 4 : place + 8], place + 8, place + 8 + size
        if end + 4 > len(data):
            raise PngError(f"the PNG picture is cut off inside the chunk at byte {place}")
        yield name, start, end
        if name == IEND:
            return
        place = end + 4


def _decoded(name: bytes, rest: bytes) -> str:
    if name == b"tEXt":
        return rest.decode("latin-1")
    if name == b"zTXt":
        return _inflated(rest[1:]).decode("latin-1")
    compressed = rest[:1] == b"\1"
    text = rest[2:].split(b"\0", 2)[-1]
    try:
        return (_inflated(text) if compressed else text).decode()
    except UnicodeDecodeError:
        raise PngError("the picture's settings are not UTF-8 text") from None


def _inflated(data: bytes) -> bytes:
    inflater = zlib.decompressobj()
    try:
        text = inflater.decompress(data, LARGEST_TEXT)
    except zlib.error as error:
        raise PngError(f"the picture's settings can't be decompressed: {error}") from None
    if inflater.unconsumed_tail:
        raise PngError(f"the picture's settings are larger than {LARGEST_TEXT} bytes")
    return text
