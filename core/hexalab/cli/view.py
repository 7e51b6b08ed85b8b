"""`hexalab view`: the viewer on files of this machine."""

from __future__ import annotations

import getpass
import os
import socket
import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Mapping
from contextlib import ExitStack
from ipaddress import ip_address
from pathlib import Path

from ..errors import HexaLabError
from ..hosts.loopback import Loopback
from ..hosts.offers import AnyOffer, FileOffer, compared_offers, file_offers
from ..hosts.opening import has_screen, open_page
from ..hosts.watching import Watch
from .ports import add_port, taken
from .settings import HELP, read_status


def loopback_address(text: str) -> str:
    """Check that an address is one of this machine alone."""
    if text == "localhost":
        return "127.0.0.1"
    try:
        address = ip_address(text)
    except ValueError:
        raise ArgumentTypeError(f"found {text!r}, expected 127.0.0.1, ::1 or localhost") from None
    if not address.is_loopback:
        raise ArgumentTypeError(
            f"{text} can be reached from other machines; meshes are shown on this one alone, and elsewhere through "
            "an SSH tunnel (ssh -L)"
        )
    return text


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE", help="mesh files; may be gzipped")
    parser.add_argument("--status", type=Path, metavar="JSON", help=HELP)
    parser.add_argument(
        "--watch", action="store_true", help="open a file again when another program has written it anew"
    )
    parser.add_argument(
        "--compare",
        action="store_true",
        help="show the second file beside the first: another mesh, or a surface to measure against "
        "(STL, OBJ, OFF, PLY, ...)",
    )
    add_port(parser)
    parser.add_argument(
        "--host",
        type=loopback_address,
        default="127.0.0.1",
        metavar="ADDRESS",
        help="the loopback's address to serve at (default: %(default)s)",
    )
    parser.add_argument("--no-browser", dest="browser", action="store_false", help="open no browser")
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Serve until interrupted."""
    for path in arguments.files:
        if path.is_dir():
            raise HexaLabError(f"{path}: found a folder, expected a mesh file")
        path.open("rb").close()  # what isn't there is told before anything starts
    status = read_status(arguments.status) if arguments.status else None
    if arguments.compare and len(arguments.files) != 2:
        raise HexaLabError(f"--compare takes two files: found {len(arguments.files)}")
    offers: Mapping[str, AnyOffer] = file_offers(arguments.files)
    if arguments.compare:
        offers = compared_offers(arguments.files)
    for offer in offers.values():
        if isinstance(offer, FileOffer):
            offer.read_ahead()  # while the browser starts
            if not arguments.compare:
                break
    try:
        server = Loopback(
            offers,
            host=arguments.host,
            port=arguments.port,
            status=status,
            watched=arguments.watch,
            compare="1" if arguments.compare else None,
        )
    except OSError as error:
        raise taken(arguments.port, error) from None
    try:
        with server:
            show(server, arguments)
    except KeyboardInterrupt:
        print()
    return 0


def show(server: Loopback, arguments: Namespace) -> None:
    """Serve, say where, open the browser, and wait: until interrupted."""
    with ExitStack() as closing:
        if arguments.watch:
            files = dict(zip(server.offers, arguments.files, strict=True))
            watch = Watch(files, server.tell_of)
            closing.callback(watch.close)
        serving = server.start()
        closing.callback(server.shutdown)
        print(f"HexaLab is at {server.address}", flush=True)
        if "SSH_CONNECTION" in os.environ:
            print(f"From your own machine: {tunnel(server.port, server.shown_host)}", flush=True)
        print("Ctrl-C ends it.", flush=True)
        if arguments.browser and has_screen() and not open_page(server.once):
            print("hexalab: no browser could be opened: open the address yourself", file=sys.stderr)
        while serving.is_alive():
            serving.join(1)


def tunnel(port: int, host: str) -> str:
    """The command that brings the server to the machine where the user sits, under the same port."""
    return f"ssh -N -L {port}:{host}:{port} {getpass.getuser()}@{socket.getfqdn()}"
