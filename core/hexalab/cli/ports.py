"""The port of a verb that serves."""

from __future__ import annotations

from argparse import ArgumentParser, ArgumentTypeError

from ..errors import HexaLabError

LARGEST_PORT = 65535


def port_number(text: str) -> int:
    """Check a port's number."""
    if text.isascii() and text.isdigit() and int(text) <= LARGEST_PORT:
        return int(text)
    raise ArgumentTypeError(f"found {text!r}, expected a port from 0 to {LARGEST_PORT}")


def add_port(parser: ArgumentParser) -> None:
    """Declare `--port`."""
    parser.add_argument(
        "--port", type=port_number, default=0, metavar="N", help="the port; any free one by default"
    )


def taken(port: int, error: OSError) -> HexaLabError:
    """Say that a port can't be had."""
    return HexaLabError(f"port {port} can't be used: {error.strerror}")
