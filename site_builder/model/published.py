"""The facts of remote meshes, as `hexalab collect` writes them beside source.yaml: a line of JSON for each.

Anybody may send such a file, so every fact is looked at before it is believed.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from hexalab.quality import METRICS
from hexalab.summary import STATISTICS

from .facts import Facts

FACTS_FILE = "facts.json"
PICTURES = "pictures"
"""Folder of the pictures of remote meshes."""

VERSION = 2
"""Of what is measured and of how it is written; facts of another version are measured anew."""

NOTE = "HexaLab's own measurements of the authors' meshes, which hexalab collect made."

DIGITS = 9
"""Significant digits of a metric's statistics."""

MOST_TEXT, MOST_ROWS, DEEPEST = 2_000, 200_000, 6
"""Characters of a text, rows of a table and levels of tables in tables that are still believed."""

Check = Callable[[Any], bool]


@dataclass
class Collected:
    """What was collected of a remote mesh.

    Parameters
    ----------
    facts : Facts
    etag : str
        By which its server knows the file, "" if it told none.
    picture : str
        What the picture shows, as a hash (`Shot.key`), "" if there is none.
    version : int
        Under which it was measured.
    """

    facts: Facts = field(default_factory=Facts)
    etag: str = ""
    picture: str = ""
    version: int = VERSION


def read_published(file: Path) -> dict[str, Collected]:
    """What was collected of remote files, by the ``url`` of their row in source.yaml.

    Raises
    ------
    ValueError
        A fact isn't one that may be told of a remote file, or isn't what it should be.
    """
    document = json.loads(file.read_text("utf-8"))
    version = document.get("version", 1)
    return {url: _collected(url, dict(row), version) for url, row in document["meshes"].items()}


def _collected(url: str, row: dict[str, Any], version: int) -> Collected:
    for name, value in row.items():
        if name not in CHECKS or not CHECKS[name](value):
            raise ValueError(f"{name!r} of {url!r} is {json.dumps(value)[:60]}")
    etag, picture, version = row.pop("etag", ""), row.pop("picture", ""), row.pop("version", version)
    if "quality" in row:
        row["quality"] = {
            metric: dict(zip(STATISTICS, numbers, strict=True)) for metric, numbers in row["quality"].items()
        }
    return Collected(Facts.from_dict(row), etag, picture, version)


def write_published(file: Path, collected: Mapping[str, Collected]) -> None:
    """Write what was collected, by ``url``; whole or not at all, and the same bytes for the same facts."""
    rows = [f"    {_text(url)}: {_text(_row(one))}" for url, one in collected.items()]
    text = f'{{\n  "version": {VERSION},\n  "note": {_text(NOTE)},\n  "meshes": {{\n'
    half = file.with_suffix(".half")
    half.write_text(text + ",\n".join(rows) + "\n  }\n}\n", "utf-8")
    half.replace(file)


def _row(one: Collected) -> dict[str, Any]:
    row = one.facts.to_dict()
    if "quality" in row:
        row["quality"] = {
            metric: [_rounded(numbers[name]) for name in STATISTICS]
            for metric, numbers in row["quality"].items()
        }
    version = one.version if one.version != VERSION else None
    more = {"etag": one.etag, "picture": one.picture, "version": version}
    return row | {name: value for name, value in more.items() if value}


def _rounded(number: float | None) -> float | None:
    return float(f"{number:.{DIGITS}g}") if isinstance(number, float) else number


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)


def _whole(value: Any) -> bool:
    return type(value) is int and 0 <= value < 2**53


def _real(value: Any) -> bool:
    return type(value) in (int, float) and math.isfinite(value)


def _plain_text(value: Any) -> bool:
    return isinstance(value, str) and len(value) <= MOST_TEXT


def _form(pattern: str) -> Check:
    return lambda value: isinstance(value, str) and re.fullmatch(pattern, value) is not None


def _or_nothing(check: Check) -> Check:
    return lambda value: value is None or check(value)


def _list_of(check: Check, count: int | None = None) -> Check:
    def holds(value: Any) -> bool:
        if not isinstance(value, list) or len(value) > MOST_ROWS or len(value) != (count or len(value)):
            return False
        return all(map(check, value))

    return holds


def _table_of(key: Check, value: Check) -> Check:
    def holds(table: Any) -> bool:
        if not isinstance(table, dict) or len(table) > MOST_ROWS:
            return False
        return all(map(key, table)) and all(map(value, table.values()))

    return holds


def _with(needed: Mapping[str, Check], more: Check) -> Check:
    """A dict that has these keys, and others whose values are checked alike."""

    def holds(value: Any) -> bool:
        if not isinstance(value, dict) or not needed.keys() <= value.keys():
            return False
        return all(needed.get(name, more)(one) for name, one in value.items())

    return holds


def _only(needed: Mapping[str, Check]) -> Check:
    return _with(needed, lambda value: False)


def _data(value: Any, depth: int = 0) -> bool:
    """Nothing but numbers, texts, and lists and tables of such."""
    if isinstance(value, dict):
        inner: list[Any] = [*value, *value.values()]
    elif isinstance(value, list):
        inner = value
    else:
        return value is None or isinstance(value, bool) or _real(value) or _plain_text(value)
    return depth < DEEPEST and len(inner) <= MOST_ROWS and all(_data(one, depth + 1) for one in inner)


_COUNTS = _table_of(_form(r"[0-9]{1,9}"), _whole)
_NAMED = _table_of(_plain_text, _whole)
_VECTOR = _list_of(_real, 3)
_TRACED = {
    "irregular": _with(
        {
            "nodes": _whole, "arcs": _whole, "loops": _whole, "arcs_by_valence": _COUNTS,
            "loops_by_valence": _COUNTS, "node_types": _NAMED,
        },
        _data,
    ),
    "sheets": _NAMED,
    "chords": _NAMED,
    "base_complex": _with({"blocks": _whole, "kinds": _NAMED, "dims": _NAMED}, _data),
    "interior_base_complex": _with({"blocks": _whole}, _data),
}  # fmt: skip
"""What pages read of a structure (`hexalab.structure.facts.facts_of`)."""

CHECKS: dict[str, Check] = {
    **dict.fromkeys(
        (
            "bytes", "vertices", "cells", "faces", "boundary_faces", "nonmanifold_faces", "edges",
            "unreferenced_vertices", "cells_repeating_a_vertex", "components", "sj_not_positive", "sj_not_finite",
        ),
        _whole,
    ),
    **dict.fromkeys(("sj_min", "sj_mean", "sj_max"), _real),
    **dict.fromkeys(("interior_edge_valence", "boundary_edge_valence"), _COUNTS),
    "sha256": _form("[0-9a-f]{64}"),
    "format": _plain_text,
    "kinds": _NAMED,
    "extent": _list_of(_VECTOR, 2),
    "view": _only({"direction": _VECTOR, "up": _VECTOR, "facing": _VECTOR}),
    "cells_per_depth": _list_of(_whole),
    "validity": _only({"valid": _whole, "invalid": _whole, "undecided": _whole}),
    "quality": _table_of(METRICS.__contains__, _list_of(_or_nothing(_real), len(STATISTICS))),
    "histogram": _only({"low": _real, "high": _real, "counts": _list_of(_whole)}),
    "findings": _list_of(_with({"id": _plain_text, "count": _whole, "message": _plain_text}, _data)),
    "notes": _list_of(_plain_text),
    "structure": _with(_TRACED, _data),
    "groups": _list_of(_with({"name": _plain_text, "kind": _plain_text, "count": _whole}, _data)),
    "features": _table_of(_plain_text, _with({"count": _whole}, _data)),
    "etag": _plain_text,
    "picture": _form("[0-9a-f]{32}"),
    "version": _whole,
}  # fmt: skip
"""What may be told of a remote mesh, and how it is recognised."""
