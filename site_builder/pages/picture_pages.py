"""What the pages of gallery and guide are filled with."""

from __future__ import annotations

import json
import math
import re
import subprocess
from functools import cache
from pathlib import Path
from typing import Any, TypedDict

from markupsafe import Markup, escape

from hexalab.formats import FORMATS, WRITERS
from hexalab.formats.registry import Format
from hexalab.quality import METRICS
from hexalab.quality.metrics import Metric

from ..pictures.collection import Collection
from .words import NOT_KNOWN

ROOT = Path(__file__).resolve().parents[2]

KEYS_SCRIPT = """
import { KEYS, OTHER_KEYS } from "./static/viewer/input/keys.js";
console.log(JSON.stringify([...KEYS, ...OTHER_KEYS].map(({ group, keys, what }) => ({ group, keys, what }))));
"""

CHAPTERS = (
    ("window", "The window"), ("view", "The view of the next mesh"), ("slice", "Slice"), ("peel", "Peel"),
    ("quality", "Quality filter"),
    ("picking", "Picking by hand"), ("regularise", "Regularise"), ("separation", "Separation"), ("colour", "Colour"),
    ("silhouette", "Silhouette"), ("see-through", "See through"), ("irregular", "Irregular edges"),
    ("structure", "Structure"), ("lighting", "Light"), ("histogram", "Histogram and statistics"),
    ("diagnosis", "Diagnosis"), ("inspector", "One cell"),
    ("compare", "Compare"), ("units", "Units"),
    ("sharing", "Settings and sharing"), ("saving", "Saving the mesh"), ("ways", "Four ways to use it"),
    ("offline", "Without a network"), ("keyboard", "Keyboard"),
    ("formats", "Formats"), ("metrics", "What the metrics mean"),
)  # fmt: skip
"""The guide's sections by their anchors."""

UNITS = {0: "none", 1: "length", 2: "length²", 3: "length³"}
"""What a metric's values are measured in, by the power of a length."""

NAMES_OF_KEYS = {"PageUp": "Page up", "PageDown": "Page down", "Escape": "Esc"}


class KeyRow(TypedDict):
    """A key of the viewer: the caps to press together, and what it does."""

    caps: list[str]
    what: str


class MetricRow(TypedDict):
    """A metric as the guide's table shows it: all in words but the formula, which is HTML."""

    name: str
    symbol: str
    variant: str
    full: str
    acceptable: str
    cube: str
    better: str
    unit: str
    formula: Markup


class FormatRow(TypedDict):
    """A file format as the guide's table shows it."""

    name: str
    extensions: str
    writes: str


def gallery_values(collection: Collection) -> dict[str, Any]:
    """Values of the gallery's template."""
    return {
        "heading": "Gallery",
        "description": "Each way to separate cells and each light, side by side, made by the program itself.",
        "sections": collection.gallery,
    }


def guide_values(collection: Collection) -> dict[str, Any]:
    """Values of the guide's template."""
    return {
        "heading": "Guide",
        "description": "Every tool of the viewer in a few sentences, with a picture; every metric with its ranges.",
        "chapters": CHAPTERS,
        "figures": collection.guide,
        "metric_rows": [_metric_row(metric) for metric in METRICS.values()],
        "format_rows": [_format_row(one) for one in FORMATS],
        "key_groups": key_groups(),
    }


@cache
def key_groups() -> dict[str, list[KeyRow]]:
    """The viewer's keys by group, out of the table that the viewer itself obeys; empty where Node is missing."""
    command = ["node", "--input-type=module", "--eval", KEYS_SCRIPT]
    try:
        done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=True)
    except (OSError, subprocess.CalledProcessError):
        return {}
    groups: dict[str, list[KeyRow]] = {}
    for row in json.loads(done.stdout):
        groups.setdefault(row["group"], []).append({"caps": _caps(row["keys"][0]), "what": row["what"]})
    return groups


def _caps(key: str) -> list[str]:
    """The caps to press for a key of the table: "Ctrl+Shift+z" is Ctrl, Shift and Z."""
    parts = [key] if key == "+" else key.split("+")
    return [part.upper() if len(part) == 1 else NAMES_OF_KEYS.get(part, part) for part in parts]


def _metric_row(metric: Metric) -> MetricRow:
    cube = NOT_KNOWN if metric.unit_cube is None else f"{metric.unit_cube:.4g}"
    return {
        "name": metric.name,
        "symbol": metric.symbol,
        "variant": metric.variant,
        "full": interval(metric.full_range),
        "acceptable": interval(metric.acceptable_range) if metric.acceptable_range else NOT_KNOWN,
        "cube": cube,
        "better": metric.better,
        "unit": UNITS[metric.length_power],
        "formula": formula(metric.formula),
    }


def interval(ends: tuple[float, float]) -> str:
    """A range in words: "0 to 1", "from 1", "any number"."""
    low, high = (f"{end:g}".replace("-", "−") for end in ends)
    if math.isinf(ends[0]):
        return "any number" if math.isinf(ends[1]) else f"up to {high}"
    return f"from {low}" if math.isinf(ends[1]) else f"{low} to {high}"


def formula(text: str) -> Markup:
    """A metric's formula as HTML: powers raised, products with a cross."""
    for plain, sign in ((" x ", " × "), (" - ", " − "), ("sqrt", "√"), ("^-", "^−")):
        text = text.replace(plain, sign)
    return Markup(
        re.sub(r"\^\(([^)]*)\)|\^(−?\w+)", lambda found: f"<sup>{found[1] or found[2]}</sup>", escape(text))
    )


def _format_row(one: Format) -> FormatRow:
    writes = "; ".join(row.name for row in WRITERS if row.format == one.id)
    return {"name": one.name, "extensions": ", ".join(one.extensions), "writes": writes}
