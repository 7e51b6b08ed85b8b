"""What all tests of the command line share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from hexalab import cli


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """Run the command line in this process: its exit code, stdout and stderr."""

    def call(*words: Any) -> tuple[int, str, str]:
        code = cli.main([str(word) for word in words])
        out, err = capsys.readouterr()
        return code, out, err

    return call
