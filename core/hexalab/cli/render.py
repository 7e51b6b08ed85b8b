"""`hexalab render`: a picture of a mesh, as the viewer makes it."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from pathlib import Path

from ..errors import HexaLabError
from ..hosts.offers import FileOffer, other_file
from . import settings

LARGEST_SIDE = 8192


def side(text: str) -> int:
    """Check a picture's width or height."""
    if text.isascii() and text.isdigit() and 1 <= int(text) <= LARGEST_SIDE:
        return int(text)
    raise ArgumentTypeError(f"found {text!r}, expected pixels from 1 to {LARGEST_SIDE}")


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("file", type=Path, metavar="FILE", help="a mesh file; may be gzipped")
    parser.add_argument(
        "--with",
        type=Path,
        dest="other",
        metavar="OTHER",
        help="what it is compared with: another mesh, seen in the same picture, or a reference surface, drawn over it",
    )
    parser.add_argument(
        "-o",
        "--out",
        type=Path,
        required=True,
        metavar="PICTURE",
        help="where the picture goes: .png, which carries its status; a figure also .svg, .pdf",
    )
    parser.add_argument(
        "--status",
        type=Path,
        metavar="JSON",
        help=settings.HELP,
    )
    parser.add_argument(
        "--figure",
        action="store_true",
        help="with legend, scale bar, axes, caption, panels, as the settings' section figure asks",
    )
    parser.add_argument("--width", type=side, metavar="N", help="pixels (default: 1280; a figure's own)")
    parser.add_argument("--height", type=side, metavar="N", help="pixels (default: 800; a figure's own)")
    parser.add_argument("--transparent", action="store_true", help="leave the background out")
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Draw; what of the settings could not be applied goes to stderr."""
    from ..hosts.headless import FIGURES, HEIGHT, WIDTH
    from ..hosts.rendering import Renderer

    out: Path = arguments.out
    form = out.suffix.lower().lstrip(".") or "png"
    figure = arguments.figure or form in ("svg", "pdf")
    if form not in (FIGURES if figure else ("png",)):
        raise HexaLabError(f"{out}: expected a name that ends in .png; of a figure also in .svg or .pdf")
    if figure and arguments.transparent:
        raise HexaLabError("--transparent: a figure has a setting for that, figure.transparent")
    if figure and bool(arguments.width) != bool(arguments.height):
        raise HexaLabError("--width, --height: of a figure give both, or none")
    status = settings.read_status(arguments.status) if arguments.status else None
    mesh = FileOffer(arguments.file, arguments.file.name)
    mesh.mesh()  # what can't be read is told before a browser is started
    beside = other_file(arguments.other) if arguments.other else None
    size = {"width": arguments.width, "height": arguments.height}
    with Renderer() as renderer:
        if figure:
            picture = renderer.figure(mesh, status, format=form, **size, beside=beside)
        else:
            size = {"width": arguments.width or WIDTH, "height": arguments.height or HEIGHT}
            picture = renderer.render(mesh, status, **size, transparent=arguments.transparent, beside=beside)
    files = {out: picture.data}
    if picture.second is not None:
        places = [out.with_name(f"{out.stem}-{side}{out.suffix}") for side in "AB"]
        files = dict(zip(places, (picture.data, picture.second), strict=True))
    for place, data in files.items():
        place.write_bytes(data)
    for rejection in picture.rejections:
        words = f"{rejection['path']}: found {rejection['found']}, expected {rejection['expected']}"
        print(f"hexalab: {arguments.status}: {words}", file=sys.stderr)
    pixels = "" if figure else f"{size['width']} x {size['height']} pixels, "
    for place, data in files.items():
        print(f"{place}: {pixels}{len(data):,} bytes")
    return 0
