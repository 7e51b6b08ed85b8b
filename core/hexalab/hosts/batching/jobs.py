"""A batch in jobs: one mesh each, with all that is needed to do it anywhere."""

from __future__ import annotations

import hashlib
import json
import re
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Self

from ... import __version__
from ...errors import HexaLabError
from ...formats import FORMATS
from ..offers import BytesOffer
from .decks import wholes
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
    """

    source: str
    name: str
    stem: str
    parts: tuple[str, ...]
    settings: str
    look: Look
    out: str
    version: str = __version__

    def as_dict(self) -> dict[str, Any]:
        """The job as JSON holds it."""
        return asdict(self)

    @classmethod
    def of_dict(cls, values: dict[str, Any]) -> Self:
        """The job out of what `as_dict` gave."""
        return cls(**{**values, "parts": tuple(values["parts"]), "look": Look(**values["look"])})

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
        digest = hashlib.sha256(self.version.encode())
        for name, data in sorted({offer.name: offer.data, **offer.companions}.items()):
            digest.update(json.dumps([name, len(data)]).encode())
            digest.update(data)
        look = [layers, self.look.width, self.look.height, self.look.figures, self.name, self.stem]
        digest.update(json.dumps(look, sort_keys=True).encode())
        return digest.hexdigest()


def jobs_in(place: Path, look: Look, out: Path) -> list[Job]:
    """Part a folder or an archive into jobs.

    Parameters
    ----------
    place : Path
        The folder, the archive, or one mesh.
    look : Look
    out : Path
        Folder for all files.

    Raises
    ------
    HexaLabError
        There is no mesh in it.
    """
    source = Source(place)
    names = source.names()
    stems: set[str] = set()
    jobs = []
    for mesh, parts in wholes(names, is_mesh, source.read):
        beside = [f"{stem_of(mesh)}.json", f"{stem_of(mesh)}.txt"]
        settings = next((name for name in names if name in beside), "")
        stem = free_name(stem_of(mesh), stems)
        jobs.append(Job(str(place.resolve()), mesh, stem, parts, settings, look, str(out.resolve())))
    if not jobs:
        raise HexaLabError(f"{place}: there is no mesh in it")
    return jobs


def is_mesh(path: str) -> bool:
    """Whether a file is a mesh by its name."""
    file = path.rpartition("/")[2]
    plain = re.sub(r"\.gz$", "", file.lower())
    endings = tuple(end for one in FORMATS for end in one.extensions)
    return not file.startswith(".") and not path.startswith("__MACOSX/") and plain.endswith(endings)


def stem_of(name: str) -> str:
    """A path without its ending, and without .gz behind that."""
    return re.sub(r"\.[^./]+$", "", re.sub(r"\.gz$", "", name, flags=re.I))


def free_name(stem: str, taken: set[str]) -> str:
    """The stem, or with a number added if a mesh of the same stem has it; notes it as taken."""
    free, number = stem, 2
    while free.lower() in taken:
        free, number = f"{stem}-{number}", number + 1
    taken.add(free.lower())
    return free
