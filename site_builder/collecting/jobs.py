"""A remote mesh as a job that can be done anywhere, and what comes of it."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any, Self, TypedDict

from hexalab import __version__

from ..model.catalogue import MeshEntry
from ..model.published import VERSION


@dataclass(frozen=True)
class CollectJob:
    """One remote mesh whose file is at hand.

    Parameters
    ----------
    id : str
        "source/mesh".
    file, name : str
        Path of the file, and its name at its source.
    up : str
        The axis that points up, "" to have it guessed.
    sha256 : str
        That source.yaml gives, "" if it gives none.
    version : str
        Of the program that made the job, and of what it measures.
    """

    id: str
    file: str
    name: str
    up: str
    sha256: str
    version: str = f"{__version__}, facts {VERSION}"

    @property
    def stem(self) -> str:
        """What it is called by."""
        return self.id.replace("/", "--")

    def as_dict(self) -> dict[str, Any]:
        """The job as JSON holds it."""
        return asdict(self)

    @classmethod
    def of_dict(cls, values: dict[str, Any]) -> Self:
        """The job out of what `as_dict` gave."""
        return cls(**values)


def job_of(mesh: MeshEntry, file: str) -> CollectJob:
    """The job of a mesh whose file is at hand."""
    return CollectJob(mesh.id, file, mesh.file_name, mesh.up, mesh.declared_sha256 or "")


class Outcome(TypedDict):
    """What came of a job.

    Attributes
    ----------
    id : str
        The job's.
    facts : dict
        As `Facts.to_dict` has them.
    picture, shows : str
        A WebP in base64, and the hash of what it shows.
    problem : str
        Why there is nothing of these; "" if there is.
    """

    id: str
    facts: dict[str, Any]
    picture: str
    shows: str
    problem: str


def failed(job: CollectJob, problem: str) -> Outcome:
    """The outcome of a job that could not be done."""
    return Outcome(id=job.id, facts={}, picture="", shows="", problem=problem)
