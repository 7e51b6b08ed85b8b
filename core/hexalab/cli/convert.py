"""`hexalab convert`: a mesh in another format."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from .. import WRITERS, write
from ..diagnosis import all_inverted, turn_round
from ..formats import read, writer_of
from ..structure import CELL_DATA, with_structure
from ..words import counted


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("source", metavar="IN", help="a mesh file; may be gzipped")
    parser.add_argument(
        "target", metavar="OUT", help="where to write; the ending says in which format, .gz at its end gzips"
    )
    parser.add_argument(
        "--format",
        metavar="ID",
        choices=[row.id for row in WRITERS],
        help="write this format, whatever the ending: "
        + ", ".join(f"{row.id} ({row.name})" for row in WRITERS),
    )
    parser.add_argument(
        "--orient",
        action="store_true",
        help="turn the mesh round if every cell is inverted; without, cells stay as they are in the file",
    )
    parser.add_argument(
        "--structure",
        action="store_true",
        help="add the structure as attributes of the cells: " + ", ".join(CELL_DATA),
    )
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Read, write, and say what was written; what reading or writing left out goes to stderr."""
    writer_of(Path(arguments.target), arguments.format)
    mesh = read(arguments.source)
    notes = mesh.notes
    if arguments.orient:
        notes = (mesh := turn_round(mesh)).notes
    elif all_inverted(mesh):
        notes = [
            *notes,
            "Every cell is inverted (negative volume) and stays so: --orient turns the mesh round.",
        ]
    if arguments.structure:
        mesh = with_structure(mesh)
    lost = write(mesh, arguments.target, arguments.format)
    for note in notes + lost:
        print(f"hexalab: {arguments.source}: {note}", file=sys.stderr)
    print(f"{arguments.target}: {counted(mesh.cell_count, 'cell')}, {counted(mesh.vertex_count, 'vertex')}")
    return 0
