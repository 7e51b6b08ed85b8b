"""What the settings document's schema is written with: kinds of values, and makers of its parts."""

from __future__ import annotations

from typing import Any

Schema = dict[str, Any]

UNIT = {"type": "number", "minimum": 0, "maximum": 1}
COLOUR = {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$", "maxLength": 7}
VECTOR = {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}
DIRECTION = {**VECTOR, "contains": {"not": {"const": 0}}}
OPEN_END = {"type": ["number", "null"], "default": None}
NUMBERS = {"type": "array", "items": {"type": "integer", "minimum": 0}, "default": []}
CELL_IDS = {**NUMBERS, "description": "Cells by number, from 0 in the file's order"}
ON = {"type": "boolean", "default": True}
IDENTITY: dict[str, Schema] = {
    "name": {"type": "string", "default": ""},
    "sha256": {"type": "string", "pattern": "^([0-9a-f]{64})?$", "maxLength": 64, "default": ""},
    "cells": {"type": "integer", "minimum": 0, "default": 0},
}
"""By what a mesh is known again."""
GROUP_IDS = {
    "type": "array",
    "items": {"type": "string", "minLength": 1, "maxLength": 500},
    "maxItems": 1000,
    "default": [],
}


def section(description: str, /, *required: str, **properties: Schema) -> Schema:
    """Build the schema of an object whose properties are these and no others."""
    schema: Schema = {
        "type": "object",
        "description": description,
        "properties": properties,
        "additionalProperties": False,
    }
    return {**schema, "required": list(required)} if required else schema


def core(schema: Schema) -> Schema:
    """Mark a setting that the core acts on; all others concern the viewer alone."""
    return {**schema, "core": True}


def choice(default: str, *others: str, description: str = "") -> Schema:
    """Build the schema of one word out of several; the first is the default."""
    return {"enum": [default, *others], "default": default, "description": description}
