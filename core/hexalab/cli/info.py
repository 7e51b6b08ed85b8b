"""`hexalab info`: what is in mesh files."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from typing import Any

import numpy as np

from .. import FORMATS, MeshReadError, certify, read, summarise
from ..diagnosis import TURNED
from ..group_facts import called
from ..mesh import Mesh
from ..words import count, counted
from . import FINDING, MISUSE, complain
from .tables import quality_table
from .units import add_unit, titles

LAYERS_SHOWN = 12
GROUPS_SHOWN = 24
CELLS_SHOWN = 5


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("files", nargs="+", metavar="FILE", help="a mesh file; may be gzipped")
    parser.add_argument("--json", action="store_true", help="print one JSON object per file, a line each")
    parser.add_argument(
        "--strict",
        action="store_true",
        help="exit with 1 if a mesh has an invalid cell, or was inverted as a whole",
    )
    add_unit(parser)
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Print the facts of each file; a file that can't be read does not stop the others."""
    code, printed = 0, False
    for path in arguments.files:
        try:
            mesh = read(path)
            facts = {**summarise(mesh), "file": path}
        except (MeshReadError, OSError, MemoryError) as error:
            if isinstance(error, BrokenPipeError):
                raise
            code = complain(error)
            continue
        if arguments.json:
            print(json.dumps(facts, ensure_ascii=False, allow_nan=False))
        else:
            print("\n" * printed + described(facts, arguments.unit))
        printed = True
        if arguments.strict and code != MISUSE and (TURNED in mesh.notes or has_invalid_cell(mesh)):
            code = FINDING
    return code


def has_invalid_cell(mesh: Mesh) -> bool:
    """Whether the Jacobian of a cell is somewhere not positive."""
    return bool(np.any(certify(mesh).state == 0))


def described(facts: dict[str, Any], unit: str) -> str:
    """Lay out the facts for reading, lengths in a unit."""
    kinds, names = facts["kinds"], {row.id: row.name for row in FORMATS}
    parts = ", ".join(counted(number, kind) for kind, number in kinds.items())
    rows = [
        ("format", names.get(facts["format"], facts["format"])),
        ("vertices", count(facts["vertices"]) + also(facts["unreferenced_vertices"], "unreferenced")),
        ("cells", (parts or "0") + also(facts["cells_repeating_a_vertex"], "repeating a vertex")),
        ("components", count(facts["components"])),
        (
            "faces",
            count(facts["faces"])
            + also(facts["boundary_faces"], "on the boundary")
            + also(facts["nonmanifold_faces"], "shared by more than two cells"),
        ),
        ("edges", count(facts["edges"])),
        ("  inside, by valence", valences(facts["interior_edge_valence"])),
        ("  on the boundary", valences(facts["boundary_edge_valence"])),
        ("cells by depth", layers(facts["cells_per_depth"])),
    ]
    width = max(len(name) for name, _ in rows)
    lines = [facts["file"], *(f"  {name.ljust(width)}  {text}" for name, text in rows)]
    lines += [f"  group: {told_group(group)}" for group in facts["groups"][:GROUPS_SHOWN]]
    if len(facts["groups"]) > GROUPS_SHOWN:
        lines.append(f"  and {len(facts['groups']) - GROUPS_SHOWN} groups more (--json lists them)")
    lines += [f"  features: {told}" for told in told_features(facts["features"])]
    lines += [f"  finding: {finding['message']}{named(finding)}" for finding in facts["findings"]]
    measured = facts["quality"]
    return "\n".join([*lines, "", quality_table(measured, titles(measured, unit))])


def named(finding: dict[str, Any]) -> str:
    """Write the first cells or vertices that a finding concerns, by the file's numbers."""
    for what, noun in (("cells", "cell"), ("vertices", "vertex")):
        numbers = finding[what]
        if numbers:
            more = finding["count"] - len(numbers[:CELLS_SHOWN])
            rest = ", ..." if more > 0 else ""
            return f" ({noun} {', '.join(map(str, numbers[:CELLS_SHOWN]))}{rest})"
    return ""


def told_group(group: dict[str, Any]) -> str:
    """Write what a group is called, and how large it is."""
    noun = "cell" if group["kind"] == "cells" else "vertex"
    return f"{called(group)}, {counted(group['count'], noun)}"


def told_features(features: dict[str, dict[str, Any]]) -> list[str]:
    """Write how many elements of each lower dimension there are, and in which groups."""
    lines = []
    for name, part in features.items():
        if part["count"]:
            groups = ", ".join(
                f"{called(row)}: {count(row['count'])}" for row in part["groups"][:LAYERS_SHOWN]
            )
            more = len(part["groups"]) - LAYERS_SHOWN
            rest = f" and {more} groups more" if more > 0 else ""
            noun = {"corners": "corner", "edges": "edge", "faces": "face"}[name]
            lines.append(counted(part["count"], noun) + (f"; {groups}{rest}" if groups else ""))
    return lines


def also(number: int, what: str) -> str:
    """Add a part of a count, where there is one."""
    return f", {count(number)} {what}" if number else ""


def valences(counts: dict[str, int]) -> str:
    """Write how many edges there are of each valence."""
    return ", ".join(f"{valence}: {count(number)}" for valence, number in counts.items()) or "none"


def layers(per_depth: list[int]) -> str:
    """Write how many cells there are at each hop distance from the boundary."""
    text = " ".join(count(number) for number in per_depth[:LAYERS_SHOWN])
    more = len(per_depth) - LAYERS_SHOWN
    return f"{text} and {more} layers more" if more > 0 else text
