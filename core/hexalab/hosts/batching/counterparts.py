"""What each mesh of a batch is compared with: one file for all, or each its own of another folder or archive."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path

from ...errors import HexaLabError
from ...reference import REFERENCE_FORMATS
from ..offers import AnyOffer, Stamp, other_bytes, stamp_of
from .decks import Whole, wholes
from .names import has_ending, is_mesh, stem_of
from .sources import Source


@dataclass(frozen=True)
class Beside:
    """What a mesh is compared with.

    Parameters
    ----------
    source : str
        Path of the folder or archive that it is in, or of the file itself.
    name : str
        Its path in there.
    parts : tuple of str
        Paths of what it may include.
    """

    source: str
    name: str
    parts: tuple[str, ...] = ()

    def offer(self) -> AnyOffer:
        """Read it.

        Raises
        ------
        HexaLabError, OSError, zipfile.BadZipFile
            It can't be read.
        """
        return _held(self, self._stamps()).offer

    def key(self) -> str:
        """The hash of its name and of all its bytes; errors as for `offer`, but for what is wrong in them."""
        return _held(self, self._stamps()).key

    def _stamps(self) -> tuple[Stamp | None, ...]:
        place = Path(self.source)
        return tuple(map(stamp_of, (place, *(place / name for name in (self.name, *self.parts)))))


class Held:
    """One of these with its bytes, as they were when it was made."""

    def __init__(self, beside: Beside) -> None:
        source = Source(Path(beside.source))
        self.parts = {part: source.read(part) for part in beside.parts}
        self.name = beside.name if self.parts else beside.name.rpartition("/")[2]
        self.data = source.read(beside.name)

    @cached_property
    def offer(self) -> AnyOffer:
        """What is in it, read."""
        return other_bytes(self.name, self.data, self.parts)

    @cached_property
    def key(self) -> str:
        """The hash of its name and of all its bytes."""
        return hash_of({self.name: self.data, **self.parts})


@lru_cache(maxsize=1)
def _held(beside: Beside, stamps: tuple[Stamp | None, ...]) -> Held:
    """The one that was asked for last is kept: it may be that of all meshes."""
    return Held(beside)


def hash_of(files: dict[str, bytes]) -> str:
    """One hash of files and their names."""
    digest = hashlib.sha256()
    for name, data in sorted(files.items()):
        digest.update(json.dumps([name, len(data)]).encode())
        digest.update(data)
    return digest.hexdigest()


class Counterparts:
    """Finds what each mesh is compared with.

    Parameters
    ----------
    place : Path
        A mesh or a reference surface, which each is compared with; or a folder or an archive, in which each has its
        counterpart by the same path, whose ending may be another.

    Raises
    ------
    HexaLabError
        There is no such file, it can't be read, or nothing is in it that a mesh can be compared with.
    """

    def __init__(self, place: Path) -> None:
        self._place = place
        source = Source(place)
        self._one: Beside | None = None
        self._wholes: list[Whole] = []
        if source.is_one_file:
            self._one = one_file(place)
            self._one.offer()  # what can't be read is told before anything starts
            _held.cache_clear()
            return
        self._wholes = wholes(source.names(), is_comparable, source.read)
        if not self._wholes:
            raise HexaLabError(f"{place}: there is no mesh and no surface in it")

    def of(self, mesh: str) -> Beside:
        """Find the counterpart of a mesh by its path.

        Raises
        ------
        HexaLabError
            There is none, or more than one.
        """
        if self._one is not None:
            return self._one
        found = [one for one in self._wholes if one.mesh == mesh]
        found = found or [one for one in self._wholes if stem_of(one.mesh) == stem_of(mesh)]
        if len(found) == 1:
            return Beside(str(self._place.resolve()), *found[0])
        if found:
            names = " and ".join(one.mesh for one in found)
            raise HexaLabError(f"{self._place} holds {names}, expected one to compare with")
        raise HexaLabError(f"{self._place} holds nothing of this name to compare with")


def one_file(path: Path) -> Beside:
    """A file of its own, and what it may include out of its folder."""
    whole = path.resolve()
    if not has_ending(path.name, (".inp",)):
        return Beside(str(whole), path.name)
    source = Source(whole.parent)
    (found,) = wholes(source.names(), lambda name: name == whole.name, source.read)
    return Beside(str(whole.parent), *found)


def is_comparable(path: str) -> bool:
    """Whether a file is a mesh or a surface by its name."""
    endings: Sequence[str] = [end for one in REFERENCE_FORMATS for end in one.extensions]
    return is_mesh(path) or has_ending(path, endings)
