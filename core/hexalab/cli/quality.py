"""`hexalab quality`: how good a mesh's cells are, and which are the worst."""

from __future__ import annotations

import csv
import json
import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from typing import Any

import numpy as np

from .. import METRICS, HexaLabError, quality_many, read
from ..arrays import Array, Floats
from ..cell_lists import LIST_FORMS, cell_list
from ..grouping import group_of_cells, groups_of
from ..mesh import Mesh, cell_barycentres
from ..numbering import cell_numbers
from ..packing import jsonable
from ..quality.measures import worst_first
from ..summary import STATISTICS, measures
from ..words import number
from .tables import quality_table, table
from .units import add_unit, titles

WORST_METRIC = "scaled_jacobian"
"""The metric by which cells are the worst, if none is named."""


def metric_id(text: str) -> str:
    """Check a metric's id; a wrong one is answered with the nearest."""
    if text in METRICS:
        return text
    near = get_close_matches(text.lower().replace(" ", "_").replace("-", "_"), METRICS, 1)
    guess = f"; did you mean {near[0]}?" if near else f"; there are {', '.join(METRICS)}"
    raise ArgumentTypeError(f"no metric {text!r}{guess}")


def positive(text: str) -> int:
    """Check a number of cells."""
    if not text.isdigit() or not int(text):
        raise ArgumentTypeError(f"{text!r} is no number of cells, expected 1 or more")
    return int(text)


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
    parser.add_argument(
        "--group",
        action="append",
        metavar="NAME",
        dest="groups",
        help="measure the cells of a group only, by its name or id (`hexalab info` lists them); may be repeated",
    )
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="print JSON: metric to statistics")
    form.add_argument(
        "--csv",
        action="store_true",
        help="print CSV: a row per metric, or with --cells and --worst per cell",
    )
    form.add_argument(
        "--as",
        choices=[row.id for row in LIST_FORMS],
        dest="form",
        help="with --worst, print the cells for other programs: "
        + ", ".join(f"{row.id} ({row.name})" for row in LIST_FORMS),
    )
    parser.add_argument(
        "--cells", action="store_true", help="give each cell's number and values, in the file's order"
    )
    parser.add_argument(
        "--worst",
        type=positive,
        metavar="N",
        help="list the N worst cells: the file's numbers of them, values and barycentres "
        f"({WORST_METRIC} by default)",
    )
    add_unit(parser)
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Print statistics, and values or the worst cells where asked for."""
    if arguments.form and not arguments.worst:
        raise HexaLabError("--as lists the worst cells: expected --worst N with it")
    mesh = read(arguments.file)
    rows = rows_of_groups(mesh, arguments.groups)
    metrics = arguments.metrics or ([WORST_METRIC] if arguments.worst else list(METRICS))
    values = {metric: array[rows] for metric, array in quality_many(mesh, metrics).items()}
    if arguments.worst:
        tell_worst(mesh, rows, values, arguments)
        return 0
    measured = measures(mesh, values, mesh.kinds[rows])
    numbers = cell_numbers(mesh, rows)
    if arguments.json:
        told: dict[str, Any] = dict(measured)
        if arguments.cells:
            told = {metric: {**row, "values": values[metric]} for metric, row in measured.items()}
            if mesh.cell_numbers is not None:
                told["numbers"] = numbers
        print(json.dumps(jsonable(told), allow_nan=False))
    elif arguments.csv or arguments.cells:
        write_csv(numbers, values if arguments.cells else None, measured)
    else:
        print(arguments.file)
        print(quality_table(measured, titles(measured, arguments.unit)))
    return 0


def rows_of_groups(mesh: Mesh, names: Sequence[str] | None) -> Array:
    """Rows of the cells of groups, rising; of all cells without any.

    Raises
    ------
    HexaLabError
        The mesh has no group of cells of that name or id.
    """
    if not names:
        return np.arange(mesh.cell_count)
    groups = groups_of(mesh)
    inside = np.zeros(mesh.cell_count, dtype=bool)
    for name in names:
        inside[group_of_cells(groups, name).members] = True
    return np.flatnonzero(inside)


def tell_worst(mesh: Mesh, rows: Array, values: Mapping[str, Floats], arguments: Namespace) -> None:
    """Print the worst cells by each metric."""
    found = {metric: worst_rows(rows, array, metric, arguments.worst) for metric, array in values.items()}
    if arguments.form:
        every = np.concatenate([some for some, _ in found.values()])
        cells = every[np.sort(np.unique(every, return_index=True)[1])]
        print(cell_list(mesh, cells, arguments.form, "WORST"), end="")
        return
    told = {metric: worst_cells(mesh, *pair) for metric, pair in found.items()}
    if arguments.json:
        print(json.dumps(jsonable(told), allow_nan=False))
    elif arguments.csv:
        writer = csv.writer(sys.stdout, lineterminator="\n")
        writer.writerow(["metric", "cell", "value", "x", "y", "z"])
        for metric, worst in told.items():
            writer.writerows([metric, one["cell"], one["value"], *one["barycentre"]] for one in worst)
    else:
        print(arguments.file)
        for metric, worst in told.items():
            lines = [[str(one["cell"]), *map(number, (one["value"], *one["barycentre"]))] for one in worst]
            print(f"  {METRICS[metric].name}, the {len(worst):,} worst")
            print(table([["cell", "value", "x", "y", "z"], *lines], indent=4))


def worst_rows(rows: Array, values: Floats, metric: str, count: int) -> tuple[Array, Floats]:
    """Rows of the worst cells by a metric, those without a finite value left out, and their values."""
    places = worst_first(values, METRICS[metric].better == "high", count)
    return rows[places], values[places]


def worst_cells(mesh: Mesh, cells: Array, values: Floats) -> list[dict[str, Any]]:
    """Number, row, value and barycentre of some cells."""
    places = cell_barycentres(mesh.coordinates, mesh.corners[:, cells], mesh.kinds[cells]).T
    return [
        {"cell": name, "row": row, "value": value, "barycentre": place}
        for name, row, value, place in zip(
            cell_numbers(mesh, cells).tolist(),
            cells.tolist(),
            values.tolist(),
            places.tolist(),
            strict=True,
        )
    ]


def write_csv(numbers: Array, values: dict[str, Floats] | None, measured: dict[str, dict[str, Any]]) -> None:
    """Print CSV: of the values a row per cell, with its number, else of the statistics a row per metric."""
    writer = csv.writer(sys.stdout, lineterminator="\n")
    if values is None:
        writer.writerow(["metric", *STATISTICS])
        writer.writerows([metric, *row.values()] for metric, row in measured.items())
    else:
        writer.writerow(["cell", *values])
        columns = [array.tolist() for array in values.values()]
        writer.writerows(zip(numbers.tolist(), *columns, strict=True))
