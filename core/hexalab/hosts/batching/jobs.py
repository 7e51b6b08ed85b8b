"""A batch in jobs: one mesh each, with all that is needed to do it anywhere."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Self

from ... import __version__
from ...errors import HexaLabError
from ..offers import BytesOffer
from .counterparts import Beside, Counterparts, hash_of
from .decks import wholes
from .names import free_name, is_mesh, stem_of
from .sources import Source


@dataclass(frozen=True)
class Look:
    """How all meshes of a batch are drawn.

    Parameters
    ----------
    status : dict
        Settings, laid over the defaults.
    width, height : int or None
        Of the pictures in pixels; None for 1280 x 800, or a figure's own.
    figures : bool
        Whether pictures are figures, as the settings ask for.
    """

    status: dict[str, Any]
    width: int | None = None
    height: int | None = None
    figures: bool = False


@dataclass(frozen=True)
class Job:
    """One mesh of a batch.

    Parameters
    ----------
    source : str
        Path of the folder or archive.
    name : str
        Path of the mesh in it.
    stem : str
        What its files are called by.
    parts : tuple of str
        Paths of what it may include.
    settings : str
        Path of the settings beside it, "" if there are none.
    look : Look
    out : str
        Folder for its files.
    version : str
        Of the program that made the job.
    beside : Beside or None
        What the mesh is compared with.
    lack : str
        Why the job can't be done: the mesh has no counterpart; "" if it can.
    """

    source: str
    name: str
    stem: str
    parts: tuple[str, ...]
    settings: str
    look: Look
    out: str
    version: str = __version__
    beside: Beside | None = None
    lack: str = ""

    def as_dict(self) -> dict[str, Any]:
        """The job as JSON holds it."""
        return asdict(self)

    @classmethod
    def of_dict(cls, values: dict[str, Any]) -> Self:
        """The job out of what `as_dict` gave."""
        beside = values["beside"]
        if beside is not None:
            beside = Beside(**{**beside, "parts": tuple(beside["parts"])})
        parts, look = tuple(values["parts"]), Look(**values["look"])
        return cls(**{**values, "parts": parts, "look": look, "beside": beside})

    def offer(self, source: Source) -> BytesOffer:
        """The mesh and what it may include; by its path if it includes others, by its last name else."""
        parts = {part: source.read(part) for part in self.parts}
        name = self.name if parts else self.name.rpartition("/")[2]
        return BytesOffer(name, source.read(self.name), parts)

    def layers(self, source: Source) -> list[Any]:
        """The settings that it is drawn under, laid over each other.

        Raises
        ------
        HexaLabError
            What lies beside it holds no settings.
        """
        if not self.settings:
            return [self.look.status]
        try:
            return [self.look.status, json.loads(source.read(self.settings))]
        except (ValueError, RecursionError) as error:
            raise HexaLabError(f"{self.settings}, beside it, holds no settings: {error}") from None

    def key(self, offer: BytesOffer, layers: list[Any]) -> str:
        """What its result depends on, as a hash."""
        look = [layers, self.look.width, self.look.height, self.look.figures, self.name, self.stem]
        files = hash_of({offer.name: offer.data, **offer.companions})
        other = [self.beside.name, self.beside.key()] if self.beside else [self.lack]
        told = json.dumps([self.version, files, look, other], sort_keys=True)
        return hashlib.sha256(told.encode()).hexdigest()


def jobs_in(place: Path, look: Look, out: Path, other: Path | None = None) -> list[Job]:
    """Part a folder or an archive into jobs.

    Parameters
    ----------
    place : Path
        The folder, the archive, or one mesh.
    look : Look
    out : Path
        Folder for all files.
    other : Path, optional
        What each is compared with; see `Counterparts`.

    Raises
    ------
    HexaLabError
        There is no mesh in it; or as for `Counterparts`.
    """
    source = Source(place)
    names = source.names()
    counterparts = Counterparts(other) if other else None
    stems: set[str] = set()
    jobs = []
    for mesh, parts in wholes(names, is_mesh, source.read):
        own = [f"{stem_of(mesh)}.json", f"{stem_of(mesh)}.txt"]
        settings = next((name for name in names if name in own), "")
        stem = free_name(stem_of(mesh), stems)
        where = str(place.resolve()), mesh, stem, parts, settings, look, str(out.resolve())
        beside, lack = paired(counterparts, mesh)
        jobs.append(Job(*where, beside=beside, lack=lack))
    if not jobs:
        raise HexaLabError(f"{place}: there is no mesh in it")
    return jobs


def paired(counterparts: Counterparts | None, mesh: str) -> tuple[Beside | None, str]:
    """The counterpart of a mesh, or why it has none."""
    try:
        return (counterparts.of(mesh) if counterparts else None), ""
    except HexaLabError as error:
        return None, str(error)
