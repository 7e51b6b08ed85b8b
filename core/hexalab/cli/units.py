"""The unit of a file's coordinates, as the user names it: told beside numbers, nothing is converted."""

from __future__ import annotations

from argparse import ArgumentParser
from collections.abc import Iterable

from .. import METRICS
from ..status import LENGTH_UNITS
from ..words import titled

NONE, *NAMED = LENGTH_UNITS


def add_unit(parser: ArgumentParser) -> None:
    """Declare `--unit`."""
    parser.add_argument(
        "--unit",
        choices=NAMED,
        default=NONE,
        help="of length, that the file's coordinates are in: told in the table; nothing is converted",
    )


def titles(metrics: Iterable[str], unit: str) -> dict[str, str]:
    """Names of metrics by their ids, with the unit of those that carry one: "Volume (mm³)"."""
    return {id: titled(METRICS[id].name, METRICS[id].length_power, unit) for id in metrics}
