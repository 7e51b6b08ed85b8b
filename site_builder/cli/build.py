"""`hexalab build`: the site out of the repository."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from hexalab.cli import FINDING
from hexalab.cli.progress import Progress
from hexalab.errors import HexaLabError

from ..build import BuildError, build


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument(
        "--repository",
        type=Path,
        default=Path("repository"),
        metavar="DIR",
        help="the folder of sources (default: %(default)s)",
    )
    parser.add_argument(
        "--out",
        type=Path,
        default=Path("build/site"),
        metavar="DIR",
        help="where the site goes (default: %(default)s)",
    )
    parser.add_argument("--strict", action="store_true", help="a warning stops the build, too")
    parser.add_argument(
        "--no-pictures",
        dest="pictures",
        action="store_false",
        help="take no new pictures of meshes, which needs a browser and minutes; those taken before are shown",
    )
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Build, and say what was built; what is wrong in the repository goes to stderr, a line each."""
    if not arguments.repository.is_dir():
        raise HexaLabError(f"{arguments.repository}: there is no such folder")
    try:
        with Progress() as tell:
            report = build(
                arguments.repository,
                arguments.out,
                strict=arguments.strict,
                progress=tell,
                pictures=arguments.pictures,
            )
    except BuildError as error:
        print(*error.problems, sep="\n", file=sys.stderr)
        return FINDING
    for warning in report.warnings:
        print(f"warning: {warning}", file=sys.stderr)
    print(report.summary)
    return 0
