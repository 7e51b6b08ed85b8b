"""Doing one job: in this process, in another of this machine, or on a machine of a cluster."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from zipfile import BadZipFile

from ... import __version__
from ...errors import HexaLabError
from ..headless import RenderError
from ..labour import Craft
from ..rendering import Bench
from .jobs import Job
from .records import Outcome, failed, keep
from .sources import Source

BENCH = Bench()


def run(values: dict[str, Any]) -> Outcome:
    """Do a job, a dict of `Job.as_dict`; what goes wrong with its mesh is told in the outcome."""
    job = Job.of_dict(values)
    if job.version != __version__:
        return failed(job, f"this worker has HexaLab {__version__}, the batch was begun by {job.version}")
    if job.lack:
        return failed(job, job.lack)
    try:
        source = Source(Path(job.source))
        offer, layers = job.offer(source), job.layers(source)
        key = job.key(offer, layers)  # of what is drawn, whatever is written anew meanwhile
        portrait = BENCH.ready().portray(
            offer, job.stem, layers, name=job.name,
            width=job.look.width, height=job.look.height, figures=job.look.figures,
            beside=job.beside.offer() if job.beside else None, beside_name=job.beside.name if job.beside else "",
        )  # fmt: skip
    except RenderError as error:
        BENCH.clear()
        return failed(job, str(error))
    except (HexaLabError, OSError, BadZipFile, MemoryError) as error:
        return failed(job, str(error) or type(error).__name__)
    out = Path(job.out)
    for name, data in portrait.files.items():
        (out / name).parent.mkdir(parents=True, exist_ok=True)
        (out / name).write_bytes(data)
    outcome = Outcome(
        stem=job.stem, measured=portrait.measured, line=portrait.line, files=list(portrait.files)
    )
    if not portrait.measured["problem"]:
        keep(job, key, outcome)
    return outcome


def finish() -> None:
    """Close the browser."""
    BENCH.clear()


CRAFT: Craft[Job, Outcome] = Craft(__name__, failed)
