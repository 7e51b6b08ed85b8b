"""Checks a settings document against its schema: what is right is kept, what is wrong is named.

It knows the keywords that `schema.SCHEMA` uses and no others, because the core depends on numpy alone; the
tests hold it against the jsonschema library.
"""

from __future__ import annotations

import json
import math
import re
from dataclasses import dataclass
from typing import Any

from .schema import SCHEMA, default_of
from .words import expected_of
from .words_of_schema import Schema

FOUND_LENGTH = 60


class _Wrong:
    """Marks a value that is not to be applied."""


WRONG = _Wrong()


@dataclass(frozen=True)
class Rejection:
    """A value of a document that can't be applied.

    Parameters
    ----------
    path : str
        Where it stands, such as ``filters.planes.items[0].offset``.
    found : str
        What stands there, as JSON, shortened.
    expected : str
        What may stand there, in words.
    """

    path: str
    found: str
    expected: str

    def as_dict(self) -> dict[str, str]:
        """Return the fields as a dict, for JSON."""
        return {"path": self.path, "found": self.found, "expected": self.expected}

    def __str__(self) -> str:
        place = f"{self.path}: " if self.path else ""
        return f"{place}found {self.found}, expected {self.expected}"


def check(document: Any) -> tuple[dict[str, Any], list[Rejection]]:
    """Part a document into what can be applied and what can't.

    Parameters
    ----------
    document : object
        A settings document or a part of one, as parsed from JSON.

    Returns
    -------
    clean : dict
        What of it fits the schema. Missing properties stay missing, except in the items of lists, which are
        completed by their defaults (a list replaces a list).
    rejections : list of Rejection
        Each value that was left out.
    """
    rejections: list[Rejection] = []
    clean = _checked(document, SCHEMA, "", rejections)
    return ({} if isinstance(clean, _Wrong) else clean), rejections


def _checked(value: Any, schema: Schema, path: str, rejections: list[Rejection]) -> Any:
    if not _fits(value, schema):
        rejections.append(Rejection(path, quoted(value), expected_of(schema)))
        return WRONG
    if isinstance(value, dict):
        return _checked_object(value, schema, path, rejections)
    if isinstance(value, list):
        return _checked_list(value, schema, path, rejections)
    if schema.get("type") == "integer":
        return int(value)
    return value


def _checked_object(value: dict[str, Any], schema: Schema, path: str, rejections: list[Rejection]) -> Any:
    properties = schema["properties"]
    clean = {}
    for name, part in value.items():
        place = f"{path}.{name}" if path else str(name)
        if name not in properties:
            rejections.append(Rejection(place, quoted(part), f"one of {', '.join(properties)}"))
            continue
        checked = _checked(part, properties[name], place, rejections)
        if not isinstance(checked, _Wrong):
            clean[name] = checked
    for name in schema.get("required", ()):
        if name in clean:
            continue
        if name not in value:
            place = f"{path}.{name}" if path else name
            rejections.append(Rejection(place, "nothing", expected_of(properties[name])))
        return WRONG
    return clean


def _checked_list(value: list[Any], schema: Schema, path: str, rejections: list[Rejection]) -> Any:
    items = schema["items"]
    if items.get("type") == "integer" and _are_sound_integers(value, items["minimum"]):
        return value
    checked = [_checked(part, items, f"{path}[{place}]", rejections) for place, part in enumerate(value)]
    if items.get("type") == "object":
        return [{**default_of(items), **part} for part in checked if not isinstance(part, _Wrong)]
    right = [part for part in checked if not isinstance(part, _Wrong)]
    whole = len(right) == len(value)
    return right if whole or schema.get("minItems") is None else WRONG


def _are_sound_integers(values: list[Any], minimum: int) -> bool:
    """Whether a list is right as a whole: thousands of cells may be picked, and a slider waits for the answer."""
    return set(map(type, values)) <= {int} and min(values, default=minimum) >= minimum


def _fits(value: Any, schema: Schema) -> bool:
    """Whether a value is right by itself, its parts apart."""
    if "const" in schema:
        return same(value, schema["const"])
    if "enum" in schema:
        return any(same(value, word) for word in schema["enum"])
    types = schema["type"]
    if not any(_is(value, name) for name in ([types] if isinstance(types, str) else types)):
        return False
    if isinstance(value, str):
        return (
            schema.get("minLength", 0) <= len(value) <= schema.get("maxLength", math.inf)
            and re.search(schema.get("pattern", ""), value) is not None
        )
    if isinstance(value, list):
        return _fits_list(value, schema)
    if isinstance(value, int | float) and not isinstance(value, bool):
        low, above, high = (schema.get(key) for key in ("minimum", "exclusiveMinimum", "maximum"))
        return (
            (low is None or low <= value)
            and (above is None or above < value)
            and (high is None or value <= high)
        )
    return True


def _fits_list(value: list[Any], schema: Schema) -> bool:
    if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", math.inf):
        return False
    if "contains" not in schema:
        return True
    forbidden = schema["contains"]["not"]["const"]
    return not all(same(part, forbidden) for part in value)


def _is(value: Any, name: str) -> bool:
    if name == "null":
        return value is None
    if name == "boolean":
        return isinstance(value, bool)
    if name == "string":
        return isinstance(value, str)
    if name == "array":
        return isinstance(value, list)
    if name == "object":
        return isinstance(value, dict)
    return _is_finite(value) and (name == "number" or value == int(value))


def _is_finite(value: Any) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:  # a whole number too large for a float
        return False


def same(value: Any, other: Any) -> bool:
    """Whether two JSON scalars are equal; true is not 1."""
    return isinstance(value, bool) == isinstance(other, bool) and bool(value == other)


def quoted(value: Any) -> str:
    """Return a value as short JSON, for a message."""
    try:
        text = json.dumps(value, ensure_ascii=False)
    except (TypeError, ValueError, RecursionError):
        text = type(value).__name__
    return text if len(text) <= FOUND_LENGTH else text[: FOUND_LENGTH - 1] + "…"
