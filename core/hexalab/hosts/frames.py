"""A question as the body of a request: four bytes with the length of what follows, JSON, then the blocks of bytes.

The JSON is ``{"id", "method", "text", "sizes"}``: the question's number, what is asked, its arguments as JSON, and the
bytes of each block that they refer to (`hexalab.session.door`).
"""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass

from ..errors import HexaLabError

LENGTH = struct.Struct("<I")


@dataclass(frozen=True)
class Question:
    """A question for a `Door`; `id` is the page's number for it."""

    id: int
    method: str
    text: str
    blocks: list[memoryview]


def read_question(body: bytes | bytearray | memoryview) -> Question:
    """Take a question apart; its blocks are views of the body.

    Raises
    ------
    HexaLabError
        If the bytes are none.
    """
    view = memoryview(body)
    try:
        (length,) = LENGTH.unpack_from(view)
        head = json.loads(bytes(view[LENGTH.size : LENGTH.size + length]))
        number, method, text, sizes = head["id"], head["method"], head["text"], head["sizes"]
        if not (isinstance(number, int) and isinstance(method, str) and isinstance(text, str)):
            raise TypeError("a part of another kind")
        blocks, at = [], LENGTH.size + length
        for size in sizes:
            if not isinstance(size, int) or size < 0 or at + size > len(view):
                raise ValueError("a block that is not there")
            blocks.append(view[at : at + size])
            at += size
    except (struct.error, ValueError, KeyError, TypeError) as error:
        raise HexaLabError(f"the question can't be read: {error}") from None
    return Question(number, method, text, blocks)
