"""The settings document (SPEC S1, S2, S4): schema, defaults, checks, migration, the original's documents."""

from __future__ import annotations

import json
from typing import Any

from ..errors import HexaLabError
from .check import Rejection, check, quoted, same
from .original import OpenMesh, from_original, is_original
from .schema import CORE_PATHS, DEFAULTS, LENGTH_UNITS, SCHEMA, VERSION, core_part

__all__ = [
    "CORE_PATHS",
    "DEFAULTS",
    "LENGTH_UNITS",
    "SCHEMA",
    "VERSION",
    "OpenMesh",
    "Rejection",
    "check",
    "core_part",
    "from_original",
    "is_original",
    "merge",
    "migrate",
    "parse",
    "read",
]


def merge(status: dict[str, Any], partial: dict[str, Any]) -> dict[str, Any]:
    """Return a status in which a checked part replaces what it holds; a list replaces a list.

    Nothing is copied that is not changed, and lists not at all: neither document is to be changed afterwards.
    """
    merged = dict(status)
    for name, part in partial.items():
        old = merged.get(name)
        if isinstance(old, dict) and isinstance(part, dict):
            merged[name] = merge(old, part)
        else:
            merged[name] = part
    return merged


def migrate(document: Any) -> tuple[Any, list[Rejection]]:
    """Bring a document of another version to the present one, as far as it is understood.

    One that says no version is taken for the oldest that it can be of. One that says it is newer is read as if
    it were of this version, and that is told.
    """
    if not isinstance(document, dict):
        return document, []
    version = document.get("version", 1)
    for older, step in STEPS.items():
        if same(version, older):
            document, version = step(document), older + 1
    if "version" in document and not same(document["version"], VERSION):
        known = {**document, "version": VERSION}
        words = f"{VERSION}; what is known of it applies"
        return known, [Rejection("version", quoted(document["version"]), words)]
    return document, []


def _from_version_1(document: dict[str, Any]) -> dict[str, Any]:
    """What a quality band looks at was called its source."""
    document = {**document, "version": 2} if "version" in document else document
    quality = _at(document, "filters", "quality")
    items = quality.get("items") if quality else None
    if not quality or not isinstance(items, list):
        return document
    bands = [
        {**{name: part for name, part in band.items() if name != "source"}, "quantity": band["source"]}
        if isinstance(band, dict) and "source" in band and "quantity" not in band
        else band
        for band in items
    ]
    return {**document, "filters": {**document["filters"], "quality": {**quality, "items": bands}}}


def _at(document: dict[str, Any], *names: str) -> dict[str, Any] | None:
    """The object that stands at a path; None if something else stands there."""
    part: Any = document
    for name in names:
        part = part.get(name) if isinstance(part, dict) else None
    return part if isinstance(part, dict) else None


STEPS = {1: _from_version_1}
"""From each older version to the next."""


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


def read(document: Any, mesh: OpenMesh | None = None) -> tuple[dict[str, Any], list[Rejection]]:
    """Read any settings document, whole or partial, ours or the original's.

    Returns
    -------
    partial : dict
        What of it applies, in the present version.
    rejections : list of Rejection
        What of it does not.
    """
    if is_original(document):
        partial, rejections = from_original(document, mesh)
        return placed(partial), rejections
    document, rejections = migrate(document)
    clean, wrong = check(document)
    return placed(clean), rejections + wrong


def placed(partial: dict[str, Any]) -> dict[str, Any]:
    """A part of a document in which a camera that says where it stands is not fitted, unless it says that too."""
    camera = partial.get("camera", {})
    if "fit" in camera or not {"target", "distance"} & set(camera):
        return partial
    return {**partial, "camera": {"fit": False, **camera}}
