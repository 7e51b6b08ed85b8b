"""`hexalab convert`: a mesh in another format."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace

from .. import read, write
from ..formats import left_behind
from .tables import count


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("source", metavar="IN", help="a mesh file; may be gzipped")
    parser.add_argument("target", metavar="OUT", help="where to write; the extension says in which format")
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Read, write, and say what was written; what reading or writing left out goes to stderr."""
    mesh = read(arguments.source)
    write(mesh, arguments.target)
    lost = left_behind(mesh, arguments.target)
    left = [f"Attributes for which {arguments.target} has no place: {', '.join(lost)}."] if lost else []
    for note in mesh.notes + left:
        print(f"hexalab: {arguments.source}: {note}", file=sys.stderr)
    print(f"{arguments.target}: {count(mesh.cell_count)} cells, {count(mesh.vertex_count)} vertices")
    return 0
