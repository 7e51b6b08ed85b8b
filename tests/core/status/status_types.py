"""The status document's type in JavaScript, made from the schema.

    PYTHONPATH=core python tests/core/status/status_types.py

writes `static/viewer/state/status.js`, which the viewer is checked with.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from hexalab.status import SCHEMA

FILE = Path(__file__).parents[3] / "static" / "viewer" / "state" / "status.js"

TEXT = """/**
 * The status document: all settings of a view. What each means, its limits and its default say the core's schema
 * (hexalab.status.schema), from which this file is made: renew it with tests/core/status/status_types.py.
 *
 * @typedef {TYPE} Status
 */

/**
 * A part of a document: any of its settings, at any depth. A list is a value, which a part replaces whole.
 *
 * @template T
 * @typedef {T extends readonly unknown[] | null ? T : T extends object ? { [K in keyof T]?: Part<T[K]> } : T} Part
 */

/** @typedef {Part<Status>} PartialStatus */

/**
 * The settings that are one word out of several, by their paths.
 *
 * @typedef {{
CHOICES * }} Choices
 */

export {};
"""

SCALARS = {"number": "number", "integer": "number", "string": "string", "boolean": "boolean", "null": "null"}


def status_types(schema: dict[str, Any] = SCHEMA) -> str:
    """The text of the file."""
    choices = "".join(f' *   "{path}": {kind},\n' for path, kind in _choices(schema))
    return TEXT.replace("TYPE", type_of(schema, " * ")).replace("CHOICES", choices)


def _choices(schema: dict[str, Any], path: str = "", kind: str = "Status") -> Iterator[tuple[str, str]]:
    """The path of each choice, and its type as a part of the whole document's."""
    for name, part in schema["properties"].items():
        place, own = f"{path}.{name}" if path else name, f'{kind}["{name}"]'
        if "enum" in part:
            yield place, own
        elif "properties" in part:
            yield from _choices(part, place, own)


def type_of(schema: dict[str, Any], margin: str = "") -> str:
    """The TypeScript type of the values that a schema admits.

    >>> type_of({"type": ["array", "null"], "items": {"type": "number"}, "minItems": 2, "maxItems": 2})
    'readonly [number, number] | null'

    Parameters
    ----------
    schema : dict
    margin : str
        What every line but the first begins with.
    """
    if "const" in schema:
        return literal(schema["const"])
    if "enum" in schema:
        return " | ".join(map(literal, schema["enum"]))
    types = [schema["type"]] if isinstance(schema["type"], str) else schema["type"]
    return " | ".join(_named(name, schema, margin) for name in types)


def literal(value: Any) -> str:
    """A text or a number as a type."""
    return f'"{value}"' if isinstance(value, str) else str(value)


def _named(name: str, schema: dict[str, Any], margin: str) -> str:
    if name == "object":
        inner = margin + "  "
        rows = [
            f"{inner}readonly {key}: {type_of(part, inner)},\n" for key, part in schema["properties"].items()
        ]
        return "{\n" + "".join(rows) + margin + "}"
    if name == "array":
        item = type_of(schema["items"], margin)
        least, most = schema.get("minItems"), schema.get("maxItems")
        if least is not None and least == most:
            return f"readonly [{', '.join([item] * least)}]"
        return f"readonly {item}[]" if "|" not in item or "{" in item else f"readonly ({item})[]"
    return SCALARS[name]


if __name__ == "__main__":
    FILE.write_text(status_types())
