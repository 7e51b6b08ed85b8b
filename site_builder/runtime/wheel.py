"""The one wheel: as hatchling builds it, and what of it a browser needs."""

from __future__ import annotations

import gzip
from collections.abc import Iterator
from pathlib import Path

from ..kept import remembered
from ..model.names import on_this_machine
from ..model.published import FACTS_FILE
from ..pages.indexes import index_json
from ..pages.memory import program
from ..reading.repository import read_repository
from .archives import packed, unpacked
from .viewer_folder import write_viewer

NOT_FOR_BROWSERS = (
    r"^hexalab/(cli|hosts|viewer)/",
    r"^hexalab/catalogue\.(py|json\.gz)$",
    r"\.dist-info/(licenses/|entry_points\.txt$)",
)
"""Files of the wheel that a browser's Python has no use for, as regular expressions."""

VIEWER = "build/viewer"
"""Where `core/build_hook.py` looks for the built viewer."""

CATALOGUE = "build/catalogue.json.gz"
"""Where it looks for the catalogue's index."""


def distribution(root: Path, out: Path, kind: str = "wheel", cache: Path | None = None) -> Path:
    """Build the distribution, viewer and catalogue in it.

    Parameters
    ----------
    root : Path
        The checkout, with node_modules.
    out : Path
        Folder for the file, made if need be.
    kind : "wheel" or "sdist"
    cache : Path, optional
        Folder of what is remembered between builds.

    Returns
    -------
    Path
        The file; the same bytes for the same sources.

    Raises
    ------
    RuntimeError
        If bundling the viewer fails.
    """
    from hatchling.builders.sdist import SdistBuilder
    from hatchling.builders.wheel import WheelBuilder

    write_viewer(root, root / VIEWER)
    repository = root / "repository"
    index = remembered(cache, "index", _texts(repository), lambda: packed_index(repository))
    (root / CATALOGUE).write_bytes(index)
    out.mkdir(parents=True, exist_ok=True)
    builder = {"wheel": WheelBuilder, "sdist": SdistBuilder}[kind](str(root))
    (file,) = builder.build(directory=str(out), versions=["standard"])
    return Path(file)


def packed_index(repository: Path) -> bytes:
    """The index of the catalogue, gzipped: the same bytes for the same repository.

    A site that nobody but its own machine reaches has no address in it, nor pictures.
    """
    catalogue = read_repository(repository)
    if on_this_machine(catalogue.address):
        catalogue.address = ""
    pictures = {mesh.picture_address for mesh in catalogue.meshes if mesh.picture}
    return gzip.compress(index_json(catalogue, pictures).encode(), mtime=0)


def _texts(repository: Path) -> Iterator[bytes]:
    """All that the index is made of: the builder, what sources say of themselves, and which files there are."""
    yield program().encode()
    for file in sorted(repository.rglob("*")):
        yield file.relative_to(repository).as_posix().encode()
        if file.suffix == ".yaml" or file.name == FACTS_FILE:
            yield file.read_bytes()


def core_wheel(wheel: Path) -> tuple[str, bytes]:
    """Cut the wheel down to the core.

    Parameters
    ----------
    wheel : Path
        As `distribution` has built it.

    Returns
    -------
    name : str
        File name of the wheel.
    data : bytes
        Its content.
    """
    files = unpacked(wheel.read_bytes(), NOT_FOR_BROWSERS)
    (metadata,) = (name for name in files if name.endswith(".dist-info/METADATA"))
    files[metadata] = files[metadata].split(b"\n\n")[0] + b"\n"  # without the README
    return wheel.name, packed(files)
