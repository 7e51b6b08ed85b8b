"""Jobs on a Dask cluster, whose workers see the same folders under the same paths."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from importlib import import_module
from time import monotonic
from typing import Any

from distributed import Client, wait

from ...errors import HexaLabError
from .craft import Craft, Job, Outcome

REACH = 5.0
"""Seconds within which a scheduler answers."""

LOOK = 2.0
"""Seconds between two looks at whether there are workers."""

ALONE = 30.0
"""Seconds that are waited for a worker, at the beginning and when all have gone."""


def outcomes(craft: Craft[Job, Outcome], jobs: Sequence[Job], address: str) -> Generator[Outcome]:
    """Do all jobs; what came of each, as it is done. Closing the iterator cancels what is left.

    Parameters
    ----------
    craft : Craft
    jobs : sequence of Job
    address : str
        The scheduler's, as "tcp://host:8786", or the path of its file.

    Raises
    ------
    HexaLabError
        No scheduler answers, or it has no worker.
    """
    run = import_module(craft.module).run
    client = _client(address)
    try:
        futures: dict[Any, Job] = {
            client.submit(run, job.as_dict(), key=f"hexalab-{number}-{job.stem}", pure=False): job
            for number, job in enumerate(jobs)
        }
        seen = monotonic()
        while futures:
            try:
                with client.as_current():  # `wait` asks no other
                    done = wait(list(futures), timeout=LOOK, return_when="FIRST_COMPLETED").done
            except TimeoutError:
                done = set()
            for future in done:
                yield _outcome(craft, future, futures.pop(future))
            if done or client.scheduler_info()["workers"]:
                seen = monotonic()
            elif monotonic() - seen > ALONE:
                raise HexaLabError(f"the scheduler at {address} has had no worker for {ALONE:.0f} s")
    finally:
        client.close(timeout=REACH)


def _client(address: str) -> Client:
    try:
        if "://" in address or ":" in address:
            return Client(address, timeout=REACH, set_as_default=False)
        return Client(scheduler_file=address, timeout=REACH, set_as_default=False)
    except (OSError, TimeoutError, ValueError) as error:
        raise HexaLabError(f"no scheduler answers at {address}: {error}") from None


def _outcome(craft: Craft[Job, Outcome], future: Any, job: Job) -> Outcome:
    if future.status == "finished":
        outcome: Outcome = future.result()
        return outcome
    error = future.exception()
    return craft.failed(job, f"the worker gave up: {type(error).__name__}: {error}")
