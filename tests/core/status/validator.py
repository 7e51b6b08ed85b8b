"""The jsonschema library's checker of the settings document: what ours is held against."""

from __future__ import annotations

from functools import cache
from typing import Any

from hexalab import status
from tests.tools import tool

jsonschema = tool("jsonschema")


@cache
def validator() -> Any:
    """Made at first use: a test that gets here is left out where the library is not installed."""
    return jsonschema.Draft202012Validator(status.SCHEMA)
