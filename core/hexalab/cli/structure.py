"""`hexalab structure`: irregular graph, sheets, chords and base complex of meshes."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from typing import Any

from .. import MeshReadError, read
from ..errors import HexaLabError
from ..structure import TABLES, Structure, csv_of, facts_of
from ..words import count, counted
from . import complain
from .tables import table

SHOWN = 12
"""So many sizes of blocks and types of nodes are listed."""


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("files", nargs="+", metavar="FILE", help="a mesh file; may be gzipped")
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="print one JSON object per file, a line each")
    form.add_argument(
        "--csv", choices=list(TABLES), metavar="TABLE", help=f"print a table of one mesh: {', '.join(TABLES)}"
    )
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Print the structure of each file; a file that can't be read does not stop the others."""
    if arguments.csv and len(arguments.files) > 1:
        raise HexaLabError(f"--csv prints a table of one mesh: found {len(arguments.files)} files")
    code, printed = 0, False
    for path in arguments.files:
        try:
            structure = Structure(read(path))
        except (MeshReadError, OSError, MemoryError) as error:
            if isinstance(error, BrokenPipeError):
                raise
            code = complain(error)
            continue
        if arguments.csv:
            print(csv_of(TABLES[arguments.csv](structure)), end="")
        elif arguments.json:
            print(json.dumps({"file": path, **facts_of(structure)}, ensure_ascii=False, allow_nan=False))
        else:
            print("\n" * printed + described(path, facts_of(structure)))
        printed = True
    return code


def described(path: str, facts: dict[str, Any]) -> str:
    """The facts in words."""
    graph, base = facts["irregular"], facts["base_complex"]
    sheets, chords = facts["sheets"], facts["chords"]
    lines = [path]
    if "skipped" in facts:
        lines.append(f"  Not traced: {facts['skipped']}; structure ends there.")
    blocks = [
        counted(number, "twisted ring" if kind == "twisted" else kind)
        for kind, number in base["kinds"].items()
    ]
    if len(blocks) != 1:
        blocks = [count(base["blocks"]), *blocks]
    rows = [
        [
            "Irregular edges inside",
            counted(graph["arcs"], "arc"),
            counted(graph["loops"], "loop"),
            counted(graph["nodes"], "node"),
        ],
        *(
            [f"{name} inside", count(number)]
            for name, edges in (("Ends of arcs", 1), ("T junctions", 3))
            if (number := _meeting(graph["node_types"], edges))
        ),
        [
            "Sheets",
            count(sheets["count"]),
            *_kinds(sheets, ("closed", "self_intersecting", "self_touching", "one_sided")),
        ],
        ["Chords", count(chords["count"]), *_kinds(chords, ("closed", "self_intersecting"))],
        ["Blocks", *blocks],
        [
            "Base complex",
            counted(base["vertices"], "vertex"),
            counted(base["edges"] + base["edge_loops"], "edge"),
            counted(base["faces"], "face"),
        ],
        ["Blocks by the inside alone", count(facts["interior_base_complex"]["blocks"])],
    ]
    width = max(len(row[0]) for row in rows)
    lines += [f"  {name.ljust(width)}  {', '.join(told)}" for name, *told in rows]
    share, cells = facts["irregular_vertex_share"], base["cells_per_block"]
    if cells is not None:
        lines.append(f"  {'Cells per block'.ljust(width)}  {cells:,.2f}")
    if share is not None:
        lines.append(f"  {'Irregular vertices inside'.ljust(width)}  {100 * share:.2f} %")
    if facts["class"]:
        lines.append(f"  {'Class'.ljust(width)}  {facts['class']}")
    for title, found in (("Node types", graph["node_types"]), ("Blocks by size", base["dims"])):
        if found:
            most = sorted(found.items(), key=lambda item: -item[1])
            lines.append(f"  {title}")
            lines.append(table([[name, count(number)] for name, number in most[:SHOWN]], indent=4))
            if len(most) > SHOWN:
                lines.append(f"    and {len(most) - SHOWN} more")
    return "\n".join(lines)


def _meeting(types: dict[str, int], edges: int) -> int:
    """Nodes inside at which so many irregular edges meet: one where an arc ends, three at a T junction."""
    return sum(n for name, n in types.items() if name.startswith("i ") and len(name.split()) == edges + 1)


def _kinds(facts: dict[str, int], names: tuple[str, ...]) -> list[str]:
    return [f"{count(facts[name])} {name.replace('_', '-')}" for name in names if facts[name]]
