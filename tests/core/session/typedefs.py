"""Reads the typedefs of a JavaScript file, as far as those of the door's answers go, and holds values against them."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

VIEWER = Path(__file__).parents[3] / "static" / "viewer"

ARRAYS = {
    "Float64Array": "float64",
    "Float32Array": "float32",
    "Int32Array": "int32",
    "Uint32Array": "uint32",
    "Int16Array": "int16",
    "Uint8Array": "uint8",
}

CLOSED = {"(": ")", "[": "]", "{": "}", "<": ">"}
COMMENT = re.compile(r"/\*\*(.*?)\*/", re.DOTALL)
TAG = re.compile(r"@(typedef|property) ")


@dataclass
class Typedef:
    """An alias, or an object with properties.

    Parameters
    ----------
    alias : str
        The type that it is another name of; "object" for one with properties.
    properties : dict of str to str
        Types by name.
    optional : set of str
        Properties that may be missing.
    """

    alias: str
    properties: dict[str, str] = field(default_factory=dict)
    optional: set[str] = field(default_factory=set)


def typedefs(path: str) -> dict[str, Typedef]:
    """Return the typedefs of a file of the viewer by name."""
    found: dict[str, Typedef] = {}
    current = Typedef("")
    for comment in COMMENT.findall((VIEWER / path).read_text()):
        text = re.sub(r"\n\s*\* ?", "\n", comment)
        for tag in TAG.finditer(text):
            length = _length(text[tag.end() :])
            kind = text[tag.end() + 1 : tag.end() + length - 1]
            rest = text[tag.end() + length :].split()
            name = rest[0]
            if tag[1] == "typedef":
                current = found[name] = Typedef(kind)
                continue
            if name.startswith("["):
                name = name.strip("[]")
                current.optional.add(name)
            current.properties[name] = kind
    return found


def parts(text: str, separator: str) -> list[str]:
    """Split at a separator that stands within no bracket.

    >>> parts("[number, null] | null", "|")
    ['[number, null]', 'null']
    """
    out, start, at = [], 0, 0
    while at < len(text):
        if text[at] in CLOSED:
            at += _length(text[at:])
        elif text[at] == separator:
            out.append(text[start:at].strip())
            at += 1
            start = at
        else:
            at += 1
    last = text[start:].strip()
    return [*out, last] if last else out


def _length(text: str) -> int:
    """Characters up to the bracket that closes the first one."""
    depth = 0
    for at, letter in enumerate(text):
        depth += (letter in CLOSED) - (letter in CLOSED.values())
        if not depth:
            return at + 1
    raise AssertionError(f"a bracket stays open in {text[:60]}")


class Shapes:
    """Holds values against types, and keeps which properties it met and missed.

    Parameters
    ----------
    known : dict of str to Typedef
    opaque : iterable of str
        Types that are held against something else elsewhere.
    """

    def __init__(self, known: dict[str, Typedef], opaque: tuple[str, ...] = ()) -> None:
        self.known = known
        self.opaque = {"unknown", *opaque}
        self.met: set[tuple[str, str]] = set()
        self.missed: set[tuple[str, str]] = set()

    def wrong(self, value: Any, kind: str, place: str = "") -> list[str]:
        """Return in words where a value is not of a type; nothing if it is."""
        if kind in self.opaque:
            return []
        options = parts(kind, "|")
        if len(options) > 1:
            wrongs = [self.wrong(value, option, place) for option in options]
            return [] if any(not one for one in wrongs) else min(wrongs, key=len)
        if kind.startswith("(") and kind.endswith(")"):
            return self.wrong(value, kind[1:-1], place)
        if kind in self.known:
            found = self.known[kind]
            if found.alias == "object":
                return self._wrong_object(value, kind, found, place)
            return self.wrong(value, found.alias, place)
        right = self._is_scalar(value, kind)
        if right is None:
            return self._wrong_compound(value, kind, place)
        return [] if right else [f"{place}: found {value!r}, expected {kind}"]

    def _is_scalar(self, value: Any, kind: str) -> bool | None:
        if kind in ARRAYS:
            return isinstance(value, np.ndarray) and value.dtype.name == ARRAYS[kind]
        if kind == "number":
            return isinstance(value, int | float) and not isinstance(value, bool)
        if kind in ("string", "boolean"):
            return isinstance(value, {"string": str, "boolean": bool}[kind])
        if kind == "null":
            return value is None
        return value == kind[1:-1] if kind.startswith('"') else None

    def _wrong_compound(self, value: Any, kind: str, place: str) -> list[str]:
        if kind.endswith("[]") and isinstance(value, list):
            return [
                word for at, one in enumerate(value) for word in self.wrong(one, kind[:-2], f"{place}[{at}]")
            ]
        if kind.startswith("[") and isinstance(value, list):
            kinds = parts(kind[1:-1], ",")
            if len(kinds) == len(value):
                pairs = enumerate(zip(value, kinds, strict=True))
                return [word for at, (one, own) in pairs for word in self.wrong(one, own, f"{place}[{at}]")]
        if kind.startswith("Record<") and isinstance(value, dict):
            own = parts(kind[len("Record<") : -1], ",")[1]
            return [word for name, one in value.items() for word in self.wrong(one, own, f"{place}.{name}")]
        if kind.startswith("{") and isinstance(value, dict):
            rows = dict(part.split(": ", 1) for part in parts(kind[1:-1], ","))
            return self._wrong_object(value, f"{place} {{}}", Typedef("object", rows), place)
        return [f"{place}: found {value!r:.60}, expected {kind}"]

    def _wrong_object(self, value: Any, name: str, found: Typedef, place: str) -> list[str]:
        if not isinstance(value, dict):
            return [f"{place}: found {value!r:.60}, expected {name}"]
        here = place or name
        missing = found.properties.keys() - value.keys()
        words = [f"{here}.{one} is missing" for one in missing - found.optional]
        words += [f"{here}.{one} is in no typedef" for one in value.keys() - found.properties.keys()]
        self.missed |= {(name, one) for one in missing}
        for one in found.properties.keys() & value.keys():
            self.met.add((name, one))
            words += self.wrong(value[one], found.properties[one], f"{here}.{one}")
        return words
