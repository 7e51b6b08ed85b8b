"""True is no 1 and 1 is no true, wherever a document may hold one of a few values."""

from __future__ import annotations

from typing import Any

import pytest

from hexalab import status
from tests.core.status.validator import validator


@pytest.mark.parametrize(
    ("document", "right"),
    [
        ({"version": status.DEFAULTS["version"]}, True),
        ({"version": float(status.DEFAULTS["version"])}, True),
        ({"version": True}, False),
        ({"version": str(status.DEFAULTS["version"])}, False),
        ({"filters": {"planes": {"enabled": True}}}, True),
        ({"filters": {"planes": {"enabled": 1}}}, False),
    ],
)
def test_S1_true_is_not_one(document: dict[str, Any], right: bool) -> None:
    assert validator().is_valid(document) == right
    clean, problems = status.check(document)
    assert bool(problems) != right
    assert (clean == document) == right
