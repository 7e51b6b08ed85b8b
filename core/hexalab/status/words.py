"""Says in words what a schema expects, for the messages."""

from __future__ import annotations

from typing import Any

from .words_of_schema import COLOUR, Schema

KIND_WORDS = {
    "null": "null",
    "boolean": "true or false",
    "string": "a text",
    "object": "an object of settings",
}


def expected_of(schema: Schema) -> str:
    """Return what may stand where this schema applies, such as "a number from 0 to 1"."""
    if "const" in schema:
        return _plain(schema["const"])
    if "enum" in schema:
        return "one of " + ", ".join(_plain(word) for word in schema["enum"])
    types = schema["type"]
    return " or ".join(_of_type(name, schema) for name in ([types] if isinstance(types, str) else types))


def _of_type(name: str, schema: Schema) -> str:
    if name == "array":
        return _list_words(schema)
    if name in ("number", "integer"):
        return ("a number" if name == "number" else "a whole number") + _limit_words(schema)
    if name == "string" and "pattern" in schema:
        is_colour = schema["pattern"] == COLOUR["pattern"]
        return "a colour such as #ffff00" if is_colour else "64 hexadecimal digits"
    if name == "string" and schema.get("minLength"):
        return "a text that is not empty"
    return KIND_WORDS[name]


def _limit_words(schema: Schema) -> str:
    low, above, high = (schema.get(key) for key in ("minimum", "exclusiveMinimum", "maximum"))
    if low is not None:
        return f" from {_plain(low)} up" if high is None else f" from {_plain(low)} to {_plain(high)}"
    if above is not None:
        return f" above {_plain(above)}" + ("" if high is None else f" and up to {_plain(high)}")
    return ""


def _list_words(schema: Schema) -> str:
    low, high = schema.get("minItems"), schema.get("maxItems")
    each = schema["items"]
    names = {
        "number": "numbers",
        "integer": "whole numbers from 0 on",
        "object": "objects",
        "string": "texts",
    }
    what = names[each["type"]]
    count = f"{low} " if low is not None and low == high else ""
    most = f", {high} at most" if high is not None and low is None else ""
    nonzero = ", not all 0" if "contains" in schema else ""
    return f"a list of {count}{what}{most}{nonzero}"


def _plain(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)
