"""What stands around a mesh file's own bytes: gzip is undone within bounds, other wrappings are named."""

from __future__ import annotations

import re
import zlib
from dataclasses import replace

from .file import File

GZIP = b"\x1f\x8b"
LARGEST = 2 * 2**30
"""No more bytes than this come out of a compressed file."""

RATIO = 200
"""Nor more than so many times its own size, above `ALWAYS_FINE`; text of meshes shrinks 3 to 30 times."""

ALWAYS_FINE = 64 * 2**20
STEP = 4 * 2**20

CONTENT = re.compile(rb"[^\0\s]")

NO_MESHES = (
    (b"\x89PNG\r\n", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"GIF8", "a GIF picture"),
    (b"%PDF", "a PDF document"),
    (b"PK\x03\x04", "a zip archive; unpack it, or open it as a batch"),
    (b"PK\x05\x06", "an empty zip archive"),
    (b"\x89HDF\r\n", "an HDF5 file"),
    (b"CDF\x01", "a netCDF file"),
    (b"CDF\x02", "a netCDF file"),
    (b"7z\xbc\xaf", "a 7-Zip archive"),
    (b"\xfd7zXZ", "an xz archive"),
    (b"BZh", "a bzip2 archive"),
    (b"\x28\xb5\x2f\xfd", "a Zstandard archive"),
    (b"\x7fELF", "a program"),
    (b"OVMB", "OpenVolumeMesh's binary .ovmb; only the ASCII form .ovm can be read"),
    (b"\xff\xfe", "text in UTF-16, expected ASCII or UTF-8"),
    (b"\xfe\xff", "text in UTF-16, expected ASCII or UTF-8"),
)
"""First bytes of files that are no meshes, and what they are."""


def unwrapped(file: File) -> File:
    """The file itself, inflated if it is gzipped.

    Raises
    ------
    MeshReadError
        Empty, a broken or oversized gzip stream, or a known kind of file that is no mesh.
    """
    if file.data.startswith(GZIP):
        file = replace(file, data=inflated(file))
    if not CONTENT.search(file.data):
        raise file.error("the file is empty, expected a mesh")
    for magic, what in NO_MESHES:
        if file.data.startswith(magic):
            raise file.error(f"the file is {what}, expected a mesh")
    if file.data.startswith(GZIP):
        raise file.error("the file is gzipped twice, expected a mesh in it")
    return file


def inflation_bound(size: int) -> int:
    """How many bytes may come out of so many compressed ones."""
    return min(LARGEST, max(ALWAYS_FINE, RATIO * size))


def inflated(file: File) -> bytes:
    """The content of a gzip stream of one or more members, bounded."""
    data = file.data
    bound = inflation_bound(len(data))
    out: list[bytes] = []
    size = position = 0
    while position < len(data):
        stream = zlib.decompressobj(wbits=31)
        feed = data[position:] if position else data
        while not stream.eof:
            try:
                part = stream.decompress(feed, STEP)
            except zlib.error as error:
                if position and not feed.startswith(GZIP):
                    return b"".join(out)
                raise file.error(f"the gzip stream is damaged ({error})", offset=position) from None
            feed = stream.unconsumed_tail
            size += len(part)
            out.append(part)
            if size > bound:
                raise file.error(
                    f"the gzip stream of {len(data)} bytes inflates to more than {bound // 2**20} MB: refused"
                )
            if not part and not feed and not stream.eof:
                raise file.error("the gzip stream is cut short", offset=len(data))
        position = len(data) - len(stream.unused_data)
    return b"".join(out)
