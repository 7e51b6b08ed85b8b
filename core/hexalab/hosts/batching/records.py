"""What came of jobs, and what is written down of it, by which a batch goes on where it was left."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, TypedDict
from zipfile import BadZipFile

from ...errors import HexaLabError
from .jobs import Job
from .sources import Source

KEPT = ".batch"
"""Folder beside the results with a record of each job that is done."""


class Outcome(TypedDict):
    """What came of a job.

    Attributes
    ----------
    stem : str
        The job's.
    measured : dict
        As `rendering.Portrait` has it; of a mesh that failed, `name` and `problem`.
    line : dict of str to str
        Its line of the table.
    files : list of str
        What was written.
    """

    stem: str
    measured: dict[str, Any]
    line: dict[str, str]
    files: list[str]


def failed(job: Job, problem: str) -> Outcome:
    """The outcome of a job that could not be done."""
    told = {"name": job.name, "problem": problem}
    return Outcome(stem=job.stem, measured=dict(told), line=dict(told), files=[])


def keep(job: Job, key: str, outcome: Outcome) -> None:
    """Write down that a job is done; whole or not at all."""
    record = record_of(job)
    record.parent.mkdir(parents=True, exist_ok=True)
    half = record.with_suffix(".half")
    half.write_text(json.dumps({"key": key, **outcome}), "utf-8")
    half.replace(record)


def kept(job: Job) -> Outcome | None:
    """What a job came to before, if its mesh, its settings, and this program are the same, and all files are there."""
    try:
        record = json.loads(record_of(job).read_text("utf-8"))
        source = Source(Path(job.source))
        key = job.key(job.offer(source), job.layers(source))
        if record.pop("key") != key or not all((Path(job.out) / name).is_file() for name in record["files"]):
            return None
        outcome: Outcome = record
        return outcome
    except (OSError, ValueError, KeyError, TypeError, HexaLabError, BadZipFile):
        return None


def record_of(job: Job) -> Path:
    """Where it is written down that a job is done."""
    return Path(job.out) / KEPT / f"{job.stem}.json"
