"""What a worker must know: what a job is, who does it, and what is told where nobody could."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar


class Task(Protocol):
    """A job.

    Attributes
    ----------
    stem : str
        What it is called by; no other of its kind is called so.
    """

    @property
    def stem(self) -> str:
        """What it is called by."""

    def as_dict(self) -> dict[str, Any]:
        """The job as JSON holds it."""


Job = TypeVar("Job", bound=Task)
Outcome = TypeVar("Outcome")


@dataclass(frozen=True)
class Craft(Generic[Job, Outcome]):
    """A kind of work.

    Parameters
    ----------
    module : str
        Name of a module that every worker can import. Its `run` takes a job's dict and gives the outcome, which JSON
        can hold; its `finish` lets go of what `run` held.
    failed : callable
        The outcome of a job that was not done, and why.
    """

    module: str
    failed: Callable[[Job, str], Outcome]
