"""Questions in, packed answers out: what every transport between a viewer and a session speaks.

A question is a method of `Session` with its arguments as JSON; where an argument is a block of bytes, such as a file,
the JSON holds ``{"$bytes": n}`` and the block comes beside it. The answer, packed as `hexalab.packing` says, is
``{"result": ...}`` or ``{"error": {"kind", "message"}}``.

>>> door = Door()
>>> answer = door.answer("open", '["cube.mesh", {"$bytes": 0}]', [data]).joined()          # doctest: +SKIP
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from ..errors import HexaLabError
from ..packing import Packed, lay_out
from . import Session

METHODS = (
    "open",
    "open_offered",
    "describe",
    "check",
    "update",
    "save_cells",
    "report",
    "report_poses",
    "quality",
    "histogram",
    "worst",
    "values",
    "group_table",
    "interfaces",
    "validity",
    "numbers",
    "find",
    "cell_list",
    "inspect",
    "value",
    "measure_sizes",
    "cell_view",
    "cut_to",
    "neighbour",
    "finding_cells",
    "trace",
    "structure_facts",
    "structure_table",
    "structure_csv",
    "sheet_pairs",
    "structure_box",
    "fingerprint",
    "hand_over",
    "compare_with",
    "compare_with_offered",
    "compare_with_surface",
    "stop_comparing",
    "measure_distance",
    "distance_facts",
    "distance_csv",
    "metric_changes",
)
"""What may be asked; nothing else of a session can be reached from outside."""

NO_MEMORY = "there is not enough memory for that"

Block = bytes | bytearray | memoryview


class Door:
    """A session that is asked from outside.

    Parameters
    ----------
    session : Session, optional
        A fresh one by default.
    """

    def __init__(self, session: Session | None = None) -> None:
        self._session = session or Session()

    def answer(self, method: str, arguments: str = "[]", blocks: Sequence[Block] = ()) -> Packed:
        """Answer one question; whatever goes wrong is told in the answer.

        Parameters
        ----------
        method : str
            One of `METHODS`.
        arguments : str
            A JSON array.
        blocks : sequence of bytes
            What the arguments refer to.
        """
        try:
            if method not in METHODS:
                raise HexaLabError(f"nothing can be asked by the name of {method}")
            result = getattr(self._session, method)(*_arguments(arguments, blocks))
            return lay_out({"result": result})
        except MemoryError:
            return lay_out({"error": {"kind": "MemoryError", "message": NO_MEMORY}})
        except Exception as error:
            return lay_out({"error": {"kind": type(error).__name__, "message": str(error)}})


def _arguments(text: str, blocks: Sequence[Block]) -> list[Any]:
    def filled(part: dict[str, Any]) -> Any:
        return blocks[part["$bytes"]] if part.keys() == {"$bytes"} else part

    found: list[Any] = json.loads(text, object_hook=filled)
    return found
