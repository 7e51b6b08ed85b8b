"""Meshes and surfaces that a host has at hand for its viewers: files, each version read once."""

from __future__ import annotations

import hashlib
import os
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Protocol, runtime_checkable

from ..errors import NoCellsError
from ..formats import read, read_bytes
from ..mesh import Mesh
from ..reference import TriangleSurface, is_surface, read_reference, read_reference_bytes
from ..session import prepared

HEAD = 8192
"""Bytes by which a surface is told from a mesh."""

Stamp = tuple[int, int, int]
"""What tells two versions of a file apart: modification time in nanoseconds, bytes, inode."""


def stamp_of(path: Path) -> Stamp | None:
    """The version of a file; None where it is not there."""
    try:
        state = os.stat(path)
    except OSError:
        return None
    return state.st_mtime_ns, state.st_size, state.st_ino


class Offer(Protocol):
    """A mesh that a host has at hand."""

    @property
    def name(self) -> str:
        """Shown to the user."""

    def mesh(self) -> Mesh:
        """The mesh, `prepared`.

        Raises
        ------
        MeshReadError
            It can't be read, or is not there.
        """

    def hasher(self) -> Callable[[], str]:
        """What tells the SHA-256, in hexadecimal, of the file that is offered now; "" where there is none."""

    def size(self) -> int | None:
        """Bytes of that file; None where there is none."""


@runtime_checkable
class SurfaceOffer(Protocol):
    """A reference surface that a host has at hand, to compare a mesh with."""

    @property
    def name(self) -> str:
        """Shown to the user."""

    def surface(self) -> TriangleSurface:
        """The surface.

        Raises
        ------
        MeshReadError
            It can't be read, or is not there.
        """

    def hasher(self) -> Callable[[], str]:
        """As that of an `Offer`."""

    def size(self) -> int | None:
        """As that of an `Offer`."""


AnyOffer = Offer | SurfaceOffer


class File:
    """A file of this machine that may be written anew.

    Parameters
    ----------
    path : Path
    name : str
        Shown to the user.
    """

    def __init__(self, path: Path, name: str) -> None:
        self.path = path
        self.name = name
        self._lock = threading.Lock()

    def hasher(self) -> Callable[[], str]:
        """What hashes the file as it is then."""
        return self.sha256

    def sha256(self) -> str:
        """SHA-256 of the file as it is now, in hexadecimal; "" where it can't be read."""
        try:
            with open(self.path, "rb") as file:
                return hashlib.file_digest(file, "sha256").hexdigest()
        except OSError:
            return ""

    def size(self) -> int | None:
        """Bytes of the file as it is now; None where it is not there."""
        stamp = stamp_of(self.path)
        return stamp[1] if stamp else None


class FileOffer(File):
    """A file that may be opened again and again, by several pages; the version that was read last is kept."""

    def __init__(self, path: Path, name: str) -> None:
        super().__init__(path, name)
        self._read: tuple[Stamp | None, Mesh] | None = None

    def mesh(self) -> Mesh:
        """Read the file, if it has changed; the mesh is `prepared`, its faces are matched.

        Raises
        ------
        MeshReadError
            It can't be read, or is not there.
        """
        with self._lock:  # whoever comes second waits for what the first has asked for
            stamp = stamp_of(self.path)  # before: what changes meanwhile is read again the next time
            if self._read is None or self._read[0] != stamp:
                self._read = None  # of large files only one version is held here
                mesh = prepared(read(self.path))
                _ = mesh.topology.boundary_face_count
                self._read = stamp, mesh
            return self._read[1]

    def read_ahead(self) -> threading.Thread:
        """Begin to read the file; what goes wrong is told to whoever asks for the mesh."""
        thread = threading.Thread(target=self._try, name=f"reading {self.name}", daemon=True)
        thread.start()
        return thread

    def _try(self) -> None:
        try:
            self.mesh()
        except Exception:
            return


class SurfaceFileOffer(File):
    """A file with a reference surface, to be compared with again and again; the version that was read last is kept."""

    def __init__(self, path: Path, name: str) -> None:
        super().__init__(path, name)
        self._read: tuple[Stamp | None, TriangleSurface] | None = None

    def surface(self) -> TriangleSurface:
        """Read the file, if it has changed.

        Raises
        ------
        MeshReadError
            It can't be read, or is not there.
        """
        with self._lock:
            stamp = stamp_of(self.path)
            if self._read is None or self._read[0] != stamp:
                self._read = stamp, read_reference(self.path)
            return self._read[1]


@dataclass(frozen=True)
class Bytes:
    """A file whose bytes are at hand, such as one out of an archive.

    Parameters
    ----------
    name : str
        Or its path, where it includes others.
    data : bytes
    companions : dict of str to bytes
        Files that it may include, by their paths.
    """

    name: str
    data: bytes
    companions: Mapping[str, bytes] = field(default_factory=dict)

    def hasher(self) -> Callable[[], str]:
        """What hashes its bytes."""
        return lambda: hashlib.sha256(self.data).hexdigest()

    def size(self) -> int:
        """Count its bytes."""
        return len(self.data)


class BytesOffer(Bytes):
    """A mesh out of bytes that are at hand; it is read once."""

    def mesh(self) -> Mesh:
        """The mesh; errors as for `Offer`."""
        return self._mesh

    @cached_property
    def _mesh(self) -> Mesh:
        return prepared(read_bytes(self.data, self.name, self.companions))


class SurfaceBytesOffer(Bytes):
    """A reference surface out of bytes that are at hand; it is read once."""

    def surface(self) -> TriangleSurface:
        """The surface; errors as for `SurfaceOffer`."""
        return self._surface

    @cached_property
    def _surface(self) -> TriangleSurface:
        return read_reference_bytes(self.data, self.name, self.companions)


def file_offers(paths: Sequence[Path]) -> dict[str, FileOffer]:
    """Offers of files, by their places in the list; files of one name are told apart by their folders."""
    return {str(place): FileOffer(path, name) for place, (path, name) in enumerate(_named(paths))}


def compared_offers(paths: Sequence[Path]) -> dict[str, FileOffer | SurfaceFileOffer]:
    """The same for files that are compared: all but the first may be reference surfaces."""
    return {
        str(place): (SurfaceFileOffer if place and _holds_surface(path) else FileOffer)(path, name)
        for place, (path, name) in enumerate(_named(paths))
    }


def other_file(path: Path) -> AnyOffer:
    """Read the other of two that are compared: a mesh; or a surface, where there are no volumetric cells.

    Raises
    ------
    MeshReadError
        It is neither.
    """
    return _read(FileOffer(path, path.name), SurfaceFileOffer(path, path.name), _holds_surface(path))


def other_bytes(name: str, data: bytes, companions: Mapping[str, bytes]) -> AnyOffer:
    """The same of bytes that are at hand; see `Bytes`."""
    offers = BytesOffer(name, data, companions), SurfaceBytesOffer(name, data, companions)
    return _read(*offers, is_surface(data, name))


def _read(mesh: Offer, surface: SurfaceOffer, told: bool) -> AnyOffer:
    """Read a file as what it is; `told`: whether it is known for a surface."""
    if not told:
        try:
            mesh.mesh()
            return mesh
        except NoCellsError:
            pass
    surface.surface()
    return surface


def _named(paths: Sequence[Path]) -> list[tuple[Path, str]]:
    names = [path.name for path in paths]
    return [(path, path.name if names.count(path.name) == 1 else str(path)) for path in paths]


def _holds_surface(path: Path) -> bool:
    try:
        with open(path, "rb") as file:
            return is_surface(file.read(HEAD), path.name)
    except OSError:
        return False


def listed(offers: Mapping[str, AnyOffer]) -> list[dict[str, Any]]:
    """What a page is told of offers."""
    return [
        {"id": id, "name": offer.name, "surface": isinstance(offer, SurfaceOffer)}
        for id, offer in offers.items()
    ]
