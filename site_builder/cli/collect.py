"""`hexalab collect`: facts and pictures of the catalogue's remote meshes."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Generator, Sequence
from pathlib import Path

from hexalab.cli import CLUSTER, FINDING, INTERRUPTED, missing
from hexalab.cli.batch import several
from hexalab.cli.progress import Progress
from hexalab.errors import HexaLabError
from hexalab.hosts.labour.crew import Crew

from ..build import BuildError
from ..collecting import Collector, Report
from ..collecting.jobs import CollectJob, Outcome
from ..collecting.work import CRAFT
from ..measuring.fetching import LARGEST, Fetcher
from ..measuring.mirror import Mirror
from ..model.catalogue import Source
from ..reading.repository import read_repository


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument(
        "sources",
        nargs="*",
        metavar="SOURCE",
        help="folders of the repository, or SOURCE/MESH (default: all)",
    )
    parser.add_argument(
        "--repository", type=Path, default=Path("repository"), metavar="DIR",
        help="the folder of sources, where facts and pictures go, too (default: %(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--mirror", type=Path, metavar="DIR",
        help="take files from copies under the same paths, and fetch nothing",
    )  # fmt: skip
    parser.add_argument(
        "--cache", type=Path, default=Path("build/cache"), metavar="DIR",
        help="where what is fetched lies until it is measured (default: %(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--largest", type=int, default=LARGEST, metavar="BYTES",
        help="of a file that is still fetched (default: %(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--check", action="store_true", help="look again at what was collected before: has it changed?"
    )
    parser.add_argument("--again", action="store_true", help="measure again what was collected before")
    parser.add_argument("--jobs", type=several, default=1, metavar="N", help="meshes at a time (default: 1)")
    parser.add_argument(
        "--scheduler", metavar="ADDRESS",
        help="of a Dask cluster whose workers see the same folders and have this clone; or its scheduler file",
    )  # fmt: skip
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Collect, and say what came of it; what went wrong goes to stderr, a line each."""
    for folder in filter(None, (arguments.repository, arguments.mirror)):
        if not folder.is_dir():
            raise HexaLabError(f"{folder}: there is no such folder")
    files: Mirror | Fetcher
    place = arguments.cache / "remote"
    files = Mirror(arguments.mirror) if arguments.mirror else Fetcher(place, arguments.largest)
    try:
        sources = chosen(arguments.repository, arguments.sources)
    except BuildError as error:
        print(*error.problems, sep="\n", file=sys.stderr)
        return FINDING
    wanted = [name.strip("/") for name in arguments.sources if "/" in name.strip("/")]
    collector = Collector(sources, files, wanted, check=arguments.check, again=arguments.again)
    try:
        with Progress() as tell:
            collector.run(lambda jobs: work(jobs, arguments), tell)
    except KeyboardInterrupt:
        told = f"{collector.report.summary}; the same command goes on"
        print(f"\nhexalab: interrupted: {told}", file=sys.stderr)
        return INTERRUPTED
    return tell_all(collector.report)


def chosen(repository: Path, names: Sequence[str]) -> list[Source]:
    """The sources of those names, each with the meshes that are wanted of it.

    Raises
    ------
    BuildError
        The repository has errors.
    HexaLabError
        There is no source or mesh of that name.
    """
    catalogue = read_repository(repository)
    if catalogue.errors:
        raise BuildError(catalogue.errors)
    known = {source.slug for source in catalogue.sources} | {mesh.id for mesh in catalogue.meshes}
    wanted = [name.strip("/") for name in names]
    for name in wanted:
        if name not in known:
            raise HexaLabError(f"{name}: {repository} has no such source or mesh")
    return [source for source in catalogue.sources if not wanted or wants(source, wanted)]


def wants(source: Source, wanted: Sequence[str]) -> bool:
    """Whether a source, or a mesh of it, is among what is wanted."""
    return source.slug in wanted or any(mesh.id in wanted for mesh in source.meshes)


def work(jobs: Sequence[CollectJob], arguments: Namespace) -> Generator[Outcome]:
    """Do jobs where they are wanted."""
    if not arguments.scheduler:
        return Crew(CRAFT, arguments.jobs).outcomes(jobs)
    try:
        from hexalab.hosts.labour.cluster import outcomes
    except ModuleNotFoundError as error:
        raise missing("--scheduler", error, CLUSTER) from None
    return outcomes(CRAFT, jobs, arguments.scheduler)


def tell_all(report: Report) -> int:
    """Say what came of it; returns the exit code for that."""
    for mesh, (before, now) in report.changed.items():
        print(f"hexalab: {mesh} has changed: SHA-256 {before} before, {now} now", file=sys.stderr)
    for mesh, problem in report.failed.items():
        print(f"hexalab: {mesh}: {problem}", file=sys.stderr)
    print(report.summary)
    return FINDING if report.failed or report.changed else 0
