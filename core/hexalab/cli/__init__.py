"""The command line: `hexalab VERB ...`, one module per verb.

Exit codes: 0, 1 for a finding, 2 for misuse or unreadable input with one line on stderr, 130 and 141 when
interrupted or when the reader of a pipe has left.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from types import ModuleType
from typing import NamedTuple, NoReturn, TextIO

from ..errors import HexaLabError

FINDING = 1
MISUSE = 2
INTERRUPTED = 130
PIPE_CLOSED = 141


class Verb(NamedTuple):
    """A verb: what it does, the module that does it, and what is to be done where that can't be imported."""

    help: str
    module: str
    remedy: str = ""


CLUSTER = "`pip install 'hexalab[cluster]'` brings it, here and on every worker"
CLONE = "this verb works in a clone of the repository: `pip install -e '.[site]'` there"
RENDER = (
    "`pip install 'hexalab[render]'` brings it; pictures need a Chromium, too: `playwright install chromium`"
)

VERBS = {
    "info": Verb("say what is in mesh files", "hexalab.cli.info"),
    "quality": Verb("measure the quality of a mesh's cells", "hexalab.cli.quality"),
    "structure": Verb(
        "tell the structure of meshes: irregular graph, sheets, blocks", "hexalab.cli.structure"
    ),
    "compare": Verb("compare two meshes, or a mesh and a surface", "hexalab.cli.compare"),
    "convert": Verb("write a mesh in another format", "hexalab.cli.convert"),
    "view": Verb("open the viewer on files of this machine", "hexalab.cli.view"),
    "render": Verb("make a picture of a mesh", "hexalab.cli.render", RENDER),
    "export": Verb("save shown cells, surface, page or turntable", "hexalab.cli.export"),
    "report": Verb("write a report of a mesh, to pass or fail", "hexalab.cli.report"),
    "batch": Verb("make pictures and measurements of many meshes", "hexalab.cli.batch", RENDER),
    "serve": Verb("serve a built site on this machine", "hexalab.cli.serve"),
    "build": Verb("build the site out of the repository", "site_builder.cli.build", CLONE),
    "validate": Verb(
        "check sources for the catalogue and measure their meshes", "site_builder.cli.validate", CLONE
    ),
    "collect": Verb(
        "measure and portray the remote meshes of the catalogue", "site_builder.cli.collect", CLONE
    ),
    "new-source": Verb("start a source's folder for the catalogue", "site_builder.cli.new_source", CLONE),
}
"""Every verb of the program; its module is imported when it is called."""


class Parser(argparse.ArgumentParser):
    """Reports misuse in one line."""

    def error(self, message: str) -> NoReturn:
        """Print one line on stderr and leave with the code for misuse."""
        self.exit(MISUSE, f"{self.prog}: {message} (see {self.prog} --help)\n")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command.

    Parameters
    ----------
    argv : sequence of str, optional
        What follows the program's name; the process's own by default.

    Returns
    -------
    int
        The exit code.
    """
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    try:
        code = run(sys.argv[1:] if argv is None else argv)
        sys.stdout.flush()
    except SystemExit as leaving:
        code = leaving.code if isinstance(leaving.code, int) else 0
    except KeyboardInterrupt:
        code = INTERRUPTED
    except BrokenPipeError:
        silence(sys.stdout)
        code = PIPE_CLOSED
    except (HexaLabError, OSError, MemoryError) as error:
        code = complain(error)
    return code


def run(argv: Sequence[str]) -> int:
    """Parse the arguments and run the verb that they name."""
    parser = Parser(prog="hexalab", description="Look into hexahedral meshes and judge their quality.")
    parser.add_argument("--version", action="store_true", help="print the version and leave")
    verbs = parser.add_subparsers(dest="verb", metavar="VERB", parser_class=Parser)
    wanted = argv[0] if argv and argv[0] in VERBS else None
    for verb, row in VERBS.items():
        description = row.help[0].upper() + row.help[1:] + "."
        sub = verbs.add_parser(verb, help=row.help, description=description)
        if verb == wanted:
            module_of(verb).configure(sub)
    arguments = parser.parse_args(argv)
    if arguments.version:
        from .. import __version__

        print(f"hexalab {__version__}")
        return 0
    if arguments.verb is None:
        parser.error(f"which verb? One of {', '.join(VERBS)}")
    try:
        return int(arguments.run(arguments))
    except ModuleNotFoundError as error:
        raise missing(arguments.verb, error, VERBS[arguments.verb].remedy) from None


def module_of(verb: str) -> ModuleType:
    """Import the module of a verb.

    Raises
    ------
    HexaLabError
        If a package that it needs is not installed; says which, and what to do.
    """
    try:
        return import_module(VERBS[verb].module)
    except ModuleNotFoundError as error:
        raise missing(verb, error, VERBS[verb].remedy) from None


def missing(what: str, error: ModuleNotFoundError, remedy: str) -> Exception:
    """Say which package a verb or an option lacks, and what to do; the error itself where a remedy is not known."""
    package = (error.name or "").split(".")[0]
    return HexaLabError(f"{what}: the package {package} is not installed; {remedy}") if remedy else error


def complain(error: Exception, prefix: str = "hexalab") -> int:
    """Say on stderr, in one line, what went wrong; returns the exit code for it."""
    print(f"{prefix}: {describe(error)}", file=sys.stderr)
    return MISUSE


def describe(error: Exception) -> str:
    """Put an exception into one line of a user's words."""
    if isinstance(error, OSError) and error.strerror:
        place = f"{error.filename}: " if error.filename is not None else ""
        return f"{place}{error.strerror[0].lower()}{error.strerror[1:]}"
    if isinstance(error, MemoryError):
        return "not enough memory for this mesh"
    return " ".join(str(error).split()) or type(error).__name__


def silence(stream: TextIO) -> None:
    """Point a stream whose reader has left at nothing, so that leaving does not complain once more."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
    except (OSError, ValueError):  # a stream without a descriptor, as in tests
        return
