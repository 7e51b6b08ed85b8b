"""What a piece of work costs, counted and not timed: the same on a fast machine, a slow one, and under load."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

import hexalab

CORE = str(Path(hexalab.__file__).parent)


def lines_of_core(work: Callable[[], Any]) -> tuple[int, Any]:
    """How many of the core's lines `work` runs, and what it returns.

    What numpy does inside of a line costs nothing: a loop over 100,000 cells runs as many lines at least, an
    operation on their array runs one.
    """
    count = 0

    def line(frame: FrameType, event: str, value: Any) -> Any:
        nonlocal count
        count += event == "line"
        return line

    def enter(frame: FrameType, event: str, value: Any) -> Any:
        return line if frame.f_code.co_filename.startswith(CORE) else None

    before = sys.gettrace()
    sys.settrace(enter)
    try:
        answer = work()
    finally:
        sys.settrace(before)
    return count, answer
