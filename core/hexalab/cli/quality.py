"""`hexalab quality`: how good a mesh's cells are."""

from __future__ import annotations

import csv
import json
import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from difflib import get_close_matches
from typing import Any

from .. import METRICS, quality_many, read
from ..arrays import Floats
from ..packing import jsonable
from ..summary import STATISTICS, measures
from .tables import quality_table
from .units import add_unit, titles


def metric_id(text: str) -> str:
    """Check a metric's id; a wrong one is answered with the nearest."""
    if text in METRICS:
        return text
    near = get_close_matches(text.lower().replace(" ", "_").replace("-", "_"), METRICS, 1)
    guess = f"; did you mean {near[0]}?" if near else f"; there are {', '.join(METRICS)}"
    raise ArgumentTypeError(f"no metric {text!r}{guess}")


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("file", metavar="FILE", help="a mesh file; may be gzipped")
    parser.add_argument(
        "--metric",
        action="append",
        type=metric_id,
        metavar="NAME",
        dest="metrics",
        help=f"a metric's id; may be repeated; all by default: {', '.join(METRICS)}",
    )
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="print JSON: metric to statistics")
    form.add_argument(
        "--csv", action="store_true", help="print CSV: a row per metric, or with --cells per cell"
    )
    parser.add_argument("--cells", action="store_true", help="give each cell's values, in the file's order")
    add_unit(parser)
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Print statistics, and values where asked for."""
    mesh = read(arguments.file)
    values = quality_many(mesh, arguments.metrics or METRICS)
    measured = measures(mesh, values)
    if arguments.json:
        if arguments.cells:
            measured = {metric: {**numbers, "values": values[metric]} for metric, numbers in measured.items()}
        print(json.dumps(jsonable(measured), allow_nan=False))
    elif arguments.csv or arguments.cells:
        write_csv(values if arguments.cells else None, measured)
    else:
        print(arguments.file)
        print(quality_table(measured, titles(measured, arguments.unit)))
    return 0


def write_csv(values: dict[str, Floats] | None, measured: dict[str, dict[str, Any]]) -> None:
    """Print CSV: of the values a row per cell, else of the statistics a row per metric."""
    writer = csv.writer(sys.stdout, lineterminator="\n")
    if values is None:
        writer.writerow(["metric", *STATISTICS])
        writer.writerows([metric, *numbers.values()] for metric, numbers in measured.items())
    else:
        writer.writerow(["cell", *values])
        columns = [array.tolist() for array in values.values()]
        writer.writerows([cell, *row] for cell, row in enumerate(zip(*columns, strict=True)))
