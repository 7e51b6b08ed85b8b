"""`hexalab compare`: two meshes, or a mesh and a reference surface, beside each other."""

from __future__ import annotations

import json
import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

from .. import METRICS, read, write
from ..comparison import compare, read_body, with_comparison
from ..errors import HexaLabError
from ..formats import writer_of
from ..report.comparison_criteria import KINDS, judged
from ..report.criteria import read_criteria
from ..report.judging import PASSED
from ..words import count, counted, number, titled
from . import FINDING
from .tables import table
from .units import add_unit

CELLS_SHOWN = 5


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("first", metavar="A", type=Path, help="a mesh file: before; may be gzipped")
    parser.add_argument(
        "second",
        metavar="B",
        type=Path,
        help="another, after; or a surface to measure against (STL, OBJ, OFF, PLY, .mesh, .vtk of faces alone)",
    )
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument(
        "--metric",
        action="append",
        choices=list(METRICS),
        metavar="ID",
        help="a metric to compare; more by repeating it (default: all)",
    )
    parser.add_argument(
        "--criteria",
        type=Path,
        metavar="FILE",
        help="criteria that decide, YAML or JSON: exit with 1 if one is missed",
    )
    parser.add_argument(
        "-o",
        "--out",
        type=Path,
        metavar="OUT",
        help="write A with distances, displacements and changes of metrics as attributes",
    )
    add_unit(parser)
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Compare, print, and judge."""
    criteria = read_criteria(arguments.criteria, KINDS) if arguments.criteria else []
    metrics = list(dict.fromkeys(arguments.metric or METRICS))
    lacking = [one.worse for one in criteria if hasattr(one, "worse") and one.worse not in metrics]
    lacking += [
        one.difference for one in criteria if hasattr(one, "difference") and one.difference not in metrics
    ]
    if lacking:
        raise HexaLabError(f"{arguments.criteria}: asks for {lacking[0]}, which --metric leaves out")
    writer = writer_of(arguments.out, None) if arguments.out else None
    first, second = read(arguments.first), read_body(arguments.second)
    facts = compare(first, second, metrics)
    facts["a"]["file"], facts["b"]["file"] = str(arguments.first), str(arguments.second)
    if criteria:
        facts["verdict"] = judged(criteria, facts)
    if arguments.json:
        print(json.dumps(facts, ensure_ascii=False, allow_nan=False))
    else:
        print(described(facts, arguments.unit))
    if writer:
        for note in write(with_comparison(first, second, metrics), arguments.out):
            print(f"hexalab: {arguments.out}: {note}", file=sys.stderr)
    if not criteria:
        return 0
    for check in facts["verdict"]["checks"]:
        if check["state"] != PASSED:
            print(f"hexalab: {check['state']}: {check['title']}: {check['found']}", file=sys.stderr)
    return 0 if facts["verdict"]["passed"] else FINDING


def described(facts: dict[str, Any], unit: str) -> str:
    """The facts in words."""
    lines = [f"{name}  {_body(facts[name.lower()])}" for name in "AB"]
    lines.append(_cells(facts))
    if facts["difference"]:
        lines += ["", "Metrics", _metrics(facts, unit)]
    if facts["changes"]:
        lines += ["", "Cell by cell", _changes(facts, unit)]
    lines += ["", "Distance of the surfaces", _distances(facts, unit)]
    return "\n".join(lines)


def _body(facts: dict[str, Any]) -> str:
    if "triangles" in facts:
        closed = "closed" if facts["closed"] else "open"
        return f"{facts['file']}: a surface of {counted(facts['triangles'], 'triangle')}, {closed}"
    kinds = ", ".join(counted(number, kind) for kind, number in facts["kinds"].items())
    findings = "".join(f"\n   finding: {one['message']}" for one in facts["findings"])
    return f"{facts['file']}: {kinds}, {counted(facts['vertices'], 'vertex')}{findings}"


def _cells(facts: dict[str, Any]) -> str:
    if "triangles" in facts["b"]:
        return "B is measured against as a surface."
    if not facts["same_connectivity"]:
        return f"The cells are not the same: {facts['connectivity']}."
    way = facts["displacement"]
    return (
        f"The cells are the same; {counted(way['moved'], 'vertex')} moved, by {number(way['max'])} at most "
        f"({number(way['max_percent'])} % of the diagonal), {number(way['mean'])} in the mean."
    )


def _metrics(facts: dict[str, Any], unit: str) -> str:
    names = ("min", "mean", "max")
    rows = [["", *(f"{side} {name}" for name in names for side in ("A", "B", "B-A"))]]
    for metric, difference in facts["difference"].items():
        row = [titled(METRICS[metric].name, METRICS[metric].length_power, unit)]
        for name in names:
            row += [number(facts[side]["quality"][metric][name]) for side in ("a", "b")]
            row.append(signed(difference[name]))
        rows.append(row)
    return table(rows)


def signed(value: float | None) -> str:
    """Write a difference with its sign."""
    return f"+{number(value)}" if value is not None and value > 0 else number(value)


def _changes(facts: dict[str, Any], unit: str) -> str:
    rows = [["", "worse", "better", "same", "largest loss", "worst cells"]]
    for metric, counts in facts["changes"].items():
        numbers = ", ".join(map(str, counts["cells"][:CELLS_SHOWN]))
        rows.append(
            [
                titled(METRICS[metric].name, METRICS[metric].length_power, unit),
                *(count(counts[name]) for name in ("worse", "better", "same")),
                number(counts["largest_loss"]),
                numbers + ("..." if counts["worse"] > CELLS_SHOWN else ""),
            ]
        )
    return table(rows)


def _distances(facts: dict[str, Any], unit: str) -> str:
    apart = facts["distance"]
    rows = [["", "A to B", "% of A's diagonal", "B to A", "% of A's diagonal"]]
    for name, title in (("max", "largest"), ("mean", "mean"), ("rms", "root mean square")):
        row = [titled(title, 1, unit)]
        for way in ("a_to_b", "b_to_a"):
            row += [number(apart[way][name]), number(apart[way][f"{name}_percent"])]
        rows.append(row)
    ways = ("a_to_b", "b_to_a")
    rows.append(["vertices", *(part for way in ways for part in (count(apart[way]["vertices"]), ""))])
    lines = [table(rows)]
    lines.append(
        f"  Hausdorff distance, of vertices: {number(apart['hausdorff'])}, "
        f"{number(apart['hausdorff_percent'])} % of A's diagonal"
    )
    if facts["volume_ratio"] is not None:
        lines.append(f"  Volume of B: {100 * facts['volume_ratio']:.6g} % of A's")
    return "\n".join(lines)
