"""The records that the viewer reads are those that the core writes: its typedefs against the dataclasses."""

from __future__ import annotations

import re
import types
import typing
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hexalab.surface import MODES
from hexalab.surface.records import Arrows, Curves, Irregular, Marks, Silhouette, Surface

TYPEDEFS = (Path(__file__).parents[3] / "static/viewer/geometry/records.js").read_text(encoding="utf-8")

ARRAYS = {"float32": "Float32Array", "int16": "Int16Array", "uint8": "Uint8Array", "uint32": "Uint32Array"}
NAMES = {str: "string", bool: "boolean", int: "number", float: "number"}
CHOICES = {("Surface", "mode"): "SeparationMode"}


def typedef(name: str) -> dict[str, str]:
    """Type of each property, in order."""
    found = re.search(rf"@typedef {{object}} {name}\b(.*?)(?=@typedef|\*/)", TYPEDEFS, re.DOTALL)
    assert found, f"no typedef of {name}"
    return {prop: kind for kind, prop in re.findall(r"@property \{(.+)\} (\w+)", found[1])}


def in_javascript(hint: Any) -> str:
    """What JavaScript calls a type of the dataclasses, e.g. `Uint32Array | null` for `NDArray[np.uint32] | None`."""
    arguments = typing.get_args(hint)
    if isinstance(hint, types.UnionType):
        return " | ".join("null" if one is type(None) else in_javascript(one) for one in arguments)
    if typing.get_origin(hint) is np.ndarray:
        return ARRAYS[np.dtype(typing.get_args(arguments[1])[0]).name]
    if typing.get_origin(hint) is dict:
        return f"Record<{', '.join(map(in_javascript, arguments))}>"
    return NAMES[hint]


@pytest.mark.parametrize("record", [Surface, Silhouette, Irregular, Curves, Arrows, Marks])
def test_the_viewer_calls_every_field_by_its_name_and_type(record: type) -> None:
    hints = typing.get_type_hints(record)
    expected = {
        field.name: CHOICES.get((record.__name__, field.name)) or in_javascript(hints[field.name])
        for field in fields(record)
    }
    assert list(typedef(record.__name__).items()) == list(expected.items())


def test_the_viewer_knows_every_way_to_draw_a_surface() -> None:
    found = re.search(r"@typedef \{(.*)\} SeparationMode", TYPEDEFS)
    assert found
    assert re.findall(r'"(\w+)"', found[1]) == list(MODES)
