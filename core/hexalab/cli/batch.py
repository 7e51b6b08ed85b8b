"""`hexalab batch`: pictures, histograms and measurements of many meshes."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Generator, Iterator, Sequence
from contextlib import closing
from importlib import import_module
from pathlib import Path

from ..errors import HexaLabError
from ..hosts.batching import Job, Look, Results, jobs_in
from ..hosts.batching.records import Outcome, kept
from ..hosts.labour.crew import Crew
from . import CLUSTER, FINDING, INTERRUPTED, missing
from .render import side
from .settings import HELP, read_status

MOST_JOBS = 256


def several(text: str) -> int:
    """Check a number of processes."""
    if text.isascii() and text.isdigit() and 1 <= int(text) <= MOST_JOBS:
        return int(text)
    raise ArgumentTypeError(f"found {text!r}, expected a number from 1 to {MOST_JOBS}")


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument(
        "meshes", type=Path, metavar="FOLDER_OR_ZIP", help="meshes, with settings beside them (name.json)"
    )
    parser.add_argument(
        "-o", "--out", type=Path, required=True, metavar="FOLDER_OR_ZIP",
        help="where pictures (NAME.png), histograms (NAME-METRIC.png, .svg) and measurements (.csv, .json) go",
    )  # fmt: skip
    parser.add_argument(
        "--with", type=Path, dest="other", metavar="OTHER",
        help="compare each with this mesh or surface; or, if it is a folder or zip, with what has the same path in it",
    )  # fmt: skip
    parser.add_argument("--status", type=Path, metavar="JSON", help=HELP)
    parser.add_argument(
        "--figures", action="store_true", help="pictures are figures, as the settings ask for"
    )
    parser.add_argument("--width", type=side, metavar="N", help="pixels (default: 1280; a figure's own)")
    parser.add_argument("--height", type=side, metavar="N", help="pixels (default: 800; a figure's own)")
    parser.add_argument("--jobs", type=several, default=1, metavar="N", help="meshes at a time (default: 1)")
    parser.add_argument(
        "--scheduler", metavar="ADDRESS",
        help="of a Dask cluster whose workers see the same folders and have hexalab[cluster]; or its scheduler file",
    )  # fmt: skip
    parser.add_argument(
        "--resume", action="store_true", help="go on where a batch was left: what is done stays"
    )
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Work through the jobs; failures go to stderr, a line each."""
    if bool(arguments.width) != bool(arguments.height):
        raise HexaLabError("--width, --height: give both, or none")
    status = read_status(arguments.status) if arguments.status else {}
    look = Look(status, arguments.width, arguments.height, arguments.figures)
    results = Results(arguments.out)
    jobs = jobs_in(arguments.meshes, look, results.folder, arguments.other)
    results.begin(arguments.resume)
    before = {job.stem: kept(job) for job in jobs} if arguments.resume else {}
    outcomes = {stem: outcome for stem, outcome in before.items() if outcome is not None}
    left = [job for job in jobs if job.stem not in outcomes]
    try:
        with closing(work(left, arguments)) as coming:
            for outcome in shown(coming, len(jobs), len(outcomes)):
                outcomes[outcome["stem"]] = outcome
    except KeyboardInterrupt:
        done = {job.stem: kept(job) for job in left if job.stem not in outcomes}
        outcomes |= {stem: outcome for stem, outcome in done.items() if outcome is not None}
        results.write_tables(jobs, outcomes)
        told = f"{len(outcomes)} of {len(jobs)} meshes are done and lie in {results.folder}; --resume goes on"
        print(f"\nhexalab: interrupted: {told}", file=sys.stderr)
        return INTERRUPTED
    results.write_tables(jobs, outcomes)
    results.finish()
    problems = [one["measured"] for one in outcomes.values() if one["measured"]["problem"]]
    for problem in problems:
        named = "" if problem["name"] in problem["problem"] else f"{problem['name']}: "
        print(f"hexalab: {named}{problem['problem']}", file=sys.stderr)
    again = f", {len(jobs) - len(left)} of them before" if len(left) < len(jobs) else ""
    print(f"{arguments.out}: {len(jobs) - len(problems)} of {len(jobs)} meshes{again}")
    return FINDING if problems else 0


def work(jobs: Sequence[Job], arguments: Namespace) -> Generator[Outcome]:
    """Do jobs where they are wanted."""
    if arguments.scheduler:
        try:
            from ..hosts.batching.work import CRAFT
            from ..hosts.labour.cluster import outcomes
        except ModuleNotFoundError as error:
            raise missing("--scheduler", error, CLUSTER) from None
        return outcomes(CRAFT, jobs, arguments.scheduler)
    craft = import_module(
        "hexalab.hosts.batching.work"
    ).CRAFT  # what is missing is told before a process starts
    return Crew(craft, arguments.jobs).outcomes(jobs)


def shown(coming: Iterator[Outcome], total: int, done: int) -> Iterator[Outcome]:
    """Pass on what comes, and show on a terminal how far it is."""
    if not sys.stderr.isatty():
        yield from coming
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), TextColumn("{task.description}"))
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("starting", total=total, completed=done)
        failures = 0
        for outcome in coming:
            failures += bool(outcome["measured"]["problem"])
            failed = f", {failures} failed" if failures else ""
            progress.update(
                task, advance=1, description=f"{outcome['measured']['name']}{failed}", markup=False
            )
            yield outcome
