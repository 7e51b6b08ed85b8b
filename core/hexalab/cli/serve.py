"""`hexalab serve`: a built site on this machine."""

from __future__ import annotations

from argparse import ArgumentParser, ArgumentTypeError, Namespace
from pathlib import Path

from ..errors import HexaLabError
from ..hosts.serving import serve

LARGEST_PORT = 65535


def port_number(text: str) -> int:
    """Check a port's number."""
    if text.isascii() and text.isdigit() and int(text) <= LARGEST_PORT:
        return int(text)
    raise ArgumentTypeError(f"found {text!r}, expected a port from 0 to {LARGEST_PORT}")


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument(
        "--port", type=port_number, default=0, metavar="N", help="the port; any free one by default"
    )
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
        raise HexaLabError(f"port {arguments.port} can't be used: {error.strerror}") from None
    return 0
