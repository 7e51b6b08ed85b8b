"""`hexalab serve`: a built site on this machine."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from ..hosts.serving import serve
from .ports import add_port, taken


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    add_port(parser)
    parser.add_argument(
        "--out",
        type=Path,
        default=Path("build/site"),
        metavar="DIR",
        help="where the site lies (default: %(default)s)",
    )
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Serve until interrupted."""
    try:
        serve(arguments.out, arguments.port)
    except OSError as error:
        if isinstance(error, FileNotFoundError):
            raise
        raise taken(arguments.port, error) from None
    return 0
