"""The compressors that VTK has for the arrays of a `.vtu` file: what can be inflated here, and what to do where not."""

from __future__ import annotations

import zlib
from collections.abc import Callable

ZLIB = "vtkZLibDataCompressor"
LZMA = "vtkLZMADataCompressor"
LZMA_MEMORY = 128 * 2**20
"""Bytes that inflating may take; the dictionary of LZMA's strongest preset takes 64 MB."""

REMEDY = "save it again with the compressor ZLib or none (in ParaView: Save Data, Compressor Type)"

Inflate = Callable[[bytes, int], bytes]
"""A compressed block, and the most bytes that may come out of it, to its content; raises Damaged."""


class Unreadable(Exception):
    """No block of that compressor can be inflated here; the message says why and what to do."""


class Damaged(Exception):
    """A block is no stream of its compressor."""


def inflater(name: str) -> Inflate:
    """How blocks of the compressor are inflated.

    Raises
    ------
    Unreadable
        It is none that Python has.
    """
    if name in ("", ZLIB):
        return inflate_zlib
    if name != LZMA:
        raise Unreadable(f"only {ZLIB} and {LZMA} can be read: {REMEDY}")
    try:
        import lzma  # noqa: F401  Python in a browser does not have it, nor do some builds
    except ImportError:
        raise Unreadable(
            f"the Python that runs here (as in a browser) has no LZMA: {REMEDY}, or use HexaLab's command line"
        ) from None
    return inflate_lzma


def inflate_zlib(block: bytes, most: int) -> bytes:
    """The content of a zlib stream, up to `most` bytes."""
    try:
        return zlib.decompressobj().decompress(block, most)
    except zlib.error as error:
        raise Damaged(str(error)) from None


def inflate_lzma(block: bytes, most: int) -> bytes:
    """The content of an xz stream, up to `most` bytes."""
    import lzma

    try:
        return lzma.LZMADecompressor(memlimit=LZMA_MEMORY).decompress(block, most)
    except (lzma.LZMAError, EOFError) as error:
        raise Damaged(str(error)) from None
