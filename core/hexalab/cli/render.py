"""`hexalab render`: a picture of a mesh, as the viewer makes it."""

from __future__ import annotations

import json
import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from pathlib import Path
from typing import Any

from .. import HexaLabError, read
from ..png_text import SIGNATURE, read_settings

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
        "-o",
        "--out",
        type=Path,
        required=True,
        metavar="PNG",
        help="where the picture goes; it carries its status",
    )
    parser.add_argument(
        "--status",
        type=Path,
        metavar="JSON",
        help="settings, whole or in part; or a picture that carries them; the original HexaLab's, too",
    )
    parser.add_argument("--width", type=side, default=1280, metavar="N", help="pixels (default: %(default)s)")
    parser.add_argument("--height", type=side, default=800, metavar="N", help="pixels (default: %(default)s)")
    parser.add_argument("--transparent", action="store_true", help="leave the background out")
    parser.add_argument(
        "--site",
        type=Path,
        default=Path("build/site"),
        metavar="DIR",
        help="a built site, whose viewer draws (default: %(default)s)",
    )
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Draw; what of the settings could not be applied goes to stderr."""
    from ..hosts.rendering import Renderer

    status = read_status(arguments.status) if arguments.status else None
    read(arguments.file)  # what can't be read is told before a browser is started
    size = {name: getattr(arguments, name) for name in ("width", "height", "transparent")}
    with Renderer(arguments.site) as renderer:
        picture = renderer.render(arguments.file.name, arguments.file.read_bytes(), status, **size)
    arguments.out.write_bytes(picture.png)
    for rejection in picture.rejections:
        words = f"{rejection['path']}: found {rejection['found']}, expected {rejection['expected']}"
        print(f"hexalab: {arguments.status}: {words}", file=sys.stderr)
    print(f"{arguments.out}: {arguments.width} x {arguments.height} pixels, {len(picture.png):,} bytes")
    return 0


def read_status(path: Path) -> Any:
    """Read settings from a JSON file or out of a picture."""
    data = path.read_bytes()
    try:
        if data.startswith(SIGNATURE):
            return read_settings(data)
        document = json.loads(data)
    except HexaLabError as error:
        raise HexaLabError(f"{path}: {error}") from None
    except (ValueError, RecursionError) as error:
        raise HexaLabError(f"{path}: the settings are not JSON: {error}") from None
    if not isinstance(document, dict):
        raise HexaLabError(f"{path}: found no settings, expected a JSON object")
    return document
