"""What a document's JSON Schema has against it, in words for whoever wrote the document."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
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


_Validator = extend(Draft202012Validator, {"pattern": _pattern})


def schema_problems(document: Document, kind: str) -> Iterator[tuple[FieldPath, str]]:
    """What a document's schema has against it, in the order of the file: field and message."""
    errors = [_deepest(error) for error in _Validator(schema(kind)).iter_errors(document.data)]
    rows = [(_place(error), _explain(error)) for error in errors]
    yield from sorted(rows, key=lambda row: document.line(row[0]))


def _place(error: ValidationError) -> FieldPath:
    """The field that is wrong; where a mapping has unknown ones, the first of these."""
    path = tuple(error.absolute_path)
    return (*path, _unknown(error)[0]) if error.validator == "additionalProperties" else path


def _unknown(error: ValidationError) -> list[str]:
    return [name for name in error.instance if name not in error.schema.get("properties", {})]


def _deepest(error: ValidationError) -> ValidationError:
    """The error that tells most, where several forms were allowed: one about a field inside."""
    if error.validator in ("anyOf", "oneOf"):
        inside = [one for one in error.context or () if len(one.absolute_path) > len(error.absolute_path)]
        if inside:
            return _deepest(inside[0])
    return error


def _explain(error: ValidationError) -> str:
    found = json.dumps(error.instance, ensure_ascii=False, default=str)
    found = found if len(found) <= 80 else found[:77] + "..."
    wanted = error.validator_value
    match error.validator:
        case "type":
            words = {"string": "text", "object": "a mapping", "array": "a list", "integer": "a whole number"}
            hint = "; put it in quotes" if wanted == "string" and isinstance(error.instance, int) else ""
            return f"found {found}, expected {words.get(str(wanted), str(wanted))}{hint}"
        case "required":
            missing = [name for name in wanted if name not in error.instance]
            return f"missing: {', '.join(missing)}"
        case "additionalProperties":
            known = error.schema.get("properties", {})
            return f"unknown: {', '.join(map(str, _unknown(error)))}; known are {', '.join(known)}"
        case "pattern":
            return f"found {found}, expected {_PATTERNS.get(wanted, 'the form ' + str(wanted))}"
        case "enum":
            return f"found {found}, expected one of {', '.join(map(str, wanted))}"
        case "oneOf" if "required" in str(wanted):
            keys = [option["required"][0] for option in wanted if "required" in option]
            return f"found {found}, expected exactly one of {', '.join(keys)}" if keys else error.message
        case "anyOf" if "description" in error.schema:
            return f"found {found}, expected {error.schema['description']}"
        case "minLength" | "minItems":
            return f"found {found}, expected at least {wanted} {_unit(error)}"
        case "maxLength" | "maxItems":
            return f"found {len(error.instance)} {_unit(error)}, expected at most {wanted}"
        case "minimum" | "maximum":
            return (
                f"found {found}, expected at {'least' if error.validator == 'minimum' else 'most'} {wanted}"
            )
    return f"found {found}: {error.message}"


def _unit(error: ValidationError) -> str:
    one = error.validator_value == 1
    if str(error.validator).endswith("Length"):
        return "character" if one else "characters"
    return "entry" if one else "entries"


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
