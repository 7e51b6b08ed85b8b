"""Making the meshes that a source's make.py gives at build time: once, and again only if a script changes."""

from __future__ import annotations

import hashlib
import importlib.util
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ..kept import remember
from ..model.catalogue import MeshEntry


class MakingError(Exception):
    """A make.py doesn't give what source.yaml says."""


def make(mesh: MeshEntry, root: Path, cache: Path) -> Path:
    """Make a mesh file, or remember it.

    Parameters
    ----------
    mesh : MeshEntry
        Of kind "made".
    root : Path
        The repository's folder, from where scripts share modules.
    cache : Path
        Folder of what is remembered.

    Raises
    ------
    MakingError
        The script has no such file, or fails.
    """
    script = mesh.source.folder / "make.py"
    kept = cache / "made" / _fingerprint(script, root) / mesh.path
    return remember(kept, lambda: _run(script, _files(script, root, mesh)))


def _files(script: Path, root: Path, mesh: MeshEntry) -> Callable[[], bytes]:
    with _importing_from(root):
        spec = importlib.util.spec_from_file_location(f"make_{mesh.source.slug.replace('-', '_')}", script)
        if spec is None or spec.loader is None:
            raise MakingError(f"{script} can't be loaded")
        module = importlib.util.module_from_spec(spec)
        loader = spec.loader
        _run(script, lambda: loader.exec_module(module))
    files: dict[str, Callable[[], bytes]] = getattr(module, "FILES", {})
    if mesh.path not in files:
        raise MakingError(f"{script} has no {mesh.path!r} in its table FILES")
    return files[mesh.path]


def _run(script: Path, step: Callable[[], Any]) -> Any:
    """A step of a script; whatever it stops with, leaving the program included, is the script's fault."""
    try:
        return step()
    except (Exception, SystemExit) as error:
        raise MakingError(f"{script} fails: {type(error).__name__}: {error}") from error


@contextmanager
def _importing_from(root: Path) -> Iterator[None]:
    sys.path.insert(0, str(root))
    try:
        yield
    finally:
        sys.path.remove(str(root))


def _fingerprint(script: Path, root: Path) -> str:
    digest = hashlib.sha256()
    for file in (script, *sorted((root / "making").glob("*.py"))):
        digest.update(file.read_bytes())
    return digest.hexdigest()[:16]
