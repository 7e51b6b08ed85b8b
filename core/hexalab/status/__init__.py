"""The settings document (SPEC S1, S2, S4): schema, defaults, checks, migration, the original's documents."""

from __future__ import annotations

import json
from typing import Any

from ..errors import HexaLabError
from .check import Problem, check, shown
from .original import OpenMesh, from_original, is_original
from .schema import DEFAULTS, SCHEMA, VERSION, copied

__all__ = [
    "DEFAULTS",
    "SCHEMA",
    "VERSION",
    "OpenMesh",
    "Problem",
    "check",
    "from_original",
    "is_original",
    "merge",
    "migrate",
    "parse",
    "read",
]


def merge(status: dict[str, Any], partial: dict[str, Any]) -> dict[str, Any]:
    """Return a status in which a checked part replaces what it holds; a list replaces a list."""
    merged = dict(status)
    for name, part in partial.items():
        old = merged.get(name)
        if isinstance(old, dict) and isinstance(part, dict):
            merged[name] = merge(old, part)
        else:
            merged[name] = copied(part)
    return merged


def migrate(document: Any) -> tuple[Any, list[Problem]]:
    """Bring a document of another version to the present one, as far as it is understood.

    There is one version so far. A document that says it is newer is read as if it were of this one, and
    that is told.
    """
    if not isinstance(document, dict) or document.get("version", VERSION) == VERSION:
        return document, []
    version = document["version"]
    known = {**document, "version": VERSION}
    return known, [Problem("version", shown(version), f"{VERSION}; what is known of it applies")]


def parse(text: str) -> Any:
    """Parse the text of a settings document.

    Raises
    ------
    HexaLabError
        If it is not JSON; line and column are told.
    """
    try:
        return json.loads(text.removeprefix("\N{BYTE ORDER MARK}"))
    except json.JSONDecodeError as error:
        place = f"line {error.lineno}, column {error.colno}"
        raise HexaLabError(f"the settings are not JSON: {place}: {error.msg}") from None
    except ValueError:
        raise HexaLabError("the settings hold a number of some thousand digits") from None
    except RecursionError:
        raise HexaLabError("the settings are nested too deeply") from None


def read(document: Any, mesh: OpenMesh | None = None) -> tuple[dict[str, Any], list[Problem]]:
    """Read any settings document, whole or partial, ours or the original's.

    Returns
    -------
    partial : dict
        What of it applies, in the present version.
    problems : list of Problem
        What of it does not.
    """
    if is_original(document):
        return from_original(document, mesh)
    document, problems = migrate(document)
    clean, wrong = check(document)
    return clean, problems + wrong
