"""`hexalab validate`: whether sources can be taken into the catalogue."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from hexalab.cli import FINDING
from hexalab.errors import HexaLabError

from ..contributing.validation import validate


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument(
        "directory",
        type=Path,
        nargs="?",
        default=Path("repository"),
        metavar="DIR",
        help="a folder of sources, or one with a source.yaml (default: %(default)s)",
    )
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Print what is wrong and what was measured, in Markdown."""
    if not arguments.directory.is_dir():
        raise HexaLabError(f"{arguments.directory}: there is no such folder")
    report = validate(arguments.directory)
    print(report.markdown, end="")
    return 0 if report.ok else FINDING
