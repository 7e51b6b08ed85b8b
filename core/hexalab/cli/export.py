"""`hexalab export`: the mesh as it is shown, for other programs and other people."""

from __future__ import annotations

import os
import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from .. import WRITERS, catalogue
from ..errors import HexaLabError
from ..formats import writer_of
from ..formats.writers import packed
from ..hosts.offers import FileOffer
from ..quality import METRICS
from ..session import Session
from ..words import counted
from . import RENDER, missing, settings
from .render import side

FRAMES, MOST_FRAMES = 72, 720
SECONDS, MOST_SECONDS = 6.0, 120
WIDTH, HEIGHT = 1280, 960


class Way(NamedTuple):
    """A kind of file: what it is, its endings, options that are for it, and what makes it."""

    what: str
    endings: tuple[str, ...]
    options: tuple[str, ...]
    make: Callable[[Namespace, FileOffer, dict[str, Any]], str]


def listed(text: str) -> list[str]:
    """Words between commas."""
    return [word for word in (part.strip() for part in text.split(",")) if word]


def slices(text: str) -> list[float]:
    """Places of a slice: how many of them, evenly from 0 on, or each, 0 to 1."""
    if text.isascii() and text.isdigit() and int(text) > 1:
        return [place / int(text) for place in range(int(text))]
    try:
        places = [float(word) for word in listed(text)]
    except ValueError:
        places = []
    if not places or not all(0 <= place <= 1 for place in places):
        raise ArgumentTypeError(
            f"found {text!r}, expected a number of slices, or places from 0 to 1 such as 0,0.3,0.6"
        )
    return places


def frames(text: str) -> int:
    """Check a number of pictures."""
    if text.isascii() and text.isdigit() and 2 <= int(text) <= MOST_FRAMES:
        return int(text)
    raise ArgumentTypeError(f"found {text!r}, expected a number from 2 to {MOST_FRAMES}")


def seconds(text: str) -> float:
    """Check a video's length."""
    try:
        length = float(text)
    except ValueError:
        length = 0.0
    if 0 < length <= MOST_SECONDS:
        return length
    raise ArgumentTypeError(f"found {text!r}, expected seconds up to {MOST_SECONDS}")


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("file", type=Path, metavar="FILE", help="a mesh file; may be gzipped")
    kinds = "; ".join(f"{', '.join(way.endings)} ({way.what})" for way in WAYS)
    parser.add_argument(
        "-o", "--out", type=Path, required=True, metavar="OUT", help=f"where to write; the ending says what: {kinds}"
    )  # fmt: skip
    parser.add_argument("--status", type=Path, metavar="JSON", help=settings.HELP)
    parser.add_argument(
        "--metrics", type=listed, metavar="NAME,...",
        help="of cells, metrics that they carry; of a page, metrics and attributes (cell:NAME) to colour by",
    )  # fmt: skip
    parser.add_argument(
        "--attributes", type=listed, metavar="NAME,...",
        help="of cells, attributes of the file that come along, cell:NAME or point:NAME, or none (default: all)",
    )  # fmt: skip
    parser.add_argument(
        "--slices", type=slices, metavar="N", help="of a page, how many slices it holds, or where: 0,0.3,0.6"
    )
    parser.add_argument(
        "--reference",
        metavar="TEXT",
        help="of a page or a surface, where the mesh is from (default: the catalogue's)",
    )
    parser.add_argument("--link", metavar="ADDRESS", help="of a page, where the mesh is in the full viewer")
    parser.add_argument(
        "--light",
        choices=("yes", "no"),
        help="of a surface, whether light is in its colours (default: as drawn)",
    )
    parser.add_argument(
        "--frames", type=frames, metavar="N", help=f"of a turntable, pictures (default: {FRAMES})"
    )
    parser.add_argument(
        "--seconds", type=seconds, metavar="S", help=f"of a video, its length (default: {SECONDS:g})"
    )
    parser.add_argument("--width", type=side, metavar="N", help=f"of a turntable, pixels (default: {WIDTH})")
    parser.add_argument(
        "--height", type=side, metavar="N", help=f"of a turntable, pixels (default: {HEIGHT})"
    )
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Make the file; what it lacks, and what of the settings could not be applied, goes to stderr."""
    way = way_of(arguments)
    status = settings.read_status(arguments.status) if arguments.status else {}
    mesh = FileOffer(arguments.file, arguments.file.name)
    mesh.mesh()  # what can't be read is told before anything is started
    told = way.make(arguments, mesh, status)
    print(f"{arguments.out}: {told}{arguments.out.stat().st_size:,} bytes")
    return 0


def way_of(arguments: Namespace) -> Way:
    """The kind of file that the name's ending says.

    Raises
    ------
    HexaLabError
        There is none, or an option was given that is for another.
    """
    name = arguments.out.name.lower()
    way = next((way for way in WAYS if name.removesuffix(".gz").endswith(way.endings)), None)
    if way is None or (name.endswith(".gz") and way is not WAYS[0]):
        known = ", ".join(ending for way in WAYS for ending in way.endings)
        raise HexaLabError(f"{arguments.out}: found another ending, expected one of {known}")
    for option in sorted({option for way in WAYS for option in way.options}):
        if getattr(arguments, option) is not None and option not in way.options:
            fit = " or ".join(other.what for other in WAYS if option in other.options)
            raise HexaLabError(f"--{option} is for {fit}; {arguments.out} is {way.what}")
    return way


def cells(arguments: Namespace, mesh: FileOffer, status: dict[str, Any]) -> str:
    """Write the shown cells: by the core alone."""
    row = writer_of(arguments.out)
    session = Session({"mesh": mesh.mesh})
    summary = session.open_offered("mesh")
    checked = session.check(status)
    complain(arguments, checked["rejections"])
    session.update(checked["partial"])
    chosen = arguments.attributes
    saved = session.save_cells(row.id, arguments.metrics or [], [] if chosen == ["none"] else chosen)
    arguments.out.write_bytes(packed(saved["data"].tobytes(), arguments.out))
    note(arguments, [*summary["notes"], *saved["notes"]])
    return (
        f"{saved['cells']:,} of {counted(summary['cells'], 'cell')}, {counted(saved['vertices'], 'vertex')}, "
    )


def page(arguments: Namespace, mesh: FileOffer, status: dict[str, Any]) -> str:
    """Write a page of one file."""
    known = mesh.mesh()
    for metric in arguments.metrics or []:
        if metric not in METRICS and ":" not in metric:
            raise HexaLabError(f"there is no metric {metric!r}; there are {', '.join(METRICS)}")
    wanted = {"metrics": arguments.metrics or [], "slices": arguments.slices or [], **origin(arguments, mesh)}
    made(arguments, mesh, status, "page", [wanted])
    return f"{counted(known.cell_count, 'cell')}, "


def origin(arguments: Namespace, mesh: FileOffer) -> dict[str, str]:
    """Where the mesh is from: what was typed, else what the catalogue knows of this file."""
    given = {name: getattr(arguments, name) or "" for name in ("reference", "link")}
    if arguments.reference is not None:
        return given
    try:
        found = catalogue.identified(mesh.sha256())
    except HexaLabError:
        return given  # no list is at hand
    if found is None:
        return given
    source, entry = found
    site = os.environ.get(catalogue.ADDRESS_VARIABLE, "").rstrip("/")
    link = given["link"] or (f"{site}/viewer/?mesh={entry.id}" if site else "")
    return {"reference": source.citations["text"], "doi": source.doi, "link": link}


def surface(arguments: Namespace, mesh: FileOffer, status: dict[str, Any]) -> str:
    """Write the shown surface."""
    wanted: dict[str, Any] = {} if arguments.light is None else {"light": arguments.light == "yes"}
    wanted["reference"] = origin(arguments, mesh)["reference"]
    made(arguments, mesh, status, "surface", [arguments.out.suffix.lower()[1:], wanted])
    return ""


def turntable(arguments: Namespace, mesh: FileOffer, status: dict[str, Any]) -> str:
    """Write pictures around the mesh, or a video of them."""
    count = arguments.frames or FRAMES
    turn = {
        "format": arguments.out.suffix.lower()[1:], "frames": count, "seconds": arguments.seconds or SECONDS,
        "width": arguments.width or WIDTH, "height": arguments.height or HEIGHT,
    }  # fmt: skip
    made(arguments, mesh, status, "turntable", [turn])
    return f"{count} pictures, "


def made(arguments: Namespace, mesh: FileOffer, status: dict[str, Any], what: Any, words: list[Any]) -> None:
    """Have the viewer make a file, and write it."""
    try:
        exporting = import_module("hexalab.hosts.exporting")
    except ModuleNotFoundError as error:
        raise missing(f"export to {arguments.out.suffix}", error, RENDER) from None
    with exporting.Renderer() as renderer:
        export = exporting.export(renderer, mesh, what, words, status)
    arguments.out.write_bytes(export.data)
    complain(arguments, export.rejections)
    note(arguments, export.notes)


def complain(arguments: Namespace, rejections: list[Any]) -> None:
    """Say what of the settings could not be applied."""
    for rejection in rejections:
        words = f"{rejection['path']}: found {rejection['found']}, expected {rejection['expected']}"
        print(f"hexalab: {arguments.status}: {words}", file=sys.stderr)


def note(arguments: Namespace, notes: list[str]) -> None:
    """Say what the file lacks."""
    for line in notes:
        print(f"hexalab: {arguments.out}: {line}", file=sys.stderr)


MESHES = tuple(dict.fromkeys(row.extension for row in WRITERS))
WAYS = (
    Way("a mesh of the shown cells", MESHES, ("metrics", "attributes"), cells),
    Way("a page of one file", (".html",), ("metrics", "slices", "reference", "link"), page),
    Way("the shown surface", (".glb", ".ply", ".obj", ".stl"), ("light", "reference"), surface),
    Way("a turntable", (".zip", ".webm", ".mp4"), ("frames", "seconds", "width", "height"), turntable),
)  # fmt: skip
"""What can be made, by the endings of file names."""
