"""Archives of Python sources, compiled to byte code by pyodide-build under the Python that will run them.

Byte code starts faster than source, and a module needs to be shipped only once. It belongs to one release of Python,
so pyodide-build runs where the right one is on every machine: inside Pyodide, under Node (`compile_python.mjs`). It
compiles, and names a wheel for the Python that its byte code is for. What it leaves to us: parts that nobody imports,
a wheel's RECORD, and dates, so that the same sources give the same bytes.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from .archives import packed, unpacked

SCRIPT = Path(__file__).with_name("compile_python.mjs")


@dataclass(frozen=True)
class Archive:
    """An archive whose Python modules are to be compiled.

    Parameters
    ----------
    name : str
        File name: `.zip`, or a wheel's by its standard form.
    data : bytes
        The archive.
    leave_out : tuple of str
        Regular expressions of names that are not wanted.
    optimize : {1, 2}
        Python's level: 1 drops assertions, 2 docstrings too.
    """

    name: str
    data: bytes
    leave_out: tuple[str, ...] = ()
    optimize: int = 2


def byte_code(archives: Sequence[Archive], interpreter: Path, tools: Path) -> list[tuple[str, bytes]]:
    """Compile the modules of archives.

    Parameters
    ----------
    archives : sequence of Archive
        Of different names.
    interpreter : Path
        Folder of Pyodide, as npm installs it.
    tools : Path
        Folder with the wheels of pyodide-build and of what it imports.

    Returns
    -------
    list of (str, bytes)
        For each archive its name now, a wheel's with the tag of Pyodide's Python, and its content: every .py
        replaced by a .pyc beside which no source is needed.

    Raises
    ------
    RuntimeError
        If the tools aren't there, a module can't be compiled, or an archive came back uncompiled.
    """
    if not list(tools.glob("pyodide_build-*.whl")):
        raise RuntimeError(f"{tools} has no wheel of pyodide-build")
    with tempfile.TemporaryDirectory() as folder:
        levels = {archive.optimize for archive in archives}
        for level in levels:
            (Path(folder) / str(level)).mkdir()
        for archive in archives:
            sources = packed(unpacked(archive.data, archive.leave_out), level=0)
            (Path(folder) / str(archive.optimize) / archive.name).write_bytes(sources)
        done = subprocess.run(
            ["node", str(SCRIPT), str(interpreter), str(tools), folder], capture_output=True, text=True
        )
        if done.returncode:
            raise RuntimeError(f"compiling Python under Pyodide failed:\n{done.stderr.strip()[-1500:]}")
        names: dict[str, str] = json.loads(done.stdout)
        return [_finished(archive, names, Path(folder)) for archive in archives]


def _finished(archive: Archive, names: dict[str, str], folder: Path) -> tuple[str, bytes]:
    """A compiled archive, packed as it is served; pyodide-build only prints why it passed one over."""
    if archive.name not in names:
        raise RuntimeError(
            f"pyodide-build did not compile {archive.name}: is that a wheel's name, with one tag?"
        )
    name = names[archive.name]
    return name, packed(unpacked((folder / str(archive.optimize) / name).read_bytes()))
