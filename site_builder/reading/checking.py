"""What a document's JSON Schema has against it, in words for whoever wrote the document."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from jsonschema import Draft202012Validator
from jsonschema.exceptions import ValidationError
from jsonschema.validators import extend

from .documents import Document, FieldPath


@cache
def schema(name: str) -> dict[str, Any]:
    """The JSON Schema of a document: "source" or "catalogue"."""
    text = (Path(__file__).parent / "schemas" / f"{name}.schema.json").read_text("utf-8")
    return dict(json.loads(text))


def matches(pattern: str, text: str) -> bool:
    """Whether a pattern of the schemas holds: as in ECMAScript, `$` is the very end, not before a last line break."""
    return re.search(re.sub(r"\$$", r"\\Z", pattern), text) is not None


def _pattern(_: Any, pattern: str, instance: Any, __: Any) -> Iterator[ValidationError]:
    if isinstance(instance, str) and not matches(pattern, instance):
        yield ValidationError(f"{instance!r} does not match {pattern!r}")


_Validator = extend(Draft202012Validator, {"pattern": _pattern})  # type: ignore[no-untyped-call]


@dataclass(frozen=True)
class _Objection:
    """What a schema has against one field.

    Parameters
    ----------
    path : tuple of str and int
        The field.
    keyword : str
        The schema's keyword that does not hold: "type", "required", ...
    wanted : object
        What the keyword asks for.
    found : object
        The field's value.
    schema : mapping
        The part of the schema that is about this field.
    message : str
        The validator's own words.
    """

    path: FieldPath
    keyword: str
    wanted: Any
    found: Any
    schema: Mapping[str, Any]
    message: str

    @classmethod
    def of(cls, error: ValidationError) -> _Objection:
        """Take over what the validator found."""
        inside: Mapping[str, Any] = error.schema if isinstance(error.schema, Mapping) else {}
        path = tuple(error.absolute_path)
        return cls(path, str(error.validator), error.validator_value, error.instance, inside, error.message)

    @property
    def unknown(self) -> list[str]:
        """Fields of a mapping that its schema doesn't name."""
        return [name for name in self.found if name not in self.schema.get("properties", {})]


def schema_problems(document: Document, kind: str) -> Iterator[tuple[FieldPath, str]]:
    """What a document's schema has against it, in the order of the file: field and message."""
    errors = _Validator(schema(kind)).iter_errors(document.data)
    objections = [_Objection.of(_deepest(error)) for error in errors]
    rows = [(_place(one), _explain(one)) for one in objections]
    yield from sorted(rows, key=lambda row: document.line(row[0]))


def _place(one: _Objection) -> FieldPath:
    """The field that is wrong; where a mapping has unknown ones, the first of these."""
    return (*one.path, one.unknown[0]) if one.keyword == "additionalProperties" else one.path


def _deepest(error: ValidationError) -> ValidationError:
    """The error that tells most, where several forms were allowed: one about a field inside."""
    if error.validator in ("anyOf", "oneOf"):
        inside = [one for one in error.context or () if len(one.absolute_path) > len(error.absolute_path)]
        if inside:
            return _deepest(inside[0])
    return error


def _explain(one: _Objection) -> str:
    found = json.dumps(one.found, ensure_ascii=False, default=str)
    found = found if len(found) <= 80 else found[:77] + "..."
    wanted = one.wanted
    match one.keyword:
        case "type":
            words = {"string": "text", "object": "a mapping", "array": "a list", "integer": "a whole number"}
            hint = "; put it in quotes" if wanted == "string" and isinstance(one.found, int) else ""
            return f"found {found}, expected {words.get(str(wanted), str(wanted))}{hint}"
        case "required":
            missing = [name for name in wanted if name not in one.found]
            return f"missing: {', '.join(missing)}"
        case "additionalProperties":
            known = one.schema.get("properties", {})
            return f"unknown: {', '.join(map(str, one.unknown))}; known are {', '.join(known)}"
        case "pattern":
            return f"found {found}, expected {_PATTERNS.get(wanted, 'the form ' + str(wanted))}"
        case "enum":
            return f"found {found}, expected one of {', '.join(map(str, wanted))}"
        case "oneOf" if "required" in str(wanted):
            keys = [option["required"][0] for option in wanted if "required" in option]
            return f"found {found}, expected exactly one of {', '.join(keys)}" if keys else one.message
        case "anyOf" if "description" in one.schema:
            return f"found {found}, expected {one.schema['description']}"
        case "minLength" | "minItems":
            return f"found {found}, expected at least {wanted} {_unit(one)}"
        case "maxLength" | "maxItems":
            return f"found {len(one.found)} {_unit(one)}, expected at most {wanted}"
        case "minimum" | "maximum":
            return f"found {found}, expected at {'least' if one.keyword == 'minimum' else 'most'} {wanted}"
    return f"found {found}: {one.message}"


def _unit(one: _Objection) -> str:
    single = one.wanted == 1
    if one.keyword.endswith("Length"):
        return "character" if single else "characters"
    return "entry" if single else "entries"


_PATTERNS = {
    schema("source")["$defs"]["address"]["pattern"]: "an address that starts with https:// or http://",
    schema("source")["$defs"]["line"]["pattern"]: "one line of text",
    schema("source")["properties"]["base_url"]["pattern"]: "an address that ends in a slash",
    schema("source")["$defs"]["mesh"]["properties"]["sha256"][
        "pattern"
    ]: "64 hexadecimal digits in lower case",
    schema("source")["$defs"]["mesh"]["properties"]["slug"]["pattern"]: "lower-case letters, digits, hyphens",
    schema("source")["$defs"]["reference"]["properties"]["DOI"][
        "pattern"
    ]: "a bare DOI like 10.1111/cgf.13617",
    schema("source")["$defs"]["reference"]["properties"]["arXiv"]["pattern"]: "an arXiv id like 1901.00238",
}
