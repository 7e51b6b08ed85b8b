"""`hexalab new-source`: the scaffold of a source's folder."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from hexalab.errors import HexaLabError

from ..citing.bibtex import BibtexError
from ..contributing.scaffold import ScaffoldError, new_source


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("name", metavar="DOI_OR_NAME", help="a DOI, a BibTeX file, or a name for the folder")
    parser.add_argument(
        "--repository",
        type=Path,
        default=Path("repository"),
        metavar="DIR",
        help="the folder of sources (default: %(default)s)",
    )
    parser.add_argument(
        "--meshes", type=Path, metavar="DIR", help="a folder whose mesh files are listed; they are not copied"
    )
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Write source.yaml; on a terminal, ask for what isn't known."""
    places = {"repository": arguments.repository, "meshes": arguments.meshes}
    try:
        file = new_source(arguments.name, **places, ask=ask if sys.stdin.isatty() else None)
    except (BibtexError, ScaffoldError) as error:
        raise HexaLabError(str(error)) from None
    print(f"{file}: fill in what is empty, then run `hexalab validate {file.parent}`")
    return 0


def ask(question: str) -> str:
    """Put a question on the terminal; the end of input is an empty answer."""
    try:
        return input(f"{question}: ")
    except EOFError:
        return ""
