"""The unit of a file's coordinates, as the user names it: told beside numbers, nothing is converted."""

from __future__ import annotations

from argparse import ArgumentParser
from collections.abc import Iterable

from .. import METRICS
from ..status import LENGTH_UNITS

NONE, *NAMED = LENGTH_UNITS
SYMBOLS = {"um": "µm"}
EXPONENTS = {1: "", 2: "²", 3: "³"}


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
    return {id: _title(METRICS[id].name, METRICS[id].length_power, unit) for id in metrics}


def _title(name: str, power: int, unit: str) -> str:
    if not power or unit == NONE:
        return name
    return f"{name} ({SYMBOLS.get(unit, unit)}{EXPONENTS[power]})"
