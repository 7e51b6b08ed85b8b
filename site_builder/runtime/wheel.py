"""The one wheel: as hatchling builds it, and what of it a browser needs."""

from __future__ import annotations

from pathlib import Path

from ..pages.library import library_json
from ..reading.repository import read_repository
from .archives import packed, unpacked
from .viewer_folder import write_viewer

NOT_FOR_BROWSERS = (
    r"^hexalab/(cli|hosts|viewer)/",
    r"^hexalab/catalogue\.(py|json)$",
    r"\.dist-info/(licenses/|entry_points\.txt$)",
)
"""Files of the wheel that a browser's Python has no use for, as regular expressions."""

VIEWER = "build/viewer"
"""Where `core/build_hook.py` looks for the built viewer."""

CATALOGUE = "build/catalogue.json"
"""Where it looks for the catalogue's list."""


def distribution(root: Path, out: Path, kind: str = "wheel") -> Path:
    """Build the distribution, viewer and catalogue in it.

    Parameters
    ----------
    root : Path
        The checkout, with node_modules.
    out : Path
        Folder for the file, made if need be.
    kind : "wheel" or "sdist"

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
    (root / CATALOGUE).write_bytes(library_json(read_repository(root / "repository")).encode())
    out.mkdir(parents=True, exist_ok=True)
    builder = {"wheel": WheelBuilder, "sdist": SdistBuilder}[kind](str(root))
    (file,) = builder.build(directory=str(out), versions=["standard"])
    return Path(file)


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
